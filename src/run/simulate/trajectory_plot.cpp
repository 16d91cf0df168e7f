// A trajectory as SVG, with a panel for each coordinate, for each input, and for E - E0 - work. The
// four components of a rotation share a panel and differ by their dashes; all lines are black, for
// printing. E itself has no panel, because a drift of 1e-9 J would be invisible. With a point as
// `path`, the plot is instead the path of this point in a square with equal scales.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "elgen/simulate.hpp"
#include "model/symbols.hpp"
#include "run/chart/chart.hpp"

namespace elgen {
namespace {

constexpr double left_margin = 92;
constexpr double panel_width = 620;
constexpr double panel_height = 110;
constexpr double panel_distance = 138;
constexpr double top_margin = 60;
constexpr double bottom_margin = 46;
constexpr double right_margin = 20;

/// A curve smaller than this fraction of its scale shows rounding errors, not the motion. The scale
/// of E is |T| + |V|: each product in E is rounded to 1.1e-16 of |T| + |V|, and a run adds up some
/// hundred errors. The scale of a coordinate is the largest coordinate of the same unit: a
/// coordinate that should be 0 is a difference of coordinates of this size.
constexpr double rounding_fraction = 1e-13;

/// Steps are accurate to 1e-9 of each number, so a smaller relative change shows no motion.
constexpr double smallest_change = 1e-9;

struct LineStyle {
  const char* name;
  const char* dashes;
};
constexpr std::array line_styles{LineStyle{"solid", "none"}, LineStyle{"dashed", "9 4"},
                                 LineStyle{"dotted", "2 3"}, LineStyle{"dash-dotted", "9 3 2 3"}};

/// 1, 2 or 5 times a power of ten; with this distance an axis has three to eight ticks.
double tick_distance(const ChartAxis& axis) {
  const double rough = (axis.high - axis.low) / 3;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double factor : {5.0, 2.0}) {
    if (factor * power <= rough) return factor * power;
  }
  return power;
}

int decade_of(double number) { return static_cast<int>(std::floor(std::log10(number))); }

/// The number with enough digits to distinguish neighbouring ticks of the axis, plus `more` digits.
std::string tick_label(double value, const ChartAxis& axis, int more) {
  const int last = decade_of(tick_distance(axis)) - more;
  const double largest = std::max(std::abs(axis.low), std::abs(axis.high));
  if (value == 0) return "0";
  if (largest > 1e-3 && largest < 1e6) return fmt::format("{:.{}f}", value, std::max(0, -last));
  return fmt::format("{:.{}e}", value, std::max(0, decade_of(largest) - last));
}

ChartAxis axis_between(double low, double high, int more) {
  ChartAxis axis{low, high};
  const double distance = tick_distance(axis);
  for (double k = std::ceil(low / distance); k * distance <= high; ++k) {
    const double value = k * distance == 0 ? 0 : k * distance;
    axis.ticks.push_back({value, tick_label(value, axis, more)});
  }
  return axis;
}

/// The interval between the smallest and the largest of the plotted numbers.
struct PlotSpan {
  double low = INFINITY;
  double high = -INFINITY;

  [[nodiscard]] double width() const { return high - low; }
  [[nodiscard]] double largest_magnitude() const { return std::max(std::abs(low), std::abs(high)); }
  /// The margin beyond both ends. If the numbers change by noise only, the margin is much larger
  /// than the changes, so that the line looks flat.
  [[nodiscard]] double margin(double noise) const {
    if (largest_magnitude() <= noise) return noise > 0 ? 10 * noise : 1;
    return width() > std::max(smallest_change * largest_magnitude(), noise)
               ? width() / 25
               : largest_magnitude() / 10;
  }
};

/// Columns that share axes.
struct PlotPanel {
  std::string name;
  std::string unit;
  std::vector<std::size_t> columns;
};

class TrajectoryPlot {
 public:
  explicit TrajectoryPlot(const Trajectory& trajectory)
      : trajectory_(trajectory),
        time_(axis_between(trajectory.rows.front().front(), trajectory.rows.back().front(), 0)) {
    for (std::size_t i = 1; i < trajectory.columns.size(); ++i) add_column(i);
  }

  [[nodiscard]] std::string panels_svg() const {
    const double panels = panel_distance * static_cast<double>(panels_.size());
    std::string svg = svg_heading(panels - panel_distance + panel_height);
    Chart chart{left_margin, top_margin, panel_width, panel_height, time_};
    for (const PlotPanel& panel : panels_) {
      if (&panel == &panels_.back()) chart.x.title = "t [s]";
      chart.y = axis_of(panel);
      svg += panel_svg(panel, chart);
      chart.top += panel_distance;
    }
    return svg + "</svg>\n";
  }

  /// The path of the point in x and y. Both axes have the same length and are centred on the path.
  [[nodiscard]] std::string path_svg() const {
    const std::size_t column = trajectory_.columns.size() - 3;
    const PlotPanel upwards = panel_of(column + 1);
    const PlotSpan x = span_of(panel_of(column));
    const PlotSpan y = span_of(upwards);
    const PlotSpan& wide = x.width() > y.width() ? x : y;
    const double reach = wide.width() / 2 + wide.margin(0);
    const auto about = [reach](const PlotSpan& span) {
      const double middle = span.low + span.width() / 2;
      return axis_between(middle - reach, middle + reach, 0);
    };
    Chart chart{left_margin, top_margin, panel_width, panel_width, about(x), about(y)};
    chart.x.title = panel_title(panel_of(column));
    const double start_x = chart.x_of(trajectory_.rows.front()[column]);
    const double start_y = chart.y_of(trajectory_.rows.front()[column + 1]);
    return svg_heading(panel_width) + panel_svg(upwards, chart, column) +
           fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\"/>\n", start_x, start_y) +
           svg_label(start_x + 7, start_y - 7, "start", "start") + "</svg>\n";
  }

