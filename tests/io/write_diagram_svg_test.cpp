#include "../../io/write_diagram_svg.h"

#include <set>

#include <doctest/doctest.h>

#include "diagram_page.h"
#include "scratch.h"

using namespace crossloft;
using namespace diagram_page;

namespace {

MoebiusCurve line(Vec2 through, Vec2 direction) {
  return {true, through, 0, (1 / std::sqrt(dot(direction, direction))) * direction};
}

/// Two equal sites: a line without ends.
MoebiusDiagram halves() {
  return {{{{-1, 0}, 1, 0}, {{1, 0}, 1, 0}}, {}, {{{0, 1}, kNone, kNone, line({0, 0}, {0, 1})}}};
}

/// The Apollonius circle of sites with lambda 4 at 0 and 1 at x = 3: about (-1, 0), of radius 2.
MoebiusDiagram disc() {
  return {{{{0, 0}, 4, 0}, {{3, 0}, 1, 0}}, {}, {{{0, 1}, kNone, kNone, {false, {-1, 0}, 2, {}}}}};
}

/// Three sites around the origin, which is a vertex.
MoebiusDiagram star() {
  MoebiusDiagram d{{{{2, 0}, 1, 0}, {{-1, 2}, 1, 1}, {{-1, -2}, 1, 1}}, {{0, 0}}, {}};
  d.arcs.push_back({{1, 0}, 0, kNone, line({0, 0}, {2, 3})});
  d.arcs.push_back({{2, 1}, 0, kNone, line({0, 0}, {-1, 0})});
  d.arcs.push_back({{2, 0}, kNone, 0, line({0, 0}, {-2, 3})});
  return d;
}

/// Four sites at the corners of a square: two vertices at one place with an arc of no length in between.
MoebiusDiagram crossroads() {
  MoebiusDiagram d{
      {{{1, 1}, 1, 0}, {{-1, 1}, 1, 0}, {{-1, -1}, 1, 0}, {{1, -1}, 1, 0}}, {{0, 0}, {0, 0}}, {}};
  d.arcs.push_back({{0, 1}, kNone, 0, line({0, 0}, {0, -1})});
  d.arcs.push_back({{1, 2}, kNone, 0, line({0, 0}, {1, 0})});
  d.arcs.push_back({{2, 0}, 0, 1, line({0, 0}, {-1, 1})});
  d.arcs.push_back({{2, 3}, kNone, 1, line({0, 0}, {0, 1})});
  d.arcs.push_back({{3, 0}, kNone, 1, line({0, 0}, {-1, 0})});
  return d;
}

DiagramDrawing shown(Vec2 low, Vec2 high) {
  DiagramDrawing drawing;
  drawing.box = ViewBox{low, high};
  return drawing;
}

void check_all(const MoebiusDiagram& diagram) {
  const Page page = draw(diagram);
  check_cells(diagram, page, 1, 1e-6);
  check_arcs(diagram, page);
}

}  // namespace

TEST_CASE("lines to infinity, a whole circle, a vertex, a crossroads") {
  check_all(halves());
  check_all(disc());
  check_all(star());
  check_all(crossroads());
}

TEST_CASE("a box that shows a part: arcs are cut at its border, cells are not") {
  for (const auto& [low, high] : {std::pair(Vec2{-4, -1}, Vec2{2, 1}),
                                  {Vec2{-1, 0.5}, Vec2{3, 4}},
                                  {Vec2{-1.5, -0.5}, Vec2{-0.5, 0.5}},
                                  {Vec2{5, 5}, Vec2{6, 6}},
                                  {Vec2{-3, -2}, Vec2{1, 2}},
                                  {Vec2{-2, -2.1}, Vec2{0, 2.1}}}) {
    for (const MoebiusDiagram& diagram : {halves(), disc(), star(), crossroads()})
      check_cells(diagram, draw(diagram, shown(low, high)), 2, 1e-6);
  }
}

