// equations: the walk over a function's instructions, in the notation and the symbols it is given.
#pragma once

#include "elgen/program.hpp"
#include "elgen/render.hpp"
#include "pieces.hpp"
#include "symbols.hpp"

namespace elgen::rendering {

struct Language {
  const Notation& notation;
  Symbols symbols = {};
};

/// The entries over named definitions: see equations() in elgen/render.hpp.
[[nodiscard]] FunctionEquations equations(const Program& program, const Function& function,
                                          const Language& language);

/// Every entry written out over the leaves.
[[nodiscard]] FunctionEquations written_out(const Program& program, const Function& function,
                                            const Language& language);

/// "1/2*sqrt(2)", 9.81: an exact constant in a notation.
[[nodiscard]] Piece constant_piece(const Notation& notation, const ConstantForm& form);

}  // namespace elgen::rendering
