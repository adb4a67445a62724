#pragma once
/// The even-odd testers of all planes.

#include <memory>
#include <mutex>
#include <vector>

#include "../arrangement/section_graph.h"

namespace crossloft {

/// Each is made when it is first asked for: only a face without walls and branching samples need one, so that
/// with a stack of slices there is none as a rule.
class PlaneLocators {
 public:
  /// The graph must outlive it.
  explicit PlaneLocators(const SectionGraph& graph)
      : graph_(&graph), planes_(std::make_unique<Plane[]>(graph.planes.size())) {}
  /// On any thread.
  const SectionLocator& of(std::uint32_t plane) const {
    Plane& p = planes_[plane];
    std::call_once(p.made, [&] { p.locator = graph_->locator(plane, p.ends); });
    return p.locator;
  }

 private:
  struct Plane {
    std::once_flag made;
    std::vector<WallEnds> ends;  ///< what the locator looks at
    SectionLocator locator;
  };
  const SectionGraph* graph_;
  std::unique_ptr<Plane[]> planes_;
};

}  // namespace crossloft
