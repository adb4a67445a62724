#include "stack.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "../arrangement/normalise.h"
#include "../geom/failing.h"
#include "messages.h"
#include "pipeline.h"
#include "seam.h"
#include "stack_planes.h"
#include "stitcher.h"

namespace crossloft {
namespace {

/// Planes that a window sees beyond those it is for: what bare or branching sections, bridges and the second
/// look do reaches two slabs, and a seam may lie two planes away from where it was meant to be. A spike goes
/// by what the slab beyond it keeps, so one slab farther.
constexpr std::uint32_t kOverlap = 4;
/// Seams that are tried, one after the other, as ways from where it was meant to be.
constexpr std::int32_t kSeams[] = {0, 1, -1, 2, -2};

/// A window with the levels that it was made from.
struct Part {
  Window window;
  std::uint32_t first = 0, last = 0;
};

class StackBuilder {
 public:
  StackBuilder(SectionSource& source, SurfaceSink& sink, const StackOptions& options, const Context& context)
      : source_(source), options_(options), context_(context), quiet_(context), sink_(sink) {
    quiet_.log = nullptr;  // windows overlap: each would say it again, and count what is in both
    quiet_.progress = nullptr;
    heard_.assign(options.options.joins.size(), 0);
  }

  Result<StackReport> run() {
    Stopwatch watch;
    if (auto good = check_stack_options(); !good) return good.error();
    auto planes = survey(source_, context_);
    if (!planes) return planes.error();
    planes_ = std::move(planes).value();
    if (auto good = check_joins(); !good) return good.error();
    if (planes_.materials.size() > 1) note(note_of_materials(planes_.materials.size()));
    stitcher_.emplace(sink_, planes_.extent.low);
    if (auto good = planes_.extent.empty() ? tell_dropped() : build(); !good) return good.error();
    finish();
    report_.seconds = watch.lap();
    return std::move(report_);
  }

 private:
  Result<Done> check_stack_options() const {
    if (auto good = check_options(options_.options); !good) return good;
    const NaturalOptions& natural = options_.options.natural;
    if (natural.divide == InCells::all || natural.look_around == InCells::all)
      return make_error(
          ErrorCode::usage,
          "points inside all cells and a look around in all cells need all planes at once, which a "
          "stream does not have");
    return Done{};
  }

  /// Windows know no more than their own planes, and do not check them.
  Result<Done> check_joins() {
    for (const JoinRequest& r : options_.options.joins)
      for (const auto& [position, contour] : {std::pair{r.plane_a, r.contour_a}, {r.plane_b, r.contour_b}}) {
        if (position >= planes_.positions.size()) return check_named(nullptr, position, contour);
        const auto plane = source_.read(position);
        if (!plane) return plane.error();
        if (auto good = check_named(&*plane, position, contour); !good) return good;
      }
    return Done{};
  }

  Result<Done> build() {
    const auto cuts = window_levels(planes_, options_.window_vertices, 2 * kOverlap);
    auto part = reconstruct_part(0, cuts[1]);
    for (std::size_t i = 1; i + 1 < cuts.size() && part; ++i) {
      auto next = reconstruct_part(cuts[i], cuts[i + 1]);
      if (!next) return next.error();
      if (auto seam = find_seam(part->window, next->window, cuts[i])) {
        if (auto good = take(part->window, seam->position); !good) return good;
        seam_ = std::move(seam);
        part = std::move(next);
      } else {
        part = unite(*part, *next);
      }
    }
    return part ? take(part->window, kNone) : part.error();
  }

  /// With its overlaps.
  Result<Part> reconstruct_part(std::uint32_t first, std::uint32_t last) {
    const std::uint32_t count = planes_.levels();
    return reconstruct_exactly(first < kOverlap ? 0 : first - kOverlap,
                               last + kOverlap > count ? count : last + kOverlap);
  }

