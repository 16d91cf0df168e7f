// The values of every output of a random model and scene, directly from the definition:
//
//     d/dt dL/dv - dL/dq = B u + Q - dD/dv
//
// For a rotation with angular velocity w, [w]x dL/dw is added to the left side, and N^T dL/dq
// replaces dL/dq, with dq/dt = N w. L is evaluated on jets along the motion. M, C, g, ... are terms
// of this equation or derivatives of terms, as models/README.md defines them. Approximations
// truncate L after s^(order + 1), with the scale s of small quantities.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "random/motion.hpp"

namespace elgen::test::random {

// Indices of infinitesimals; index 0 belongs to Motion.
inline constexpr unsigned moment = 1;     ///< of time
inline constexpr unsigned direction = 2;  ///< of dL/dv and dL/dq
inline constexpr unsigned second = 3;     ///< of second derivatives

/// "output" or "output.field" -> entries, row by row.
using Values = std::map<std::string, std::vector<Number>>;

class Truth {
 public:
  /// The state has numbers for all coordinates. Numbers of locked coordinates are ignored.
  Truth(const System& system, ParameterValues parameters, State state);

  /// The values of every output for which the definition gives values at the state.
  [[nodiscard]] Values outputs();
  /// The places of coordinates with their locks, and the state.
  [[nodiscard]] const Layout& layout() const { return layout_; }
  [[nodiscard]] const State& state() const { return state_; }

 private:
  const System& system_;
  ParameterValues parameters_;
  Layout layout_;
  Layout whole_;  ///< without locks
  State state_;
  std::vector<std::size_t> free_;  ///< indices in v of velocities that are not locked
  Values values_;

  using Read = std::function<Jet(Motion&)>;
  [[nodiscard]] Jet read(const Layout& layout, const State& state, const Read& read) const;
  [[nodiscard]] State small(const Layout& layout, State state) const;
  [[nodiscard]] Jet lagrangian(const Layout& layout, const State& state) const;
  [[nodiscard]] Vector momentum(const Layout& layout, const State& state) const;
  [[nodiscard]] Vector inertial(const Layout& layout, const State& state) const;
  [[nodiscard]] Vector dissipation(const Layout& layout, const State& state) const;
  [[nodiscard]] Vector forces(const Layout& layout, const State& state) const;
  [[nodiscard]] Vector torque(const Layout& layout, const State& state) const;
  [[nodiscard]] Matrix mass_matrix(const State& state) const;
  [[nodiscard]] Matrix turning(const Vector& x) const;
  [[nodiscard]] Matrix coriolis_matrix(const Matrix& M) const;
  [[nodiscard]] Matrix torque_slopes(const State& at, bool has_inputs, bool by_velocity) const;
  [[nodiscard]] State state_at_rest(State state) const;

  void keep(const std::string& name, const Vector& entries);
  void keep(const std::string& name, const Matrix& rows);
  [[nodiscard]] Vector free_entries(const Vector& all) const;
  void add_velocity_terms(const Matrix& M);
  void add_energies();
  void add_forces();
  void add_solutions(const Matrix& M);
  void add_derivatives(const Matrix& M);
  void add_reaction();
  void add_kinematics();
  void add_output(const Output& output);
  [[nodiscard]] Vector output_values(const Output& output, const State& state) const;
  [[nodiscard]] Vector output_rates(const Output& output, const State& state) const;
};

/// The state after the infinitesimal time `index`: q moves along v, v along a, and t advances.
[[nodiscard]] State later(const Layout& layout, const State& state, unsigned index);
/// The state with q displaced along velocity number `index` by the infinitesimal `along`.
[[nodiscard]] State displaced(const Layout& layout, const State& state, std::size_t index,
                              unsigned along);

/// Solves M x = b for every column. Throws std::domain_error if M is singular.
[[nodiscard]] Matrix solved(Matrix M, Matrix columns);

/// The parameter values of the model file. Values that the scene fixes replace values of the file.
[[nodiscard]] ParameterValues given_parameters(const System& system);

}  // namespace elgen::test::random
