#include "../../io/svg.h"

#include <doctest/doctest.h>

#include "../../io/curve_piece.h"
#include "svg_reader.h"

using namespace crossloft;

namespace {

std::string pixels(double value) {
  std::string text;
  append_pixels(text, value);
  return text;
}

const PageMap kMap(ViewBox{{-1, -2}, {3, 0}}, 400);

}  // namespace

TEST_CASE("page: the box fills the width, y is up in the plane and down on the page") {
  CHECK(kMap.size() == Vec2{400, 200});
  CHECK(kMap.place({-1, -2}) == Vec2{0, 200});
  CHECK(kMap.place({3, 0}) == Vec2{400, 0});
  CHECK(kMap.length(0.25) == 25);
}

TEST_CASE("numbers are the shortest that read back as floats") {
  CHECK(pixels(0.1) == "0.1");
  CHECK(pixels(1.0 / 3) == "0.33333334");
  CHECK(pixels(-0.0) == "0");
  CHECK(pixels(-1e-60) == "0");
  CHECK(pixels(123456) == "123456");
  CHECK(pixels(-1e200) == "-1e+30");
}

TEST_CASE("path: lines, arcs by their ends, flat arcs as lines") {
  SvgPath path(kMap);
  path.move({0, -1}).line({1, -1});
  path.piece({{1, -1}, {0, 0}, false, {0, -1}, 1, true}).close();
  CHECK(path.data() == "M100 100L200 100A100 100 0 0 0 100 0Z");
  SvgPath flat(kMap);
  flat.move({0, 0}).piece({{0, 0}, {1, 0}, false, {0.5, 1e9}, 1e9, true});
  CHECK(flat.data() == "M100 0L200 0");
  SvgPath clockwise(kMap);
  clockwise.move({0, 0}).piece({{0, 0}, {1, -1}, false, {0, -1}, 1, false});
  CHECK(clockwise.data() == "M100 0A100 100 0 0 1 200 100");
}

TEST_CASE("writer: elements nest, titles and text are escaped") {
  SvgWriter out(kMap, "a < b & \"c\"");
  out.open_group("id=\"outer\"");
  out.open_group("id=\"inner\"");
  out.dot({0, 0}, 3, "fill=\"none\"", "x > y");
  out.close_group();
  out.square({1, -1}, 2, "");
  out.text({3, 0}, {1, 2}, "<7>");
  out.close_group();
  const std::string text = std::move(out).finish();
  const svg::Document document = svg::parse(text);
  REQUIRE(document.well_formed);
  CHECK(document.root.title == "a < b & \"c\"");
  CHECK(document.root.attributes.at("viewBox") == "0 0 400 200");
  REQUIRE(document.elements.size() == 4);
  CHECK(document.elements[0].attributes.at("fill") == "#fff");  // the page
  CHECK(document.elements[1].group == "inner");
  CHECK(document.elements[1].title == "x > y");
  CHECK(document.elements[1].number("cx") == 100);
  CHECK(document.elements[1].attributes.at("fill") == "none");
  CHECK(document.elements[2].group == "outer");
  CHECK(document.elements[2].number("x") == 198);
  CHECK(document.elements[2].number("width") == 4);
  CHECK(document.elements[3].text == "<7>");
  CHECK(document.elements[3].number("y") == -2);
}

TEST_CASE("escaping drops control characters and keeps the rest") {
  CHECK(xml_escaped("a\x01\t<&>\"'\xC3\xA4") == "a&lt;&amp;&gt;&quot;'\xC3\xA4");
}
