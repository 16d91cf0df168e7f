// dialect: how a language writes a function. compiled_dialect.hpp has the statements of compiled
// languages, emit/source the bodies of interpreted ones.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "elgen/program.hpp"
#include "elgen/scene.hpp"
#include "emit/code/function_formulas.hpp"
#include "emit/text/layout.hpp"

namespace elgen {

/// How names and members are written.
struct BodyRules {
  /// Parameters that are read more than once get a name: reading a member costs as much as an
  /// operation where code is interpreted.
  bool names_parameters = false;
  std::size_t deepest = 0;       ///< brackets in brackets that are read; 0: any
  std::size_t longest_name = 0;  ///< characters of a name that are read; 0: any
  CommentMarks comments = {};    ///< of members
};

/// The entries of each field, row-major.
using FieldTexts = std::vector<std::vector<std::string>>;

/// The text before the braces and between them: lines with indentation and line ends.
struct DefinitionText {
  std::string signature = {};
  std::string body = {};
};

/// The struct in which the parts of a function share values.
struct WorkspaceText {
  std::string name = {};
  std::vector<std::string> values = {};  ///< the names of values that several parts use
};

struct FunctionDefinition {
  DefinitionText whole = {};
  std::vector<DefinitionText> parts = {};  ///< called by the whole; none where it is short
  WorkspaceText workspace = {};            ///< of the parts
};

class Dialect : public Vocabulary {
 public:
  Dialect(const Model& model, const Program& program, LanguageId language)
      : model_(model), program_(program), language_(language) {}

  [[nodiscard]] FormulaText square_root(const FormulaText& radicand) const override;
  [[nodiscard]] FormulaText call(FunctionId function,
                                 const std::vector<FormulaText>& arguments) const override;

  /// A temporary's name, with an underscore behind where it would hide something.
  [[nodiscard]] std::string temporary(const std::string& name) const;

  [[nodiscard]] virtual BodyRules rules() const { return {}; }

  /// Lines of documentation, as they can stand in the code.
  [[nodiscard]] virtual std::vector<std::string> documented(std::vector<std::string> lines) const {
    return lines;
  }

  /// "Forces<Scalar> gravity;": a member of the struct a function gives; empty where the language
  /// has no arrays without elements.
  [[nodiscard]] virtual std::string member(const Function& function, const Field& field) const = 0;

  /// "ForwardDynamics": the struct a function gives.
  [[nodiscard]] virtual std::string struct_name(const Function& function) const = 0;

  /// The function with its statements.
  [[nodiscard]] virtual FunctionDefinition definition(const Function& function,
                                                      Storage storage) const = 0;

 protected:
  /// sqrt, or a function of the model language.
  [[nodiscard]] static bool is_function(std::string_view name);
  [[nodiscard]] const Model& model() const { return model_; }
  [[nodiscard]] const Program& program() const { return program_; }
  /// Whether a field is one number, and no array.
  [[nodiscard]] bool is_number(const Function& function, const Field& field) const;
  [[nodiscard]] std::vector<std::string_view> argument_names_of(const Function& function) const;

 private:
  /// Whether the header has the name for itself, beside arguments and functions.
  [[nodiscard]] virtual bool is_reserved(const std::string& name) const = 0;
  /// A function of the standard library, by its name for double.
  [[nodiscard]] virtual std::string library_function(std::string_view name) const = 0;
  /// A function of the header.
  [[nodiscard]] virtual std::string own_function(std::string_view name) const = 0;

  const Model& model_;
  const Program& program_;
  LanguageId language_;
};

}  // namespace elgen
