// cpp_spelling: leaves, constants, calls and types of a Program -> C++ text.
#pragma once

#include <string>
#include <vector>

#include "elgen/model.hpp"
#include "elgen/program.hpp"
#include "statements.hpp"

namespace elgen {

/// p.m, p.l[2], q[0], v[0], a[0], u[0], t; constant<Scalar>(0.5), number_pi<Scalar>(); sin(x).
class CppSpelling final : public Spelling {
 public:
  CppSpelling(const Model& model, const Program& program);

  [[nodiscard]] std::string leaf(const Instruction& instruction) const override;
  [[nodiscard]] Term constant(const Constant& constant) const override;
  [[nodiscard]] std::string call(FunctionId function, const std::string& arguments) const override;
  [[nodiscard]] std::string square_root(const std::string& argument) const override;
  [[nodiscard]] std::string temporary(const std::string& name) const override;
  [[nodiscard]] std::string shared(const std::string& name) const override;

 private:
  std::vector<std::string> parameters_;  ///< of each leaf number
};

/// "Forces<Scalar>", "Scalar", "std::array<Scalar, 3>": what holds a field of a function.
[[nodiscard]] std::string field_type(OutputKind kind, const Field& field);

/// The row of the output table a field of `dynamics` is from; the function's own row otherwise.
[[nodiscard]] OutputKind kind_of_field(const Program& program, const Function& function,
                                       const Field& field);

/// Outputs beyond so many entries are written by reference: they would not fit a stack.
inline constexpr std::size_t largest_returned = 4096;
[[nodiscard]] bool is_returned(const Function& function);

}  // namespace elgen
