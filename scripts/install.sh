# Sourced by the other scripts: Debian packages, and the build with the presets.

program_packages="ca-certificates cmake ninja-build g++ libboost-dev libeigen3-dev
                  libcli11-dev nlohmann-json3-dev libpng-dev"
test_packages="doctest-dev libgmp-dev libcgal-dev"

# install_missing PACKAGE...: installs those that are not there yet. Root or sudo, never a question.
install_missing() {
  command -v dpkg-query >/dev/null || { echo "not a Debian system; needed: $*"; return 0; }
  local package missing=() as_root=()
  for package in "$@"; do
    [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return 0
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || { echo "needs root or sudo to install: ${missing[*]}" >&2; return 1; }
    as_root=(sudo)
    [ -t 0 ] || as_root=(sudo -n)
  fi
  echo "installing: ${missing[*]}"
  local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive
             apt-get -q -y -o Acquire::Retries=3 -o DPkg::Lock::Timeout=600)
  "${apt[@]}" update </dev/null >/dev/null || echo "apt-get update failed; trying with the lists at hand"
  "${apt[@]}" install --no-install-recommends "${missing[@]}" </dev/null >/dev/null
}

# build PRESET [TARGET]: configures and builds; ccache is used where it is installed.
build() {
  local launcher=()
  command -v ccache >/dev/null && launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
  cmake --preset "$1" "${launcher[@]}" "${configure_arguments[@]}"
  cmake --build --preset "$1" ${2:+--target "$2"}
}
configure_arguments=()