 private:
  /// The title; below it the model, the method and the number of steps.
  [[nodiscard]] std::string svg_heading(double height) const {
    const bool has_title = !trajectory_.title.empty();
    return svg_start(left_margin + panel_width + right_margin, top_margin + height + bottom_margin,
                     has_title ? trajectory_.title : trajectory_.model) +
           svg_label(14, 38, "start",
                     fmt::format("{} by {}: {} steps to t = {:.10g} s", trajectory_.model,
                                 trajectory_.method, trajectory_.steps, time_.high));
  }

  [[nodiscard]] PlotPanel panel_of(std::size_t column) const {
    return {trajectory_.columns[column].symbol, trajectory_.columns[column].unit, {column}};
  }

  void add_column(std::size_t i) {
    const TrajectoryColumn& column = trajectory_.columns[i];
    if (column.panel.empty()) return;
    if (panels_.empty() || panels_.back().name != column.panel) {
      panels_.push_back({column.panel, column.unit, {}});
    }
    panels_.back().columns.push_back(i);
  }

  [[nodiscard]] double displayed_value(const std::vector<double>& row, std::size_t column) const {
    if (!trajectory_.columns[column].is_relative_to_start) return row[column];
    const auto at = static_cast<std::size_t>(&row - trajectory_.rows.data());
    const double work = trajectory_.work.empty() ? 0 : trajectory_.work[at];
    return row[column] - trajectory_.rows.front()[column] - work;
  }

  [[nodiscard]] ChartAxis axis_of(const PlotPanel& panel) const {
    const TrajectoryColumn& first = trajectory_.columns[panel.columns.front()];
    const PlotSpan span = span_of(panel);
    const double margin = span.margin(noise_of(first));
    // In a panel of differences from the start, only tick labels show the size, so they have one
    // more digit.
    return axis_between(span.low - margin, span.high + margin, first.is_relative_to_start ? 1 : 0);
  }

  [[nodiscard]] PlotSpan span_of(const PlotPanel& panel) const {
    PlotSpan span;
    for (const auto& row : trajectory_.rows) {
      for (const std::size_t column : panel.columns) {
        span.low = std::min(span.low, displayed_value(row, column));
        span.high = std::max(span.high, displayed_value(row, column));
      }
    }
    return span;
  }

  [[nodiscard]] double noise_of(const TrajectoryColumn& column) const {
    if (column.is_relative_to_start) return rounding_fraction * trajectory_.energy.scale;
    double largest = 0;
    for (std::size_t i = 0; i < trajectory_.columns.size(); ++i) {
      const TrajectoryColumn& other = trajectory_.columns[i];
      const bool has_same_unit = other.unit == column.unit && !other.is_relative_to_start;
      if (has_same_unit) largest = std::max(largest, span_of(panel_of(i)).largest_magnitude());
    }
    return rounding_fraction * largest;
  }

  /// The title of a panel: "θ [rad]", "e: e_w solid, e_x dashed, …".
  [[nodiscard]] std::string panel_title(const PlotPanel& panel) const {
    const std::string unit = unicode_unit(panel.unit);
    std::string text = panel.name + (unit.empty() ? "" : " [" + unit + "]");
    if (panel.columns.size() == 1) return text;
    for (std::size_t k = 0; k < panel.columns.size(); ++k) {
      text += fmt::format("{} {} {}", k == 0 ? ":" : ",",
                          trajectory_.columns[panel.columns[k]].symbol, line_style(k).name);
    }
    return text;
  }

  static const LineStyle& line_style(std::size_t k) { return line_styles[k % line_styles.size()]; }

  [[nodiscard]] std::string panel_svg(const PlotPanel& panel, const Chart& chart,
                                      std::size_t x = 0) const {
    std::string svg = svg_title(left_margin, chart.top - 7, panel_title(panel)) + chart.grid();
    svg += fmt::format(
        "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#888\"/>\n",
        left_margin, chart.top, chart.width, chart.height);
    for (std::size_t k = 0; k < panel.columns.size(); ++k) {
      svg += fmt::format(
          "<path d=\"{}\" fill=\"none\" stroke=\"black\" stroke-width=\"1.2\" "
          "stroke-dasharray=\"{}\"/>\n",
          curve_path(panel.columns[k], chart, x), line_style(k).dashes);
    }
    return svg;
  }

  /// The line of a column. At a jump of more than half a turn, an angle was wrapped, so the line is
  /// interrupted.
  [[nodiscard]] std::string curve_path(std::size_t column, const Chart& chart,
                                       std::size_t x) const {
    const bool is_angle = trajectory_.columns[column].unit == "rad";
    std::string result;
    double before = trajectory_.rows.front()[column];
    for (const auto& row : trajectory_.rows) {
      const bool jumps = is_angle && std::abs(row[column] - before) > 3.15;
      result += fmt::format("{}{:.1f} {:.1f}", result.empty() || jumps ? "M" : "L",
                            chart.x_of(row[x]), chart.y_of(displayed_value(row, column)));
      before = row[column];
    }
    return result;
  }

  const Trajectory& trajectory_;
  ChartAxis time_;
  std::vector<PlotPanel> panels_ = {};
};

}  // namespace

std::string to_svg(const Trajectory& trajectory) {
  const TrajectoryPlot plot(trajectory);
  return trajectory.path.empty() ? plot.panels_svg() : plot.path_svg();
}

}  // namespace elgen
