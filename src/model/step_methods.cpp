// Orders and coefficients of composition methods. The middle coefficient is 1 minus the sum of all
// others, so that the final time is exact. Order 4: Suzuki (1990), outer coefficients
// 1/(4 - 4^(1/3)). Order 8: Kahan, Li (1997), 17 stages. Hairer, Lubich, Wanner, Geometric
// Numerical Integration, 2nd ed., sec. V.3.2.
#include "elgen/step_methods.hpp"

#include <cln/integer.h>

#include <span>

#include "numbers/exact_number.hpp"

namespace elgen {
namespace {

constexpr long decimals = 26;

/// The coefficients before the middle coefficient, in units of 10^-26.
constexpr std::array parts_of_order_4{"41449077179437573714235406", "41449077179437573714235406"};
constexpr std::array parts_of_order_8{"13020248308889008087881763",  "56116298177510838456196441",
                                      "-38947496264484728640807860", "15884190655515560089621075",
                                      "-39590389413323757733623154", "18453964097831570709183254",
                                      "25837438768632204729397911",  "29501172360931029887096624"};

struct CompositionRow {
  std::uint32_t order;
  std::span<const char* const> outer_coefficients;
};
constexpr std::array compositions{CompositionRow{4, parts_of_order_4},
                                  CompositionRow{8, parts_of_order_8}};

}  // namespace

std::vector<std::uint32_t> step_orders(std::uint32_t own) {
  std::vector<std::uint32_t> orders{own};
  if (own != 2) return orders;
  for (const CompositionRow& row : compositions) orders.push_back(row.order);
  return orders;
}

std::vector<cln::cl_RA> composition_coefficients(std::uint32_t composed_order) {
  std::vector<cln::cl_RA> parts;
  for (const CompositionRow& row : compositions) {
    if (row.order != composed_order) continue;
    for (const char* const digits : row.outer_coefficients) {
      parts.push_back(cln::cl_RA(cln::cl_I(digits)) / power_of_ten(decimals));
    }
  }
  cln::cl_RA middle = 1;
  for (const cln::cl_RA& part : parts) middle = middle - 2 * part;
  const std::vector<cln::cl_RA> first = parts;
  parts.push_back(middle);
  parts.insert(parts.end(), first.rbegin(), first.rend());
  return parts;
}

}  // namespace elgen
