// sine_data: the numbers of sines in line -> the values of the holes of the templates
// trigonometry.hpp.mustache and sine_cosine.h.mustache.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "emit/code/header_data.hpp"
#include "program/evaluate/sines.hpp"

namespace elgen {

/// Where a template has a number: by its name, or by its value.
enum class SineSpelling : std::uint8_t { names, values };

/// How a language writes a number of the scalar.
using SineLiteral = std::function<std::string(double)>;

/// One hole for each number; lists of the later parts of pi/2, of powers of x^2, and of the lines
/// that compute the polynomials `sine` and `cosine`.
[[nodiscard]] TemplateRow sine_data(const std::vector<SineNumber>& numbers, ScalarKind scalar,
                                    const SineLiteral& literal, SineSpelling spelling);

/// The section `tables` of C++ headers: there where scalars have one.
[[nodiscard]] TemplateData trigonometry_tables(const Numerics& numerics, SinesOf arithmetic,
                                               const std::vector<ScalarKind>& scalars);

}  // namespace elgen
