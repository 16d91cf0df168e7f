// SourceSpelling: the syntax of an interpreted language, and the command that runs it
// (spellings.def).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "elgen/functions.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// The syntax of a list of values.
struct ListSpelling {
  std::string_view opening;
  std::string_view separator;
  std::string_view closing;
  std::string_view after_single;  ///< text after the value of a list with one value: ","
  std::string_view empty;         ///< the empty list; {0}: number of columns of a matrix
};

/// The types in annotations; all empty if the language has no annotations.
struct TypeSpelling {
  std::string_view parameters;
  std::string_view list_argument;
  std::string_view empty_argument;  ///< an argument without entries
  std::string_view empty_default;   ///< its default value, if it is the last argument
  std::string_view number;
  std::string_view vector;
  std::string_view matrix;
};

/// Assignments of the entries of arguments to local variables, at the start of a body; they check
/// the lengths. All empty: the body reads entries by SourceSpelling::element.
struct UnpackingSpelling {
  std::string_view element;     ///< entry {1}, from 0, of the argument {0}: "q_0"
  std::string_view no_entries;  ///< the right side of the assignment if {0} has no entries
  std::string_view block;       ///< the assignments {0}, with the error of a wrong length
};

/// A loop over the columns of a function.
struct LoopSpelling {
  std::string_view results;  ///< a list for {0} results, before the loop
  std::string_view opening;  ///< first line, for {0} columns; defines `at`, the column
  std::string_view closing;  ///< last line
};

/// A row of spellings.def, which also explains the placeholders {0} and {1} of patterns.
struct SourceSpelling {
  LanguageId language;
  std::string_view element;
  std::uint32_t first_index;
  UnpackingSpelling unpacking = {};
  std::string_view definition;
  LoopSpelling loop;
  std::size_t indent;        ///< number of spaces before a statement
  std::string_view local;    ///< text before the name in the definition of a local variable
  std::string_view library;  ///< a library function in a call; {0}: its name in the library
  /// The functions that the library has under their C names, between spaces.
  std::string_view functions;
  /// Functions of the library that raise an error if the value is too large for double.
  std::string_view overflow_errors = {};
  std::string_view result;  ///< text before the value that a function returns
  /// A struct of type {0} with the results {1}; "": each result is a statement (`field`).
  std::string_view results;
  std::string_view field;    ///< text before the value of a result; {0}: name of the result
  std::string_view opening;  ///< opening bracket of a value that takes several lines
  std::string_view closing;
  std::string_view end;          ///< end of a statement
  std::string_view end_of_line;  ///< end of a line whose statement continues on the next line
  ListSpelling vector;
  ListSpelling row;     ///< row of a matrix
  ListSpelling matrix;  ///< list of rows
  ListSpelling texts;   ///< list of string literals in a constant of the module
  ListSpelling numbers;
  ListSpelling intervals;
  std::string_view interval;      ///< one interval; {0}, {1}: its bounds
  std::string_view number_value;  ///< text before the value of a scalar parameter {0}
  std::string_view array_value;   ///< text before the value of an array parameter {0}
  std::string_view end_of_value;  ///< text after the value of a parameter
  std::string_view typed;         ///< an argument or a field {0} with its type {1}
  TypeSpelling types = {};
  std::string_view comment;         ///< start of the comment after a parameter: "# "
  std::string_view member_comment;  ///< text before the description of a member
  char quote;                       ///< quotation mark around texts
  char escape;                      ///< character that escapes `quote` and itself inside texts
  /// Characters written as \u003c, because they would be markup on a page.
  std::string_view coded_in_texts;
  std::string_view escaped_in_docs;  ///< characters that need a backslash in documentation
  std::string_view end_of_docs;      ///< end mark of documentation; texts contain "* /" for "*/"
  std::string_view own_function;     ///< a function of the module in a call; {0}: its name
  /// The name of constant number {0}, from 1. "": constants are written as literals.
  std::string_view named_number;
  bool has_reflection;          ///< the template has the placeholders of emit/source/reflection.hpp
  std::string_view unbounded;   ///< an infinite number
  std::size_t max_empty_lines;  ///< largest number of consecutive empty lines
  std::size_t max_nesting;      ///< deepest nesting of brackets that the language parses; 0: any
  std::size_t max_name_length;  ///< most characters of a name; 0: no limit
  std::string_view reserved;    ///< reserved words, between spaces; `_` is appended to such a name
  std::string_view used_names;  ///< names that the module uses
  std::string_view forbidden_names;  ///< names that a module cannot have
  std::string_view command;          ///< command that starts the interpreter
  std::string_view variable;         ///< environment variable that replaces `command`
  /// C names of functions that the interpreter implements itself, between spaces. Outputs that call
  /// such a function have a tolerance of at least 4 u. `roundings`: the tolerance of all other
  /// outputs in u, relative to the largest entry of a field; 0: bit-identical.
  std::string_view own_implementations;
  int roundings;
};

inline constexpr std::array spelling_table{
#define ELGEN_SPELLING(id, ...) SourceSpelling{.language = LanguageId::id, __VA_ARGS__},
#include "elgen/spellings.def"
};

/// The place of a definition: the library of the language, or each module that calls the function.
enum class FunctionProvider : std::uint8_t { library, module };

/// A function that the library of a language lacks, or that has another name than in C.
struct FunctionSpelling {
  LanguageId language;
  FunctionId function;
  std::string_view name;
  FunctionProvider provider;
};

inline constexpr std::array function_spelling_table{
#define ELGEN_FUNCTION_SPELLING(id, function, name, provider) \
  FunctionSpelling{LanguageId::id, FunctionId::function, name, FunctionProvider::provider},
#include "elgen/spellings.def"
};

/// The row of `language` in `spelling_table`. `language` must be an interpreted language.
[[nodiscard]] constexpr const SourceSpelling& source_spelling(LanguageId language) {
  std::size_t at = 0;
  while (spelling_table[at].language != language) ++at;
  return spelling_table[at];
}

}  // namespace elgen
