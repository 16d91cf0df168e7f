// Elements of plots, and their axes.
#include "run/chart/chart.hpp"

#include <catch2/catch.hpp>

using namespace elgen;

TEST_CASE("a plot starts with its size, a white background and its title") {
  const std::string svg = svg_start(300, 200, "a<b");
  CHECK(
      svg.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"300\" height=\"200\" "
                      "viewBox=\"0 0 300 200\""));
  CHECK(svg.ends_with(" font-weight=\"bold\">a&lt;b</text>\n"));
}

TEST_CASE("texts are escaped, positions are rounded to a tenth of a pixel") {
  CHECK(svg_label(1.04, 2, "end", "a<b & c") ==
        "<text x=\"1.0\" y=\"2.0\" text-anchor=\"end\">a&lt;b &amp; c</text>\n");
  // XML forbids ]]> in text.
  CHECK(svg_title(1, 2, "a[b[1]]>0") ==
        "<text x=\"1\" y=\"2\" font-weight=\"bold\">a[b[1]]&gt;0</text>\n");
  CHECK(svg_title(1, 2, "a<b") == "<text x=\"1\" y=\"2\" font-weight=\"bold\">a&lt;b</text>\n");
  CHECK(svg_grid_line(0, 1, 2, 3.26) ==
        "<line x1=\"0.0\" y1=\"1.0\" x2=\"2.0\" y2=\"3.3\" stroke=\"#ddd\"/>\n");
}

TEST_CASE("values are mapped to pixels, y upwards, and clamped to the axes") {
  const Chart chart{10, 20, 100, 50, {0, 4}, {-1, 1}};
  CHECK(chart.x_of(1) == 35);
  CHECK(chart.y_of(0.5) == 32.5);
  CHECK(chart.x_of(9) == 110);
  CHECK(chart.y_of(-9) == 70);
}

TEST_CASE("an x axis without a title has grid lines only") {
  Chart chart{10, 20, 100, 50, {0, 4, {{1, "one"}}}, {0, 1, {{1, "top"}}}};
  const std::string lines = svg_grid_line(35, 20, 35, 70);
  const std::string above = svg_grid_line(10, 20, 110, 20) + svg_label(4, 24, "end", "top");
  CHECK(chart.grid() == lines + above);
  chart.x.title = "t [s]";
  CHECK(chart.grid() ==
        lines + svg_label(35, 86, "middle", "one") + above + svg_label(60, 106, "middle", "t [s]"));
}
