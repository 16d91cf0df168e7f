// literal: floating literals of C and C++, exactly, and whether they are what a number rounds to.
//
//     0.1F   ->   1/10 with the suffix F, the float nearest to 1/10
#pragma once

#include <cln/rational.h>
#include <cln/real.h>

#include <optional>
#include <string_view>

#include "elgen/scene.hpp"

namespace elgen {

struct Literal {
  cln::cl_RA value = 0;
  char suffix = '\0';
};

/// None for what is no decimal floating literal: `2`, `0x1p3`, `1.5e`.
[[nodiscard]] std::optional<Literal> read_literal(std::string_view text);

/// Whether a compiler makes of both the same number. Of `long double`, whose width is the
/// compiler's affair, 40 digits have to be right.
[[nodiscard]] bool rounds_alike(const cln::cl_R& written, const cln::cl_R& value,
                                ScalarKind scalar);

/// The exact value of what a compiler makes of it in `float` or `double`.
[[nodiscard]] cln::cl_R rounded(const cln::cl_R& value, ScalarKind scalar);

}  // namespace elgen
