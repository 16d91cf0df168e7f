// Constraint: the hint to replace `coincide` by only the equations that have an effect.
#include "elgen/constraint.hpp"

#include <fmt/ranges.h>

#include <algorithm>

namespace elgen {
namespace {

/// The index "[3]" in the name of a row of a repeated entry; "" if the entry is not repeated.
std::string index_suffix(const Constraint& row) {
  return row.name.substr(std::min(row.name.find('['), row.name.size()));
}

}  // namespace

std::string equation_hint(const std::vector<Constraint>& rows, const std::vector<bool>& is_vacuous,
                          const Constraint& row) {
  std::vector<std::string> equations;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const bool is_part = rows[k].equation_span.begin == row.equation_span.begin &&
                         index_suffix(rows[k]) == index_suffix(row);
    if (!is_part || is_vacuous[k] || rows[k].equality.empty()) continue;
    equations.push_back("\"" + rows[k].equality + "\"");
  }
  if (equations.empty()) return {};
  return fmt::format("`equation = [{}]` is enough", fmt::join(equations, ", "));
}

}  // namespace elgen
