// eigen_dialect: functions as C++17 writes them, on vectors and matrices of Eigen: arguments are
// read where they lie, and results are written into the matrix that is returned.
//
//     Vector<Scalar, 2> result;
//     result(0) = p.m * sin(q[1]);
//     return result;
#pragma once

#include <string>

#include "cpp_dialect.hpp"

namespace elgen {

class EigenDialect final : public CppDialect {
 public:
  using CppDialect::CppDialect;

  [[nodiscard]] std::string temporary(const std::string& name) const override;
  [[nodiscard]] std::string returned(const Function& function, const Function& ordered,
                                     const FunctionBody& body) const override;

 private:
  [[nodiscard]] std::string element(std::uint32_t index) const override;
  [[nodiscard]] std::string type_of_field(OutputKind kind, const Field& field) const override;
  [[nodiscard]] std::string type_of_argument(Argument argument) const override;
};

/// Whether templates/cpp/eigen.hpp.mustache needs the name for itself.
[[nodiscard]] bool is_eigen_name(const std::string& name);

}  // namespace elgen
