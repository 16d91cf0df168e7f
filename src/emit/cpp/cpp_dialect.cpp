// cpp_dialect: code without branches, so that Scalar can also be a pack or an AutoDiff type.
// sign, min and max are functions of the header: the standard versions do not accept every ordered
// scalar.
#include "emit/cpp/cpp_dialect.hpp"

#include <fmt/ranges.h>

#include <algorithm>

#include "emit/code/cpp_constant.hpp"
#include "emit/code/definition.hpp"
#include "emit/cpp/cpp_names.hpp"
#include "emit/interface/code_interface.hpp"
#include "emit/text/layout.hpp"

namespace elgen {
namespace {

using Texts = std::vector<std::string>;

std::string join_lines(const Texts& lines) { return fmt::format("{}", fmt::join(lines, "\n")); }

/// The rows of a matrix, joined by commas, if every row fits a line; else one entry per line.
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
    lines.push_back(join_lines(wrap_expression(entry, wrapping)));
  }
  return lines;
}

/// A field and the texts of its entries. `is_number`: the type of the field is a number, no array.
struct FieldEntryTexts {
  const Field& field;
  const Texts& entries;
  bool is_number;
};

/// The text of the value: a number has no braces, an array has the double braces of std::array.
std::string field_value_text(const FieldEntryTexts& value, std::size_t indent) {
  const auto& [field, entries, is_number] = value;
  const std::string margin(indent, ' ');
  if (is_number) {
    return join_lines(wrap_expression(entries.front(), {line_width - indent - 8, margin + "    "}));
  }
  if (entries.empty()) return "{}";
  const std::string line = fmt::format("{{{{{}}}}}", fmt::join(entries, ", "));
  if (indent + line.size() + 8 <= line_width) return line;
  const Texts lines = entry_lines(field, entries, indent + 4);
  return fmt::format("{{{{\n{0}    {1},\n{0}}}}}", margin,
                     fmt::join(lines, ",\n" + margin + "    "));
}

std::string part_name(const Function& function, std::size_t part) {
  return fmt::format("{}_part_{}", function.name, part + 1);
}

/// `blank_and_name`; "" if the body does not use the argument.
std::string name_if_used(const UsedNames& used, std::string_view blank_and_name) {
  return std::string(used.variables.count(blank_and_name.substr(1)) > 0 ? blank_and_name : "");
}

/// "const auto [sin_x, cos_x]", "std::tie(w.sin_x, w.cos_x)": the left-hand side for both values.
std::string sine_cosine_target(const std::string& sine, const std::string& cosine,
                               bool is_declared) {
  return is_declared ? fmt::format("const auto [{}, {}]", sine, cosine)
                     : fmt::format("std::tie({}, {})", sine, cosine);
}

/// Begins the names of groups of angles: "angles", "angles_2".
constexpr std::string_view angles_name = "angles";

ColumnLoopTexts make_loop_texts(std::string_view scope, std::uint32_t count) {
  return {fmt::format("  using Columns = {0}detail::Columns<Scalar>;\n"
                      "  for (std::size_t first = 0; first < {1}; first += Columns::size) {{\n"
                      "    const std::size_t at = first + Columns::size < {1} ? first : {1} - "
                      "Columns::size;\n",
                      scope, count),
          "const typename Columns::Value ", "Columns::load({0} + {1}at)",
          "    Columns::store({2}, {0} + {1}at);\n", "  }\n"};
}

class CppDialect : public CompiledDialect {
 public:
  CppDialect(const Model& model, const Program& program)
      : CompiledDialect(model, program, LanguageId::cpp, ".") {}

  FormulaText constant(const Constant& constant) const override {
    const bool is_negative = cln::minusp(constant.value);
    const std::string magnitude =
        is_short_constant(constant.value)
            ? cpp_magnitude(constant.value, scalar_type())
            : fmt::format("{}<{}>()", constant_name(constant), scalar_type());
    return {(is_negative ? "-" : "") + magnitude, is_negative ? Binding::negation : Binding::atom};
  }

  std::string_view scalar_type() const override { return "Scalar"; }

  std::string declaration(const std::string& name) const override {
    return fmt::format("const {} {}", scalar_type(), name);
  }

  std::string sine_cosine_statement(const std::string& sine, const std::string& cosine,
                                    const FormulaText& angle, bool is_declared) const override {
    const std::string name =
        fmt::format("{}detail::SineCosine<{}>::of", namespace_prefix(), scalar_type());
    return assignment(sine_cosine_target(sine, cosine, is_declared),
                      named_call_text(name, {angle}).text);
  }

  BodyRules body_rules() const override {
    return {.groups_angles = language_row(LanguageId::cpp).groups_angles};
  }

