// SourceSpelling: how an interpreted language writes code, and how it is run (spellings.def).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "elgen/functions.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// How several values are one.
struct ListSpelling {
  std::string_view opening;
  std::string_view between;
  std::string_view closing;
  std::string_view behind_one;  ///< of one value alone
  std::string_view empty;       ///< {0}: columns
};

struct SourceSpelling {
  LanguageId language;
  std::string_view element;
  std::uint32_t first_index;
  std::string_view definition;
  std::size_t indent;          ///< of statements
  std::string_view local;      ///< before a name that gets its value
  std::string_view library;    ///< a function {0} of the library
  std::string_view functions;  ///< of numbers, between spaces: those of C that the library has
  std::string_view result;     ///< before the value that a function gives
  std::string_view results;  ///< several values {1} in a struct {0}; empty: a statement gives each
  std::string_view field;    ///< before one of them, {0}
  std::string_view opening;  ///< around a value of several lines
  std::string_view closing;
  std::string_view end;          ///< of a statement
  std::string_view end_of_line;  ///< of a line that the next one continues
  ListSpelling vector;
  ListSpelling row;     ///< of a matrix
  ListSpelling matrix;  ///< of rows
  ListSpelling texts;   ///< at the head of the module, as those that follow
  ListSpelling numbers;
  ListSpelling intervals;
  std::string_view interval;         ///< {0}, {1}: its bounds
  std::string_view number_value;     ///< of a parameter: {0} is the name
  std::string_view array_value;      ///< of a parameter that is one
  std::string_view end_of_value;     ///< of a parameter
  std::string_view number_member;    ///< of a struct of results, in documentation
  std::string_view array_member;     ///< of it
  std::string_view comment;          ///< before a comment behind a parameter
  std::string_view member_comment;   ///< before what a member is
  char quote;                        ///< around texts
  char escape;                       ///< before it, and before itself
  std::string_view coded_in_texts;   ///< is written \u003c: it would be markup of a page
  std::string_view escaped_in_docs;  ///< by a backslash
  std::string_view end_of_docs;      ///< is parted by a blank in them
  std::string_view own_function;     ///< of what the module has where its library has none
  std::string_view named_number;     ///< {0}: the number of a constant that has a name; or empty
  bool has_reflection;               ///< its template has the holes of emit/source/reflection.hpp
  std::string_view unbounded;        ///< an infinite number
  std::size_t most_empty;            ///< empty lines in a row, at most
  std::size_t deepest;               ///< brackets in brackets that it reads
  std::size_t longest_name;          ///< 0: any
  std::string_view reserved;         ///< words that are no names, between spaces: `_` is appended
  std::string_view taken;            ///< names that the module needs
  std::string_view unnameable;       ///< names that no module may have
  std::string_view command;          ///< starts its interpreter
  std::string_view variable;         ///< of the environment, which has another command
  /// Functions that the interpreter has code of its own for, and the error of a field that calls
  /// one, in u of its largest entry; `roundings`: that of any other.
  std::string_view own_implementations;
  int roundings;
};

inline constexpr std::array spelling_table{
#define ELGEN_SPELLING(id, ...) SourceSpelling{.language = LanguageId::id, __VA_ARGS__},
#include "elgen/spellings.def"
};

/// Who defines a function: the library of the language, or each module for itself.
enum class FunctionHome : std::uint8_t { library, module };

/// A function that the library of a language lacks, or has under another name than C.
struct FunctionSpelling {
  LanguageId language;
  FunctionId function;
  std::string_view name;
  FunctionHome home;
};

inline constexpr std::array function_spelling_table{
#define ELGEN_FUNCTION_SPELLING(id, function, name, home) \
  FunctionSpelling{LanguageId::id, FunctionId::function, name, FunctionHome::home},
#include "elgen/spellings.def"
};

/// The row of an interpreted language.
[[nodiscard]] constexpr const SourceSpelling& source_spelling(LanguageId language) {
  std::size_t at = 0;
  while (spelling_table[at].language != language) ++at;
  return spelling_table[at];
}

}  // namespace elgen
