// EquationsOfMotion: the outputs in recursive form: entries over one ordered list of definitions.
//
//     M(q,t) a + C(q,v,t) v + drift + g + dD/dv = B u + Q
//     tau = M a + bias,   bias = C v + drift + g + dD/dv - Q
//
// Only the outputs of the scene are derived.
#pragma once

#include "elgen/lagrangian.hpp"
#include "elgen/scene.hpp"

namespace elgen {

struct FieldEquations {
  std::string name = {};  ///< "" if the output has only one field
  std::uint32_t rows = 1;
  std::uint32_t columns = 1;
  std::vector<GiNaC::ex> entries = {};  ///< row-major
};

struct OutputEquations {
  OutputRequest request = {};
  std::vector<FieldEquations> fields = {};
  ExpressionMap<std::string> value_names = {};  ///< symbol of a definition -> its name
  /// If the fields are the parts of an output (elgen/compose.hpp): the velocities in the order in
  /// which M is eliminated.
  std::vector<std::uint32_t> elimination_order = {};
};

struct EquationsOfMotion {
  Symbols symbols = {};
  LeafNames leaves = {};
  Definitions definitions = {};
  std::vector<OutputEquations> outputs = {};  ///< in the order of the scene, if has_equations()
  /// Forward dynamics by the articulated-body algorithm, with separate definitions, if this
  /// algorithm may give shorter code than elimination of M. If the code is certainly shorter,
  /// `outputs` does not contain forward dynamics.
  std::vector<EquationsOfMotion> alternatives = {};
};

/// The equations of every output in `outputs` with has_equations(). The headers of src/derive/
/// explain the mechanics. Errors: E313; E501, E537 or E603 if a pivot is 0; E908 if the definitions
/// exceed limits.derived_nodes.
[[nodiscard]] Result<EquationsOfMotion> derive(const Lagrangian& lagrangian,
                                               const std::vector<OutputRequest>& outputs,
                                               const Limits& limits);

/// V of [energy] at zero rates, and its derivatives by the variables x of V (coordinates and t).
/// The outputs are V, all dV/dx_i and, if derived, all d2V/dx_i dx_j with i <= j.
struct PotentialEquations {
  std::vector<GiNaC::ex> variables = {};  ///< the variables x, in the order of (q, t)
  std::vector<OutputRequest> requests = {};
  EquationsOfMotion equations = {};
};

/// V and its first derivatives and, if `has_second`, its second derivatives. None if V depends on
/// no coordinate or on rates, or if the scene expands the energies.
[[nodiscard]] std::optional<PotentialEquations> derive_potential(const Lagrangian& lagrangian,
                                                                 bool has_second);

/// `lagrangian` with V of [energy] replaced by an open value with the arguments `variables`. V and
/// its derivatives are numbered after the open values of the model, in the order of
/// PotentialEquations. Third derivatives are 0, so no output may use them.
[[nodiscard]] Lagrangian with_open_potential(Lagrangian lagrangian,
                                             const std::vector<GiNaC::ex>& variables);

[[nodiscard]] std::string dump(const EquationsOfMotion& equations);

}  // namespace elgen
