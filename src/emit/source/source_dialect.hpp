// source_dialect: functions in an interpreted language, by its row of spellings.def.
#pragma once

#include <cln/real.h>

#include <memory>
#include <string>
#include <vector>

#include "elgen/spellings.hpp"
#include "emit/code/dialect.hpp"

namespace elgen {

inline constexpr CommentMarks python_marks{"# ", "# "};

/// "9.81": the nearest double.
[[nodiscard]] std::string source_literal(const cln::cl_R& value);

/// "[1.0, 2.0]", "[[1.0, 2.0], [3.0, 4.0]]": entries, or the rows of a matrix.
[[nodiscard]] std::string source_vector(const SourceSpelling& spelling,
                                        const std::vector<std::string>& entries);

[[nodiscard]] std::unique_ptr<Dialect> source_dialect(const Model& model, const Scene& scene,
                                                      const Program& program);

}  // namespace elgen
