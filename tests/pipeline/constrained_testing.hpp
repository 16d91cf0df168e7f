// A model with constraints that has been through the pipeline. Fields of its outputs are computed
// by the program, in double and in 64 digits, and by the oracle.
#pragma once

#include <array>
#include <cmath>

#include "numbers/exact_number.hpp"
#include "oracle/model_builder.hpp"
#include "pipeline/pipeline_testing.hpp"
#include "program/evaluate/subject.hpp"

namespace elgen::test {

using ExactNumbers = std::vector<cln::cl_R>;

inline double double_of(const cln::cl_R& value) { return to_double(value); }

class Constrained {
 public:
  Constrained(const std::string& text, const std::string& outputs, const std::string& scene = {})
      : products_(derived(scene.empty() ? inputs_of(text) : inputs_of(text, scene), outputs)) {}

  [[nodiscard]] const Model& model() const { return products_.checked->model; }
  [[nodiscard]] const Program& program() const { return *products_.program; }
  [[nodiscard]] State nominal() const { return nominal_state(model(), products_.checked->scene); }

  [[nodiscard]] const Function& function(OutputKind kind) const {
    const Function* const found = find_function(program(), kind);
    if (found == nullptr) throw std::runtime_error("no such function in the program");
    return *found;
  }

  /// The field in double, from the program at the rounded state.
  [[nodiscard]] std::vector<double> double_field(OutputKind kind, const std::string& field,
                                                 const State& state) const {
    return part(kind, field, evaluate(program(), function(kind), arguments_at<double>(state)));
  }

  /// The field in 64 digits, from the program.
  [[nodiscard]] ExactNumbers exactly(OutputKind kind, const std::string& field,
                                     const State& state) const {
    const OracleValues values =
        to_oracle_values(evaluate(program(), function(kind), arguments_at<Real>(state)));
    return part(kind, field, values.value());
  }

  /// The field from the oracle.
  [[nodiscard]] ExactNumbers truth(OutputKind kind, const std::string& field,
                                   const State& state) const {
    const OutputRequest request{.kind = kind, .independent = function(kind).independent};
    return part(kind, field, oracle_values(model(), request, state).value());
  }

 private:
  template <class Number>
  [[nodiscard]] std::vector<Number> part(OutputKind kind, const std::string& field,
                                         const std::vector<Number>& values) const {
    auto begin = values.begin();
    for (const Field& each : function(kind).fields) {
      const auto end = begin + static_cast<std::ptrdiff_t>(each.entries.size());
      if (each.name == field) return {begin, end};
      begin = end;
    }
    throw std::runtime_error("no such field");
  }

  Products products_;
};

/// A reproducible state of rational numbers from 3/17 to 25/17; quaternions have length 1.
inline State random_state(const Constrained& system) {
  State state = system.nominal();
  const auto fill = [](std::vector<cln::cl_R>& leaves, int first) {
    for (std::size_t i = 0; i < leaves.size(); ++i) {
      leaves[i] = cln::cl_RA((first + 37 * static_cast<int>(i)) % 23 + 3) / 17;
    }
  };
  fill(state.q, 3);
  fill(state.v, 8);
  fill(state.reference, 17);
  fill(state.a, 5);
  fill(state.u, 20);
  for (const Rotation& rotation : system.model().rotations) {
    const std::array<int, 4> quaternion{1, 5, 1, 3};  // of length 6
    for (std::size_t i = 0; i < 4; ++i) {
      state.q[rotation.first_coordinate + i] = cln::cl_RA(quaternion[i]) / 6;
    }
  }
  return state;
}

/// Checks that each error is at most `tolerance` times the largest expected |entry|.
inline void check_close(const std::vector<double>& found, const ExactNumbers& expected,
                        double tolerance) {
  REQUIRE(found.size() == expected.size());
  const double scale = double_of(max_magnitude(expected));
  for (std::size_t i = 0; i < found.size(); ++i) {
    INFO("entry " << i << ": " << found[i] << " instead of " << double_of(expected[i]));
    CHECK(std::abs(found[i] - double_of(expected[i])) <= tolerance * scale);
  }
}

/// Checks that each error is at most 10^-digits times the largest expected |entry|.
inline void check_digits(const ExactNumbers& found, const ExactNumbers& expected, int digits) {
  REQUIRE(found.size() == expected.size());
  const cln::cl_R tolerance = max_magnitude(expected) * power_of_ten(-digits);
  for (std::size_t i = 0; i < found.size(); ++i) {
    INFO("entry " << i << ": " << double_of(found[i]) << " instead of " << double_of(expected[i]));
    CHECK(cln::abs(found[i] - expected[i]) <= tolerance);
  }
}

/// Compares `expected` with the oracle and the program to 40 digits, and with double to 1e-13.
inline void check_field(const Constrained& system, OutputKind kind, const std::string& field,
                        const State& state, const ExactNumbers& expected) {
  INFO(output_row(kind).name << " " << field);
  check_digits(system.truth(kind, field, state), expected, 40);
  check_digits(system.exactly(kind, field, state), expected, 40);
  check_close(system.double_field(kind, field, state), expected, 1e-13);
}

}  // namespace elgen::test
