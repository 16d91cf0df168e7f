// dialect: how a C-like language writes a function; definition.hpp puts the pieces together.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "elgen/program.hpp"
#include "elgen/scene.hpp"
#include "emit/code/function_formulas.hpp"
#include "emit/text/layout.hpp"

namespace elgen {

/// The variables that a body reads and writes, and the functions that it calls.
struct UsedNames {
  std::set<std::string_view> variables = {};  ///< "q", "w", "result"
  std::set<std::string_view> functions = {};  ///< of the library: "exp"
};

/// How a loop over columns is written.
struct ColumnWords {
  std::string opening = {};  ///< its first lines; `at` is the first of the columns of a pass
  std::string value = {};    ///< "const double": the declaration of a value without its name
  std::string load = {};     ///< takes the place of the first of some numbers, and gives a value
  std::string store = {};    ///< takes a value and such a place
};

/// How bodies are put together.
struct BodyRules {
  bool has_parts = true;  ///< long functions are in parts
  bool has_loops = true;  ///< repetitions are loops; else they are written out
  /// Parameters that are read more than once get a name: reading a member costs as much as an
  /// operation where code is interpreted.
  bool names_parameters = false;
  std::size_t deepest = 0;       ///< brackets in brackets that are read; 0: any
  std::size_t longest_name = 0;  ///< characters of a name that are read; 0: any
  CommentMarks comments = {};    ///< of members
};

/// The entries of each field, row-major.
using FieldTexts = std::vector<std::vector<std::string>>;

class Dialect : public Vocabulary {
 public:
  /// `access`: "." or "->", between a struct and its member.
  Dialect(const Model& model, const Program& program, LanguageId language, std::string_view access);

  [[nodiscard]] std::string leaf(Opcode kind, std::uint32_t number) const override;
  [[nodiscard]] FormulaText constant(const Constant& constant) const override = 0;
  [[nodiscard]] FormulaText square_root(const FormulaText& radicand) const override;
  [[nodiscard]] FormulaText call(FunctionId function,
                                 const std::vector<FormulaText>& arguments) const override;

  [[nodiscard]] const Dialect* inner() const override { return nullptr; }

  /// A temporary's name, with an underscore behind where it would hide something.
  [[nodiscard]] std::string temporary(const std::string& name) const;

  /// A temporary that several parts of a function share, where it is written and read.
  [[nodiscard]] std::string shared(const std::string& name) const;

  /// Whether one statement gives the sine and the cosine of an angle.
  [[nodiscard]] virtual bool has_pairs() const { return true; }

  /// "const auto [sin_x, cos_x] = detail::SineCosine<Scalar>::of(x);", a line or more: both values,
  /// declared here or not.
  [[nodiscard]] virtual std::string pair(const std::string& sine, const std::string& cosine,
                                         const FormulaText& angle, bool is_declared) const = 0;

  /// "const Scalar x": the declaration of a temporary, without its value.
  [[nodiscard]] virtual std::string declaration(const std::string& name) const = 0;

  /// "  const Scalar x = a + b;\n": a statement that gives `target` a value.
  [[nodiscard]] virtual std::string assignment(const std::string& target,
                                               const std::string& value) const;

  [[nodiscard]] virtual BodyRules rules() const { return {}; }

  /// Lines of documentation, as they can stand in the code.
  [[nodiscard]] virtual std::vector<std::string> documented(std::vector<std::string> lines) const {
    return lines;
  }

  /// "double": the type of numbers.
  [[nodiscard]] virtual std::string_view scalar() const = 0;

  /// A loop over so many columns.
  [[nodiscard]] virtual ColumnWords columns(std::uint32_t count) const = 0;

  /// "result.gravity[1]": where an entry is written, when it is not returned at once.
  [[nodiscard]] virtual std::string target(const Function& function, std::uint32_t field,
                                           std::uint32_t index) const = 0;

  /// The statements that end a function in one piece: a return, or empty where every entry is to
  /// be assigned to its target. The function says the type of what is returned, `ordered` and the
  /// entries say the order in which they are stored.
  [[nodiscard]] virtual std::string returned(const Function& function, const Function& ordered,
                                             const FieldTexts& entries) const = 0;

  /// The lines before the statements of a body: using-declarations, unused arguments.
  [[nodiscard]] virtual std::string opening(const Function& function, const UsedNames& used,
                                            bool is_part) const = 0;

  /// Everything before the brace of a function, or of one of its parts.
  [[nodiscard]] virtual std::string signature(const Function& function,
                                              const UsedNames& used) const = 0;
  [[nodiscard]] virtual std::string part_signature(const Function& function, std::size_t part,
                                                   const UsedNames& used) const = 0;

  /// The body that calls the parts one after another.
  [[nodiscard]] virtual std::string calling_body(const Function& function,
                                                 std::size_t parts) const = 0;

  /// "Forces<Scalar> gravity;": a member of the struct a function gives; empty where the language
  /// has no arrays without elements.
  [[nodiscard]] virtual std::string member(const Function& function, const Field& field) const = 0;

  /// "ForwardDynamics": the struct a function gives, and the one its parts share values in.
  [[nodiscard]] virtual std::string struct_name(const Function& function) const = 0;
  [[nodiscard]] virtual std::string workspace_name(const Function& function) const = 0;

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
  std::string access_;
  std::vector<std::string> parameters_;  ///< of each leaf number
};

}  // namespace elgen
