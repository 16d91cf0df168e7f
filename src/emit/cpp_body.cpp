// cpp_body: straight-line code. Nothing is branched, so that packs and AutoDiff numbers pass.
//
//     using std::sin;
//     const Scalar sin_theta = sin(q[1]);
//     return {{p.m * sin_theta, constant<Scalar>(0.0)}};
#include "cpp_body.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cpp_names.hpp"
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

std::string using_declarations(const Function& function) {
  const Usage used = usage(function);
  std::set<std::string> names;
  if (used.opcodes.count(Opcode::square_root) != 0) names.insert("sqrt");
  for (const FunctionId call : used.calls) {
    if (is_standard(call)) names.insert(std::string(function_row(call).name));
  }
  std::string text;
  for (const std::string& name : names) text += fmt::format("  using std::{};\n", name);
  return text;
}

std::string statement_line(const Statement& statement) {
  const std::string start = fmt::format("  const Scalar {} = ", statement.name);
  const Wrapping wrapping{line_width - start.size() - 1, "      "};
  return start + joined_lines(wrap_expression(statement.value, wrapping)) + ";\n";
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
    return joined_lines(wrap_expression(entries.front(), {line_width - indent - 8, margin + "    "}));
  }
  if (entries.empty()) return "{}";
  const std::string line = fmt::format("{{{{{}}}}}", fmt::join(entries, ", "));
  if (indent + line.size() + 8 <= line_width) return line;
  const Texts lines = entry_lines(field, entries, indent + 4);
  return fmt::format("{{{{\n{0}    {1},\n{0}}}}}", margin,
                     fmt::join(lines, ",\n" + margin + "    "));
}

std::string struct_value(const std::vector<Value>& values) {
  std::string text = "{\n";
  for (const Value& value : values) text += fmt::format("      {},\n", field_value(value, 6));
  return text + "  }";
}

/// The result through a reference, entry by entry.
std::string assignments(const std::vector<Value>& values) {
  std::string text;
  for (const auto& [field, entries, is_scalar] : values) {
    const std::string to = field.name.empty() ? "result" : "result." + field.name;
    for (std::size_t i = 0; i < entries.size(); ++i) {
      const std::string index = is_scalar ? "" : fmt::format("[{}]", i);
      const std::string start = fmt::format("  {}{} = ", to, index);
      const Wrapping wrapping{line_width - start.size() - 1, "      "};
      text += start + joined_lines(wrap_expression(entries[i], wrapping)) + ";\n";
    }
  }
  return text;
}

std::string result_text(const Function& function, const std::vector<Value>& values) {
  if (entry_count(function) > largest_returned) return assignments(values);
  const bool is_struct = returns_struct(function);
  return fmt::format("  return {};\n",
                     is_struct ? struct_value(values) : field_value(values.front(), 2));
}

}  // namespace

std::string cpp_body(const Model& model, const Program& program, const Function& function) {
  const FunctionBody body = statements(program, function, CppSpelling(model, program));
  std::string text = using_declarations(function);
  for (const Statement& statement : body.statements) text += statement_line(statement);
  std::vector<Value> values;
  for (std::size_t i = 0; i < function.fields.size(); ++i) {
    const Field& field = function.fields[i];
    const std::string type = field_type(kind_of_field(program, function, field), field);
    values.push_back({field, body.entries[i], type == "Scalar"});
  }
  return text + result_text(function, values);
}

}  // namespace elgen
