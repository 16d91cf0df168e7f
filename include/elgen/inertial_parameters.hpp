// InertialParameter: one entry of pi in tau = Y(q, v, a) pi + rest. The forces of a model are
// affine in all entries together. Their order is:
//
//     bodies in frames, in file order   m, m c, I_xx I_yy I_zz I_xy I_xz I_yz about the frame's
//                                       origin; planar: m, m c_x, m c_y, I_zz
//     other bodies                      m, and the moments of inertia as declared
//     points                            m
//     armatures, in the order of q      J of 1/2 J v_i^2
//     parameters                        the parameters in which D alone is linear, then the
//                                       parameters that `[regressor]` of a scene names
//
// Khalil, Dombre, Modeling, Identification and Control of Robots (2002), chapter 12.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "elgen/model.hpp"

namespace elgen {

enum class InertialOwner : std::uint8_t { body, point, coordinate, parameter };

/// The components of a body, by number: mass, first moments, moments of inertia.
inline constexpr std::uint32_t first_moment_component = 1;
inline constexpr std::uint32_t first_inertia_component = 4;
inline constexpr std::uint32_t components_of_body = 10;

/// The owner of an entry of pi in a model.
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

/// The owners of the entries of pi, in order. Cheaper than inertial_parameters(), since no names
/// are built.
[[nodiscard]] std::vector<InertialPlace> inertial_places(const Model& model);

[[nodiscard]] InertialParameter inertial_parameter(const Model& model, const InertialPlace& place);

/// The entries of pi of a model.
[[nodiscard]] std::vector<InertialParameter> inertial_parameters(const Model& model);

/// Two parameters that an expression contains as a product. Both are the same parameter if the
/// expression is not affine in it.
struct CoupledParameters {
  std::uint32_t first = 0;
  std::uint32_t second = 0;
};
[[nodiscard]] std::optional<CoupledParameters> find_coupled_parameters(
    const Model& model, ExpressionId expression, const std::vector<std::uint32_t>& parameters);

/// The parameters in order that occur in D, in no other root of the equations, and in which D is
/// jointly affine.
[[nodiscard]] std::vector<std::uint32_t> friction_parameters(const Model& model);

}  // namespace elgen
