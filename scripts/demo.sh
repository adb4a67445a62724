#!/usr/bin/env bash
# Installs what the program needs, builds it, reconstructs the demo and says where the result is.
set -euo pipefail
cd "$(dirname "$0")/.."
. scripts/install.sh

install_missing $program_packages
configure_arguments=(-DCROSSLOFT_BUILD_TESTS=OFF)
build release crossloft_cli
build/release/crossloft demo -o "${1:-demo-output}"
