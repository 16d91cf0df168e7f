// Places that a page draws, and the lines between them.
#include "model/shown_places.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "check/check_testing.hpp"

namespace elgen::test {
namespace {

/// The shown lines: "bob origin" for a rod to the world origin, "bob ~ anchor" for a spring.
std::string lines_of(const Model& model) {
  const std::vector<ShownPlace> places = shown_places(model);
  std::string text;
  for (const ShownLine& line : shown_lines(model)) {
    text += places[line.from].name + (line.is_spring ? " ~ " : " ") +
            (line.to ? places[*line.to].name : "origin") + "\n";
  }
  return text;
}

std::string point(const std::string& name, const std::string& x, const std::string& keys = {}) {
  return "[[point]]\nname = \"" + name + "\"\nat = [\"" + x + "\", \"0\"]\n" + keys;
}

std::string lines(const std::string& entries) { return lines_of(checked(block(entries)).model); }

}  // namespace

TEST_CASE("a position written relative to another point is joined to it") {
  CHECK(lines(point("a", "x") + point("b", "x(a) + x")) == "b a\n");
  const std::string chain = "[sizes]\nn = 3\n" + point("p[0]", "x") +
                            point("p[i]", "x(p[i-1]) + x", "for = \"i in 1..n\"\n");
  CHECK(lines(chain) == "p[1] p[0]\np[2] p[1]\np[3] p[2]\n");
}

TEST_CASE("joined_to adds a line to a point, a frame or the origin") {
  CHECK(lines(point("a", "x")).empty());
  CHECK(lines(point("a", "x", "joined_to = \"origin\"\n")) == "a origin\n");
  CHECK(lines(point("a", "x", "joined_to = \"b\"\n") + point("b", "0")) == "a b\n");
  CHECK(lines(point("a", "x", "joined_to = [\"b\", \"arm\", \"origin\"]\nas = \"spring\"\n") +
              point("b", "0") + "[[frame]]\nname = \"arm\"\nparent = \"world\"\n") ==
        "a ~ b\na ~ arm\na ~ origin\n");
  CHECK(lines("[sizes]\nn = 3\n" + point("p[0]", "0") +
              point("p[i]", "i*x", "for = \"i in 1..n\"\njoined_to = \"p[i-1]\"\n")) ==
        "p[1] p[0]\np[2] p[1]\np[3] p[2]\n");
}

TEST_CASE("a line is drawn once, as a spring if requested, and no line joins a point to itself") {
  CHECK(lines(point("a", "x", "joined_to = [\"a\", \"origin\", \"origin\"]\n")) == "a origin\n");
  CHECK(lines(point("a", "x") + point("b", "x(a) + x", "joined_to = \"a\"\nas = \"spring\"\n")) ==
        "b ~ a\n");
}

TEST_CASE("`origin` means the point of this name if the model has one") {
  const Model model =
      checked(block(point("a", "x", "joined_to = \"origin\"\n") + point("origin", "2*x"))).model;
  CHECK(shown_lines(model).front().to == 1);
}

TEST_CASE("lines remain if a coordinate is locked") {
  const std::string text = block(
      "[[coordinate]]\nname = \"y\"\nunit = \"m\"\n[[point]]\nname = \"a\"\n"
      "at = [\"x\", \"y\"]\nmass = \"m\"\njoined_to = \"origin\"\n");
  CheckOptions wanted;
  wanted.scene = scene_of_block("[lock]\nx = { value = 1 }\n");
  CHECK(lines_of(checked(text, wanted).model) == "a origin\n");
}

TEST_CASE("lines do not change the stamp") {
  const std::string a = point("a", "x");
  const std::string more = "joined_to = \"origin\"\nas = \"spring\"\n";
  CHECK(checked(block(a)).model.canonical_text == checked(block(a + more)).model.canonical_text);
}

}  // namespace elgen::test
