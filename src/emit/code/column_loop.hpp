// column_loop: writes the repetitions of a Function as a loop; each repetition is a column.
//
//     3 = multiply 0 1   4 = multiply 0 2   repeated 1 2
//
//     given[0] = b;  given[1] = c;
//     for (…) store(a * load(given + at), solved + at);          3 is solved[0], 4 is solved[1]
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "elgen/program.hpp"
#include "emit/code/dialect.hpp"

namespace elgen {

struct ColumnLoop {
  std::uint32_t first = 0;  ///< the first repeated instruction
  std::uint32_t count = 0;  ///< number of columns; 0 if the function repeats nothing
  /// Operands that are computed before the loop and differ between columns: a row per operand, an
  /// entry per column.
  std::vector<std::uint32_t> varying_operands = {};
  /// Instructions of the first column that compute an entry of the result, either themselves or by
  /// their repetition in another column.
  std::vector<std::uint32_t> stored_instructions = {};
  /// Operands that are computed before the loop and are the same in all columns, without
  /// duplicates.
  std::vector<std::uint32_t> invariant_operands = {};
};

[[nodiscard]] ColumnLoop column_loop(const Function& function);

/// The index in `solved` at which code after the loop reads the value of instruction `at`; none if
/// the loop does not store this value.
[[nodiscard]] std::optional<std::size_t> solved_index(const ColumnLoop& loop,
                                                      const Function& function, std::uint32_t at);

/// Names that the loop body uses. `values`: names of the instructions before the loop and of the
/// first column. `given`, `solved`: the arrays, which a function in parts keeps in its workspace.
struct ColumnLoopNames {
  std::vector<std::string> values = {};
  std::string given = "given";
  std::string solved = "solved";
};

[[nodiscard]] std::string column_loop_text(const Dialect& dialect, const Program& program,
                                           const Function& function, const ColumnLoop& loop,
                                           const ColumnLoopNames& names);

}  // namespace elgen
