// Where everything of a random model is, and its energies and forces, for one state given in jets.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "random/model.hpp"

namespace elgen::random {

/// One entry of q, and of v: a scalar, or a component of a rotation (four of q, three of v).
struct Layout {
  struct Place {
    std::string name;   ///< with its index: "q1", "r[2]"
    std::size_t q = 0;  ///< of its first entry
    std::size_t v = 0;
    bool is_rotation = false;
    int lock = -1;  ///< of the scene, where it is held
  };
  std::vector<Place> places;
  std::size_t q_count = 0;
  std::size_t v_count = 0;

  [[nodiscard]] const Place& place(const std::string& name) const;
};

/// The places of the model's coordinates; `locks` says which are held.
[[nodiscard]] Layout layout_of(const Model& model, const std::vector<Lock>& locks);

/// Arguments of the equations, of all coordinates, held ones too (theirs are not read).
struct State {
  Vector q, v, a, u;
  Jet t;
};

/// Values of parameters, by name and element ("" of a single one).
using ParameterValues = std::map<std::pair<std::string, std::string>, Number>;

struct Energies {
  Jet T, V, D, L;
};

/// A model at one state. Positions move along v: infinitesimal 0 is that of time.
class Motion : public Scope {
 public:
  struct Pose {
    Matrix R;
    Vector p;
  };

  Motion(const System& system, const Layout& layout, const ParameterValues& parameters,
         const State& state);

  Jet value_of(const std::string& name, const std::string& element) override;
  Jet component_of(const std::string& point, const std::string& element, int axis) override;
  int dimension_of(const std::string& point) override;
  Jet now() override { return now_; }
  Vector turning_of(const std::string& frame, const std::string& axes) override;

  const Pose& pose_of(const std::string& frame);
  /// Angular velocity in world axes, velocity of the origin.
  Vector spin_of(const std::string& frame);
  Energies energies();
  /// Generalized force of every force and input on the velocity `v`, which infinitesimal
  /// `direction` has moved.
  Jet force_along(unsigned direction);
  /// The rates of locked coordinates, by v's index; others are as given.
  const Vector& rates() const { return v_; }

 private:
  const System& system_;
  const Layout& layout_;
  const ParameterValues& parameters_;
  Vector q_, v_, u_;
  Jet now_;
  std::map<std::string, Pose> poses_;
  std::map<std::pair<std::string, std::string>, Vector> positions_;

  void move_held();
  const Vector& position_of(const std::string& point, const std::string& element);
  Matrix turn_of(const Frame& frame, Vector& origin);
  Jet kinetic_energy_of(const Body& body);
  Jet body_mass_terms(const Body& body, const Vector& com, const Vector& spin_in_body);
  Jet weight(const Jet& mass, const Vector& position);
  void add_masses(Energies& energies);
  Jet power_of(const Force& force, unsigned direction);
};

/// Quaternion rates of an angular velocity in the axes of the body.
[[nodiscard]] Vector quaternion_rate(const Vector& q, const Vector& spin);

}  // namespace elgen::random
