// c99_dialect: functions of <math.h> have the suffix f for float. The emitted header defines sign,
// min and max, because the C code must compute the same values as the C++ code, and fmin drops a
// NaN. The emitted header also defines the in-line sine and cosine.
#include "emit/c99/c99_dialect.hpp"

#include <fmt/ranges.h>

#include "emit/interface/code_interface.hpp"
#include "emit/text/layout.hpp"
#include "numbers/scalar_literal.hpp"
#include "program/evaluate/sines.hpp"

namespace elgen {
namespace {

using Texts = std::vector<std::string>;

/// "[7]"; "[]" for size 0, since C has no arrays of zero elements.
std::string extent_text(std::size_t size) { return size == 0 ? "[]" : fmt::format("[{}]", size); }

/// "dynamics_part_1"; the caller adds the prefix of the scene.
std::string c99_part_name(const Function& function, std::size_t part) {
  return fmt::format("{}_part_{}", function.name, part + 1);
}

/// "sine_of" for "sin", "cosine_of" for "cos": in-line functions of the header. "" for other names.
std::string_view inline_sine_name(std::string_view name) {
  return name == "sin" ? "sine_of" : name == "cos" ? "cosine_of" : "";
}

/// "  double sin_x, cos_x;\n  p_sine_cosine(x, &sin_x, &cos_x);\n"; an empty `scalar` omits the
/// declaration.
std::string sine_cosine_lines(const std::string& scalar, const std::string& call,
                              const std::string& sine, const std::string& cosine) {
  const std::string text = fmt::format("{}, &{}, &{})", call, sine, cosine);
  const Texts lines = wrap_expression(text, {line_width - 3, "      "});
  const std::string declared = fmt::format("  {} {}, {};\n", scalar, sine, cosine);
  return fmt::format("{}  {};\n", scalar.empty() ? "" : declared, fmt::join(lines, "\n"));
}

ColumnLoopTexts make_loop_texts(const std::string& prefix, std::uint32_t count) {
  const std::string width = upper_case(prefix) + "COLUMNS";
  return {fmt::format("  for (int first = 0; first < {0}; first += {1}) {{\n"
                      "    const int at = first + {1} < {0} ? first : {0} - {1};\n",
                      count, width),
          fmt::format("const {}columns ", prefix), prefix + "load_columns({0} + {1}at)",
          fmt::format("    {}store_columns({{2}}, {{0}} + {{1}}at);\n", prefix), "  }\n"};
}

class C99Dialect final : public CompiledDialect {
 public:
  C99Dialect(const Model& model, const Scene& scene, const Program& program)
      : CompiledDialect(model, program, LanguageId::c99, "->"),
        scalar_kind_(c99_scalar(scene)),
        scalar_(name_of(scalar_kind_)),
        prefix_(name_space(scene) + "_"),
        has_sine_cosine_calls_(has_inline_sines(scene, scalar_kind_)) {}

  FormulaText constant(const Constant& constant) const override {
    const bool is_negative = cln::minusp(constant.value);
    return {c99_literal(constant.value, scalar_kind_),
            is_negative ? Binding::negation : Binding::atom};
  }

  bool has_sine_cosine_calls() const override { return has_sine_cosine_calls_; }

  std::string sine_cosine_statement(const std::string& sine, const std::string& cosine,
                                    const FormulaText& angle, bool is_declared) const override {
    const std::string call = fmt::format("{}sine_cosine({}", prefix_, angle.text);
    return sine_cosine_lines(is_declared ? scalar_ : "", call, sine, cosine);
  }

  std::string declaration(const std::string& name) const override {
    return fmt::format("const {} {}", scalar_, name);
  }

  std::string_view scalar_type() const override { return scalar_; }

  ColumnLoopTexts column_loop_texts(std::uint32_t count) const override {
    return make_loop_texts(prefix_, count);
  }

  std::string assignment_target(const Function& function, std::uint32_t at,
                                std::uint32_t index) const override {
    const Field& field = function.fields[at];
    const std::string element = fmt::format("[{}]", index);
    if (field.name.empty()) return "result" + element;
    return "result->" + field.name + (is_scalar_field(function, field) ? "" : element);
  }

  std::string return_statement(const Function& function, const Function& /*ordered*/,
                               const FieldTexts& entries) const override {
    if (!returns_number(function)) return "";
    const Wrapping wrapping{line_width - 10, "      "};
    const Texts lines = wrap_expression(entries.front().front(), wrapping);
    return fmt::format("  return {};\n", fmt::join(lines, "\n"));
  }

  /// "  (void)q;" for each argument that the body does not use, so that compilers do not warn.
  std::string body_prologue(const Function& function, const UsedNames& used,
                            bool is_part) const override {
    std::vector<std::string_view> names = argument_names_of(function);
    if (is_part) names.emplace_back("w");
    if (is_part || !returns_number(function)) names.emplace_back("result");
    std::string lines;
    for (const std::string_view name : names) {
      if (used.variables.count(name) == 0) lines += fmt::format("  (void){};\n", name);
    }
    return lines;
  }