  Result<Part> reconstruct_exactly(std::uint32_t first, std::uint32_t last) {
    context_.report("slices", static_cast<double>(first) / planes_.levels());
    auto sections = read_part(source_, planes_, first, last);
    if (!sections) return sections.error();
    auto window = reconstruct_window(*sections, options_.options, quiet_);
    if (!window) return window.error();
    if (auto good = check_order(*window); !good) return good.error();
    for (std::size_t i = 0; i < heard_.size(); ++i) heard_[i] |= window->heard[i];
    ++report_.windows;
    return Part{std::move(window).value(), first, last};
  }

  /// Frames put the planes in the survey's order.
  Result<Done> check_order(const Window& window) const {
    for (std::size_t p = 1; p < window.planes.size(); ++p)
      if (planes_.level_of[window.planes[p - 1]] > planes_.level_of[window.planes[p]])
        return Error{ErrorCode::internal, "the plane is not where the survey has it",
                     source_.name(),      0,
                     window.planes[p],    kNone};
    return Done{};
  }

  /// One window instead of two that fit nowhere. It has to fit what has been handed on already.
  Result<Part> unite(const Part& a, const Part& b) {
    auto part = reconstruct_exactly(a.first, b.last);
    if (!part || !seam_) return part;
    const std::uint32_t plane = plane_in(part->window, seam_->position);
    if (plane == kNone || !fits(*seam_, part->window, plane))
      return Error{ErrorCode::internal, "windows of the stack do not fit: it has to be reconstructed at once",
                   source_.name(),      0,
                   seam_->position,     kNone};
    return part;
  }

  static std::uint32_t plane_in(const Window& window, std::uint32_t position) {
    const auto found = std::find(window.planes.begin(), window.planes.end(), position);
    return found == window.planes.end() ? kNone : static_cast<std::uint32_t>(found - window.planes.begin());
  }

  std::optional<Seam> find_seam(const Window& below, const Window& above, std::uint32_t level) const {
    for (const std::int32_t way : kSeams) {
      const std::uint32_t position =
          planes_.level(static_cast<std::uint32_t>(static_cast<std::int32_t>(level) + way)).front();
      const std::uint32_t a = plane_in(below, position), b = plane_in(above, position);
      if (a == kNone || b == kNone) continue;
      Seam seam = make_seam(below, a);
      if (fits(seam, above, b)) return seam;
    }
    return std::nullopt;
  }

  /// What the window has between the last seam and the plane at `upper`.
  Result<Done> take(const Window& window, std::uint32_t upper) {
    const std::uint32_t low = seam_ ? plane_in(window, seam_->position) : kNone;
    const std::uint32_t high = upper == kNone ? kNone : plane_in(window, upper);
    add_figures(window, low, high);
    return stitcher_->take(window, low, high);
  }

  void add_figures(const Window& window, std::uint32_t low, std::uint32_t high) {
    const Report& from = window.report;
    report_.diagonal = from.diagonal;
    for (std::uint32_t p = 0; p < from.planes.size(); ++p)
      if ((low == kNone || p >= low) && (high == kNone || p < high)) add_plane(from.planes[p]);
    const auto is_between = [&](std::uint32_t slab) {
      return (low == kNone || slab > low) && (high == kNone || slab <= high);
    };
    std::map<std::uint32_t, std::uint32_t> cells;  // by slab: at most one has tetrahedra
    for (std::uint32_t c = 0; c < from.cells.size(); ++c)
      if (is_between(window.cell_slab[c])) cells.emplace(window.cell_slab[c], c);
    for (const auto& [slab, c] : cells) {
      report_.cells.push_back(from.cells[c]);
      add_up(from.cells[c], report_.topology);
    }
    for (std::uint32_t s = 0; s < window.slab_tets.size(); ++s)
      if (is_between(s)) report_.solid_tets += window.slab_tets[s];
    // Neighbours say the same of planes that both have.
    for (const std::string& text : window.framing_notes)
      if (told_.insert(text).second) note(text);
    for (const std::string& text : window.framing_warnings)
      if (told_.insert(text).second) warn(text);
    merged_vertices_ += from.merged_vertices;
    const auto count = [&](const std::vector<std::uint32_t>& slabs) {
      return static_cast<std::size_t>(std::count_if(slabs.begin(), slabs.end(), is_between));
    };
    contacts_ += count(window.contact_slab);
    touching_ += count(window.touching_slab);
    crowded_ += count(window.crowded_slab);
    for (const std::uint32_t p : window.unsampled) unsampled_ += is_between(p + 1) ? 1 : 0;
  }

