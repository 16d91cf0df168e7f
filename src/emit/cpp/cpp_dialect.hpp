// cpp_dialect: functions in C++17, as templates on the scalar type or for a single type, which the
// header calls Scalar. Arguments of the templates are arrays, or Eigen's vectors and matrices.
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
/// The dialect of a step whose inner instructions compute in `Inner`. `name_space` is the namespace
/// of the main header.
[[nodiscard]] std::unique_ptr<CompiledDialect> mixed_dialect(const Model& model,
                                                             const Program& program,
                                                             const std::string& name_space);

}  // namespace elgen
