// Decimal numbers: reads the text of a number as an exact rational, never through a double.
#pragma once

#include <cln/rational.h>

#include <optional>
#include <string>
#include <string_view>

#include "elgen/diagnostic.hpp"
#include "elgen/limits.hpp"

namespace elgen {

/// How far the number that starts at a position goes, and whether it is one.
struct NumberExtent {
  std::size_t end = 0;
  bool well_formed = true;
};

/// The number at `begin`, where a digit or a point stands: `12`, `0.5`, `1e-3`. Characters that
/// follow without a separator and cannot follow a number (`1.2.3`, `1_000`, `0x10`, `1e`) make it
/// malformed.
[[nodiscard]] NumberExtent number_extent(std::string_view text, std::size_t begin);

/// The limit that a number exceeds: the code (E903, E904), the message, how to raise the limit.
struct LimitHit {
  Code code;
  std::string message;
  std::string hint;
};

/// Digits, a fraction, an exponent; read before any big arithmetic is done.
struct DecimalParts {
  std::string digits;        ///< of integer part and fraction, without leading zeros
  std::size_t fraction = 0;  ///< how many of them follow the point
  std::string exponent;      ///< its digits, without leading zeros
  bool negative_exponent = false;
};

/// `text` is a well-formed number without a sign; underscores are skipped.
[[nodiscard]] DecimalParts decimal_parts(std::string_view text);

[[nodiscard]] std::optional<LimitHit> limit_hit(const DecimalParts& parts, const Limits& limits);

/// The value of parts within the limits.
[[nodiscard]] cln::cl_RA decimal_value(const DecimalParts& parts);

/// The shortest literal of a finite decimal: `0.1`, `1e-400`, `-5`. A number that is none, such as
/// 1/3, as a quotient.
[[nodiscard]] std::string decimal_text(const cln::cl_RA& value);

}  // namespace elgen
