// cpp_body: straight-line code. Nothing is branched, so that packs and AutoDiff numbers pass.
//
//     using std::sin;
//     const Scalar sin_theta = sin(q[1]);
//     return {{p.m * sin_theta, constant<Scalar>(0.0)}};
#include "cpp_body.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cpp_names.hpp"
#include "cpp_signature.hpp"
#include "cpp_spelling.hpp"
#include "layout.hpp"

namespace elgen {
namespace {

using Texts = std::vector<std::string>;

std::string joined_lines(const Texts& lines) { return fmt::format("{}", fmt::join(lines, "\n")); }

/// sign, min and max are not the standard library's.
bool is_standard(FunctionId function) {
  return function != FunctionId::sign && function != FunctionId::min && function != FunctionId::max;
}

/// Those of the standard functions that the statements mention.
std::string using_declarations(const std::string& statements) {
  std::set<std::string> names = {"sqrt"};
  for (const FunctionRow& row : function_table) {
    if (is_standard(row.id)) names.emplace(row.name);
  }
  std::string text;
  for (const std::string& name : names) {
    if (mentions(statements, name)) text += fmt::format("  using std::{};\n", name);
  }
  return text;
}

/// "  const Scalar x = …;"
std::string assignment(const std::string& target, const Term& value) {
  const std::string start = fmt::format("  {} = ", target);
  const Wrapping wrapping{line_width - start.size() - 1, "      "};
  return start + joined_lines(wrap_expression(value.text, wrapping)) + ";\n";
}

/// The rows of a matrix, joined by commas, where every row fits a line; else one line per entry.
Texts entry_lines(const Field& field, const Texts& entries, std::size_t indent) {
  Texts rows;
  for (std::size_t row = 0; row < field.rows; ++row) {
    const auto begin = entries.begin() + static_cast<std::ptrdiff_t>(row * field.columns);
    rows.push_back(fmt::format("{}", fmt::join(begin, begin + field.columns, ", ")));
  }
  const auto fits = [&](const std::string& row) { return indent + row.size() + 1 <= line_width; };
  if (std::all_of(rows.begin(), rows.end(), fits)) return rows;
  const Wrapping wrapping{line_width - indent - 1, std::string(indent + 4, ' ')};
  Texts lines;
  for (const std::string& entry : entries) {
    lines.push_back(joined_lines(wrap_expression(entry, wrapping)));
  }
  return lines;
}

/// A field to be written: `is_scalar` where its type is no array.
struct Value {
  const Field& field;
  const Texts& entries;
  bool is_scalar;
};

/// A scalar as it is, an array in the double braces of std::array.
std::string field_value(const Value& value, std::size_t indent) {
  const auto& [field, entries, is_scalar] = value;
  const std::string margin(indent, ' ');
  if (is_scalar) {
    return joined_lines(
        wrap_expression(entries.front(), {line_width - indent - 8, margin + "    "}));
  }
  if (entries.empty()) return "{}";
  const std::string line = fmt::format("{{{{{}}}}}", fmt::join(entries, ", "));
  if (indent + line.size() + 8 <= line_width) return line;
  const Texts lines = entry_lines(field, entries, indent + 4);
  return fmt::format("{{{{\n{0}    {1},\n{0}}}}}", margin,
                     fmt::join(lines, ",\n" + margin + "    "));
}

/// "result.gravity[1]"
std::string target_of(const CppText& text, const SectionItem& item) {
  const Field& field = text.function.fields[item.field];
  const std::string member = field.name.empty() ? "" : "." + field.name;
  const std::string index = text.is_scalar[item.field] ? "" : fmt::format("[{}]", item.index);
  return "result" + member + index;
}

Texts texts_of(const std::vector<Term>& terms) {
  Texts texts;
  for (const Term& term : terms) texts.push_back(term.text);
  return texts;
}

std::string result_statement(const CppText& text) {
  Texts values;
  const bool is_struct = returns_struct(text.function);
  for (std::size_t i = 0; i < text.function.fields.size(); ++i) {
    const Texts entries = texts_of(text.body.entries[i]);
    values.push_back(
        field_value({text.function.fields[i], entries, text.is_scalar[i]}, is_struct ? 6 : 2));
  }
  if (!is_struct) return fmt::format("  return {};\n", values.front());
  return fmt::format("  return {{\n      {},\n  }};\n", fmt::join(values, ",\n      "));
}

/// Entry by entry, through the reference.
std::string result_assignments(const CppText& text) {
  std::string lines;
  for (std::uint32_t field = 0; field < text.body.entries.size(); ++field) {
    for (std::uint32_t index = 0; index < text.body.entries[field].size(); ++index) {
      const SectionItem item{true, field, index};
      lines += assignment(target_of(text, item), value_of(text.body, item));
    }
  }
  return lines;
}

}  // namespace

CppText cpp_text(const Program& program, const Function& function, const FunctionBody& body) {
  CppText text{function, body};
  for (const Field& field : function.fields) {
    const OutputKind kind = kind_of_field(program, function, field);
    text.is_scalar.push_back(field_type(kind, field) == "Scalar");
  }
  return text;
}

std::string cpp_body(const CppText& text) {
  std::string lines;
  for (const Statement& statement : text.body.statements) {
    lines += assignment("const Scalar " + statement.name, statement.value);
  }
  lines += is_returned(text.function) ? result_statement(text) : result_assignments(text);
  return using_declarations(lines) + lines;
}

std::string cpp_part(const CppText& text, const Sections& sections, std::size_t part) {
  std::string lines;
  for (const SectionItem& item : sections.parts[part]) {
    const bool is_local = !item.is_entry && !sections.crosses[item.index];
    const std::string target =
        item.is_entry ? target_of(text, item) : text.body.statements[item.index].name;
    lines += assignment((is_local ? "const Scalar " : "") + target, value_of(text.body, item));
  }
  return using_declarations(lines) + lines;
}

}  // namespace elgen
