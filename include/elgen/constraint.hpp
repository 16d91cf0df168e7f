// Constraint: an equation that the motion of a Model satisfies. Held: a variable that a scene
// removes from the model, because it is locked (Lock) or cyclic (Cyclic).
#pragma once

#include <cln/real.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "elgen/expression.hpp"
#include "elgen/source_text.hpp"
#include "elgen/units.hpp"

namespace elgen {

struct Model;

/// One equation of a [[constraint]]: f(q, t) = 0 for positions, or phi(q, v, t) = 0, affine in the
/// rates, for velocities. `value` is the left side minus the right side of the equation.
///
///     r = df/dt or phi,   A = dr/dv,   gamma = dr/dt at a = 0
///     A a + gamma = -2 zeta omega r - omega^2 f,   M a + bias = B u + A^T lambda
struct Constraint {
  std::string name;        ///< "rod"; one of several equations: "loop_x", "loop_1", "link_2[3]"
  std::string identifier;  ///< `name` as an identifier: "link_2_3"
  ExpressionId value = 0;
  bool is_position = true;
  std::optional<ExpressionId> omega = {};  ///< omega of `stabilise`; none: 0
  std::optional<ExpressionId> zeta = {};
  std::optional<Unit> unit = {};  ///< unit of f or phi; none: unknown
  std::string doc = {};
  Span span = {};  ///< position of the name of the [[constraint]]
  Span equation_span = {};
  std::string equality = {};  ///< equation for `coincide`: "z(P[i]) = z(Q)"; else ""
};

/// The hint to write `equation` instead of `coincide`, if `row` is a row of `coincide`. The
/// equation keeps the rows of the same entry, except the rows that `is_vacuous` marks as having no
/// effect. Empty if `row` is a row of `equation`, or if all rows are marked.
///
///     coincide = ["P", "Q"], y marked  ->  "`equation = ["x(P) = x(Q)", "z(P) = z(Q)"]` is enough"
[[nodiscard]] std::string equation_hint(const std::vector<Constraint>& rows,
                                        const std::vector<bool>& is_vacuous, const Constraint& row);

inline constexpr std::uint32_t quaternion_size = 4;
inline constexpr std::uint32_t axis_count = 3;

/// A coordinate or rotation that a scene locks, or a coordinate that `[routh]` eliminates.
struct HeldCoordinate {
  std::uint32_t coordinate = 0;  ///< index of the coordinate, or of the rotation's first coordinate
  std::uint32_t velocity = 0;    ///< index of the velocity, or of the rotation's first velocity
  bool is_rotation = false;
  bool has_reaction = false;  ///< true: the output `reaction` contains the force of the lock
  Span span = {};

  [[nodiscard]] std::uint32_t velocity_count() const { return is_rotation ? axis_count : 1; }
  [[nodiscard]] std::uint32_t coordinate_count() const { return is_rotation ? quaternion_size : 1; }
  [[nodiscard]] bool has_coordinate(std::uint32_t index) const {
    return coordinate <= index && index < coordinate + coordinate_count();
  }
  [[nodiscard]] bool has_velocity(std::uint32_t index) const {
    return velocity <= index && index < velocity + velocity_count();
  }
};

/// A variable that a scene prescribes as a function of time.
struct LockedCoordinate : HeldCoordinate {
  std::vector<ExpressionId> values = {};  ///< s(t), or the four entries of a unit quaternion
};

/// A cyclic coordinate that `[routh]` eliminates. Its constant momentum becomes a parameter.
struct CyclicCoordinate : HeldCoordinate {
  std::uint32_t parameter = 0;
  /// The declared momentum, which contains only numbers and parameters; none: the momentum at the
  /// start.
  std::optional<ExpressionId> exact_expression = {};
  /// The value of `parameter`, from the scene, an option or set_routh_momenta().
  std::optional<cln::cl_R> momentum = {};
};

/// The held variables of a scene, and `unreduced`, the model that still contains them. The stage
/// check removes the variables from the Model, which the oracle evaluates; independently,
/// specialise removes the variables from the Lagrangian. Verification compares the results.
struct ModelReduction {
  std::vector<LockedCoordinate> locks = {};     ///< in the order of the velocities of `unreduced`
  std::vector<CyclicCoordinate> cyclic = {};    ///< in the order of the velocities of `unreduced`
  std::shared_ptr<const Model> unreduced = {};  ///< null if no variable is held
};

/// The new indices of the entries of a list after some entries are removed.
class RemainingIndices {
 public:
  /// Gives entry i of a list of `size` entries the index i.
  explicit RemainingIndices(std::size_t size) : places_(size, 0) { remove(0, 0); }

  void remove(std::uint32_t first, std::uint32_t count) {
    std::uint32_t next = 0;
    for (std::uint32_t i = 0; i < places_.size(); ++i) {
      if (first <= i && i < first + count) places_[i].reset();
      if (places_[i]) places_[i] = next++;
    }
  }

  /// The new index of entry `i`; none if the entry is removed.
  [[nodiscard]] const std::optional<std::uint32_t>& operator[](std::size_t i) const {
    return places_[i];
  }

  /// Erases the removed entries from a list.
  template <class List>
  void erase_removed(List& list) const {
    List left;
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (places_[i]) left.push_back(std::move(list[i]));
    }
    list = std::move(left);
  }

  /// A list of the old size: the entries of `left` at their old indices, and 0 for each removed
  /// entry.
  template <class List>
  [[nodiscard]] List with_zeros(const List& left) const {
    List list(places_.size());
    for (std::size_t i = 0; i < places_.size(); ++i) {
      if (places_[i]) list[i] = left[*places_[i]];
    }
    return list;
  }

 private:
  std::vector<std::optional<std::uint32_t>> places_;
};

/// The new indices of the entries of q, v and u after variables are removed.
struct RemainingVariables {
  RemainingIndices coordinates;
  RemainingIndices velocities;
  RemainingIndices inputs = RemainingIndices(0);

  void remove(const HeldCoordinate& variable) {
    coordinates.remove(variable.coordinate, variable.coordinate_count());
    velocities.remove(variable.velocity, variable.velocity_count());
  }
};

/// True if one of the variables has the velocity.
template <class Variables>
[[nodiscard]] bool has_velocity(const Variables& variables, std::uint32_t velocity) {
  return std::ranges::any_of(variables, [velocity](const HeldCoordinate& variable) {
    return variable.has_velocity(velocity);
  });
}

/// The indices of the velocities of the variables with `has_reaction`, in the order of `variables`.
template <class Variables>
[[nodiscard]] std::vector<std::uint32_t> velocities_with_reaction(const Variables& variables) {
  std::vector<std::uint32_t> velocities;
  for (const HeldCoordinate& variable : variables) {
    if (!variable.has_reaction) continue;
    for (std::uint32_t i = 0; i < variable.velocity_count(); ++i) {
      velocities.push_back(variable.velocity + i);
    }
  }
  return velocities;
}

}  // namespace elgen
