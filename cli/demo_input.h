#pragma once
/// The demo's cross-sections: the file examples/demo.contour inside the program, and where they come from.

#include <string>
#include <vector>

#include "../geom/bounds.h"
#include "../inspect/slice.h"

namespace crossloft::cli {

/// The text of examples/demo.contour as it was when the program was built.
std::string demo_input();

/// The planes that cut the demo's solid; a mesh cut by them is the file.
std::vector<CuttingPlane> demo_planes(const Bounds& box);

}  // namespace crossloft::cli
