// Constraint: an equation that the motion of a Model satisfies. Held: a variable that a scene
// removes from a model, locked or cyclic.
#pragma once

#include <cln/real.h>

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
/// rates, for velocities. `value` is left side minus right side.
///
/// Let r = df/dt or phi, A = dr/dv, and gamma = dr/dt at a = 0. The motion satisfies A a + gamma =
/// -2 zeta omega r - omega^2 f. The multiplier acts as A^T lambda on the side of the inputs.
struct Constraint {
  std::string name;        ///< "rod"; with several equations "loop_x", "loop_1", "link_2[3]"
  std::string identifier;  ///< "link_2_3"
  ExpressionId value = 0;
  bool is_position = true;
  std::optional<ExpressionId> omega = {};  ///< omega of `stabilise`; none: 0
  std::optional<ExpressionId> zeta = {};
  std::optional<Unit> unit = {};  ///< of f or phi; none: unknown
  std::string doc = {};
  Span span = {};  ///< of the name of the entry
  Span equation_span = {};
  std::string equality = {};  ///< "z(P[i]) = z(Q)" for coincident points
};

/// The hint to write `equation` instead of `coincide` if the rows in `without` constrain nothing.
/// Empty for a row of `equation`, and if no row remains.
///
///     coincide = ["P", "Q"], y   ->   "`equation = ["x(P) = x(Q)", "z(P) = z(Q)"]` is enough"
[[nodiscard]] std::string equation_hint(const std::vector<Constraint>& rows,
                                        const std::vector<bool>& without, const Constraint& row);

inline constexpr std::uint32_t quaternion_size = 4;
inline constexpr std::uint32_t axis_count = 3;

/// A coordinate or rotation whose motion a scene prescribes or eliminates.
struct Held {
  std::uint32_t coordinate = 0;  ///< the first of a rotation
  std::uint32_t velocity = 0;    ///< the first of a rotation
  bool is_rotation = false;
  bool reaction = false;  ///< the force that holds it is an output
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
struct Lock : Held {
  std::vector<ExpressionId> values = {};  ///< s(t); of a rotation its unit quaternion
};

/// A cyclic coordinate that `[routh]` eliminates. Its constant momentum becomes a parameter.
struct Cyclic : Held {
  std::uint32_t parameter = 0;
  /// The momentum by numbers and parameters; none: the momentum at the start.
  std::optional<ExpressionId> form = {};
  /// The value of the parameter. The scene or an option fixes it, or find_momenta() computes it.
  std::optional<cln::cl_R> momentum = {};
};

/// The held variables of a scene, and the whole model, in which they move. They are eliminated
/// twice, independently: check removes them from the Model that the oracle reads, specialise from
/// the Lagrangian that is derived. Each result checks the other.
struct Variant {
  std::vector<Lock> locks = {};             ///< in the order of v of the whole model
  std::vector<Cyclic> cyclic = {};          ///< in the same order
  std::shared_ptr<const Model> whole = {};  ///< null: no variable is held
};

/// The new positions of the entries of a list after some entries are removed.
class RemainingPositions {
 public:
  /// Nothing is removed yet.
  explicit RemainingPositions(std::size_t size) : places_(size, 0) { remove(0, 0); }

  void remove(std::uint32_t first, std::uint32_t count) {
    std::uint32_t next = 0;
    for (std::uint32_t i = 0; i < places_.size(); ++i) {
      if (first <= i && i < first + count) places_[i].reset();
      if (places_[i]) places_[i] = next++;
    }
  }

  /// None for a removed entry.
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

  /// The list at its old size, with 0 for each removed entry.
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

/// The new positions of the entries of q, v and u after variables are removed.
struct RemainingVariables {
  RemainingPositions coordinates;
  RemainingPositions velocities;
  RemainingPositions inputs = RemainingPositions(0);

  void remove(const Held& variable) {
    coordinates.remove(variable.coordinate, variable.coordinate_count());
    velocities.remove(variable.velocity, variable.velocity_count());
  }
};

/// The velocities of the variables with `reaction`, in order.
template <class Variables>
[[nodiscard]] std::vector<std::uint32_t> velocities_with_reaction(const Variables& variables) {
  std::vector<std::uint32_t> velocities;
  for (const Held& variable : variables) {
    if (!variable.reaction) continue;
    for (std::uint32_t i = 0; i < variable.velocity_count(); ++i) {
      velocities.push_back(variable.velocity + i);
    }
  }
  return velocities;
}

}  // namespace elgen
