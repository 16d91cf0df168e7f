// literal: the decimal of the model where it is short enough to read, else the shortest one that
// rounds to the same number.
#include "literal.hpp"

#include <cln/integer.h>

#include "evaluate/decimal.hpp"

namespace elgen {

std::string scalar_literal(const cln::cl_R& value, ScalarKind scalar) {
  constexpr std::size_t readable_digits = 17;  // as many as a double has
  const std::optional<Decimal> decimal = exact_decimal(value);
  const bool is_readable =
      decimal && integer_text(cln::abs(decimal->significand)).size() <= readable_digits;
  return is_readable ? literal_text(*decimal) : shortest_literal(value, scalar);
}

}  // namespace elgen
