#include "run.h"

namespace pipeline_bench {

Way product(const std::string& path) {
  return {
      "crossloft", true, {"crossloft"}, [path] { return crossloft::bench::run(path, kLeastSeconds); }, {}};
}

}  // namespace pipeline_bench
