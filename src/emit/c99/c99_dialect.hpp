// c99_dialect: functions as C99 writes them, for one scalar. All names begin with the prefix;
// arrays and structs are written through `result`, numbers are returned.
//
//     const float sin_theta = sinf(q[1]);
//     result[0] = p->m * sin_theta;
//     result[1] = 0.0f;
#pragma once

#include <memory>
#include <string>

#include "elgen/scene.hpp"
#include "emit/code/compiled_dialect.hpp"

namespace elgen {

/// The scalar C code is written for.
[[nodiscard]] ScalarKind c99_scalar(const Scene& scene);

/// "9.81", "9.81f", "-0.5": a literal of the scalar.
[[nodiscard]] std::string c99_literal(const cln::cl_R& value, ScalarKind scalar);

[[nodiscard]] std::unique_ptr<CompiledDialect> c99_dialect(const Model& model, const Scene& scene,
                                                           const Program& program);

}  // namespace elgen
