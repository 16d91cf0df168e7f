// cpp_dialect: functions as C++17 writes them, templated on the scalar; on vectors and matrices of
// Eigen; or of one type, which the header calls Scalar.
//
//     using std::sin;                                  Vector<Scalar, 2> result;
//     const Scalar sin_theta = sin(q[1]);              result(0) = p.m * sin(q[1]);
//     return {{p.m * sin_theta, p.g}};                 return result;
#pragma once

#include <memory>
#include <string>

#include "emit/code/compiled_dialect.hpp"

namespace elgen {

[[nodiscard]] std::unique_ptr<CompiledDialect> cpp_dialect(const Model& model,
                                                           const Program& program);
[[nodiscard]] std::unique_ptr<CompiledDialect> eigen_dialect(const Model& model,
                                                             const Program& program);
[[nodiscard]] std::unique_ptr<CompiledDialect> wide_dialect(const Model& model,
                                                            const Program& program);
/// Inner instructions in `Inner`, beside the functions in a namespace.
[[nodiscard]] std::unique_ptr<CompiledDialect> mixed_dialect(const Model& model,
                                                             const Program& program,
                                                             const std::string& name_space);

}  // namespace elgen
