// Constraint: what remains of points that coincide if some of their components are equal anyway.
#include "elgen/constraint.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>

namespace elgen {
namespace {

/// The names in the list of `coincide`, without their quotes: `["P[i]", "Q"]`.
std::vector<std::string> listed_points(std::string_view list) {
  std::vector<std::string> names;
  if (!list.starts_with('[')) return names;
  for (std::size_t at = list.find_first_of("\"'"); at != list.npos;) {
    const std::size_t end = std::min(list.find(list[at], at + 1), list.size());
    names.emplace_back(list.substr(at + 1, end - at - 1));
    at = list.find_first_of("\"'", end + 1);
  }
  return names;
}

/// "[3]" of a repeated entry, or nothing.
std::string index_of(const Constraint& row) {
  return row.name.substr(std::min(row.name.find('['), row.name.size()));
}

}  // namespace

std::string equations_instead(const std::vector<Constraint>& rows, const std::vector<bool>& without,
                              const Constraint& row) {
  const std::vector<std::string> points = listed_points(covered_text(row.equation_span));
  std::vector<std::string> equations;
  for (std::size_t k = 0; k < rows.size() && points.size() == 2; ++k) {
    const std::string index = index_of(rows[k]);
    const bool is_part =
        rows[k].equation_span.begin == row.equation_span.begin && index == index_of(row);
    if (!is_part || without[k]) continue;
    const char axis = rows[k].name[rows[k].name.size() - index.size() - 1];  // of "loop_x[3]"
    equations.push_back(fmt::format("\"{0}({1}) = {0}({2})\"", axis, points[0], points[1]));
  }
  if (equations.empty()) return {};
  return fmt::format("`equation = [{}]` is enough", fmt::join(equations, ", "));
}

}  // namespace elgen
