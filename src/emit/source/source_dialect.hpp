// source_dialect: functions in an interpreted language, by its row of spellings.def.
#pragma once

#include <cln/real.h>

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/ascii.hpp"
#include "elgen/spellings.hpp"
#include "emit/code/dialect.hpp"

namespace elgen {

/// How a language writes a function that C has: by its row of `others`, or as C if its library has
/// the function. None if neither.
[[nodiscard]] constexpr std::optional<FunctionSpelling> function_spelling(
    const SourceSpelling& spelling, FunctionId function, std::string_view name,
    std::span<const FunctionSpelling> others = function_spelling_table) {
  for (const FunctionSpelling& other : others) {
    if (other.language == spelling.language && other.function == function) return other;
  }
  if (!has_word(spelling.functions, name)) return std::nullopt;
  return FunctionSpelling{spelling.language, function, name, FunctionHome::library};
}

/// The name of a function of the library, sqrt among them; none if the module defines it.
[[nodiscard]] std::optional<std::string_view> library_name(const SourceSpelling& spelling,
                                                           std::string_view name);

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

/// A value behind `start` at the head of a module, broken into lines.
[[nodiscard]] std::string source_value(const SourceSpelling& spelling, const std::string& start,
                                       const std::string& text);

[[nodiscard]] std::unique_ptr<Dialect> source_dialect(const Model& model, const Scene& scene,
                                                      const Program& program);

}  // namespace elgen
