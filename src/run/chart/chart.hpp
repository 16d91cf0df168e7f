// Charts as SVG, black and grey on white: axes with ticks, and labels. Positions are in pixels.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "formula/glyphs.hpp"

namespace elgen {

/// The opening of an SVG: the tag, a white background, and `title` in the top 30 pixels.
[[nodiscard]] inline std::string svg_start(double width, double height, const std::string& title) {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
      "viewBox=\"0 0 {0} {1}\" font-family=\"sans-serif\" font-size=\"12\">\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
      "<text x=\"14\" y=\"22\" font-size=\"14\" font-weight=\"bold\">{2}</text>\n",
      width, height, escape_xml(title));
}

[[nodiscard]] inline std::string svg_grid_line(double x1, double y1, double x2, double y2) {
  return fmt::format(
      "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"#ddd\"/>\n", x1, y1,
      x2, y2);
}

/// The SVG of a text at (x, y). `anchor`: the part of the text at x, "start", "middle" or "end".
[[nodiscard]] inline std::string svg_label(double x, double y, const char* anchor,
                                           const std::string& text) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor,
                     escape_xml(text));
}

/// The SVG of a bold text that begins at (x, y): the title of a part of the plot.
[[nodiscard]] inline std::string svg_title(double x, double y, const std::string& text) {
  return fmt::format("<text x=\"{}\" y=\"{}\" font-weight=\"bold\">{}</text>\n", x, y,
                     escape_xml(text));
}

/// A tick of an axis: a line across the chart, and its label.
struct ChartTick {
  double at = 0;
  std::string label = {};
};

struct ChartAxis {
  double low = 0;
  double high = 1;
  std::vector<ChartTick> ticks = {};
  std::string title = {};  ///< of the x axis; if "", this axis has no title and no labels

  /// The position of a number on the axis: 0 at or below the low end, 1 at or above the high end.
  [[nodiscard]] double axis_fraction(double number) const {
    return (std::clamp(number, low, high) - low) / (high - low);
  }
};

/// A rectangle with an x axis and a y axis.
struct Chart {
  double left = 0;
  double top = 0;
  double width = 0;
  double height = 0;
  ChartAxis x = {};
  ChartAxis y = {};

  [[nodiscard]] double x_of(double number) const { return left + width * x.axis_fraction(number); }
  [[nodiscard]] double y_of(double number) const {
    return top + height * (1 - y.axis_fraction(number));
  }

  /// The SVG of a line at each tick. Labels and title of the x axis are below the chart; labels of
  /// the y axis are left of the chart.
  [[nodiscard]] std::string grid() const {
    const double bottom = top + height;
    std::string svg;
    for (const auto& [at, label] : x.ticks) {
      svg += svg_grid_line(x_of(at), top, x_of(at), bottom);
      if (!x.title.empty()) svg += svg_label(x_of(at), bottom + 16, "middle", label);
    }
    for (const auto& [at, label] : y.ticks) {
      svg += svg_grid_line(left, y_of(at), left + width, y_of(at)) +
             svg_label(left - 6, y_of(at) + 4, "end", label);
    }
    if (x.title.empty()) return svg;
    return svg + svg_label(left + width / 2, bottom + 36, "middle", x.title);
  }
};

}  // namespace elgen
