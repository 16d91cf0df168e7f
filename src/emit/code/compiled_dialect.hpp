// compiled_dialect: the statements of C and C++; definition.hpp assembles them.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "emit/code/dialect.hpp"

namespace elgen {

/// Variables that a body reads or writes, and library functions that it calls.
struct UsedNames {
  std::set<std::string_view> variables = {};  ///< "q", "w", "result"
  std::set<std::string_view> functions = {};  ///< of the standard library: "exp"
};

/// An angle and the names of its sine and cosine; "" for a value that the function does not use.
struct AngleTexts {
  FormulaText angle = {};
  std::string sine = {};
  std::string cosine = {};
};

/// Writes the statements of a function in a compiled language, C++ or C99.
class CompiledDialect : public Dialect {
 public:
  /// `access`: "." or "->", selects a member of the parameters or the workspace.
  CompiledDialect(const Model& model, const Program& program, LanguageId language,
                  std::string_view access);

  [[nodiscard]] std::string leaf(Opcode kind, std::uint32_t number) const override;
  [[nodiscard]] FormulaText at_run_time(const FormulaText& number) const override {
    return named_call_text(helper_function_name("at_run_time"), {number});
  }
  [[nodiscard]] const CompiledDialect* inner_vocabulary() const override { return nullptr; }
  [[nodiscard]] std::string loop_assignment(const std::string& target,
                                            const std::string& value) const override;
  [[nodiscard]] FunctionDefinition function_definition(const Function& function,
                                                       Storage storage) const override;

  /// The workspace member of a temporary that several parts of a function use.
  [[nodiscard]] std::string workspace_member(const std::string& name) const;

  /// True if a single statement computes the sine and the cosine of an angle.
  [[nodiscard]] virtual bool has_sine_cosine_calls() const { return true; }

  /// "const auto [sin_x, cos_x] = detail::SineCosine<Scalar>::of(x);": one or more lines that
  /// compute both values, and declare them if `is_declared`.
  [[nodiscard]] virtual std::string sine_cosine_statement(const std::string& sine,
                                                          const std::string& cosine,
                                                          const FormulaText& angle,
                                                          bool is_declared) const = 0;

  /// The lines that compute the sines and cosines of several angles together. `number`: of the
  /// group in its function, from 1. Called only if body_rules() has `groups_angles`.
  [[nodiscard]] virtual std::string angles_statement(const std::vector<AngleTexts>& /*angles*/,
                                                     std::size_t /*number*/,
                                                     bool /*is_declared*/) const {
    return {};
  }

  /// "const Scalar x": declares a temporary, without its value.
  [[nodiscard]] virtual std::string declaration(const std::string& name) const = 0;

  /// "double", "Scalar": the type of numbers.
  [[nodiscard]] virtual std::string_view scalar_type() const = 0;

  /// "result.gravity[1]": the destination of an entry that is not part of a return statement.
  [[nodiscard]] virtual std::string assignment_target(const Function& function, std::uint32_t field,
                                                      std::uint32_t index) const = 0;

  /// The end of a function that is not cut into parts: a return statement, or "" if the caller must
  /// assign each entry to its target. `function` defines the return type; `ordered` and `entries`
  /// have storage order.
  [[nodiscard]] virtual std::string return_statement(const Function& function,
                                                     const Function& ordered,
                                                     const FieldTexts& entries) const = 0;

  /// The lines before the statements of a body: using-declarations, or casts of unused arguments.
  [[nodiscard]] virtual std::string body_prologue(const Function& function, const UsedNames& used,
                                                  bool is_part) const = 0;

  /// Everything before the opening brace of a function or of one of its parts.
  [[nodiscard]] virtual std::string signature(const Function& function,
                                              const UsedNames& used) const = 0;
  [[nodiscard]] virtual std::string part_signature(const Function& function, std::size_t part,
                                                   const UsedNames& used) const = 0;

  /// The body that calls the parts in order.
  [[nodiscard]] virtual std::string body_calling_parts(const Function& function,
                                                       std::size_t parts) const = 0;

  /// "ForwardDynamicsWorkspace": the struct of values that several parts of a function use.
  [[nodiscard]] virtual std::string workspace_name(const Function& function) const = 0;

 private:
  std::string access_;
  std::vector<std::string> parameters_;  ///< the member of each parameter leaf: "l[2]"
};

}  // namespace elgen
