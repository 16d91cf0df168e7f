// fields: what every language has to know of the fields of a function: which output they are from,
// whether they are plain numbers, and in which order their entries are stored.
#pragma once

#include <vector>

#include "elgen/program.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// True for functions that give a struct: all but those with one field without a name.
[[nodiscard]] bool gives_struct(const Function& function);

/// The row of the output table a field of `dynamics` is from; the function's own row otherwise.
[[nodiscard]] OutputKind kind_of_field(const Program& program, const Function& function,
                                       const Field& field);

/// Whether a field is one number by its nature: an energy, or a user's value of one component. The
/// gravity of one coordinate is an array of one.
[[nodiscard]] bool is_scalar(OutputKind kind, const Field& field);

/// The same of each field of a function.
[[nodiscard]] std::vector<bool> scalar_fields(const Program& program, const Function& function);

/// The function with the entries of its matrices in the order of storage; a column-major matrix
/// becomes its transpose, row by row:
///
///     2 x 3: a b c d e f   ->   3 x 2: a d b e c f
[[nodiscard]] Function stored(const Function& function, Storage storage);

/// Outputs beyond so many entries are not returned: they would not fit a stack.
inline constexpr std::size_t largest_returned = 4096;
[[nodiscard]] bool is_returned(const Function& function);

}  // namespace elgen
