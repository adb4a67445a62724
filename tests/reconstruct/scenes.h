#pragma once
/// What the tests of the pipeline share: scenes of the examples, rearrangements that must not matter.

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "../../io/read_sections.h"
#include "../../reconstruct/reconstruct.h"
#include "shuffled.h"
#include "result_hash.h"

namespace crossloft::test {

/// By its path below the source tree's examples/.
inline Sections load(const std::string& name, const std::string& folder = "/examples/") {
  auto sections = read_sections(CROSSLOFT_SOURCE_DIR + folder + name);
  REQUIRE(sections.ok());
  return std::move(sections).value();
}

}  // namespace crossloft::test
