// dialect: how a C-like language writes a function, where Spelling says how it writes expressions.
// definition.hpp puts the pieces together; what is no picture in templates/ is here.
#pragma once

#include <string>

#include "sections.hpp"
#include "statements.hpp"

namespace elgen {

class Dialect : public Spelling {
 public:
  /// "const Scalar x": the declaration of a temporary, without its value.
  [[nodiscard]] virtual std::string declaration(const std::string& name) const = 0;

  /// "result.gravity[1]": where an entry is written, when it is not returned at once.
  [[nodiscard]] virtual std::string target(const Function& function,
                                           const SectionItem& entry) const = 0;

  /// The statements that end a function in one piece: a return, or empty where every entry is to
  /// be assigned to its target. The function says the type of what is returned, `ordered` and the
  /// body say the order in which entries are stored.
  [[nodiscard]] virtual std::string returned(const Function& function, const Function& ordered,
                                             const FunctionBody& body) const = 0;

  /// What has to stand before the statements of a body: using-declarations, unused arguments.
  [[nodiscard]] virtual std::string opening(const Function& function, const std::string& statements,
                                            bool is_part) const = 0;

  /// Everything before the brace of a function, or of one of its parts.
  [[nodiscard]] virtual std::string signature(const Function& function,
                                              const std::string& body) const = 0;
  [[nodiscard]] virtual std::string part_signature(const Function& function, std::size_t part,
                                                   const std::string& body) const = 0;

  /// The body that calls the parts one after another.
  [[nodiscard]] virtual std::string calling_body(const Function& function,
                                                 std::size_t parts) const = 0;

  /// "Forces<Scalar> gravity;": a member of the struct a function gives; empty where the language
  /// has no arrays without elements.
  [[nodiscard]] virtual std::string member(const Function& function, const Field& field) const = 0;

  /// "ForwardDynamics": the struct a function gives, and the one its parts share values in.
  [[nodiscard]] virtual std::string struct_name(const Function& function) const = 0;
  [[nodiscard]] virtual std::string workspace_name(const Function& function) const = 0;
};

}  // namespace elgen
