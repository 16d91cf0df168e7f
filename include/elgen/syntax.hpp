// FileSyntax: the parse tree of a model or a scene. Every node has a span; names are not resolved.
//
// parse_model() checks everything that does not depend on other entries: TOML, keys, types of
// values, the grammar of expressions, limits. The key table (key_table()) says which keys and types
// are permitted.
#pragma once

#include <cln/rational.h>

#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "elgen/diagnostic.hpp"
#include "elgen/limits.hpp"
#include "elgen/source_text.hpp"

namespace elgen {

enum class SyntaxKind : std::uint8_t {
  number,    ///< the number `value`
  name,      ///< the name `text`; operands = {index} if the name has an index
  call,      ///< text = name of the function, operands = arguments
  negate,    ///< operands = {e}
  add,       ///< n-ary, as a + b + c; a - b is a + (negate b)
  multiply,  ///< n-ary, as a * b * c
  divide,    ///< operands = {numerator, denominator}; left-associative
  power,     ///< operands = {base, exponent}
};

/// An expression as typed. `span` covers the expression with its brackets, `token` only its
/// operator or name. limits.expression_depth limits the nesting: brackets, calls, indices, signs,
/// powers and quotients count one level each; terms of a sum and factors of a product count none.
/// The height of the tree is at most a few times this limit.
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

/// A TOML value, read according to the key table (see KeyType). A bare TOML number becomes a number
/// expression; its digits are read from the source text, so that it is exact.
struct ValueSyntax {
  ValueKind kind = ValueKind::text;
  Span span = {};         ///< span of the value; quotes of a string are excluded
  std::string text = {};  ///< the text of a string, or the source text of an expression
  bool boolean = false;
  ExpressionSyntax expression = {};
  std::vector<ValueSyntax> items = {};  ///< the items of a list, in file order
  std::vector<KeySyntax> entries;       ///< the keys of a table, in file order

  /// The entry with this key; null if the table lacks the key.
  [[nodiscard]] const KeySyntax* find(std::string_view key) const;
};

struct KeySyntax {
  std::string key = {};
  Span key_span = {};  ///< span of the key, including quotes
  ValueSyntax value = {};
};

/// One table of the file: `[model]`, one `[[coordinate]]`, `[parameters]` …
struct EntrySyntax {
  std::string name = {};  ///< "model", "coordinate", …, "outputs"; "" for the top level
  Span span = {};         ///< span of the header
  std::vector<KeySyntax> keys = {};

