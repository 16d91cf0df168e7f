// Positions, energies and forces of a random model at one state, computed with jets.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "random/model.hpp"

namespace elgen::test::random {

/// Places of coordinates in q and v: a scalar, or a rotation with four entries of q and three of v.
struct Layout {
  struct Place {
    std::string name;   ///< with its index: "q1", "r[2]"
    std::size_t q = 0;  ///< index of the first entry in q; the member `v`: index in v
    std::size_t v = 0;
    bool is_rotation = false;
    int lock = -1;  ///< index in the scene's locks, -1 if not locked
  };
  std::vector<Place> places;
  std::size_t q_count = 0;
  std::size_t v_count = 0;

  [[nodiscard]] const Place& place(const std::string& name) const;
};

/// The places of the model's coordinates; `locks` are the locked coordinates.
[[nodiscard]] Layout layout_of(const Model& model, const std::vector<Lock>& locks);

/// Arguments of the equations for all coordinates. Values of locked coordinates are ignored.
struct State {
  Vector q, v, a, u;
  Jet t;
};

/// Values of parameters by name and element ("" if not an array).
using ParameterValues = std::map<std::pair<std::string, std::string>, Number>;

struct Energies {
  Jet T, V, D, L;
};

/// A model at one state. Infinitesimal 0 is a change of time: the positions move with v.
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
  /// The angular velocity of a frame in world axes.
  Vector spin_of(const std::string& frame);
  Energies energies();
  /// The generalised force of all forces and inputs on one velocity. The state must contain
  /// infinitesimal `direction` as a term of this velocity.
  Jet force_along(unsigned direction);
  /// The velocities, with the rates of locked coordinates filled in.
  const Vector& rates() const { return v_; }

 private:
  const System& system_;
  const Layout& layout_;
  const ParameterValues& parameters_;
  Vector q_, v_, u_;
  Jet now_;
  std::map<std::string, Pose> poses_;
  std::map<std::pair<std::string, std::string>, Vector> positions_;

  void set_locked();
  const Vector& position_of(const std::string& point, const std::string& element);
  Matrix rotation_of(const Frame& frame, Vector& origin);
  Jet kinetic_energy_of(const Body& body);
  Jet body_mass_terms(const Body& body, const Vector& com, const Vector& spin_in_body);
  Jet weight(const Jet& mass, const Vector& position);
  void add_masses(Energies& energies);
  Jet power_of(const Force& force, unsigned direction);
};

/// The rate of a quaternion for an angular velocity in body axes.
[[nodiscard]] Vector quaternion_rate(const Vector& q, const Vector& spin);

}  // namespace elgen::test::random
