// derive_frame_steps: the motion of frames and of their bodies, as textbooks list it. T uses the
// same twists and velocities (tree_kinetic_energy()).
//
//     short    omega_inner = (beta', alpha' sin beta, alpha' cos beta)
//     long     T_rotor = 1/2 A omega_rotor_x^2 + 1/2 B omega_rotor_y^2 + 1/2 C omega_rotor_z^2
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
  if (value.nops() == 0) {
    if (left == 0) return false;
    --left;
    return true;
  }
  for (std::size_t i = 0; i < value.nops(); ++i) {
    if (!fits(definitions, value.op(i), left)) return false;
  }
  return true;
}

/// `whole` is over the leaves of the Lagrangian, `parts` over components of earlier quantities.
template <class Value>
struct BothForms {
  Value whole = {};
  Value parts = {};
};
using Forms = BothForms<ExVector3>;

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
  using TransformIndex = std::optional<std::uint32_t>;
  using TwistForms = BothForms<Twist>;

  [[nodiscard]] TwistForms twist_at(TransformIndex transform) const {
    return transform ? twists_[*transform] : TwistForms{};
  }

  /// Appends to `twists_`. The last transform of a frame adds the quantities of the frame.
  void add_transform(std::uint32_t k) {
    const TreeTransform& transform = tree_.transform(k);
    auto [whole, parts] = twist_at(transform.parent);
    whole = child_twist(tree_, k, whole, along_);
    parts = child_twist(tree_, k, parts, along_);
    if (ends_frame(k)) {
      const std::string& name = transform.name;
      parts.spin = add({FrameQuantityKind::spin}, "omega_" + name, {whole.spin, parts.spin});
      if (is_short(whole.velocity)) {
        parts.velocity = whole.velocity;
      } else {
        parts.velocity = add({FrameQuantityKind::origin_velocity}, "nu_" + name,
                             {whole.velocity, parts.velocity});
      }
    }
    twists_.push_back({whole, parts});
  }

  [[nodiscard]] bool ends_frame(std::uint32_t k) const {
    const Entity& origin = tree_.transform(k).origin;
    if (origin.kind != EntityKind::frame) return false;
    if (k + 1 == tree_.size()) return true;
    const Entity& next = tree_.transform(k + 1).origin;
    return next.kind != origin.kind || next.index != origin.index;
  }

  void add_body(const RigidBody& body) {
    const bool is_point = body.origin.kind == EntityKind::point;
    const std::string& name = is_point ? model_.points[body.origin.index].identifier
                                       : model_.bodies[body.origin.index].identifier;
    auto [whole, parts] = twist_at(body.transform);
    RigidBody shown = body;
    if (has_mass(body)) {
      const std::optional<ExVector3> rate = add_position(body, name);
      const Forms velocity{rate ? *rate : com_velocity(body, whole),
                           rate ? *rate : com_velocity(body, parts)};
      const ExVector3 leaves = add({FrameQuantityKind::velocity}, "v_" + name, velocity);
      if (!body.is_about_origin) {
        shown.com = {0, 0, 0};
        whole.velocity = velocity.whole;
        parts.velocity = leaves;
      }
    }
    const ex energy = GiNaC::add(body_kinetic_energy(tree_.algebra, shown, whole));
    const ex of_parts = GiNaC::add(body_kinetic_energy(tree_.algebra, shown, parts));
    add({FrameQuantityKind::energy}, "T_" + name, {{energy, 0, 0}, {of_parts, 0, 0}});
  }

  /// Adds the position of the centre of mass: in the world if it is short, otherwise in the frame.
  /// Returns the rate of the position in the world, if a rotation turns the frame.
  std::optional<ExVector3> add_position(const RigidBody& body, const std::string& name) {
    ExVector3 at = body.com;
    ExVector3 local = at;
    FrameQuantity position{FrameQuantityKind::position};
    bool is_rotated = false;
    for (TransformIndex k = body.transform; k && (!position.frame || is_short(at));
         k = tree_.transform(*k).parent) {
      const TreeTransform& transform = tree_.transform(*k);
      if (transform.origin.kind == EntityKind::frame && !position.frame) {
        position.frame = transform.origin.index;
        local = at;
      }
      is_rotated = is_rotated || transform.rotation;
      at = tree_.to_parent(*k, at);
      if (transform.kind != TransformKind::translation) continue;
      at = tree_.algebra.add(at, transform.vector);
    }
    if (is_short(at)) {
      position.frame.reset();
      local = at;
    }
    add(position, "r_" + name, {local, local});
    if (position.frame || !is_rotated) return std::nullopt;
    return tree_.algebra.rate(local, along_);
  }

  [[nodiscard]] ExVector3 com_velocity(const RigidBody& body, const Twist& twist) {
    const ExVector3 carried = tree_.algebra.cross(twist.spin, body.com);
    return tree_.algebra.add(twist.velocity, carried);
  }

  [[nodiscard]] bool is_short(const ExVector3& vector) const {
    return std::ranges::all_of(vector, [this](const ex& component) {
      std::size_t left = longest_component;
      return fits(derivation_.definitions, component, left);
    });
  }

  /// Adds the whole form of a quantity, or its parts if the whole form is long. Returns leaves for
  /// its components.
  ExVector3 add(const FrameQuantity& quantity, std::string name,
                const BothForms<ExVector3>& forms) {
    const bool is_planar = has_plane_vectors(model_);
    const bool is_turn = is_planar && quantity.kind == FrameQuantityKind::spin;
    const bool is_scalar = is_turn || quantity.kind == FrameQuantityKind::energy;
    const std::uint32_t first = is_turn ? 2U : 0U;
    const std::uint32_t rows = is_scalar ? 1U : is_planar ? 2U : 3U;
    while (has_value_named(model_, name)) name += "_";
    ExVector3 components = is_short(forms.whole) ? forms.whole : forms.parts;
    FieldEquations field{"", rows};
    for (std::uint32_t axis = first; axis < first + rows; ++axis) {
      ex& component = components[axis];
      component = field.entries.emplace_back(tree_.algebra.define(component));
      component = leaf_for(component, is_scalar ? name : name + "_" + "xyz"[axis]);
    }
    OutputRequest request;
    request.kind = OutputKind::user_value;
    request.user = static_cast<std::uint32_t>(steps_.requests.size());
    request.name = name;
    steps_.requests.push_back(request);
    steps_.equations.outputs.push_back({request, {std::move(field)}});
    steps_.quantities.push_back(quantity);
    return components;
  }

  /// A leaf in place of `value`. Numbers and leaves stand for themselves.
  [[nodiscard]] ex leaf_for(const ex& value, const std::string& name) {
    Definitions& definitions = derivation_.definitions;
    const auto is_definition = [&](const ex& symbol) {
      return definitions.places.at(symbol).is_definition;
    };
    if (std::ranges::none_of(symbols_of(definitions, value), is_definition)) return value;
    const ex leaf = GiNaC::realsymbol(name);
    add_leaf(definitions, leaf, Opcode::open_value);
    derivation_.lagrangian.symbols.f.push_back(leaf);
    derivation_.lagrangian.leaves.f.push_back(name);
    return leaf;
  }

  Derivation derivation_;
  const Model& model_;
  KinematicTree& tree_;
  Tangent& along_;
  std::vector<TwistForms> twists_ = {};  ///< by transform
  FrameSteps steps_ = {};
};

}  // namespace

FrameSteps derive_frame_steps(const Lagrangian& lagrangian, const Model& model) {
  if (lagrangian.tree.bodies.empty()) return {};
  return FrameStepsDerivation(lagrangian, model).derive();
}

}  // namespace elgen
