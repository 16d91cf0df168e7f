// cpp_dialect: straight-line code. Nothing is branched, so that packs and AutoDiff numbers pass.
// sign, min and max are helpers of the header, because the standard library has none that every
// ordered scalar takes.
#include "cpp_dialect.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cpp_constant.hpp"
#include "cpp_names.hpp"
#include "cpp_types.hpp"
#include "fields.hpp"
#include "layout.hpp"
#include "signature.hpp"

namespace elgen {
namespace {

using Texts = std::vector<std::string>;

std::string joined_lines(const Texts& lines) { return fmt::format("{}", fmt::join(lines, "\n")); }

/// sign, min and max are not the standard library's.
bool is_standard(std::string_view name) {
  const auto is_called = [name](const FunctionRow& row) { return row.name == name; };
  const bool is_own = name == "sign" || name == "min" || name == "max";
  return name == "sqrt" ||
         (!is_own && std::any_of(function_table.begin(), function_table.end(), is_called));
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

/// A field to be written: `is_number` where its type is no array.
struct Value {
  const Field& field;
  const Texts& entries;
  bool is_number;
};

/// A scalar as it is, an array in the double braces of std::array.
std::string field_value(const Value& value, std::size_t indent) {
  const auto& [field, entries, is_number] = value;
  const std::string margin(indent, ' ');
  if (is_number) {
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

Texts texts_of(const std::vector<Term>& terms) {
  Texts texts;
  for (const Term& term : terms) texts.push_back(term.text);
  return texts;
}

std::string part_name(const Function& function, std::size_t part) {
  return fmt::format("{}_part_{}", function.name, part + 1);
}

}  // namespace

Formula CppDialect::constant(const Constant& constant) const {
  const bool is_negative = cln::minusp(constant.value);
  const std::string magnitude = is_short_constant(constant.value)
                                    ? cpp_magnitude(constant.value)
                                    : constant_name(constant) + "<Scalar>()";
  return {(is_negative ? "-" : "") + magnitude, is_negative ? Binding::negation : Binding::atom};
}

std::string CppDialect::library_function(std::string_view name) const { return std::string(name); }

std::string CppDialect::own_function(std::string_view name) const {
  return fmt::format("detail::{}<Scalar>", name);
}

std::string CppDialect::temporary(const std::string& name) const { return cpp_temporary(name); }

std::string CppDialect::declaration(const std::string& name) const {
  return "const Scalar " + name;
}

std::string CppDialect::target(const Function& function, const SectionItem& entry) const {
  const Field& field = function.fields[entry.field];
  const std::string member = field.name.empty() ? "" : "." + field.name;
  return "result" + member + (is_number(function, field) ? "" : element(entry.index));
}

std::string CppDialect::returned(const Function& function, const Function& ordered,
                                 const FunctionBody& body) const {
  if (!is_returned(function)) return "";
  const bool is_struct = gives_struct(function);
  Texts values;
  for (std::size_t i = 0; i < function.fields.size(); ++i) {
    const Texts entries = texts_of(body.entries[i]);
    const bool is_plain = is_number(function, function.fields[i]);
    values.push_back(field_value({ordered.fields[i], entries, is_plain}, is_struct ? 6 : 2));
  }
  if (!is_struct) return fmt::format("  return {};\n", values.front());
  return fmt::format("  return {{\n      {},\n  }};\n", fmt::join(values, ",\n      "));
}

std::string CppDialect::opening(const Function& /*function*/, const UsedNames& used,
                                bool /*is_part*/) const {
  std::string text;
  for (const std::string_view name : used) {
    if (is_standard(name)) text += fmt::format("  using std::{};\n", name);
  }
  return text;
}

std::string CppDialect::element(std::uint32_t index) const { return fmt::format("[{}]", index); }

std::string CppDialect::type_of_field(OutputKind kind, const Field& field) const {
  return field_type(kind, field);
}

std::string CppDialect::type_of_argument(Argument argument) const {
  return argument_type(argument);
}

std::string CppDialect::result_type(const Function& function) const {
  if (gives_struct(function)) return cpp_struct_name(function) + "<Scalar>";
  return type_of_field(function.kind, function.fields.front());
}

/// Arguments that the body does not use have no name.
Texts CppDialect::declared_arguments(const Function& function, const UsedNames& used) const {
  Texts texts;
  for (const Argument argument : arguments_of(model(), function)) {
    const std::string_view name = argument_name(argument);
    texts.push_back(type_of_argument(argument) +
                    (used.count(name) > 0 ? fmt::format(" {}", name) : ""));
  }
  return texts;
}

std::string CppDialect::signature(const Function& function, const UsedNames& used) const {
  Texts arguments = declared_arguments(function, used);
  const std::string type = result_type(function);
  if (is_returned(function)) {
    const std::string start = fmt::format("[[nodiscard]] {} {}", type, function.name);
    return elgen::signature(start, arguments, " noexcept");
  }
  arguments.insert(arguments.begin(), type + "& result");
  return elgen::signature("void " + function.name, arguments, " noexcept");
}

std::string CppDialect::part_signature(const Function& function, std::size_t part,
                                       const UsedNames& used) const {
  Texts arguments = {result_type(function) + "&", workspace_name(function) + "<Scalar>&"};
  if (used.count("result") > 0) arguments[0] += " result";
  if (used.count("w") > 0) arguments[1] += " w";
  const Texts own = declared_arguments(function, used);
  arguments.insert(arguments.end(), own.begin(), own.end());
  return elgen::signature("void " + part_name(function, part), arguments, " noexcept");
}

std::string CppDialect::calling_body(const Function& function, std::size_t parts) const {
  std::string body;
  if (is_returned(function)) body += fmt::format("  {} result;\n", result_type(function));
  body += fmt::format("  detail::{}<Scalar> w;\n", workspace_name(function));
  std::string arguments = "result, w";
  for (const Argument argument : arguments_of(model(), function)) {
    arguments += fmt::format(", {}", argument_name(argument));
  }
  for (std::size_t part = 0; part < parts; ++part) {
    body += fmt::format("  detail::{}({});\n", part_name(function, part), arguments);
  }
  return is_returned(function) ? body + "  return result;\n" : body;
}

std::string CppDialect::member(const Function& function, const Field& field) const {
  return fmt::format("{} {};", type_of_field(kind_of(function, field), field), field.name);
}

std::string CppDialect::struct_name(const Function& function) const {
  return cpp_struct_name(function);
}

std::string CppDialect::workspace_name(const Function& function) const {
  return cpp_struct_name(function) + "Workspace";
}

}  // namespace elgen
