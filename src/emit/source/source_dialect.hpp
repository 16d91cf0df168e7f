// source_dialect: functions in an interpreted language, according to its row of spellings.def.
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

/// The spelling of `function` in a language: the row of `function` in `others`. Without a row: the
/// C name `name` if the library of the language has this name, otherwise none.
[[nodiscard]] constexpr std::optional<FunctionSpelling> function_spelling(
    const SourceSpelling& spelling, FunctionId function, std::string_view name,
    std::span<const FunctionSpelling> others = function_spelling_table) {
  for (const FunctionSpelling& other : others) {
    if (other.language == spelling.language && other.function == function) return other;
  }
  if (!has_word(spelling.functions, name)) return std::nullopt;
  return FunctionSpelling{spelling.language, function, name, FunctionProvider::library};
}

/// The name of a library function or of sqrt; none if the module defines the function itself.
[[nodiscard]] std::optional<std::string_view> library_function_spelling(
    const SourceSpelling& spelling, std::string_view name);

/// "9.81": a literal of the nearest double.
[[nodiscard]] std::string source_literal(const cln::cl_R& value);

/// "\"kg\"": a quoted text on one line; its content can end neither the quotes nor a script of a
/// page.
[[nodiscard]] std::string source_string_literal(const SourceSpelling& spelling,
                                                std::string_view text);

/// "[1.0, 2.0]", "[[1.0, 2.0], [3.0, 4.0]]": a list of values, or of the rows of a matrix with
/// `columns` columns.
[[nodiscard]] std::string source_list(const ListSpelling& list,
                                      const std::vector<std::string>& values,
                                      std::size_t columns = 1);

/// A statement, wrapped with the line continuation of the language.
[[nodiscard]] std::string wrap_source_statement(const SourceSpelling& spelling,
                                                const std::string& text, Wrapping wrapping);

/// A value that follows `start` at the head of a module, wrapped.
[[nodiscard]] std::string wrap_source_value(const SourceSpelling& spelling,
                                            const std::string& start, const std::string& text);

[[nodiscard]] std::unique_ptr<Dialect> source_dialect(const Model& model, const Scene& scene,
                                                      const Program& program);

}  // namespace elgen
