#pragma once
/// Judges the drawing of a Moebius diagram by the definition of the diagram.

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "../../io/write_diagram_svg.h"
#include "svg_reader.h"

namespace diagram_page {

using namespace crossloft;

inline double distance_from(const MoebiusSite& site, Vec2 x) {
  return site.lambda * dot(x - site.p, x - site.p) - site.mu;
}

/// The nearest site, or kNone if another one is nearly as near.
inline std::uint32_t clearly_nearest(const std::vector<MoebiusSite>& sites, Vec2 x, double tolerance) {
  std::uint32_t nearest = 0;
  for (std::uint32_t s = 1; s < sites.size(); ++s) {
    if (distance_from(sites[s], x) < distance_from(sites[nearest], x)) nearest = s;
  }
  for (std::uint32_t s = 0; s < sites.size(); ++s) {
    if (s != nearest && distance_from(sites[s], x) - distance_from(sites[nearest], x) < tolerance)
      return kNone;
  }
  return nearest;
}

struct Page {
  svg::Document document;
  PageMap map;
};

inline Page draw(const MoebiusDiagram& diagram, DiagramDrawing drawing = {}) {
  if (!drawing.box) drawing.box = view_of(diagram);
  const auto text = format_diagram_svg(diagram, drawing);
  REQUIRE(text.ok());
  Page page{svg::parse(*text), PageMap(*drawing.box, drawing.width)};
  REQUIRE(page.document.well_formed);
  return page;
}

inline std::vector<const svg::Element*> group(const Page& page, const std::string& name) {
  std::vector<const svg::Element*> members;
  for (const svg::Element& element : page.document.elements) {
    if (element.group == name) members.push_back(&element);
  }
  return members;
}

/// Every point is filled by the cell of the nearest site and by no other, but where two are equally near.
inline void check_cells(const MoebiusDiagram& diagram, const Page& page, unsigned seed, double tolerance,
                        int points = 2000) {
  std::vector<std::pair<std::uint32_t, std::vector<svg::Segment>>> cells;
  for (const svg::Element* cell : group(page, "cells")) {
    cells.emplace_back(static_cast<std::uint32_t>(cell->number("data-site")),
                       svg::parse_path(cell->attributes.at("d")));
  }
  std::mt19937 random(seed);
  const ViewBox box = page.map.box();
  std::uniform_real_distribution<double> x(box.low.x, box.high.x), y(box.low.y, box.high.y);
  int wrong = 0;
  for (int i = 0; i < points; ++i) {
    const Vec2 at{x(random), y(random)};
    const std::uint32_t nearest = clearly_nearest(diagram.sites, at, tolerance);
    if (nearest == kNone) continue;
    for (const auto& [site, path] : cells)
      wrong += svg::fills(path, page.map.place(at)) != (site == nearest) ? 1 : 0;
    const bool there =
        std::any_of(cells.begin(), cells.end(), [&](const auto& cell) { return cell.first == nearest; });
    wrong += there ? 0 : 1;
  }
  CHECK(wrong == 0);
}

inline bool near(Vec2 a, Vec2 b) { return dot(a - b, a - b) <= 1e-4; }

/// Every arc is there: pieces joined end to end with the arc's radius, centre and ends.
/// REQUIRES: the page shows all vertices and whole circles.
inline void check_arcs(const MoebiusDiagram& diagram, const Page& page) {
  const auto drawn = group(page, "arcs");
  REQUIRE(drawn.size() == diagram.arcs.size());
  for (std::size_t a = 0; a < drawn.size(); ++a) {
    const MoebiusArc& arc = diagram.arcs[a];
    CHECK(drawn[a]->number("data-arc") == static_cast<double>(a));
    const Vec2 centre = page.map.place(arc.curve.centre);
    const double radius = page.map.length(arc.curve.radius);
    if (drawn[a]->name == "circle") {
      CHECK((!arc.curve.is_line && arc.from == kNone));
      CHECK(near({drawn[a]->number("cx"), drawn[a]->number("cy")}, centre));
      CHECK(drawn[a]->number("r") == doctest::Approx(radius));
      continue;
    }
    const auto pieces = svg::parse_path(drawn[a]->attributes.at("d"));
    if (pieces.empty()) continue;  // of no length
    if (arc.from != kNone) CHECK(near(pieces.front().from, page.map.place(diagram.vertices[arc.from])));
    if (arc.to != kNone) CHECK(near(pieces.back().to, page.map.place(diagram.vertices[arc.to])));
    for (const svg::Segment& piece : pieces) {
      if (piece.radius == 0) continue;
      CHECK(!arc.curve.is_line);
      CHECK(piece.radius == doctest::Approx(radius));
      // Floats of short flat arcs leave little of the centre.
      const Vec2 chord = piece.to - piece.from;
      if (dot(chord, chord) > 0.01 * radius * radius) CHECK(near(0.1 * piece.centre, 0.1 * centre));
    }
  }
}

}  // namespace diagram_page