TEST_CASE("no site, one site, equal sites: one cell over all, hidden sites hollow") {
  CHECK(group(draw({}), "cells").empty());
  CHECK(group(draw({}), "sites").empty());
  for (const Vec2 p : {Vec2{0, 0}, Vec2{1e7, -3}, Vec2{1e-9, 0}}) {
    const MoebiusDiagram one{{{p, 1, 0}, {p, 1, 0}}, {}, {}};
    const Page page = draw(one);
    REQUIRE(group(page, "cells").size() == 1);
    CHECK(svg::fills(svg::parse_path(group(page, "cells")[0]->attributes.at("d")), {1, 1}));
    const auto dots = group(page, "sites");
    REQUIRE(dots.size() == 2);
    CHECK(dots[0]->attributes.count("fill") == 0);
    CHECK(dots[1]->attributes.at("fill") == "#ffffff");
    CHECK(dots[0]->number("cx") == doctest::Approx(page.map.size().x / 2));
  }
}

TEST_CASE("tooltips say what a cell belongs to; sites with lambda <= 0 are squares") {
  MoebiusDiagram diagram = disc();
  diagram.sites.push_back({{1, 1}, -0.5, -1e9});
  const Page page = draw(diagram);
  CHECK(group(page, "cells")[0]->title == "site 0: p = (0, 0), lambda = 4, mu = 0");
  CHECK(group(page, "sites")[0]->name == "circle");
  CHECK(group(page, "sites")[2]->name == "rect");
  CHECK(group(page, "sites")[2]->title == "site 2: p = (1, 1), lambda = -0.5, mu = -1e+09, no cell");
}

TEST_CASE("cells that meet differ in colour") {
  for (const MoebiusDiagram& diagram : {halves(), disc(), star(), crossroads()}) {
    const Page page = draw(diagram);
    const auto cells = group(page, "cells");
    for (const MoebiusArc& arc : diagram.arcs)
      CHECK(cells[arc.sites[0]]->attributes.at("fill") != cells[arc.sites[1]]->attributes.at("fill"));
  }
}

TEST_CASE("the view holds all sites and what is near, and is never empty") {
  const ViewBox box = view_of(disc());
  CHECK(box.low.x < -3);
  CHECK(box.high.x > 3);
  CHECK(box.low.y < -2);
  MoebiusDiagram far = star();
  far.vertices[0] = {1e6, 0};
  CHECK(view_of(far).high.x < 10);
  const ViewBox flat = view_of(halves());
  CHECK(flat.size().y >= flat.size().x / 3);
}

TEST_CASE("an arc between ends that nearly coincide is tiny, or all but a whole circle, as the arc says") {
  // The circle of disc() with two vertices side by side at its right end, which a third site has just
  // reached.
  MoebiusDiagram diagram = disc();
  diagram.sites.push_back({{1, 0}, 1000, 0});
  diagram.vertices = {{1, 1e-9}, {1, -1e-9}};
  diagram.arcs[0].from = 0;
  diagram.arcs[0].to = 1;
  const DiagramDrawing all = shown({-5, -5}, {5, 5});
  const auto drawn = [&] {
    return svg::parse_path(group(draw(diagram, all), "arcs")[0]->attributes.at("d"));
  };
  CHECK(drawn().size() <= 1);
  diagram.arcs[0].over_half = true;
  CHECK(drawn().size() >= 3);
}

TEST_CASE("options: no sites, labels, width") {
  DiagramDrawing drawing;
  drawing.sites = false;
  drawing.labels = true;
  drawing.width = 300;
  const Page page = draw(star(), drawing);
  CHECK(group(page, "sites").empty());
  REQUIRE(group(page, "labels").size() == 3);
  CHECK(group(page, "labels")[2]->text == "2");
  CHECK(page.document.root.number("width") == 300);
}

TEST_CASE("boxes and widths that make no sense are errors") {
  const double nan = std::nan("");
  for (const DiagramDrawing& drawing : {shown({1, 0}, {0, 1}), shown({0, 0}, {0, 1}), shown({0, nan}, {1, 1}),
                                        shown({-1e308, 0}, {1e308, 1}), shown({0, 0}, {1000, 1})}) {
    const auto text = format_diagram_svg(halves(), drawing);
    REQUIRE(!text.ok());
    CHECK(text.error().code == ErrorCode::usage);
  }
  for (const double width : {0.0, -1.0, nan}) {
    DiagramDrawing drawing;
    drawing.width = width;
    CHECK(!format_diagram_svg(halves(), drawing).ok());
  }
}

