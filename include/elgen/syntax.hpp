// FileSyntax: a model or a scene as written, every piece with its span; names are not resolved
// yet.
//
// parse() checks what needs no knowledge of other entries: TOML, keys, types of values, the grammar
// of expressions and its limits. The key table (key_table()) drives it, and the messages about
// keys.
#pragma once

#include <cln/rational.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "elgen/diagnostic.hpp"
#include "elgen/limits.hpp"
#include "elgen/source_text.hpp"

namespace elgen {

enum class SyntaxKind : std::uint8_t {
  number,    ///< value
  name,      ///< text, operands = {index} if it has one
  call,      ///< text (function name), operands = arguments
  negate,    ///< operands = {e}
  add,       ///< n-ary, as a + b + c; a - b is a + (negate b)
  multiply,  ///< n-ary
  divide,    ///< operands = {numerator, denominator}; left-associative
  power,     ///< operands = {base, exponent}
};

/// An expression as written. `span` covers the whole of it with its own brackets, `token` the
/// operator or name inside. The tree is at most a few times limits.expression_depth high: brackets,
/// calls, indices, signs, powers and quotients count one level each, and terms of one sum or
/// product none.
struct ExpressionSyntax {
  SyntaxKind kind = SyntaxKind::number;
  std::string text = {};
  cln::cl_RA value = 0;
  std::vector<ExpressionSyntax> operands = {};
  Span span = {};
  Span token = {};
};

enum class ValueKind : std::uint8_t { expression, text, boolean, list, table };

struct KeySyntax;

/// A TOML value read as the key table says (see KeyType for which kind of value each type becomes).
/// Bare TOML numbers become number expressions, signed and exact as written (re-read from the
/// source, never through double).
struct ValueSyntax {
  ValueKind kind = ValueKind::text;
  Span span = {};         ///< the value; inside the quotes for strings
  std::string text = {};  ///< text, and the source text of an expression
  bool boolean = false;
  ExpressionSyntax expression = {};
  std::vector<ValueSyntax> items = {};  ///< list
  std::vector<KeySyntax> entries;       ///< table, in file order

  /// Null where it has no such key.
  [[nodiscard]] const KeySyntax* find(std::string_view key) const;
};

struct KeySyntax {
  std::string key = {};
  Span key_span = {};  ///< with its quotes, if it has any
  ValueSyntax value = {};
};

/// One table of the file: `[model]`, one `[[coordinate]]`, `[parameters]` …
struct EntrySyntax {
  std::string name = {};  ///< "model", "coordinate", …, "outputs"; "" for the top level
  Span span = {};         ///< the header
  std::vector<KeySyntax> keys = {};

