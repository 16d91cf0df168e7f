// operation_columns: what OperationCounts counts, by name, in the order in which it is listed.
#pragma once

#include <array>
#include <string_view>

#include "elgen/program.hpp"

namespace elgen {

struct OperationColumn {
  std::string_view name;
  std::size_t OperationCounts::*count;
};

inline constexpr std::array operation_columns{OperationColumn{"add", &OperationCounts::add},
                                              OperationColumn{"mul", &OperationCounts::mul},
                                              OperationColumn{"div", &OperationCounts::div},
                                              OperationColumn{"sqrt", &OperationCounts::sqrt},
                                              OperationColumn{"sincos", &OperationCounts::sincos},
                                              OperationColumn{"other", &OperationCounts::other}};

}  // namespace elgen
