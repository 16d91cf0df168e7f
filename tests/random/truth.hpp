// The values of every output of a random model and scene, straight from the definition:
//
//     d/dt dL/dv - dL/dq = B u + Q - dD/dv      (with [w]x dL/dw where rotations turn, dL/dq along
//     N)
//
// L is evaluated on jets along the motion; M, C, g, … are derivatives and parts of it as
// models/README.md defines them. Approximations evaluate L cut at order + 1 in the scale of all
// that is small.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "random/motion.hpp"

namespace elgen::random {

// Infinitesimals: 0 belongs to Motion.
inline constexpr unsigned moment = 1;     ///< time runs
inline constexpr unsigned direction = 2;  ///< of dL/dv, dL/dq
inline constexpr unsigned second = 3;     ///< of second derivatives

/// Entries by "output" or "output.field", row by row.
using Values = std::map<std::string, std::vector<Number>>;

class Truth {
 public:
  /// Numbers of the state are of all coordinates; those of locked ones are not read.
  Truth(const System& system, ParameterValues parameters, State state);

  /// Every output that the system has, where its definition gives a value.
  [[nodiscard]] Values outputs();
  /// Numbers of q, v, a, u without locked coordinates.
  [[nodiscard]] const Layout& layout() const { return layout_; }
  [[nodiscard]] const State& state() const { return state_; }

 private:
  const System& system_;
  ParameterValues parameters_;
  Layout layout_;
  Layout whole_;  ///< nothing is locked in it
  State state_;
  std::vector<std::size_t> free_;  ///< indices in v of what is not locked
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
  [[nodiscard]] State resting(State state) const;

  void keep(const std::string& name, const Vector& entries);
  void keep(const std::string& name, const Matrix& rows);
  [[nodiscard]] Vector of_free(const Vector& all) const;
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

/// The state a moment later, by the given infinitesimal: q moves along v, v along a, t runs.
[[nodiscard]] State later(const Layout& layout, const State& state, unsigned index);
/// q moved along the velocity `index` alone.
[[nodiscard]] State displaced(const Layout& layout, const State& state, std::size_t index,
                              unsigned along);

/// Solves M x = b for every column; throws std::domain_error where M is singular.
[[nodiscard]] Matrix solved(Matrix M, Matrix columns);

/// The values that the files give parameters, fixed ones by the scene's.
[[nodiscard]] ParameterValues given_parameters(const System& system);

}  // namespace elgen::random