  void add_plane(const PlaneReport& plane) {
    report_.planes.push_back(plane);
    report_.section_area += plane.area;
    report_.flat_area += plane.flat_area;
    report_.flat_regions += plane.flat_regions;
    report_.thickened_regions += plane.thickened_regions;
    report_.displacement = std::max(report_.displacement, plane.displacement);
    report_.off_plane = std::max(report_.off_plane, plane.off_plane);
  }

  void note(std::string text) {
    context_.note(text);
    report_.notes.push_back(std::move(text));
  }
  void warn(std::string text) {
    context_.warn(text);
    report_.warnings.push_back(std::move(text));
  }

  void finish() {
    const Shells::Totals totals = stitcher_->totals();
    report_.surface_vertices = stitcher_->points();
    report_.surface_triangles = stitcher_->triangles();
    report_.bodies = totals.bodies;
    report_.cavities = totals.cavities;
    report_.genus = totals.genus;
    report_.volume = totals.volume;
    explain();
  }

  /// In the order of a whole.
  void explain() {
    if (unsampled_ != 0) note(tell_unsampled(unsampled_));
    if (merged_vertices_ != 0)
      warn(tell_merged(merged_vertices_) + "; what two windows share is counted twice");
    if (crowded_ != 0) warn(tell_crowded(crowded_));
    if (contacts_ != 0) warn(tell_contacts(contacts_, touching_));
    for (std::string& text : why_unheard(options_.options.joins, options_.options.mode, heard_))
      warn(std::move(text));
    if (report_.surface_triangles == 0)
      explain_empty();
    else if (report_.flat_regions != 0)
      warn(tell_flats(report_.flat_regions));
  }

  /// Without any wall there is no window whose frame would tell of contours that cancelled each other.
  Result<Done> tell_dropped() {
    for (std::uint32_t l = 0; l < planes_.levels(); ++l) {
      const auto part = read_part(source_, planes_, l, l + 1);
      if (!part) return part.error();
      const auto normalised = normalise(*part, options_.options.plane_tolerance, quiet_);
      if (!normalised) return normalised.error();
      for (const std::string& text : normalised->warnings)
        if (told_.insert(text).second) warn(text);
    }
    return Done{};
  }

  void explain_empty() {
    if (report_.planes.empty()) warn(planes_.extent.empty() ? kNoContour : kNoWideContour);
    const auto filled = std::count_if(report_.planes.begin(), report_.planes.end(),
                                      [](const PlaneReport& plane) { return plane.edges != 0; });
    warn(why_empty(static_cast<std::size_t>(filled)));
  }

  SectionSource& source_;
  const StackOptions& options_;
  const Context& context_;
  Context quiet_;
  SurfaceSink& sink_;
  StackPlanes planes_;
  std::optional<Stitcher> stitcher_;
  std::optional<Seam> seam_;    ///< up to which all has been handed on
  std::set<std::string> told_;  ///< of notes and warnings
  std::vector<std::uint8_t> heard_;  ///< by request: 1 if some cell of a window has both contours
  std::size_t merged_vertices_ = 0, contacts_ = 0, touching_ = 0, crowded_ = 0, unsampled_ = 0;
  StackReport report_;
};

}  // namespace

Result<StackReport> reconstruct_stack(SectionSource& source, SurfaceSink& sink, const StackOptions& options,
                                      const Context& context) {
  return or_out_of_memory([&] { return StackBuilder(source, sink, options, context).run(); });
}

}  // namespace crossloft
