// A table as a picture.
#include <tinyxml2.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "support/shell.hpp"
#include "tradeoff/tables.hpp"

using namespace elgen;
using namespace elgen::test;

TEST_CASE("a picture is XML with every design that has numbers, and the front joined") {
  const std::string svg = to_svg(judged(sample_table()));
  tinyxml2::XMLDocument document;
  REQUIRE(document.Parse(svg.c_str()) == tinyxml2::XML_SUCCESS);
  CHECK(count(svg, "fill=\"black\"") == 2 * 3);
  CHECK(count(svg, "transform=") == 2 * 4);
  CHECK(mentions(svg, ">1  float, packs<"));
  CHECK(mentions(svg, "arm, gravity"));
  CHECK_FALSE(mentions(svg, "E709"));
}

TEST_CASE("shapes tell the values of the first dimension apart") {
  const std::string svg = to_svg(judged(sample_table()));
  CHECK(count(svg, "d=\"M-5 0A") == 4);
  CHECK(count(svg, "d=\"M-4.5 ") == 4);
}

TEST_CASE("errors without a logarithm stay inside the picture") {
  const std::string svg = to_svg(
      judged({.dimensions = {"a"}, .rows = {row_of({"1"}, 1, 0), row_of({"2"}, 0.5, INFINITY)}}));
  CHECK_FALSE(mentions(svg, "nan"));
  CHECK_FALSE(mentions(svg, "inf"));
}
