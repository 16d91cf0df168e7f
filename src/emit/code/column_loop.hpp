// column_loop: the repetitions of a Function as a loop over columns.
//
//     3 = multiply 0 1   4 = multiply 0 2   repeated 1 2
//
//     given[0] = b;  given[1] = c;
//     for (…) store(a * load(given + at), solved + at);          3 is solved[0], 4 is solved[1]
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "elgen/program.hpp"
#include "emit/code/compiled_dialect.hpp"

namespace elgen {

struct ColumnLoop {
  std::uint32_t first = 0;  ///< instruction that is repeated
  std::uint32_t count = 0;  ///< of columns; 0 where nothing is repeated
  /// The operands that are not the same in all columns, row-major.
  std::vector<std::uint32_t> given = {};
  /// The instructions of the first column that are read behind the loop.
  std::vector<std::uint32_t> solved = {};
  /// The operands that are the same in all columns, each once.
  std::vector<std::uint32_t> shared = {};
};

[[nodiscard]] ColumnLoop column_loop(const Function& function);

/// The name of an instruction behind the loop, "" where it is not read: "solved[3]".
[[nodiscard]] std::string solved_name(const ColumnLoop& loop, const Function& function,
                                      std::uint32_t at);

/// The names in the loop: of the instructions before it and of the first column; of the arrays, as
/// the function has them or its parts share them.
struct ColumnNames {
  std::vector<std::string> values = {};
  std::string given = "given";
  std::string solved = "solved";
};

/// The lines of the loop.
[[nodiscard]] std::string column_lines(const CompiledDialect& dialect, const Program& program,
                                       const Function& function, const ColumnLoop& loop,
                                       const ColumnNames& names);

}  // namespace elgen
