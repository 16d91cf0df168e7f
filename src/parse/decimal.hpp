// Decimal numbers: reads the text of a number as an exact rational, never through a double.
#pragma once

#include <cln/rational.h>

#include <optional>
#include <string>
#include <string_view>

#include "elgen/diagnostic.hpp"
#include "elgen/limits.hpp"

namespace elgen {

/// The end of the number that starts at a position, and whether the number is well-formed.
struct NumberExtent {
  std::size_t end = 0;
  bool well_formed = true;
};

/// The extent of the number at `begin`, a digit or a point: `12`, `0.5`, `1e-3`. The number is
/// malformed if a character that cannot follow a number follows directly: `1.2.3`, `1_000`, `0x10`,
/// `1e`.
[[nodiscard]] NumberExtent number_extent(std::string_view text, std::size_t begin);

/// The error for a number beyond a limit: the code (E903, E904), the message, and how to raise the
/// limit.
struct ExceededLimit {
  Code code;
  std::string message;
  std::string hint;
};

/// Digits, fraction and exponent of a number, before any big-integer arithmetic.
struct DecimalParts {
  std::string digits;               ///< of integer part and fraction, without leading zeros
  std::size_t fraction_digits = 0;  ///< number of `digits` after the point
  std::string exponent;             ///< without leading zeros
  bool negative_exponent = false;
};

/// The parts of `text`, a well-formed number; a leading sign and underscores are skipped.
[[nodiscard]] DecimalParts decimal_parts(std::string_view text);

[[nodiscard]] std::optional<ExceededLimit> find_exceeded_limit(const DecimalParts& parts,
                                                               const Limits& limits);

/// The value of a number within the limits.
[[nodiscard]] cln::cl_RA decimal_value(const DecimalParts& parts);

/// `value` as an exact literal if it is a finite decimal: `0.1`, `-5`, and `1e-400` beyond 30
/// places. Any other number, such as 1/3, as a quotient.
[[nodiscard]] std::string decimal_text(const cln::cl_RA& value);

}  // namespace elgen
