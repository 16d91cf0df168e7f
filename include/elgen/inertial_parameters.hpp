// InertialParameter: one entry of pi in tau = Y(q, v, a) pi + rest, with `rest` independent of pi.
// The entries are, in this order (m: mass, c: centre of mass, I: inertia):
//
//     bodies in frames, in file order   m, m c, I_xx I_yy I_zz I_xy I_xz I_yz about the frame's
//                                       origin; planar: m, m c_x, m c_y, I_zz
//     other bodies                      m, and the moments of inertia as declared
//     points                            m
//     armatures, in the order of q      J of 1/2 J v_i^2
//     parameters                        the parameters that occur only in D, and linearly; then
//                                       the parameters that `[regressor]` of a scene names
//
// Khalil, Dombre, Modeling, Identification and Control of Robots (2002), chapter 12.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "elgen/model.hpp"

namespace elgen {

enum class InertialOwner : std::uint8_t { body, point, coordinate, parameter };

/// The ten components of a body are numbered: 0 is the mass, 1 to 3 are the first moments, 4 to 9
/// the moments of inertia.
inline constexpr std::uint32_t first_moment_component = 1;
inline constexpr std::uint32_t first_inertia_component = 4;
inline constexpr std::uint32_t body_component_count = 10;

/// One entry of pi: its owner in the model and, if the owner is a body, its component.
struct InertialEntry {
  InertialOwner owner = InertialOwner::body;
  std::uint32_t index = 0;      ///< index in Model::bodies, points, coordinates or parameters
  std::uint32_t component = 0;  ///< component of a body, 0 to 9; 0 for other owners

  [[nodiscard]] bool is_mass() const {
    return owner == InertialOwner::point || (owner == InertialOwner::body && component == 0);
  }
};

struct InertialParameter : InertialEntry {
  std::string name = {};  ///< "hand.m", "hand.mx", "hand.Ixx", "armature.q1", "damping"
  std::optional<Unit> unit = {};
};

/// The entries of pi, in order, without names and units. Cheaper than inertial_parameters().
[[nodiscard]] std::vector<InertialEntry> inertial_entries(const Model& model);

[[nodiscard]] InertialParameter inertial_parameter(const Model& model, const InertialEntry& place);

/// The entries of pi, in order, with names and units.
[[nodiscard]] std::vector<InertialParameter> inertial_parameters(const Model& model);

/// Two parameters whose product an expression contains. If the expression is not affine in one
/// parameter alone (p^2, for example), `first` and `second` are both this parameter.
struct CoupledParameters {
  std::uint32_t first = 0;
  std::uint32_t second = 0;
};
/// A coupled pair among `parameters`; none if `expression` is jointly affine in `parameters`.
[[nodiscard]] std::optional<CoupledParameters> find_coupled_parameters(
    const Model& model, ExpressionId expression, const std::vector<std::uint32_t>& parameters);

/// The indices of the parameters that occur in D, but in no other expression of the equations of
/// motion, and in which D is jointly affine. In the order of declaration.
[[nodiscard]] std::vector<std::uint32_t> friction_parameters(const Model& model);

}  // namespace elgen
