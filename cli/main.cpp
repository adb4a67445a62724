#include <CLI/CLI.hpp>

int main(int argc, char** argv) {
  CLI::App app{"Reconstructs solids from planar cross-sections, exactly.", "crossloft"};
  app.set_version_flag("--version", "crossloft " CROSSLOFT_VERSION);
  CLI11_PARSE(app, argc, argv);
}
