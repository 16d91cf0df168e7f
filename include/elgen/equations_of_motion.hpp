// EquationsOfMotion: the wanted outputs in recursive form: entries over one ordered list of
// definitions.
//
//     M(q,t) a + C(q,v,t) v + drift + g + dD/dv = B u + Q
//     tau = M a + bias,   bias = C v + drift + g + dD/dv - Q
//
// Derived only as far as the scene's outputs need it.
#pragma once

#include "elgen/lagrangian.hpp"
#include "elgen/scene.hpp"

namespace elgen {

struct FieldEquations {
  std::string name = {};  ///< "" for outputs of one field
  std::uint32_t rows = 1;
  std::uint32_t columns = 1;
  std::vector<GiNaC::ex> entries = {};  ///< row-major
};

struct OutputEquations {
  OutputRequest request = {};
  std::vector<FieldEquations> fields = {};
  ExpressionMap<std::string> told = {};  ///< names of definitions, by their symbols
  /// Where the fields are the parts of an output (elgen/compose.hpp): the velocities in the order
  /// in which M is eliminated.
  std::vector<std::uint32_t> elimination = {};
};

struct EquationsOfMotion {
  Symbols symbols = {};
  LeafNames leaves = {};
  Definitions definitions = {};
  std::vector<OutputEquations> outputs = {};  ///< in the order of the scene; without `dynamics`
  /// Forward dynamics by articulated bodies, where that may be shorter, over definitions of its
  /// own; where it is shorter whatever M is, it is not among `outputs`.
  std::vector<EquationsOfMotion> other_routes = {};
};

/// Derives every requested output (mechanics: see the headers of src/derive/).
[[nodiscard]] Result<EquationsOfMotion> derive(const Lagrangian& lagrangian,
                                               const std::vector<OutputRequest>& outputs,
                                               const Limits& limits);

/// V of [energy] at zero rates, and its derivatives by the coordinates, and t, that it depends on:
/// V, dV/dx_i, d2V/dx_i dx_j (i <= j), each an output of its own.
struct PotentialEquations {
  std::vector<GiNaC::ex> variables = {};  ///< x
  std::vector<OutputRequest> requests = {};
  EquationsOfMotion equations = {};
};

/// Without second derivatives where these are not wanted. None where V depends on no coordinate, or
/// on rates, or where a scene expands it.
[[nodiscard]] std::optional<PotentialEquations> derive_potential(const Lagrangian& lagrangian,
                                                                 bool has_second);

/// The same Lagrangian with V of [energy] as one leaf, whose derivatives are leaves too: open
/// values behind those of the model, in the order of PotentialEquations. Third derivatives are 0,
/// so that no output may take them.
[[nodiscard]] Lagrangian with_open_potential(Lagrangian lagrangian,
                                             const std::vector<GiNaC::ex>& variables);

[[nodiscard]] std::string dump(const EquationsOfMotion& equations);

}  // namespace elgen
