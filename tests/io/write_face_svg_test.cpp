#include "../../io/write_face_svg.h"

#include <algorithm>

#include <doctest/doctest.h>

#include "scratch.h"
#include "svg_reader.h"

using namespace crossloft;

namespace {

/// A square section with a hole in a larger face, a line across it, a circle around the hole, a far-off
/// circle.
FaceDrawing example() {
  FaceDrawing drawing;
  drawing.title = "face 3, above";
  drawing.face = {{{-5, -5}, {5, -5}, {5, 5}, {-5, 5}}};
  drawing.section = {{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{1, 1}, {1, 3}, {3, 3}, {3, 1}}};
  drawing.contour = {{{{0, 0}, {4, 0}}}, {{{1, 1}, {1, 3}}}};
  drawing.arcs = {{{true, {0.5, 0}, 0, {0, 1}}, false, false, {}, {}},
                  {{false, {2, 2}, 1.7, {}}, true, false, {}, {}},
                  {{false, {40, 2}, 1, {}}, true, false, {}, {}}};
  drawing.samples = {{0.5, 1}, {0.5, 2}};
  drawing.sites = {{2, 2}};
  return drawing;
}

std::size_t count(const svg::Document& document, const std::string& group) {
  return static_cast<std::size_t>(std::count_if(document.elements.begin(), document.elements.end(),
                                                [&](const svg::Element& e) { return e.group == group; }));
}

}  // namespace

TEST_CASE("a face: section with its hole, arcs that are seen, samples") {
  const svg::Document document = svg::parse(format_face_svg(example()));
  REQUIRE(document.well_formed);
  CHECK(document.root.title == "face 3, above");
  CHECK(count(document, "arcs") == 2);
  CHECK(count(document, "samples") == 2);
  CHECK(count(document, "sites") == 1);
  CHECK(count(document, "contour") == 1);
  const auto section = std::find_if(document.elements.begin(), document.elements.end(),
                                    [](const svg::Element& e) { return e.group == "section"; });
  REQUIRE(section != document.elements.end());
  const auto path = svg::parse_path(section->attributes.at("d"));
  const PageMap map({{-0.2, -0.2}, {4.2, 4.2}}, 800);
  CHECK(svg::fills(path, map.place({0.5, 2})));
  CHECK(!svg::fills(path, map.place({2, 2})));
  CHECK(!svg::fills(path, map.place({-0.1, 2})));
}

TEST_CASE("whatever is missing, there is a page") {
  FaceDrawing drawing;
  CHECK(svg::parse(format_face_svg(drawing)).well_formed);
  drawing.face = example().face;
  CHECK(svg::parse(format_face_svg(drawing)).root.number("width") == 800);
  drawing.samples = {{1, 1}};
  CHECK(svg::parse(format_face_svg(drawing)).root.number("height") == 800);
  drawing.samples = {{1, 1}, {1, 3}};
  CHECK(svg::parse(format_face_svg(drawing)).root.number("height") == 800);
}

TEST_CASE("the file is the text") {
  const Scratch scratch;
  REQUIRE(write_face_svg(scratch.path("f.svg"), example()).ok());
  CHECK(scratch.bytes("f.svg") == format_face_svg(example()));
}