  std::string angles_statement(const std::vector<AngleTexts>& angles, std::size_t number,
                               bool is_declared) const override {
    const std::string name =
        number == 1 ? std::string(angles_name) : fmt::format("{}_{}", angles_name, number);
    std::vector<FormulaText> arguments;
    std::string lines;
    for (std::size_t i = 0; i < angles.size(); ++i) {
      const auto& [angle, sine, cosine] = angles[i];
      arguments.push_back(angle);
      if (!sine.empty() && !cosine.empty()) {
        lines += assignment(sine_cosine_target(sine, cosine, is_declared),
                            fmt::format("{}[{}]", name, i));
      } else {
        const std::string& own = sine.empty() ? cosine : sine;
        lines += assignment(is_declared ? declaration(own) : own,
                            fmt::format("{}.{}({})", name, sine.empty() ? "cosine" : "sine", i));
      }
    }
    const std::string function =
        fmt::format("{}detail::sines_of<{}>", namespace_prefix(), scalar_type());
    return assignment("const auto " + name, named_call_text(function, arguments).text) + lines;
  }

  ColumnLoopTexts column_loop_texts(std::uint32_t count) const override {
    return make_loop_texts(namespace_prefix(), count);
  }

  std::string assignment_target(const Function& function, std::uint32_t at,
                                std::uint32_t index) const override {
    const Field& field = function.fields[at];
    const std::string member = field.name.empty() ? "" : "." + field.name;
    return "result" + member + (is_scalar_field(function, field) ? "" : element_access(index));
  }

  std::string return_statement(const Function& function, const Function& ordered,
                               const FieldTexts& entries) const override {
    if (!is_returned_by_value(function)) return "";
    const bool is_struct = returns_struct(function);
    Texts values;
    for (std::size_t i = 0; i < function.fields.size(); ++i) {
      const bool is_plain = is_scalar_field(function, function.fields[i]);
      values.push_back(
          field_value_text({ordered.fields[i], entries[i], is_plain}, is_struct ? 6 : 2));
    }
    if (!is_struct) return fmt::format("  return {};\n", values.front());
    return fmt::format("  return {{\n      {},\n  }};\n", fmt::join(values, ",\n      "));
  }

  std::string body_prologue(const Function& /*function*/, const UsedNames& used,
                            bool /*is_part*/) const override {
    std::string text;
    for (const std::string_view name : used.functions) {
      text += fmt::format("  using std::{};\n", name);
    }
    return text;
  }

  std::string signature(const Function& function, const UsedNames& used) const override {
    Texts arguments = argument_declarations(function, used);
    const std::string type = result_type(function);
    if (is_returned_by_value(function)) {
      const std::string start =
          fmt::format("[[nodiscard]] {}{} {}", function_macro(), type, function.name);
      return elgen::signature(start, arguments, " noexcept");
    }
    arguments.insert(arguments.begin(), type + "& result");
    return elgen::signature(fmt::format("{}void {}", function_macro(), function.name), arguments,
                            " noexcept");
  }

  std::string part_signature(const Function& function, std::size_t part,
                             const UsedNames& used) const override {
    Texts arguments = {result_type(function) + "&" + name_if_used(used, " result"),
                       fmt::format("{}<{}>&{}", workspace_name(function), workspace_types(),
                                   name_if_used(used, " w"))};
    const Texts own = argument_declarations(function, used);
    arguments.insert(arguments.end(), own.begin(), own.end());
    const std::string start = fmt::format("{}void {}", function_macro(), part_name(function, part));
    return elgen::signature(start, arguments, " noexcept");
  }

  std::string body_calling_parts(const Function& function, std::size_t parts) const override {
    std::string body;
    if (is_returned_by_value(function))
      body += fmt::format("  {} result;\n", result_type(function));
    body += fmt::format("  detail::{}<{}> w;\n", workspace_name(function), workspace_types());
    for (std::size_t part = 0; part < parts; ++part) {
      body += fmt::format("  detail::{}(result, w, {});\n", part_name(function, part),
                          fmt::join(argument_names_of(function), ", "));
    }
    return is_returned_by_value(function) ? body + "  return result;\n" : body;
  }

  std::string field_declaration(const Function& function, const Field& field) const override {
    return fmt::format("{} {};", type_of_field(kind_of_field(program(), function, field), field),
                       field.name);
  }

  std::string struct_name(const Function& function) const override {
    return camel_case(function.name);
  }

  std::string workspace_name(const Function& function) const override {
    return camel_case(function.name) + "Workspace";
  }

 protected:
  /// "Forces<Scalar>", "ForwardDynamics<Scalar>": the return type of a function.
  std::string result_type(const Function& function) const {
    if (returns_struct(function)) return camel_case(function.name) + "<Scalar>";
    return type_of_field(function.kind, function.fields.front());
  }

  /// "::cart_pole::": the qualifier of `detail::` outside the namespace of the header; "" inside.
  virtual std::string_view namespace_prefix() const { return ""; }

  /// The template arguments of a workspace.
  virtual std::string_view workspace_types() const { return "Scalar"; }

  /// Macro before the return type of a function, with a trailing blank.
  virtual std::string_view function_macro() const { return "ELGEN_FUNCTION "; }

  /// "[2]": the index after the name of an array.
  virtual std::string element_access(std::uint32_t index) const {
    return fmt::format("[{}]", index);
  }

