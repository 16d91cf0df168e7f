// Subject: the three views of one system that verification compares, and the ways between their
// states.
#pragma once

#include <string>

#include "elgen/domain.hpp"
#include "elgen/evaluate.hpp"
#include "elgen/model.hpp"
#include "elgen/oracle.hpp"
#include "elgen/program.hpp"
#include "elgen/scene.hpp"
#include "numbers/exact_number.hpp"

namespace elgen {

struct Subject {
  const Model& model;
  const Scene& scene;
  const Program& program;

  operator StateSpace() const { return {model, scene, program.leaves}; }
};

/// The exact state the oracle gets for binary inputs; fixed parameters stay the exact numbers they
/// are, and quaternions get the length 1 that rounding took from them. Scalar: double or float.
template <class Scalar>
[[nodiscard]] State exact_state(const Subject& subject, const Arguments<Scalar>& arguments);

/// The arguments of a program at an exact state, rounded to Scalar where Scalar rounds.
template <class Scalar>
[[nodiscard]] Arguments<Scalar> arguments_at(const State& state) {
  return map_leaves([](const cln::cl_R& value) { return ScalarTraits<Scalar>::from_real(value); },
                    state);
}

/// The numbers behind Reals; none where one is undefined.
[[nodiscard]] OracleValues defined_values(const std::vector<Real>& values);

/// Null where the program has no function of this kind.
[[nodiscard]] const Function* find_function(const Program& program, OutputKind kind,
                                            std::uint32_t user = 0);

/// 2 zeta omega r + omega^2 f of each constraint, for the entries of a residual: f, then r.
[[nodiscard]] std::vector<Real> stabilising_terms(const Model& model, const State& state,
                                                  const std::vector<Real>& residual);

/// "q = (0.1, 2), v = (3, -1), u = (0.5), t = 2"; parameters only where they are not at their
/// value.
[[nodiscard]] std::string describe(const Subject& subject, const State& state);

/// The same with every number in 17 digits, and none left out.
[[nodiscard]] std::string describe_exactly(const Subject& subject, const State& state);

/// Six significant digits of an exact number, whatever its size.
[[nodiscard]] std::string short_text(const cln::cl_R& value);

}  // namespace elgen
