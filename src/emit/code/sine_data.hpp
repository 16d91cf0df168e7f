// sine_data: the coefficients of in-line sines -> data of the templates trigonometry.hpp.mustache
// and sine_cosine.h.mustache.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "emit/code/header_data.hpp"
#include "program/evaluate/sines.hpp"

namespace elgen {

/// A template writes a coefficient by its name or by its value.
enum class SineSpelling : std::uint8_t { names, values };

/// Writes a number as a literal of the scalar type.
using LiteralWriter = std::function<std::string(double)>;

/// sine_constants(), and lone_sine_constants() if the code has lone sines.
struct SineNumbers {
  std::vector<SineConstant> joint = {};
  std::vector<SineConstant> lone = {};
};

/// A variable for each coefficient, and four lists: all coefficients, the third and later parts of
/// pi/2, the powers of x^2, and the lines that compute the polynomials `sine` and `cosine`. The
/// section `lone` has the lists of lone sines; absent without these.
[[nodiscard]] TemplateRow sine_data(const SineNumbers& numbers, ScalarKind scalar,
                                    const LiteralWriter& literal, SineSpelling spelling);

/// Section `tables` of C++ headers; absent if `scalars` is empty.
[[nodiscard]] TemplateData trigonometry_tables(
    const std::vector<ScalarKind>& scalars,
    const std::function<SineNumbers(ScalarKind)>& numbers_of);

}  // namespace elgen
