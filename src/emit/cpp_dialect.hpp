// cpp_dialect: functions as C++17 writes them, templated on the scalar.
//
//     using std::sin;
//     const Scalar sin_theta = sin(q[1]);
//     return {{p.m * sin_theta, constant<Scalar>(0.0)}};
#pragma once

#include <string>
#include <vector>

#include "dialect.hpp"

namespace elgen {

class CppDialect : public Dialect {
 public:
  CppDialect(const Model& model, const Program& program) : Dialect(model, program, ".") {}

  [[nodiscard]] Formula constant(const Constant& constant) const override;
  [[nodiscard]] std::string temporary(const std::string& name) const override;
  [[nodiscard]] std::string declaration(const std::string& name) const override;
  [[nodiscard]] std::string target(const Function& function,
                                   const SectionItem& entry) const override;
  [[nodiscard]] std::string returned(const Function& function, const Function& ordered,
                                     const FunctionBody& body) const override;
  [[nodiscard]] std::string opening(const Function& function, const UsedNames& used,
                                    bool is_part) const override;
  [[nodiscard]] std::string signature(const Function& function,
                                      const UsedNames& used) const override;
  [[nodiscard]] std::string part_signature(const Function& function, std::size_t part,
                                           const UsedNames& used) const override;
  [[nodiscard]] std::string calling_body(const Function& function,
                                         std::size_t parts) const override;
  [[nodiscard]] std::string member(const Function& function, const Field& field) const override;
  [[nodiscard]] std::string struct_name(const Function& function) const override;
  [[nodiscard]] std::string workspace_name(const Function& function) const override;

 protected:
  /// "Forces<Scalar>", "ForwardDynamics<Scalar>": what the function returns.
  [[nodiscard]] std::string result_type(const Function& function) const;

  /// "[2]": after the name of an array.
  [[nodiscard]] virtual std::string element(std::uint32_t index) const;
  /// "SquareMatrix<Scalar>", "const Coordinates<Scalar>&"
  [[nodiscard]] virtual std::string type_of_field(OutputKind kind, const Field& field) const;
  [[nodiscard]] virtual std::string type_of_argument(Argument argument) const;

 private:
  [[nodiscard]] std::string library_function(std::string_view name) const override;
  [[nodiscard]] std::string own_function(std::string_view name) const override;
  [[nodiscard]] std::vector<std::string> declared_arguments(const Function& function,
                                                            const UsedNames& used) const;
};

}  // namespace elgen