  std::string signature(const Function& function, const UsedNames& /*used*/) const override {
    Texts arguments = argument_declarations(function);
    const bool is_returned = returns_number(function);
    if (!is_returned) arguments.push_back(result_argument(function));
    return elgen::signature(fmt::format("static inline {} {}{}", is_returned ? scalar_ : "void",
                                        prefix_, function.name),
                            arguments, "");
  }

  std::string part_signature(const Function& function, std::size_t part,
                             const UsedNames& /*used*/) const override {
    Texts arguments = argument_declarations(function);
    arguments.push_back(workspace_name(function) + " *w");
    arguments.push_back(result_argument(function));
    return elgen::signature("static inline void " + prefix_ + c99_part_name(function, part),
                            arguments, "");
  }

  std::string body_calling_parts(const Function& function, std::size_t parts) const override {
    const bool is_returned = returns_number(function);
    std::string body = is_returned ? fmt::format("  {} result[1];\n", scalar_) : "";
    body += fmt::format("  {} w;\n", workspace_name(function));
    for (std::size_t part = 0; part < parts; ++part) {
      body += fmt::format("  {}{}({}, &w, result);\n", prefix_, c99_part_name(function, part),
                          fmt::join(argument_names_of(function), ", "));
    }
    return is_returned ? body + "  return result[0];\n" : body;
  }

  std::string field_declaration(const Function& function, const Field& field) const override {
    if (field.entries.empty()) return "";
    return fmt::format("{} {}{};", scalar_, field.name,
                       is_scalar_field(function, field) ? "" : extent_text(field.entries.size()));
  }

  std::string struct_name(const Function& function) const override {
    return prefix_ + function.name + "_result";
  }

  std::string workspace_name(const Function& function) const override {
    return prefix_ + function.name + "_workspace";
  }

 private:
  /// True for a name that no temporary may hide: a name of the header, which begins with the
  /// prefix, or fabs, fabsf, sinf, … of <math.h>.
  bool is_reserved(const std::string& name) const override {
    const bool is_float = name.ends_with('f');
    const std::string own = is_float ? name.substr(0, name.size() - 1) : name;
    return name.starts_with(prefix_) || own == "fabs" || (is_float && is_function_name(own));
  }

  std::string library_function_name(std::string_view name) const override {
    const std::string_view own = has_sine_cosine_calls_ ? inline_sine_name(name) : "";
    if (!own.empty()) return helper_function_name(own);
    const bool is_float = scalar_kind_ == ScalarKind::single_precision;
    return fmt::format("{}{}", name == "abs" ? "fabs" : name, is_float ? "f" : "");
  }

  std::string helper_function_name(std::string_view name) const override {
    return fmt::format("{}{}", prefix_, name);
  }

  Texts argument_declarations(const Function& function) const;

  bool returns_number(const Function& function) const {
    return !returns_struct(function) && is_scalar_field(function, function.fields.front());
  }

  /// "double result[4]", "cart_pole_dynamics_result *result"
  std::string result_argument(const Function& function) const {
    if (returns_struct(function)) return struct_name(function) + " *result";
    return fmt::format("{} result{}", scalar_, extent_text(entry_count(function)));
  }

  ScalarKind scalar_kind_;
  std::string scalar_;          ///< "double"
  std::string prefix_;          ///< "cart_pole_"
  bool has_sine_cosine_calls_;  ///< true if one in-line call computes sine and cosine
};

Texts C99Dialect::argument_declarations(const Function& function) const {
  Texts arguments;
  for (const Opcode argument : arguments_of(model(), function, program(), LanguageId::c99)) {
    const std::string_view name = leaf_row(argument).symbol;
    if (argument == Opcode::parameter) {
      arguments.push_back(fmt::format("const {}parameters *{}", prefix_, name));
    } else if (is_single(argument)) {
      arguments.push_back(fmt::format("{} {}", scalar_, name));
    } else {
      arguments.push_back(
          fmt::format("const {} {}{}", scalar_, name, extent_text(leaf_count(model(), argument))));
    }
  }
  return arguments;
}

}  // namespace

ScalarKind c99_scalar(const Scene& scene) { return scene.numerics.scalars.front(); }

std::string c99_literal(const cln::cl_R& value, ScalarKind scalar) {
  const bool is_float = scalar == ScalarKind::single_precision;
  return signed_literal(value, scalar) + (is_float ? "f" : "");
}

std::unique_ptr<CompiledDialect> c99_dialect(const Model& model, const Scene& scene,
                                             const Program& program) {
  return std::make_unique<C99Dialect>(model, scene, program);
}

}  // namespace elgen
