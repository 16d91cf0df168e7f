// derive_frame_steps: the motion of frames and of their bodies, as textbooks list it. A long
// quantity is written over components of earlier quantities.
//
//     short    omega_inner = (beta', alpha' sin beta, alpha' cos beta)
//     long     T_rotor = 1/2 A omega_rotor[1]^2 + 1/2 B omega_rotor[2]^2 + 1/2 C omega_rotor[3]^2
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "derive/tree/tree_dynamics.hpp"
#include "elgen/leaf_names.hpp"
#include "elgen/steps.hpp"

namespace elgen {

using GiNaC::ex;

namespace {

/// The most leaves and numbers of a component that is written over the leaves of the Lagrangian. T
/// of the rotor of a gyroscope in two gimbals has about 35.
constexpr std::size_t longest_component = 50;

/// Subtracts from `left` the number of leaves and numbers in `value`, with all definitions written
/// out. Returns false if `left` is too small.
bool fits(const Definitions& definitions, const ex& value, std::size_t& left) {
  const auto place = definitions.places.find(value);
  if (place != definitions.places.end() && place->second.is_definition) {
    return fits(definitions, definitions.list[place->second.index].value, left);
  }
  if (value.nops() == 0) return left-- > 0;
  for (std::size_t i = 0; i < value.nops(); ++i) {
    if (!fits(definitions, value.op(i), left)) return false;
  }
  return true;
}

class FrameStepsDerivation {
 public:
  FrameStepsDerivation(const Lagrangian& lagrangian, const Model& model)
      : derivation_(lagrangian),
        model_(model),
        tree_(tree_of(derivation_)),
        along_(derivation_.rate_without_acceleration) {}

  FrameSteps derive() {
    for (std::uint32_t k = 0; k < tree_.size(); ++k) add_transform(k);
    for (const RigidBody& body : tree_.frames().bodies) add_body(body);
    steps_.equations.symbols = derivation_.symbols;
    steps_.equations.leaves = derivation_.lagrangian.leaves;
    steps_.equations.definitions = std::move(derivation_.definitions);
    return std::move(steps_);
  }

 private:
  [[nodiscard]] Twist twist_at(std::optional<std::uint32_t> transform) const {
    return transform ? twists_[*transform] : Twist{};
  }

  /// Appends to `twists_`. The last transform of a frame adds the quantities of the frame.
  void add_transform(std::uint32_t k) {
    const TreeTransform& transform = tree_.transform(k);
    Twist twist = child_twist(tree_, k, twist_at(transform.parent), along_);
    const bool is_last = k + 1 == tree_.size() || tree_.transform(k + 1).origin != transform.origin;
    if (is_last && transform.origin.kind == EntityKind::frame) {
      twist.spin = add(FrameQuantity::spin, "omega_" + transform.name, twist.spin);
      if (!is_short(twist.velocity))
        twist.velocity = add(FrameQuantity::origin_rate, "nu_" + transform.name, twist.velocity);
    }
    twists_.push_back(twist);
  }

  void add_body(RigidBody body) {
    const bool is_point = body.origin.kind == EntityKind::point;
    const std::string& name = is_point ? model_.points[body.origin.index].identifier
                                       : model_.bodies[body.origin.index].identifier;
    Twist twist = twist_at(body.transform);
    ex energy = GiNaC::add(body_kinetic_energy(tree_.algebra, body, twist));
    if (has_mass(body)) {
      const ExVector3 velocity = add_centre(body, name, twist);
      if (!body.is_about_origin && !is_short({energy, 0, 0})) {
        body.com = {0, 0, 0};
        twist.velocity = velocity;
        energy = GiNaC::add(body_kinetic_energy(tree_.algebra, body, twist));
      }
    }
    add(FrameQuantity::energy, "T_" + name, {energy, 0, 0});
  }

