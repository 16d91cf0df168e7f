// A hand-written model and header for the toolchain's tests: one coordinate, a parameter, and an
// array of two parameters.
#pragma once

#include <string>

#include "elgen/toolchain.hpp"
#include "support/text.hpp"

namespace elgen::test::sample {

inline Model model() {
  Model model;
  model.name = "sample";
  append_coordinate(model, {.name = "x", .identifier = "x"});
  model.parameter_arrays.push_back({.name = "m", .first = 0});
  model.parameter_arrays.push_back({.name = "l", .first = 1, .count = 2, .is_array = true});
  model.parameters.push_back({.name = "m", .identifier = "m", .array = 0});
  model.parameters.push_back({.name = "l[1]", .identifier = "l_1", .array = 1, .element = 0});
  model.parameters.push_back({.name = "l[2]", .identifier = "l_2", .array = 1, .element = 1});
  return model;
}

inline Scene scene() {
  Scene scene;
  scene.base_name = "sample";
  return scene;
}

/// Inverse dynamics with one entry, and forward dynamics as a struct of two fields.
inline Program program() {
  Program program;
  program.leaves.parameters = {"m", "l[1]", "l[2]"};
  program.leaves.q = program.leaves.v = program.leaves.a = {"x"};
  // Reading an element makes its whole array an argument.
  program.functions.push_back(
      {.kind = OutputKind::inverse_dynamics,
       .name = "inverse_dynamics",
       .instructions = {{Opcode::parameter, {}, 0, 0}, {Opcode::parameter, {}, 2, 0}},
       .fields = {{.entries = {0}}}});
  program.functions.push_back({.kind = OutputKind::forward_dynamics,
                               .name = "forward_dynamics",
                               .fields = {{.name = "acceleration", .entries = {0}},
                                          {.name = "relative_pivots", .entries = {0}}}});
  return program;
}

inline std::string header() {
  return R"(#pragma once
#include <array>
#include <cstddef>
namespace sample {
inline constexpr std::size_t coordinate_count = 1, velocity_count = 1, input_count = 0;
template <class Scalar> struct Parameters { Scalar m; std::array<Scalar, 2> l; };
template <class Scalar> using Vector = std::array<Scalar, 1>;
template <class Scalar> using Inputs = std::array<Scalar, 0>;
template <class Scalar> struct Forward {
  Vector<Scalar> acceleration;
  Vector<Scalar> relative_pivots;
};
template <class Scalar>
Vector<Scalar> inverse_dynamics(const Parameters<Scalar>& p, const Vector<Scalar>& q,
                                const Vector<Scalar>& v, const Vector<Scalar>& a) noexcept {
  return {p.m * a[0] + p.l[0] * q[0] + p.l[1] * v[0]};
}
template <class Scalar>
Forward<Scalar> forward_dynamics(const Parameters<Scalar>& p, const Vector<Scalar>& q,
                                 const Vector<Scalar>& v, const Inputs<Scalar>&) noexcept {
  return {{p.l[0] * q[0] + v[0]}, {p.m}};
}
}  // namespace sample
)";
}

/// The two functions of program() in C, with numbers of the type `real`.
inline std::string c_functions(const std::string& real) {
  return replaced_all(R"(typedef struct sample_forward_dynamics_result {
  REAL acceleration[1];
  REAL relative_pivots[1];
} sample_forward_dynamics_result;
static inline void sample_inverse_dynamics(const sample_parameters *restrict p, const REAL *q,
                                           const REAL *v, const REAL *a, REAL *result) {
  result[0] = p->m * a[0] + p->l[0] * q[0] + p->l[1] * v[0];
}
static inline void sample_forward_dynamics(const sample_parameters *p, const REAL *q,
                                           const REAL *v, const REAL *u,
                                           sample_forward_dynamics_result *result) {
  (void)u;
  result->acceleration[0] = p->l[0] * q[0] + v[0];
  result->relative_pivots[0] = p->m;
}
)",
                      "REAL", real);
}

inline EmittedFiles files(const std::string& text) { return {{{"sample/sample.hpp", text}}}; }

}  // namespace elgen::test::sample
