// dialect: the interface through which a language writes a function. compiled_dialect.hpp adds the
// statements of compiled languages; emit/source has the interpreted languages.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "elgen/program.hpp"
#include "elgen/scene.hpp"
#include "emit/code/function_formulas.hpp"
#include "emit/text/layout.hpp"

namespace elgen {

/// Rules of a language for names and members.
struct BodyRules {
  /// A parameter that is read more than once gets a local name: in interpreted code, reading a
  /// member costs as much as an operation.
  bool needs_parameter_names = false;
  std::size_t max_bracket_depth =
      0;  ///< nested brackets that the language can parse; 0: any number
  std::size_t max_name_length =
      0;                       ///< characters of a name that the language accepts; 0: any number
  CommentMarks comments = {};  ///< marks around the documentation of members
  bool groups_angles = false;  ///< a statement computes a group of angles; its calls need names
};

/// The entries of each field, row-major.
using FieldTexts = std::vector<std::vector<std::string>>;

/// The text before the braces, and the lines between them with indentation and line ends.
struct DefinitionText {
  std::string signature = {};
  std::string body = {};
};

/// The struct of values that several parts of a function use.
struct WorkspaceText {
  std::string name = {};
  std::vector<std::string> members = {};  ///< "Scalar sin_x", "Scalar given[60]"
};

struct FunctionDefinition {
  DefinitionText whole = {};
  std::vector<DefinitionText> parts = {};  ///< called by `whole`; empty if the function is short
  WorkspaceText workspace = {};            ///< shared by the parts
};

/// Texts of a loop over columns. One pass of the loop computes one or more columns.
struct ColumnLoopTexts {
  std::string opening = {};  ///< first lines; define `at`, the first column of a pass
  std::string value = {};    ///< "const double ": precedes the name of a new value
  std::string load = {};     ///< the value of a pass; {0}: array, {1}: "60 + ", before `at`
  std::string store = {};    ///< the line that stores {2} there
  std::string closing = {};
};

class Dialect : public Vocabulary {
 public:
  Dialect(const Model& model, const Program& program, LanguageId language)
      : model_(model), program_(program), language_(language) {}

  [[nodiscard]] FormulaText square_root(const FormulaText& radicand) const override;
  [[nodiscard]] FormulaText call(FunctionId function,
                                 const std::vector<FormulaText>& arguments) const override;

  /// `name` as the name of a temporary, with an underscore if `name` would hide another name.
  [[nodiscard]] std::string temporary_name(const std::string& name) const;

  [[nodiscard]] virtual BodyRules body_rules() const { return {}; }

  /// Lines of documentation, escaped for a comment of the language.
  [[nodiscard]] virtual std::vector<std::string> escape_docs(std::vector<std::string> lines) const {
    return lines;
  }

  /// "Forces<Scalar> gravity;": a member of the result struct; "" for an array of zero elements if
  /// the language has no such arrays.
  [[nodiscard]] virtual std::string field_declaration(const Function& function,
                                                      const Field& field) const = 0;

  /// "ForwardDynamics": the result struct of a function.
  [[nodiscard]] virtual std::string struct_name(const Function& function) const = 0;

  /// The texts of a loop over `count` columns.
  [[nodiscard]] virtual ColumnLoopTexts column_loop_texts(std::uint32_t count) const = 0;
  /// The line of a loop over columns that computes a value.
  [[nodiscard]] virtual std::string loop_assignment(const std::string& target,
                                                    const std::string& value) const = 0;

  [[nodiscard]] virtual FunctionDefinition function_definition(const Function& function,
                                                               Storage storage) const = 0;

 protected:
  /// True for sqrt and the functions of the model language.
  [[nodiscard]] static bool is_function_name(std::string_view name);
  [[nodiscard]] const Model& model() const { return model_; }
  [[nodiscard]] const Program& program() const { return program_; }
  /// True if a field is a number and not an array.
  [[nodiscard]] bool is_scalar_field(const Function& function, const Field& field) const;
  [[nodiscard]] std::vector<std::string_view> argument_names_of(const Function& function) const;
  /// The name of a function that the emitted code defines itself.
  [[nodiscard]] virtual std::string helper_function_name(std::string_view name) const = 0;

 private:
  /// True if the emitted code itself uses `name`; arguments and functions are checked separately.
  [[nodiscard]] virtual bool is_reserved(const std::string& name) const = 0;
  /// The name with which the language calls a function of the standard library. `name` is the C
  /// name for double.
  [[nodiscard]] virtual std::string library_function_name(std::string_view name) const = 0;

  const Model& model_;
  const Program& program_;
  LanguageId language_;
};

}  // namespace elgen
