// ModelSyntax, SceneSyntax: a file as written, every piece with its span; names are not resolved
// yet.
//
// parse() checks what needs no knowledge of other entries: TOML, keys, types of values, the grammar
// of expressions and its limits. The key table (key_table()) drives it, and the messages about
// keys.
#pragma once

#include <cln/rational.h>

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
  divide,    ///< operands = {numerator, denominator}
  power,     ///< operands = {base, exponent}
};

/// An expression as written. `span` covers the whole of it, `token` the operator or name inside.
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

/// A TOML value read as the key table says. Bare TOML numbers become number expressions, exact as
/// written (re-read from the source, never through double).
struct ValueSyntax {
  ValueKind kind = ValueKind::text;
  Span span = {};         ///< the value; inside the quotes for strings
  std::string text = {};  ///< text, and the source text of an expression
  bool boolean = false;
  ExpressionSyntax expression = {};
  std::vector<ValueSyntax> items = {};  ///< list
  std::vector<KeySyntax> entries = {};  ///< table, in file order
};

struct KeySyntax {
  std::string key = {};
  Span key_span = {};
  ValueSyntax value = {};
};

/// One table of the file: `[model]`, one `[[coordinate]]`, `[parameters]` …
struct EntrySyntax {
  std::string name = {};  ///< "model", "coordinate", "parameters", …; "" for the top level
  Span span = {};         ///< the header
  std::vector<KeySyntax> keys = {};

  [[nodiscard]] const KeySyntax* find(std::string_view key) const;
};

struct ModelSyntax {
  SourcePointer source = {};
  std::vector<EntrySyntax> entries = {};  ///< in file order
};

struct SceneSyntax {
  SourcePointer source = {};
  std::vector<EntrySyntax> entries = {};
};

/// What a key's value must be.
enum class KeyType : std::uint8_t {
  expression,         ///< bare number or string
  expression_list,    ///< list of expressions
  expression_matrix,  ///< list of lists of expressions
  expression_or_list,
  name,        ///< string: a declared or referenced name, perhaps with an index
  text,        ///< free text
  unit,        ///< string: a unit expression
  repetition,  ///< "i in 1..n", or a list of such
  integer,
  boolean,
  range,  ///< [low, high]
  free,   ///< read as it stands; check decides (parameters, fixed, expect, start, outputs)
};

/// One row of the key table.
struct KeyRow {
  std::string_view entry;  ///< "coordinate"; a scene's entries are "scene" and "scene.outputs", …
  std::string_view key;    ///< "*": any name the user chooses
  KeyType type;
  bool required;
  bool supported;  ///< false: E108 "not yet supported"
  std::string_view doc;
};

/// One row per entry: whether it is an array of tables, and whether it is supported yet.
struct EntryRow {
  std::string_view entry;
  bool repeated;  ///< [[…]]
  bool required;
  bool supported;
  std::string_view doc;
};

[[nodiscard]] const std::vector<KeyRow>& key_table();
[[nodiscard]] const std::vector<EntryRow>& entry_table();

/// Reads a model or a scene file. Errors: E1xx (TOML, keys, types), E3xx (expressions), E9xx
/// (limits).
[[nodiscard]] Result<ModelSyntax> parse_model(SourcePointer source, const Limits& limits);
[[nodiscard]] Result<SceneSyntax> parse_scene(SourcePointer source, const Limits& limits);

/// Reads one expression of the model language; `source` holds nothing else (options, tests).
[[nodiscard]] Result<ExpressionSyntax> parse_expression(SourcePointer source, const Limits& limits);

[[nodiscard]] std::string dump(const ModelSyntax& syntax);
[[nodiscard]] std::string dump(const SceneSyntax& syntax);
/// Fully bracketed: `(a + (b * c))`.
[[nodiscard]] std::string dump(const ExpressionSyntax& expression);

}  // namespace elgen
