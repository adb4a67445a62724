/// The entry point that libFuzzer calls, for the target that the build names.
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "targets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const crossloft::test::FuzzTarget& target =
      *crossloft::test::find_fuzz_target(CROSSLOFT_FUZZ_TARGET);
  const std::string broken = target.judge({reinterpret_cast<const char*>(data), size});
  if (broken.empty()) return 0;
  std::fprintf(stderr, "%s: %s\n", target.name, broken.c_str());
  std::abort();
}
