#include <set>

#include "../arrangement/normalise.h"
#include "../geom/failing.h"
#include "byte_writer.h"
#include "section_loops.h"
#include "write_sections.h"

namespace crossloft {
namespace {

void append_loop(std::string& text, const std::vector<SectionLoop>& loops, const SectionLoop& loop) {
  const bool hole = loop.parent != kNone;
  append_decimal(text, loop.vertices.size());
  if (hole) append_decimal(text += 'h', loop.parent);
  append_decimal(text += ' ', hole ? loops[loop.parent].material : loop.material);
  for (const std::uint32_t v : loop.vertices) append_decimal(text += ' ', v);
  text += '\n';
}

void append_plane(std::string& text, std::size_t number, const PlaneSection& plane,
                  const std::vector<SectionLoop>& loops) {
  append_decimal(text += '\n', number);
  append_decimal(text += ' ', plane.vertices.size());
  append_decimal(text += ' ', loops.size());
  append_decimal(text += ' ', plane.normal);
  append_decimal(text += ' ', plane.offset);
  text += "\n\n";
  for (const Vec3& vertex : plane.vertices) {
    append_decimal(text, vertex);
    text += '\n';
  }
  text += '\n';
  for (const SectionLoop& loop : loops) append_loop(text, loops, loop);
}

}  // namespace

Result<std::string> format_csl(const Sections& sections, const Context& context) {
  return or_out_of_memory([&]() -> Result<std::string> {
    if (const Result<Done> good = check_numbers(sections); !good) return good.error();
    std::set<std::int32_t> labels{0};  // 0 stands for the outside, which NLABELS counts
    std::string planes;
    bool mixed = false;
    for (std::uint32_t p = 0; p < sections.planes.size(); ++p) {
      Result<std::vector<SectionLoop>> loops = section_loops(sections.planes[p]);
      if (!loops.ok()) {
        loops.error().file = sections.source;
        loops.error().plane = p;
        return loops.error();
      }
      for (const SectionLoop& loop : *loops) {
        labels.insert(loop.material);
        mixed = mixed || loop.mixed;
      }
      append_plane(planes, p + 1, sections.planes[p], *loops);
    }
    if (mixed)
      context.warn(
          ".csl knows one material per contour: where a contour bounds several, the first is written");
    return "CSLC\n" + std::to_string(sections.planes.size()) + ' ' + std::to_string(labels.size()) + '\n' +
           planes;
  });
}

}  // namespace crossloft
