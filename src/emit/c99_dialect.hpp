// c99_dialect: functions as C99 writes them, for one scalar. All names begin with the prefix;
// arrays and structs are written through `result`, numbers are returned.
//
//     const float sin_theta = sinf(q[1]);
//     result[0] = p->m * sin_theta;
//     result[1] = 0.0f;
#pragma once

#include <string>
#include <vector>

#include "dialect.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// The scalar C code is written for.
[[nodiscard]] ScalarKind c99_scalar(const Scene& scene);

/// "9.81", "9.81f", "-0.5": a literal of the scalar.
[[nodiscard]] std::string c99_literal(const cln::cl_R& value, ScalarKind scalar);

class C99Dialect final : public Dialect {
 public:
  C99Dialect(const Model& model, const Scene& scene, const Program& program);

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

 private:
  [[nodiscard]] std::string library_function(std::string_view name) const override;
  [[nodiscard]] std::string own_function(std::string_view name) const override;
  [[nodiscard]] std::vector<std::string> declared_arguments(const Function& function) const;
  /// "double": what a function returns where it gives one number.
  [[nodiscard]] bool gives_number(const Function& function) const;
  /// "double result[4]", "cart_pole_dynamics_result *result"
  [[nodiscard]] std::string result_argument(const Function& function) const;
  [[nodiscard]] std::string part_name(const Function& function, std::size_t part) const;

  ScalarKind scalar_kind_;
  std::string scalar_;  ///< "double"
  std::string prefix_;  ///< "cart_pole_"
};

}  // namespace elgen
