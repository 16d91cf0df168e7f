// c99_dialect: writes functions in C99 for a single scalar type. All names begin with the prefix of
// the scene. Arrays and structs are written through the pointer `result`; numbers are returned.
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

/// The scalar type of the C code: the first type that the scene lists.
[[nodiscard]] ScalarKind c99_scalar(const Scene& scene);

/// "9.81", "9.81f", "-0.5": a literal of this scalar type.
[[nodiscard]] std::string c99_literal(const cln::cl_R& value, ScalarKind scalar);

[[nodiscard]] std::unique_ptr<CompiledDialect> c99_dialect(const Model& model, const Scene& scene,
                                                           const Program& program);

}  // namespace elgen