  /// "SquareMatrix<Scalar>", "const Coordinates<Scalar>&"
  virtual std::string type_of_field(OutputKind kind, const Field& field) const {
    return field_type(model(), kind, field);
  }
  virtual std::string type_of_argument(Opcode argument) const {
    // The type of t is not deduced, so that callers may pass t as a number of another type.
    return fmt::format("const {}&", leaf_row(argument).type);
  }

  bool is_reserved(const std::string& name) const override {
    return is_emitted_name(name) || name.starts_with(angles_name);
  }

 private:
  /// "detail::Sine<Scalar>::of" for "sin", because the header computes sines in line if possible.
  std::string library_function_name(std::string_view name) const override {
    if (name != "sin" && name != "cos") return std::string(name);
    return helper_function_name(name == "sin" ? "Sine" : "Cosine") + "::of";
  }

  std::string helper_function_name(std::string_view name) const override {
    return fmt::format("{}detail::{}<{}>", namespace_prefix(), name, scalar_type());
  }

  Texts argument_declarations(const Function& function, const UsedNames& used) const {
    Texts texts;
    for (const Opcode argument : arguments_of(model(), function)) {
      texts.push_back(type_of_argument(argument) +
                      name_if_used(used, fmt::format(" {}", leaf_row(argument).symbol)));
    }
    return texts;
  }
};

/// Writes functions whose arguments are references to the memory of the caller, not copies. A type
/// states its size as a number (Vector<Scalar, 3>), because several arrays can have the same size.
class EigenDialect final : public CppDialect {
 public:
  using CppDialect::CppDialect;

  /// Assigns each entry, because double braces initialise an Eigen matrix differently from
  /// std::array.
  std::string return_statement(const Function& function, const Function& ordered,
                               const FieldTexts& entries) const override {
    const bool is_plain =
        !returns_struct(function) && is_scalar_field(function, function.fields.front());
    if (is_plain || !is_returned_by_value(function))
      return CppDialect::return_statement(function, ordered, entries);
    return fmt::format("  {} result;\n{}  return result;\n", result_type(function),
                       entry_assignments(*this, ordered, entries));
  }

 private:
  bool is_reserved(const std::string& name) const override {
    return is_eigen_name(name) || CppDialect::is_reserved(name);
  }

  std::string_view function_macro() const override { return ""; }

  std::string element_access(std::uint32_t index) const override {
    return fmt::format("({})", index);
  }

  std::string type_of_field(OutputKind kind, const Field& field) const override {
    return eigen_type(kind, field);
  }

  std::string type_of_argument(Opcode argument) const override {
    if (!is_vector(argument)) return CppDialect::type_of_argument(argument);
    return fmt::format("const Argument<Scalar, {}>&", leaf_count(model(), argument));
  }
};

/// Functions for numbers of a single type, which the header calls Scalar.
class WideDialect : public CppDialect {
 public:
  using CppDialect::CppDialect;

 private:
  std::string_view function_macro() const override { return "inline "; }
};

/// Functions for the type `scalar`. Their bodies use `name_space`::detail of the main header.
class TypedDialect : public CppDialect {
 public:
  TypedDialect(const Model& model, const Program& program, std::string_view scalar,
               const std::string& name_space)
      : CppDialect(model, program), scalar_(scalar), scope_("::" + name_space + "::") {}

  FormulaText convert_scalar(const FormulaText& value) const override {
    return {fmt::format("static_cast<{}>({})", scalar_, value.text)};
  }

 private:
  std::string_view scalar_type() const override { return scalar_; }
  std::string_view namespace_prefix() const override { return scope_; }

  std::string_view scalar_;
  std::string scope_;
};

/// Steps whose states are packs or numbers of type Scalar, and accelerations of type Inner.
class MixedDialect final : public TypedDialect {
 public:
  MixedDialect(const Model& model, const Program& program, const std::string& name_space)
      : TypedDialect(model, program, "Scalar", name_space),
        inner_(model, program, "Inner", name_space) {}

  const CompiledDialect* inner_vocabulary() const override { return &inner_; }

 private:
  std::string_view workspace_types() const override { return "Scalar, Inner"; }

  /// Parameters are the same for all states of a pack.
  std::string type_of_argument(Opcode argument) const override {
    if (argument == Opcode::parameter) return "const Parameters<double>&";
    return TypedDialect::type_of_argument(argument);
  }

  TypedDialect inner_;
};

}  // namespace

std::unique_ptr<CompiledDialect> cpp_dialect(const Model& model, const Program& program) {
  return std::make_unique<CppDialect>(model, program);
}

std::unique_ptr<CompiledDialect> eigen_dialect(const Model& model, const Program& program) {
  return std::make_unique<EigenDialect>(model, program);
}

std::unique_ptr<CompiledDialect> wide_dialect(const Model& model, const Program& program) {
  return std::make_unique<WideDialect>(model, program);
}

std::unique_ptr<CompiledDialect> mixed_dialect(const Model& model, const Program& program,
                                               const std::string& name_space) {
  return std::make_unique<MixedDialect>(model, program, name_space);
}

}  // namespace elgen
