// SystemUnderTest: the model, scene and program of one system under verification. Functions here
// also convert between states of the oracle and arguments of the program.
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

struct SystemUnderTest {
  const Model& model;
  const Scene& scene;
  const Program& program;
  /// Functions that the scene does not request, but that save work of the oracle; may be null.
  /// Their values are compared with the oracle's before they are used.
  const Program* unrequested = nullptr;

  operator StateSpace() const { return {model, scene, program.leaves}; }
};

/// The exact state that the oracle gets for binary arguments. Fixed parameters keep their exact
/// values. Quaternions are scaled back to length 1. Scalar: double or float.
template <class Scalar>
[[nodiscard]] State exact_state(const SystemUnderTest& subject, const Arguments<Scalar>& arguments);

/// The program's arguments at an exact state, rounded if Scalar is a machine type.
template <class Scalar>
[[nodiscard]] Arguments<Scalar> arguments_at(const State& state) {
  return map_leaves([](const cln::cl_R& value) { return ScalarTraits<Scalar>::from_real(value); },
                    state);
}

/// The values as numbers; none if a value is undefined.
[[nodiscard]] OracleValues to_oracle_values(const std::vector<Real>& values);

/// The function of this kind; null if the program has none.
[[nodiscard]] const Function* find_function(const Program& program, OutputKind kind,
                                            std::uint32_t user = 0);

/// 2 zeta omega r + omega^2 f for each position constraint f = 0, r = df/dt; 2 zeta omega r for
/// each velocity constraint r = 0. `residual` holds all f, then all r.
[[nodiscard]] std::vector<Real> stabilising_terms(const Model& model, const State& state,
                                                  const std::vector<Real>& residual);

/// "q = (0.1, 2), v = (3, -1), u = (0.5), t = 2". Parameters appear only if they differ from their
/// nominal value; lists end after 8 numbers.
[[nodiscard]] std::string describe_state(const SystemUnderTest& subject, const State& state);

/// describe_state() with 17 digits for every number, and with complete lists.
[[nodiscard]] std::string describe_state_exactly(const SystemUnderTest& subject,
                                                 const State& state);

/// Six significant digits of an exact number; three, with a power of ten, if double cannot hold it.
[[nodiscard]] std::string short_number_text(const cln::cl_R& value);

}  // namespace elgen
