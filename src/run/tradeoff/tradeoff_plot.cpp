// A table as SVG: worst error over cost, both logarithmic. Each design is a mark with its number.
// The shape of the mark shows the value of the first dimension. Marks on the Pareto front are
// filled and joined by a staircase line. The legend lists the designs and explains marks and line.
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <set>

#include "elgen/tradeoff.hpp"
#include "run/chart/chart.hpp"

namespace elgen {
namespace {

constexpr double left_margin = 70;
constexpr double top_margin = 66;
constexpr double plot_width = 520;
constexpr double plot_height = 420;
constexpr double bottom_margin = 50;
constexpr double legend_left = left_margin + plot_width + 30;
constexpr double legend_width = 430;  // enough for all dimensions
constexpr double line_height = 18;
constexpr double radius = 5;

/// Outlines of marks around (0, 0), by value of the first dimension.
constexpr std::array outlines{"M-5 0A5 5 0 1 0 5 0A5 5 0 1 0 -5 0Z",
                              "M-4.5 -4.5H4.5V4.5H-4.5Z",
                              "M0 -5.5L5.5 4.5H-5.5Z",
                              "M0 -6L6 0L0 6L-6 0Z",
                              "M0 5.5L5.5 -4.5H-5.5Z",
                              "M-2 -6H2V6H-2Z"};

/// A log10 axis without ticks, from the power of ten below the smallest number to the power of ten
/// above the largest number. 0 and infinity are ignored here, and drawn at the ends of the axis.
ChartAxis log_axis_around(const std::vector<double>& numbers) {
  double low = INFINITY;
  double high = -INFINITY;
  for (const double number : numbers) {
    if (!(number > 0 && std::isfinite(number))) continue;
    low = std::min(low, std::log10(number));
    high = std::max(high, std::log10(number));
  }
  if (low > high) return {};
  low = std::floor(low);
  return {low, std::max(std::ceil(high), low + 1)};
}

ChartAxis axis_of_costs(const std::vector<double>& costs) {
  ChartAxis axis = log_axis_around(costs);
  const bool is_narrow = axis.high - axis.low <= 2;
  for (double k = axis.low; k <= axis.high; ++k) {
    for (const int factor : {1, 2, 5}) {
      if (factor > 1 && (k == axis.high || !is_narrow)) break;
      axis.ticks.push_back(
          {k + std::log10(factor), fmt::format("{:g}", factor * std::pow(10.0, k))});
    }
  }
  return axis;
}

ChartAxis axis_of_errors(const std::vector<double>& errors) {
  ChartAxis axis = log_axis_around(errors);
  const double distance = 1 + std::floor((axis.high - axis.low) / 12);
  for (double k = axis.low; k <= axis.high; k += distance) {
    axis.ticks.push_back({k, fmt::format("1e{:g}", k)});
  }
  return axis;
}

class TradeoffPlot {
 public:
  explicit TradeoffPlot(const TradeoffTable& table) : table_(table) {
    for (const TradeoffRow& row : table.rows) {
      if (row.failure.empty()) rows_.push_back(&row);
    }
    std::vector<double> costs;
    std::vector<double> errors;
    for (const TradeoffRow* row : rows_) {
      costs.push_back(row->cost.least);
      errors.push_back(row->error.worst);
    }
    chart_ = {left_margin, top_margin,           plot_width,
              plot_height, axis_of_costs(costs), axis_of_errors(errors)};
    chart_.x.title = fmt::format("cost [{}]", table.cost);
  }

  [[nodiscard]] std::string to_svg_text() const {
    std::string svg =
        svg_start(legend_left + legend_width,
                  std::max(top_margin + plot_height + bottom_margin, legend_y(rows_.size() + 5)),
                  fmt::format("{}, {}: {}", table_.model, table_.subject, table_.error));
    svg += chart_.grid() + svg_label(14, top_margin - 14, "start", "worst error, relative") +
           pareto_front_svg() + legend_svg();
    // In reverse order, because rows on the front come first among equal costs: drawn last, they
    // are not covered.
    for (std::size_t i = rows_.size(); i-- > 0;) {
      const TradeoffRow& row = *rows_[i];
      svg += mark_svg(row, x_of(row), y_of(row)) + mark_number_svg(i);
    }
    return svg + "</svg>\n";
  }

