// SourceSpelling: how an interpreted language writes code, and how it is run (spellings.def).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "elgen/scene.hpp"

namespace elgen {

struct SourceSpelling {
  LanguageId language;
  std::string_view element;
  std::uint32_t first_index;
  std::string_view definition;
  std::string_view end_of_definition;  ///< a line below the statements; may be empty
  std::size_t indent;                  ///< of statements
  std::string_view result;             ///< before the value that a function gives
  std::string_view field;              ///< before one of several, {0}; empty: one call makes all
  std::string_view opening;            ///< around a value of several lines
  std::string_view closing;
  std::string_view end;          ///< of a statement
  std::string_view end_of_line;  ///< of a line that the next one continues
  std::string_view vector;       ///< {}: the entries; of matrices, the rows
  std::string_view between_entries;
  std::string_view matrix_row;
  std::string_view between_rows;
  std::string_view own_function;  ///< of what the module has where its library has none
  std::string_view absolute;      ///< |x| of a number
  std::string_view unbounded;     ///< an infinite number
  std::size_t deepest;            ///< brackets in brackets that it reads
  std::size_t longest_name;       ///< 0: any
  std::string_view reserved;      ///< words that are no names, between spaces: `_` is appended
  std::string_view taken;         ///< names that the module needs
  std::string_view unnameable;    ///< names that no module may have
  std::string_view command;       ///< starts its interpreter
  std::string_view variable;      ///< of the environment, which has another command
  /// Functions that the interpreter has code of its own for, and the error of a field that calls
  /// one, in u of its largest entry; `roundings`: that of any other.
  std::string_view own_implementations;
  int roundings;
};

inline constexpr std::array spelling_table{
#define ELGEN_SPELLING(id, ...) SourceSpelling{.language = LanguageId::id, __VA_ARGS__},
#include "elgen/spellings.def"
#undef ELGEN_SPELLING
};

/// Of a language that is interpreted.
[[nodiscard]] constexpr const SourceSpelling& source_spelling(LanguageId language) {
  std::size_t at = 0;
  while (spelling_table[at].language != language) ++at;
  return spelling_table[at];
}

}  // namespace elgen