  [[nodiscard]] const KeySyntax* find(std::string_view key) const;
};

enum class FileKind : std::uint8_t { model, scene };

struct FileSyntax {
  SourcePointer source = {};
  std::vector<EntrySyntax> entries = {};  ///< the tables of the file, in file order
};

/// find_entry: the first entry `name` of `file`. find_key: the key `key` of the first entry
/// `entry`. entry_keys: all keys of this entry. Null or empty if `file` is null, or if the entry or
/// key is missing.
[[nodiscard]] const EntrySyntax* find_entry(const FileSyntax* file, std::string_view name);
[[nodiscard]] const KeySyntax* find_key(const FileSyntax* file, std::string_view entry,
                                        std::string_view key);
[[nodiscard]] const std::vector<KeySyntax>& entry_keys(const FileSyntax* file,
                                                       std::string_view entry);

/// The type of the value of a key. Each comment names the form in TOML, then the resulting
/// ValueSyntax.
enum class KeyType : std::uint8_t {
  expression,           ///< bare number or string: ValueKind::expression
  expression_list,      ///< list of expressions
  expression_or_list,   ///< an expression, or a list of expressions
  expression_or_table,  ///< a parameter: an expression, or a table (rows `<entry>.<key>`)
  closed_form,          ///< expression, list, matrix, or a table {for, value}
  name,         ///< string with a name, perhaps with an index: an expression of SyntaxKind::name
  text,         ///< free text
  choice,       ///< text, one of the words of choice_table()
  choice_list,  ///< list of words of choice_table()
  unit,         ///< string: a unit as text
  repetition,  ///< "i in 1..n" or a list of these: always a list of tables with the entries `index`
               ///< (a name), `low` and `high` (expressions)
  condition,   ///< "a > b", one of > >= < <=: a table with the entries `left`, `right`
               ///< (expressions) and `sign` (a text)
  equations,   ///< "a = b" or a list of these: always a list of tables with the entries `left` and
               ///< `right` (expressions)
  integer,     ///< bare integer: a number expression
  boolean,     ///< ValueKind::boolean
  range,       ///< [low, high]: list of two expressions
  turns,       ///< list of [axis, angle]: the axis a text or a list of three expressions
  table,       ///< inline table or sub-table (rows `<entry>.<key>`)
  value_or_table,         ///< a table; `0.3` or `[0, 1]` is read as { value = … }
  output_request,         ///< true, or a table; "rk4" is read as { method = "rk4" } for a step,
                          ///< "closed" as { form = "closed" } for another output
  boolean_or_expression,  ///< a momentum: true, or an expression
  text_or_table,          ///< a text or a table
  names_or_table,         ///< `fixed`: a text, a list of texts, or a table
  latex_symbol,           ///< string: LaTeX of a symbol
};

/// The description of a default that is no constant: "made from the name".
struct DefaultInWords {
  std::string_view text;
};

/// The value of a key that a file omits. Empty if the key is required, or if its name is free
/// ("*").
using KeyDefault =
    std::variant<std::monostate, DefaultInWords, bool, std::int64_t, double, std::string_view>;

/// One row of the key table.
struct KeyRow {
  std::string_view entry;  ///< "coordinate", "" for the top level, "coordinate.start" for a table
                           ///< that is a value; in scenes "scene", "scene.outputs", …
  std::string_view key;    ///< "*": any name that the user chooses
  KeyType type;
  bool required = false;
  bool supported = true;  ///< false: E108 "not yet supported"
  std::string_view doc = {};
  bool is_for_drawings = false;  ///< only drawings use the key: stamps and `diff` ignore it
  KeyDefault default_value = {};
  std::string_view details = {};  ///< up to three sentences: signs, units, exclusions
};

/// One permitted word of a key of KeyType::choice or choice_list.
struct ChoiceRow {
  std::string_view entry;
  std::string_view key;
  std::string_view word;
};

/// The properties of an entry of the file.
struct EntryRow {
  std::string_view entry;  ///< in scenes "scene.outputs", …
  bool repeated = false;   ///< true: an array of tables, [[…]]
  bool required = false;
  bool supported = true;
  std::string_view doc;
  bool may_be_list = false;  ///< true: a list of keys is read as a table with `key = true` for each
  std::string_view details = {};  ///< up to three sentences that follow `doc`
};

[[nodiscard]] std::span<const KeyRow> key_table();
[[nodiscard]] std::span<const ChoiceRow> choice_table();
[[nodiscard]] std::span<const EntryRow> entry_table();
/// The entry whose keys `entry` has: "frame" for "scene.frame", because both have the same keys;
/// otherwise `entry`.
[[nodiscard]] std::string_view entry_of_keys(std::string_view entry);
/// True if only drawings depend on the key.
[[nodiscard]] bool is_drawing_key(std::string_view entry, std::string_view key);
/// The permitted words of a key of KeyType::choice or choice_list; empty for other types.
[[nodiscard]] std::vector<std::string_view> choice_words(const KeyRow& row);
/// The default as in a file (`1`, `true`, `"rod"`), or in words; "" if the key has none.
[[nodiscard]] std::string default_text(const KeyRow& row);
/// A type in words: "expression", "one of".
[[nodiscard]] std::string_view type_text(KeyType type);
/// The header of an entry in a file: "[[frame]]" for "frame", "[outputs]" for "scene.outputs".
[[nodiscard]] std::string header_text(const EntryRow& row);
/// All entries and keys in Markdown: the text of models/REFERENCE.md.
[[nodiscard]] std::string reference_page();
/// A hint for the error if `word` was a word of the key `row` in a former version; else empty.
[[nodiscard]] std::string_view former_choice_hint(const KeyRow& row, std::string_view word);

/// The key table as a JSON Schema, with which editors check TOML files. Every file that the parser
/// accepts satisfies the schema. It does not describe the grammar of expressions, keys that exclude
/// each other, or references by name; only elgen checks these.
[[nodiscard]] std::string file_schema(FileKind kind);

/// The span of the value of the key `model = "…"` in a scene. None if the text is not TOML, or if
/// `model` is missing or is no string (a table in a model file).
[[nodiscard]] std::optional<Span> find_model_key(const SourceText& source);

/// True if the text is TOML with a table [model].
[[nodiscard]] bool declares_model(const SourceText& source);

/// Parses a model or scene file. Errors: E1xx (TOML, keys, types), E205 (names), E210
/// (repetitions), E3xx (expressions), E9xx (limits).
[[nodiscard]] Result<FileSyntax> parse_model(SourcePointer source, const Limits& limits);
[[nodiscard]] Result<FileSyntax> parse_scene(SourcePointer source, const Limits& limits);

/// Parses one expression of the model language: the bytes of the span `text`, or all of `source`.
[[nodiscard]] Result<ExpressionSyntax> parse_expression(const Span& text, const Limits& limits);
[[nodiscard]] Result<ExpressionSyntax> parse_expression(const SourcePointer& source,
                                                        const Limits& limits);

/// The parts of `text` between commas outside brackets, without the spaces around each part.
[[nodiscard]] std::vector<Span> split_at_commas(const Span& text);

/// split_at_commas() of all `options`.
[[nodiscard]] std::vector<Span> option_words(const std::vector<SourcePointer>& options);

/// The words of options as keys of a table: NAME=VALUE; for expression_or_list also NAME=[A, B];
/// for range NAME=LOW..HIGH or NAME=LOW:HIGH; for boolean_or_expression a bare NAME means true.
/// Blanks around names are removed. Returns the keys that can be read, and errors for all other
/// words: E606 (no value, no range, a duplicate name) and the errors of expressions.
[[nodiscard]] Result<std::vector<KeySyntax>> parse_options(
    const std::vector<SourcePointer>& options, KeyType type, const Limits& limits);

/// One line per table header and one per key with its value, in file order, without comments.
[[nodiscard]] std::string dump(const FileSyntax& syntax);
/// dump() without keys that only drawings use. Stamps contain the hash of this text.
[[nodiscard]] std::string canonical_model_text(const FileSyntax& model);
/// The expression with all brackets: `(a + (b * c))`.
[[nodiscard]] std::string dump(const ExpressionSyntax& expression);

}  // namespace elgen
