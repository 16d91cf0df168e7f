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

/// A variable for each coefficient, and four lists: all coefficients, the third and later parts of
/// pi/2, the powers of x^2, and the lines that compute the polynomials `sine` and `cosine`.
[[nodiscard]] TemplateRow sine_data(const std::vector<SineConstant>& numbers, ScalarKind scalar,
                                    const LiteralWriter& literal, SineSpelling spelling);

/// Section `tables` of C++ headers; absent if `scalars` is empty.
[[nodiscard]] TemplateData trigonometry_tables(const Numerics& numerics, SineArithmetic arithmetic,
                                               const std::vector<ScalarKind>& scalars);

}  // namespace elgen
