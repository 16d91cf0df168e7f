// operation_table: the rows that say what each function executes, compared with a count.
//
//     mass_matrix        1      3     0     0      1     0            3  closed
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "readback/dialect.hpp"

namespace elgen {

/// A line, and what is wrong with it.
struct WrongLine {
  std::string_view line = {};
  std::string problem = {};
};

/// Looks at the lines behind the heading, without what stands before `function`. No line where all
/// are right.
[[nodiscard]] WrongLine wrong_operations(const Program& program,
                                         const std::vector<std::string_view>& lines);

}  // namespace elgen