 private:
  [[nodiscard]] double x_of(const TradeoffRow& row) const {
    return chart_.x_of(std::log10(row.cost.least));
  }
  /// The y of a mark; the bottom of the chart if the error is 0.
  [[nodiscard]] double y_of(const TradeoffRow& row) const {
    return chart_.y_of(std::log10(row.error.worst));
  }

  /// The front as a staircase line: costs increase along the line, and errors decrease. Between two
  /// costs, the line has the error of the cheaper design.
  [[nodiscard]] std::string pareto_front_svg() const {
    std::string path;
    for (const TradeoffRow* row : rows_) {
      if (!row->is_on_pareto_front) continue;
      path += fmt::format("{}{:.1f}{}{:.1f}", path.empty() ? "M" : "H", x_of(*row),
                          path.empty() ? " " : "V", y_of(*row));
    }
    return fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"#888\"/>\n", path);
  }

  [[nodiscard]] std::string mark_svg(const TradeoffRow& row, double x, double y) const {
    const char* const fill = row.is_on_pareto_front   ? "black"
                             : row.is_below_reference ? "#bbb"
                                                      : "white";
    return fmt::format(
        "<path d=\"{}\" transform=\"translate({:.1f} {:.1f})\" fill=\"{}\" stroke=\"black\"/>\n",
        outline_of(row), x, y, fill);
  }

  [[nodiscard]] const char* outline_of(const TradeoffRow& row) const {
    if (row.values.empty()) return outlines.front();
    std::set<std::string> values;
    for (const TradeoffRow* other : rows_) values.insert(other->values.front());
    const auto at = std::distance(values.begin(), values.find(row.values.front()));
    return outlines[static_cast<std::size_t>(at) % outlines.size()];
  }

  /// The number of mark i, at the upper left or the lower right in turn, because marks with similar
  /// costs are often close. The line of the Pareto front touches neither place.
  [[nodiscard]] std::string mark_number_svg(std::size_t i) const {
    const bool is_left = i % 2 == 0;
    return svg_label(x_of(*rows_[i]) + (is_left ? -radius : radius),
                     y_of(*rows_[i]) + (is_left ? -radius : radius + 9), is_left ? "end" : "start",
                     std::to_string(i + 1));
  }

  [[nodiscard]] static double legend_y(std::size_t line) {
    return top_margin + line_height * (static_cast<double>(line) + 0.5);
  }

  /// Lists dimensions and designs, and explains the marks and the line.
  [[nodiscard]] std::string legend_svg() const {
    std::string svg = svg_title(legend_left + 14, legend_y(0) + 4,
                                fmt::format("{}", fmt::join(table_.dimensions, ", ")));
    std::size_t line = 1;
    for (; line <= rows_.size(); ++line) svg += legend_line(line);
    std::vector<std::string> notes{"black: the front; no cheaper design is as accurate",
                                   "line: error of the front at each cost"};
    if (std::ranges::any_of(table_.rows, &TradeoffRow::is_below_reference)) {
      notes.emplace_back("grey: error too small for the reference, not on the front");
    }
    for (const std::string& note : notes) {
      svg += svg_label(legend_left + 14, legend_y(++line), "start", note);
    }
    return svg;
  }

  [[nodiscard]] std::string legend_line(std::size_t line) const {
    const TradeoffRow& row = *rows_[line - 1];
    std::vector<std::string> values = row.values;
    std::replace(values.begin(), values.end(), std::string("one"),
                 std::string("one state at a time"));
    return mark_svg(row, legend_left, legend_y(line)) +
           svg_label(legend_left + 14, legend_y(line) + 4, "start",
                     fmt::format("{}  {}", line, fmt::join(values, ", ")));
  }

  const TradeoffTable& table_;
  std::vector<const TradeoffRow*> rows_ = {};
  Chart chart_ = {};
};

}  // namespace

std::string to_svg(const TradeoffTable& table) { return TradeoffPlot(table).to_svg_text(); }

}  // namespace elgen
