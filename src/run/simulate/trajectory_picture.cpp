// A trajectory as SVG: a panel for each coordinate, each input and E - E0 - work, one black line in
// each, so that it reads in print too; the four components of a rotation share a panel, in four
// kinds of line. Of E only the difference is drawn: beside E itself a drift of 1e-9 J could not be
// seen.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/svg.hpp"
#include "elgen/simulate.hpp"

namespace elgen {
namespace {

constexpr double left = 92;
constexpr double panel_width = 620;
constexpr double panel_height = 110;
constexpr double panel_distance = 138;
constexpr double top = 60;
constexpr double bottom = 46;
constexpr double right = 20;

struct LineKind {
  const char* name;
  const char* dashes;
};
constexpr std::array line_kinds{LineKind{"solid", "none"}, LineKind{"dashed", "9 4"},
                                LineKind{"dotted", "2 3"}, LineKind{"dash-dotted", "9 3 2 3"}};

struct AxisRange {
  double low = 0;
  double high = 0;
};

/// 1, 2 or 5 times a power of ten, so that three to seven of them fill the range.
double tick_distance(const AxisRange& range) {
  const double rough = (range.high - range.low) / 3;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double factor : {5.0, 2.0}) {
    if (factor * power <= rough) return factor * power;
  }
  return power;
}

std::vector<double> ticks(const AxisRange& range) {
  const double distance = tick_distance(range);
  std::vector<double> result;
  for (double k = std::ceil(range.low / distance); k * distance <= range.high; ++k) {
    result.push_back(k * distance == 0 ? 0 : k * distance);
  }
  return result;
}

int decade_of(double number) { return static_cast<int>(std::floor(std::log10(number))); }

/// In as many digits as tell the ticks of a range apart, and `more`.
std::string tick_label(double value, const AxisRange& range, int more) {
  const int last = decade_of(tick_distance(range)) - more;
  const double largest = std::max(std::abs(range.low), std::abs(range.high));
  if (value == 0) return "0";
  if (largest > 1e-3 && largest < 1e6) return fmt::format("{:.{}f}", value, std::max(0, -last));
  return fmt::format("{:.{}e}", value, std::max(0, decade_of(largest) - last));
}

/// Columns that share axes.
struct PicturePanel {
  std::string name;
  std::string unit;
  std::vector<std::size_t> columns;
};

class TrajectoryPicture {
 public:
  explicit TrajectoryPicture(const Trajectory& trajectory)
      : trajectory_(trajectory),
        time_{trajectory.rows.front().front(), trajectory.rows.back().front()} {
    for (std::size_t i = 1; i < trajectory.columns.size(); ++i) add_column(i);
  }

  [[nodiscard]] std::string text() const {
    const double panels = panel_distance * static_cast<double>(panels_.size());
    std::string svg =
        svg_start(left + panel_width + right, top + panels - panel_distance + panel_height + bottom,
                  fmt::format("{} by {}: {} steps to t = {:.10g} s", trajectory_.model,
                              trajectory_.method, trajectory_.steps, time_.high));
    double y = top;
    for (const PicturePanel& panel : panels_) {
      svg += drawn(panel, y);
      y += panel_distance;
    }
    return svg + time_axis(y - panel_distance + panel_height) + "</svg>\n";
  }

 private:
  void add_column(std::size_t i) {
    const TrajectoryColumn& column = trajectory_.columns[i];
    if (column.panel.empty()) return;
    if (panels_.empty() || panels_.back().name != column.panel) {
      panels_.push_back({column.panel, column.unit, {}});
    }
    panels_.back().columns.push_back(i);
  }

  [[nodiscard]] double shown(const std::vector<double>& row, std::size_t column) const {
    if (!trajectory_.columns[column].from_start) return row[column];
    const auto at = static_cast<std::size_t>(&row - trajectory_.rows.data());
    const double work = trajectory_.work.empty() ? 0 : trajectory_.work[at];
    return row[column] - trajectory_.rows.front()[column] - work;
  }