  [[nodiscard]] const KeySyntax* find(std::string_view key) const;
};

enum class FileKind : std::uint8_t { model, scene };

struct FileSyntax {
  SourcePointer source = {};
  std::vector<EntrySyntax> entries = {};  ///< in file order
};

/// An entry that is not repeated, and a key of it, or null; its keys, or none. `file` may be null.
[[nodiscard]] const EntrySyntax* find_entry(const FileSyntax* file, std::string_view name);
[[nodiscard]] const KeySyntax* find_key(const FileSyntax* file, std::string_view entry,
                                        std::string_view key);
[[nodiscard]] const std::vector<KeySyntax>& keys_of(const FileSyntax* file, std::string_view entry);

/// The type that a key's value must have, and the ValueSyntax it is read as.
enum class KeyType : std::uint8_t {
  expression,           ///< bare number or string: ValueKind::expression
  expression_list,      ///< list of expressions
  expression_or_list,   ///< either
  expression_or_table,  ///< a parameter: an expression, or a table (rows `<entry>.<key>`)
  closed_form,          ///< expression, list, matrix, or a table {for, value}
  name,              ///< string: a name, perhaps with an index: an expression of SyntaxKind::name
  text,              ///< free text
  choice,            ///< text, one of the words of choice_table()
  choice_list,       ///< list of such
  unit,              ///< string: a unit as text
  repetition,        ///< "i in 1..n" or a list of such: always a list of tables with the entries
                     ///< `index` (a name), `low` and `high` (expressions)
  condition,         ///< "a > b", one of > >= < <=: a table with the entries `left`, `right`
                     ///< (expressions) and `sign` (a text)
  equations,         ///< "a = b" or a list of such: always a list of tables with the entries
                     ///< `left` and `right` (expressions)
  integer,           ///< bare integer: a number expression
  boolean,           ///< ValueKind::boolean
  range,             ///< [low, high]: list of two expressions
  turns,             ///< list of [axis, angle]: the axis a text or a list of three expressions
  table,             ///< inline table or sub-table (rows `<entry>.<key>`)
  boolean_or_table,  ///< a wanted output: true, or a table
  boolean_or_expression,  ///< a momentum: true, or an expression
  text_or_table,          ///< `fixed`: the text "all", or a table
  symbol,                 ///< string: LaTeX of a symbol
};

/// One row of the key table.
struct KeyRow {
  std::string_view entry;  ///< "coordinate", "" for the top level, "coordinate.start" for a table
                           ///< that is a value; a scene's are "scene", "scene.outputs", …
  std::string_view key;    ///< "*": any name the user chooses
  KeyType type;
  bool required = false;
  bool supported = true;  ///< false: E108 "not yet supported"
  std::string_view doc = {};
  bool is_drawn = false;  ///< drawings alone follow it: stamps and `diff` do not
};

/// One word a key of KeyType::choice or choice_list may hold.
struct ChoiceRow {
  std::string_view entry;
  std::string_view key;
  std::string_view word;
};

/// One row per entry: whether it is an array of tables, and whether it is supported yet.
struct EntryRow {
  std::string_view entry;
  bool repeated = false;  ///< [[…]]
  bool required = false;
  bool supported = true;
  std::string_view doc;
};

[[nodiscard]] std::span<const KeyRow> key_table();
[[nodiscard]] std::span<const ChoiceRow> choice_table();
[[nodiscard]] std::span<const EntryRow> entry_table();
/// Whether the row of this key says that drawings alone follow it.
[[nodiscard]] bool is_drawn(std::string_view entry, std::string_view key);
/// The words that a key of KeyType::choice or choice_list may hold; none of others.
[[nodiscard]] std::vector<std::string_view> choice_words(const KeyRow& row);
/// The word that took the place of a former one; empty for any other.
[[nodiscard]] std::string_view hint_of_former_choice(const KeyRow& row, std::string_view word);

/// The key table for editors, as JSON Schema: TOML files are checked as JSON of the same keys.
/// Every file that the reader takes satisfies it. Rules beyond a schema, such as the grammar of
/// expressions, which keys exclude each other and what names refer to, are left to elgen.
[[nodiscard]] std::string file_schema(FileKind kind);

/// The value of `model = "…"`, where the text is TOML that has it: in a model file `model` is a
/// table.
[[nodiscard]] std::optional<Span> named_model(const SourceText& source);

/// Whether the text is TOML with a table [model].
[[nodiscard]] bool declares_model(const SourceText& source);

/// Reads a model or a scene file. Errors: E1xx (TOML, keys, types), E3xx (expressions), E9xx
/// (limits).
[[nodiscard]] Result<FileSyntax> parse_model(SourcePointer source, const Limits& limits);
[[nodiscard]] Result<FileSyntax> parse_scene(SourcePointer source, const Limits& limits);

/// Reads one expression of the model language: all of a text, or a part of it that holds nothing
/// else (options).
[[nodiscard]] Result<ExpressionSyntax> parse_expression(const Span& text, const Limits& limits);
[[nodiscard]] Result<ExpressionSyntax> parse_expression(const SourcePointer& source,
                                                        const Limits& limits);

/// The words of options, between commas outside of brackets, without the blanks around them.
[[nodiscard]] std::vector<Span> option_words(const std::vector<SourcePointer>& options);

/// The words of options as the keys of a table: NAME=VALUE, of expression_or_list also NAME=[A, B],
/// and of range, which is a list, NAME=LOW..HIGH. Of boolean_or_expression a NAME alone is true.
/// Names lose their blanks. The keys that can be read, and of the others E606: no value, no range,
/// or a name that is given twice; and what expressions give.
[[nodiscard]] Result<std::vector<KeySyntax>> parse_options(
    const std::vector<SourcePointer>& options, KeyType type, const Limits& limits);

/// Every key with its value, in file order; blanks and comments leave no trace.
[[nodiscard]] std::string dump(const FileSyntax& syntax);
/// The same without the keys that drawings alone follow. Stamps are hashes of this text.
[[nodiscard]] std::string stamped_text(const FileSyntax& model);
/// Fully bracketed: `(a + (b * c))`.
[[nodiscard]] std::string dump(const ExpressionSyntax& expression);

}  // namespace elgen
