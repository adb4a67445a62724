#pragma once
/// Several threads insert points into one triangulation of space, without locks.
///
/// Space is divided (division.h), and each thread inserts the points of its part as long as their cavities
/// stay within its territory. What is left over, the points near the borders, goes through other divisions
/// while that takes many of them in; the caller inserts the rest. The triangulation is a function of the
/// points alone (perturbation.h), so neither the divisions nor the order of the threads' work can be seen in
/// it. Source: Marot, Pellerin, Remacle, One machine, one minute, three billion tetrahedra (2019), for
/// partitions that change and for leaving points over instead of waiting.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

#include "division.h"
#include "in_parallel.h"
#include "inserter.h"

namespace crossloft::detail {

template <class P>
class ParallelInsertion {
 public:
  /// The triangulation must have been started; `kept` becomes as long as there are points.
  ParallelInsertion(const P& predicates, GrowingTriangulation<3>& triangulation, unsigned threads)
      : predicates_(predicates), triangulation_(triangulation), part_of_(predicates.size()) {
    auto& kept = triangulation.kept;
    const std::size_t known = kept.size();
    resize_in_large_pages(kept, predicates.size());
    std::iota(kept.begin() + static_cast<std::ptrdiff_t>(known), kept.end(),
              static_cast<std::uint32_t>(known));
    for (std::uint16_t part = 0; part < threads; ++part) {
      workers_.push_back(std::make_unique<Worker>(predicates, triangulation, Territory{&part_of_, part}));
    }
    in_parallel(threads, [&](unsigned k) { workers_[k]->inserter.see_points(); });
  }

  /// Inserts points begin..end-1, all before them being in; returns those left over, in their order.
  std::vector<std::uint32_t> insert(std::uint32_t begin, std::uint32_t end);
  std::uint32_t some_finite_cell() const {
    const auto& cells = triangulation_.cells;
    std::uint32_t cell = 0;
    while (cells.is_free(cell) || cells.is_ghost(cell)) ++cell;
    return cell;
  }
  /// How many vertices have come.
  std::int64_t gained() const {
    std::int64_t sum = 0;
    for (const auto& worker : workers_) sum += worker->inserter.gained();
    return sum;
  }

 private:
  /// Fewer points a thread than this are not worth a pass.
  static constexpr std::size_t kFew = 1000;

  struct Worker {
    Worker(const P& predicates, GrowingTriangulation<3>& triangulation, Territory territory)
        : inserter(predicates, triangulation, territory) {}

    void run() {
      left.clear();
      anchors.fill(inserter.hint());
      for (const std::uint32_t i : points)
        if (!has_start || inserter.pool().ran_dry || !insert(i)) left.push_back(i);
    }
    /// The owned cells may fall apart into several pieces, and a search can't leave the one it starts in: so
    /// after many failures it starts again from cells made a while ago. Those that are still there are owned.
    bool insert(std::uint32_t i) {
      if (inserter.insert(i)) {
        failures = 0;
        if (++inserted % kAnchorEvery == 0)
          anchors[inserted / kAnchorEvery % anchors.size()] = inserter.hint();
        return true;
      }
      if (++failures % kManyFailures != 0) return false;
      for (const std::uint32_t cell : anchors)
        if (inserter.is_there(cell) && inserter.insert(i, cell)) return true;
      return false;
    }

    Inserter<3, P, Territory> inserter;
    std::vector<std::uint32_t> points, left;
    bool has_start = false;
    static constexpr std::size_t kAnchorEvery = 256, kManyFailures = 16;
    std::array<std::uint32_t, 3> anchors{};
    std::size_t inserted = 0, failures = 0;
  };

  void divide(const std::vector<std::uint32_t>& points, std::uint32_t vertices);
  void find_starts();
  void provide_cells(std::uint32_t vertices, double generosity);
  void run_workers();

