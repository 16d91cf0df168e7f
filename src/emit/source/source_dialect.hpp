// source_dialect: functions in an interpreted language, by its row of spellings.def.
#pragma once

#include <cln/real.h>

#include <memory>
#include <string>
#include <vector>

#include "elgen/spellings.hpp"
#include "emit/code/dialect.hpp"

namespace elgen {

/// "9.81": the nearest double.
[[nodiscard]] std::string source_literal(const cln::cl_R& value);

/// "\"kg\"": a text on one line, which ends neither its quotes nor a script of a page.
[[nodiscard]] std::string source_text(const SourceSpelling& spelling, std::string_view text);

/// "[1.0, 2.0]", "[[1.0, 2.0], [3.0, 4.0]]": values, or the rows of a matrix of so many columns.
[[nodiscard]] std::string source_list(const ListSpelling& list,
                                      const std::vector<std::string>& values,
                                      std::size_t columns = 1);

/// A statement in lines that the language continues.
[[nodiscard]] std::string source_lines(const SourceSpelling& spelling, const std::string& text,
                                       Wrapping wrapping);

/// What stands behind `start` at the head of a module, in lines.
[[nodiscard]] std::string source_value(const SourceSpelling& spelling, const std::string& start,
                                       const std::string& text);

[[nodiscard]] std::unique_ptr<Dialect> source_dialect(const Model& model, const Scene& scene,
                                                      const Program& program);

}  // namespace elgen