TEST_CASE("the file is the text") {
  const Scratch scratch;
  REQUIRE(write_diagram_svg(scratch.path("d.svg"), star()).ok());
  CHECK(scratch.bytes("d.svg") == *format_diagram_svg(star()));
  CHECK(scratch.files() == 1);
  CHECK(!write_diagram_svg(scratch.path("no/d.svg"), star()).ok());
}

namespace {

/// Shows all vertices and circles, and a point of each whole line.
DiagramDrawing everything(const MoebiusDiagram& diagram) {
  ViewBox box = view_of(diagram);
  const auto add = [&box](Vec2 p, double reach) {
    box.low = {std::min(box.low.x, p.x - reach), std::min(box.low.y, p.y - reach)};
    box.high = {std::max(box.high.x, p.x + reach), std::max(box.high.y, p.y + reach)};
  };
  for (const Vec2 v : diagram.vertices) add(v, 0);
  for (const MoebiusArc& arc : diagram.arcs) {
    if (!arc.curve.is_line || (arc.from == kNone && arc.to == kNone)) add(arc.curve.centre, arc.curve.radius);
  }
  return shown(box.low, box.high);
}

enum class Kind { voronoi, power, weighted, nearly_equal, moebius, any_sign, grid };

std::vector<MoebiusSite> random_sites(Kind kind, std::size_t count, std::mt19937& random) {
  std::uniform_real_distribution<double> place(-1, 1), weight(0.5, 3), offset(-0.1, 0.1);
  std::uniform_int_distribution<int> step(-3, 3), small(0, 2);
  std::vector<MoebiusSite> sites(count);
  for (MoebiusSite& site : sites) {
    site.p = {place(random), place(random)};
    if (kind == Kind::weighted || kind == Kind::moebius) site.lambda = weight(random);
    if (kind == Kind::nearly_equal) site.lambda = 1 + 1e-10 * weight(random);
    if (kind == Kind::any_sign) site.lambda = place(random);
    if (kind == Kind::power || kind == Kind::moebius || kind == Kind::any_sign) site.mu = offset(random);
    if (kind != Kind::grid) continue;
    site = {{static_cast<double>(step(random)), static_cast<double>(step(random))},
            static_cast<double>(small(random)),
            static_cast<double>(small(random))};
  }
  return sites;
}

DiagramDrawing random_box(std::mt19937& random) {
  std::uniform_real_distribution<double> place(-4, 4), size(0.1, 4);
  const Vec2 low{place(random), place(random)};
  return shown(low, low + Vec2{size(random), size(random)});
}

}  // namespace

TEST_CASE("random diagrams: the nearest site fills each point, every arc is there") {
  MESSAGE("seeds 0..79 of each kind");
  for (const Kind kind : {Kind::voronoi, Kind::power, Kind::weighted, Kind::nearly_equal, Kind::moebius,
                          Kind::any_sign, Kind::grid}) {
    for (unsigned seed = 0; seed < 80; ++seed) {
      CAPTURE(static_cast<int>(kind));
      CAPTURE(seed);
      std::mt19937 random(seed);
      const auto diagram = moebius_diagram(random_sites(kind, 1 + seed % 40, random));
      REQUIRE(diagram.ok());
      check_cells(*diagram, draw(*diagram), seed, 1e-4, 100);
      check_cells(*diagram, draw(*diagram, random_box(random)), seed, 1e-4, 100);
      if (kind == Kind::nearly_equal) continue;  // circles of radius 1e10
      if (const DiagramDrawing all = everything(*diagram); format_diagram_svg(*diagram, all).ok())
        check_arcs(*diagram, draw(*diagram, all));
    }
  }
}

TEST_CASE("curves beyond the range of doubles are left out") {
  for (const double size : {1e-200, 1e80, 1e200}) {
    CAPTURE(size);
    std::vector<MoebiusSite> sites{{{1, 0}, 1, 0}, {{0, 1}, 2, 0}, {{3, 1}, 3, 0}, {{1, 1}, 1.5, 0}};
    for (MoebiusSite& site : sites) site.p = size * site.p;
    const auto diagram = moebius_diagram(sites);
    REQUIRE(diagram.ok());
    const auto text = format_diagram_svg(*diagram);
    REQUIRE(text.ok());
    CHECK(text->find("nan") == std::string::npos);
    CHECK(text->find("inf") == std::string::npos);
  }
}