  const P& predicates_;
  GrowingTriangulation<3>& triangulation_;
  std::vector<std::uint16_t> part_of_;
  Division::Cuts cuts_;
  std::vector<std::unique_ptr<Worker>> workers_;
};

template <class P>
std::vector<std::uint32_t> ParallelInsertion<P>::insert(std::uint32_t begin, std::uint32_t end) {
  std::vector<std::uint32_t> points(end - begin);
  for (std::uint32_t i = begin; i < end; ++i) points[i - begin] = i;
  cuts_.clear();
  double generosity = 1;
  while (points.size() >= kFew * workers_.size()) {
    const std::size_t before = points.size();
    divide(points, end);
    find_starts();
    provide_cells(static_cast<std::uint32_t>(end - before), generosity);
    run_workers();
    points.clear();
    for (const auto& worker : workers_) points.insert(points.end(), worker->left.begin(), worker->left.end());
    std::sort(points.begin(), points.end());
    const bool ran_dry = std::any_of(workers_.begin(), workers_.end(),
                                     [](const auto& worker) { return worker->inserter.pool().ran_dry; });
    if (ran_dry) generosity *= 2;
    const bool has_more_cells = ran_dry && triangulation_.cells.size() < SimplexStore<3>::kMostCells;
    if (points.size() > before / 2 && !has_more_cells) break;
  }
  return points;
}

/// REQUIRES: no points but those below `vertices` are in the triangulation, or will be in this pass.
template <class P>
void ParallelInsertion<P>::divide(const std::vector<std::uint32_t>& points, std::uint32_t vertices) {
  const Division division(predicates_, points, static_cast<std::uint32_t>(workers_.size()), cuts_);
  in_slices(static_cast<unsigned>(workers_.size()), vertices,
            [&](std::size_t begin, std::size_t end, unsigned) {
              for (std::size_t v = begin; v < end; ++v)
                part_of_[v] =
                    static_cast<std::uint16_t>(division.part_of(predicates_, static_cast<std::uint32_t>(v)));
            });
  for (const auto& worker : workers_) worker->points.clear();
  for (const std::uint32_t i : points) workers_[part_of_[i]]->points.push_back(i);
}

/// A finite cell of its own for each worker; none if there is none.
template <class P>
void ParallelInsertion<P>::find_starts() {
  const auto& cells = triangulation_.cells;
  for (const auto& worker : workers_) worker->has_start = false;
  std::size_t missing = workers_.size();
  for (std::uint32_t cell = 0; cell < cells.size() && missing > 0; ++cell) {
    if (cells.is_free(cell) || cells.is_ghost(cell)) continue;
    const std::uint16_t part = part_of_[cells.vertices(cell)[0]];
    Worker& worker = *workers_[part];
    if (worker.has_start || !Territory{&part_of_, part}.owns(cells.vertices(cell))) continue;
    worker.inserter.set_hint(cell);
    worker.has_start = true;
    --missing;
  }
}

/// Cells for all that each worker may insert, if a point needs as many as so far, or a multiple, while there
/// are any; a worker that runs out leaves the rest over. `vertices`: how many points the present cells are
/// of.
template <class P>
void ParallelInsertion<P>::provide_cells(std::uint32_t vertices, double generosity) {
  auto& cells = triangulation_.cells;
  constexpr std::size_t kMost = SimplexStore<3>::kMostCells;
  std::size_t size = cells.size(), used = size;
  for (const auto& worker : workers_) used -= worker->inserter.pool().size();
  const double per_point = generosity * static_cast<double>(used) / vertices;
  for (const auto& worker : workers_) {
    CellPool& pool = worker->inserter.pool();
    const double for_all = per_point * static_cast<double>(worker->points.size());
    const std::size_t wanted = static_cast<std::size_t>(std::min(for_all, double{kMost})) + 4 * kFew;
    pool.ran_dry = false;
    for (; pool.next != pool.end; ++pool.next) pool.freed.push_back(pool.next);
    if (pool.freed.size() >= wanted) continue;
    pool.next = static_cast<std::uint32_t>(size);
    size += std::min(wanted - pool.freed.size(), kMost - size);
    pool.end = static_cast<std::uint32_t>(size);
  }
  cells.grow_to(size, static_cast<unsigned>(workers_.size()));
}

template <class P>
void ParallelInsertion<P>::run_workers() {
  in_parallel(static_cast<unsigned>(workers_.size()), [&](unsigned k) { workers_[k]->run(); });
}

}  // namespace crossloft::detail