  /// With a margin; what does not move is a line in the middle.
  [[nodiscard]] AxisRange range_of(const PicturePanel& panel) const {
    AxisRange range{INFINITY, -INFINITY};
    for (const auto& row : trajectory_.rows) {
      for (const std::size_t column : panel.columns) {
        range.low = std::min(range.low, shown(row, column));
        range.high = std::max(range.high, shown(row, column));
      }
    }
    const double width = range.high - range.low;
    const double size = std::max(std::abs(range.low), std::abs(range.high));
    const double margin = width > 1e-9 * size ? width / 25 : size > 0 ? size / 10 : 1;
    return {range.low - margin, range.high + margin};
  }

  /// "theta [rad]"; "e: e_w solid, e_x dashed, …"
  [[nodiscard]] std::string title(const PicturePanel& panel) const {
    std::string text = panel.name + (panel.unit.empty() ? "" : " [" + panel.unit + "]");
    if (panel.columns.size() == 1) return text;
    for (std::size_t k = 0; k < panel.columns.size(); ++k) {
      text += fmt::format("{} {} {}", k == 0 ? ":" : ",",
                          trajectory_.columns[panel.columns[k]].name, kind_of(k).name);
    }
    return text;
  }

  static const LineKind& kind_of(std::size_t k) { return line_kinds[k % line_kinds.size()]; }

  [[nodiscard]] double x_of(double t) const {
    return left + panel_width * (t - time_.low) / (time_.high - time_.low);
  }

  [[nodiscard]] std::string drawn(const PicturePanel& panel, double y) const {
    const AxisRange range = range_of(panel);
    const auto y_of = [&](double value) {
      return y + panel_height * (range.high - value) / (range.high - range.low);
    };
    // A difference is looked at for its size, of which the ticks alone say one digit.
    const int more = trajectory_.columns[panel.columns.front()].from_start ? 1 : 0;
    std::string svg = svg_title(left, y - 7, title(panel));
    for (const double value : ticks(range)) {
      svg += svg_grid_line(left, y_of(value), left + panel_width, y_of(value));
      svg += svg_label(left - 6, y_of(value) + 4, "end", tick_label(value, range, more));
    }
    for (const double t : ticks(time_)) svg += svg_grid_line(x_of(t), y, x_of(t), y + panel_height);
    svg += fmt::format(
        "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#888\"/>\n",
        left, y, panel_width, panel_height);
    for (std::size_t k = 0; k < panel.columns.size(); ++k) {
      svg += fmt::format(
          "<path d=\"{}\" fill=\"none\" stroke=\"black\" stroke-width=\"1.2\" "
          "stroke-dasharray=\"{}\"/>\n",
          path(panel.columns[k], y_of), kind_of(k).dashes);
    }
    return svg;
  }

  /// An angle that wraps jumps by more than half a turn; the line is interrupted there.
  template <class YOf>
  [[nodiscard]] std::string path(std::size_t column, const YOf& y_of) const {
    const bool is_angle = trajectory_.columns[column].unit == "rad";
    std::string result;
    double before = trajectory_.rows.front()[column];
    for (const auto& row : trajectory_.rows) {
      const bool jumps = is_angle && std::abs(row[column] - before) > 3.15;
      result += fmt::format("{}{:.1f} {:.1f}", result.empty() || jumps ? "M" : "L", x_of(row[0]),
                            y_of(shown(row, column)));
      before = row[column];
    }
    return result;
  }

  [[nodiscard]] std::string time_axis(double y) const {
    std::string svg = svg_label(left + panel_width / 2, y + 34, "middle", "t [s]");
    for (const double t : ticks(time_)) {
      svg += svg_label(x_of(t), y + 16, "middle", tick_label(t, time_, 0));
    }
    return svg;
  }

  const Trajectory& trajectory_;
  AxisRange time_;
  std::vector<PicturePanel> panels_ = {};
};

}  // namespace

std::string to_svg(const Trajectory& trajectory) { return TrajectoryPicture(trajectory).text(); }

}  // namespace elgen