  /// Adds the position of the centre of mass, and its velocity if it is not 0: in the world if both
  /// are short, otherwise in the frame. Returns the velocity.
  ExVector3 add_centre(const RigidBody& body, const std::string& name, const Twist& twist) {
    ExVector3 at = body.com;
    std::optional<std::uint32_t> k = body.transform;
    for (; k && is_short(at); k = tree_.transform(*k).parent) {
      at = tree_.to_parent(*k, at);
      const TreeTransform& transform = tree_.transform(*k);
      if (transform.kind == TransformKind::translation)
        at = tree_.algebra.add(at, transform.vector);
    }
    ExVector3 velocity = tree_.algebra.rate(at, along_);
    if (!k && is_short(at) && is_short(velocity)) {
      add(FrameQuantity::position, "r_" + name, at);
    } else {
      // A point that moves in its frame is the origin of its own transform.
      const bool moves =
          body.transform && tree_.transform(*body.transform).origin.kind == EntityKind::point;
      add(FrameQuantity::centre, "c_" + name,
          moves ? tree_.transform(*body.transform).vector : body.com);
      velocity = tree_.algebra.cross(twist.spin, body.com);
      velocity = tree_.algebra.add(twist.velocity, velocity);
    }
    return is_zero(velocity) ? velocity : add(FrameQuantity::velocity, "v_" + name, velocity);
  }

  /// `vector` over the leaves of the Lagrangian.
  [[nodiscard]] ExVector3 write_out(ExVector3 vector) {
    Substitution replace(derivation_.definitions, values_);
    for (ex& component : vector) component = replace(component);
    return vector;
  }

  [[nodiscard]] bool is_short(const ExVector3& vector) {
    return std::ranges::all_of(write_out(vector), [this](const ex& component) {
      std::size_t left = longest_component;
      return fits(derivation_.definitions, component, left);
    });
  }

  /// Adds a quantity, written out if it is short. Returns leaves for its components.
  ExVector3 add(FrameQuantity quantity, std::string name, ExVector3 components) {
    const bool is_planar = has_plane_vectors(model_);
    const bool is_turn = is_planar && quantity == FrameQuantity::spin;
    const bool is_scalar = is_turn || quantity == FrameQuantity::energy;
    const std::uint32_t first = is_turn ? 2U : 0U;
    const std::uint32_t rows = is_scalar || is_zero(components) ? 1U : is_planar ? 2U : 3U;
    while (has_value_named(model_, name)) name += "_";
    const ExVector3 values = write_out(components);
    if (is_short(components)) components = values;
    FieldEquations field{"", rows};
    for (std::uint32_t i = first; i < first + rows; ++i) {
      ex& component = components[i];
      component = field.entries.emplace_back(tree_.algebra.define(component));
      if (GiNaC::is_a<GiNaC::numeric>(component)) continue;
      const std::string own = is_scalar ? name : fmt::format("{}[{}]", name, i + 1);
      component = GiNaC::realsymbol(own);
      add_leaf(derivation_.definitions, component, Opcode::open_value);
      derivation_.lagrangian.symbols.f.push_back(component);
      derivation_.lagrangian.leaves.f.push_back(own);
      values_.emplace(component, values[i]);
    }
    const auto user = static_cast<std::uint32_t>(steps_.requests.size());
    const OutputRequest request{.kind = OutputKind::user_value, .user = user, .name = name};
    steps_.requests.push_back(request);
    steps_.equations.outputs.push_back({request, {std::move(field)}});
    steps_.quantities.push_back(quantity);
    return components;
  }

  Derivation derivation_;
  const Model& model_;
  KinematicTree& tree_;
  Tangent& along_;
  std::vector<Twist> twists_ = {};  ///< by transform
  Seeds values_ = {};  ///< leaf of a component -> value over the leaves of the Lagrangian
  FrameSteps steps_ = {};
};

}  // namespace

FrameSteps derive_frame_steps(const Lagrangian& lagrangian, const Model& model) {
  if (lagrangian.tree.bodies.empty()) return {};
  return FrameStepsDerivation(lagrangian, model).derive();
}

}  // namespace elgen
