// InertialParameter: one entry of pi in tau = Y(q, v, a) pi + rest, the forces of a model being
// affine in all of them together.
//
//     bodies in frames, in file order   m, m c, I_xx I_yy I_zz I_xy I_xz I_yz about the frame's
//                                       origin; of a planar one m, m c_x, m c_y, I_zz
//     other bodies                      m, and the moments of inertia as they are given
//     points                            m
//     armatures, in the order of q      J of 1/2 J v_i^2
//     parameters                        those in which D alone is linear, then those that
//                                       `[regressor]` of a scene names
//
// Khalil, Dombre, Modeling, Identification and Control of Robots (2002), chapter 12.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "elgen/model.hpp"

namespace elgen {

enum class InertialOwner : std::uint8_t { body, point, coordinate, parameter };

/// The parameters of a body, by number: its mass, first moments and moments of inertia.
inline constexpr std::uint32_t first_moment_component = 1;
inline constexpr std::uint32_t first_inertia_component = 4;
inline constexpr std::uint32_t components_of_body = 10;

/// Where an entry of pi stands in a model.
struct InertialPlace {
  InertialOwner owner = InertialOwner::body;
  std::uint32_t index = 0;      ///< in the list of the owner
  std::uint32_t component = 0;  ///< of a body

  [[nodiscard]] bool is_mass() const {
    return owner == InertialOwner::point || (owner == InertialOwner::body && component == 0);
  }
};

struct InertialParameter : InertialPlace {
  std::string name = {};  ///< "hand.m", "hand.mx", "hand.Ixx", "armature.q1", "damping"
  std::optional<Unit> unit = {};
};

/// The places of the entries of pi, in order: cheap, since no name is built.
[[nodiscard]] std::vector<InertialPlace> inertial_places(const Model& model);

/// The entry of pi at a place.
[[nodiscard]] InertialParameter inertial_parameter(const Model& model, const InertialPlace& place);

/// pi of a model.
[[nodiscard]] std::vector<InertialParameter> inertial_parameters(const Model& model);

/// Two parameters of which a product stands below an expression, or one twice if it stands there in
/// another way than linearly.
struct CoupledParameters {
  std::uint32_t first = 0;
  std::uint32_t second = 0;
};
[[nodiscard]] std::optional<CoupledParameters> coupled_in(
    const Model& model, ExpressionId expression, const std::vector<std::uint32_t>& parameters);

/// The parameters that stand in D and nowhere else in the equations, and in which D is affine
/// together, in their order.
[[nodiscard]] std::vector<std::uint32_t> parameters_of_friction(const Model& model);

}  // namespace elgen
