// From a file of cross-sections to a watertight surface: minimal SECTIONS SURFACE
#include <cstdio>

#include "io/read_sections.h"
#include "io/write_mesh.h"
#include "reconstruct/reconstruct.h"

static int fail(const crossloft::Error& error) {
  return std::fprintf(stderr, "%s\n", to_string(error).c_str()), 1;
}

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const auto sections = crossloft::read_sections(argv[1]);
  if (!sections) return fail(sections.error());
  const auto result = crossloft::reconstruct(*sections);
  if (!result) return fail(result.error());
  const auto written = crossloft::write_surface(argv[2], result->surface);
  return written ? 0 : fail(written.error());
}
