// compiled_dialect: how C and C++ write statements; definition.hpp puts them together.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "emit/code/dialect.hpp"

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

/// How a compiled language, C++ or C99, writes the statements of a function.
class CompiledDialect : public Dialect {
 public:
  /// `access`: "." or "->", between a struct and its member.
  CompiledDialect(const Model& model, const Program& program, LanguageId language,
                  std::string_view access);

  [[nodiscard]] std::string leaf(Opcode kind, std::uint32_t number) const override;
  [[nodiscard]] const CompiledDialect* inner() const override { return nullptr; }
  [[nodiscard]] FunctionDefinition definition(const Function& function,
                                              Storage storage) const override;

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

  /// "ForwardDynamicsWorkspace": the struct in which the parts of a function share values.
  [[nodiscard]] virtual std::string workspace_name(const Function& function) const = 0;

 private:
  std::string access_;
  std::vector<std::string> parameters_;  ///< of each leaf number
};

}  // namespace elgen
