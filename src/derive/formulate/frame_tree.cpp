// Builds the tree of frames: transforms, parents first; then bodies, wrenches and outputs on the
// transforms.
#include <algorithm>
#include <utility>

#include "derive/formulate/expressions.hpp"

namespace elgen {

using GiNaC::ex;

namespace {

bool is_zero(const ExVector3& vector) {
  return std::all_of(vector.begin(), vector.end(), [](const ex& x) { return x.is_zero(); });
}

/// True for each frame with a body, point mass, force or output, and for all ancestors of these
/// frames. If needs_energy_sums(), only outputs count.
std::vector<bool> needed_frames(const Model& model) {
  std::vector<bool> needed(model.frames.size(), false);
  const auto mark = [&](std::optional<std::uint32_t> frame) {
    for (; frame && !needed[*frame]; frame = model.frames[*frame].parent) needed[*frame] = true;
  };
  const auto mark_point = [&](std::optional<std::uint32_t> point) {
    if (point && model.points[*point].local) mark(model.points[*point].local->frame);
  };
  for (const UserOutput& output : model.outputs) mark(output.frame);
  if (needs_energy_sums(model)) return needed;
  for (const Body& body : model.bodies) {
    if (body.local) mark(body.local->com.frame);
  }
  for (std::uint32_t i = 0; i < model.points.size(); ++i) {
    if (model.points[i].mass) mark_point(i);
  }
  for (const Force& force : model.forces) {
    mark(force.frame);
    mark(force.reaction_frame);
    mark_point(force.point);
    mark_point(force.reaction_point);
    const bool uses_axes = force.frame || (force.point && model.points[*force.point].local) ||
                           (force.reaction_point && model.points[*force.reaction_point].local);
    if (uses_axes) mark(force.declared_axes);
  }
  return needed;
}

/// The wanted frames in the order of declaration, but each after its parent.
std::vector<std::uint32_t> order_parents_first(const Model& model,
                                               const std::vector<bool>& wanted) {
  std::vector<std::uint32_t> order;
  std::vector<bool> done(model.frames.size(), false);
  for (std::uint32_t i = 0; i < model.frames.size(); ++i) {
    std::vector<std::uint32_t> path;
    std::optional<std::uint32_t> frame = i;
    for (; frame && wanted[*frame] && !done[*frame]; frame = model.frames[*frame].parent) {
      done[*frame] = true;
      path.push_back(*frame);
    }
    order.insert(order.end(), path.rbegin(), path.rend());
  }
  return order;
}

bool is_identity(const TreeTransform& transform) {
  if (transform.kind == TransformKind::turn) return transform.angle.is_zero();
  return transform.kind == TransformKind::translation && is_zero(transform.vector);
}

/// If `transform` is a turn R about a coordinate axis, by a constant angle with rational cosine and
/// sine: sets x to R^T x and returns true. Otherwise returns false.
bool undo_quarter_turn(const TreeTransform& transform, ExVector3& x) {
  const ex cosine = GiNaC::cos(transform.angle);
  const ex sine = GiNaC::sin(transform.angle);
  if (!GiNaC::is_a<GiNaC::numeric>(cosine) || !GiNaC::is_a<GiNaC::numeric>(sine)) return false;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!(transform.vector[k] * transform.vector[k]).is_equal(1)) continue;
    const std::size_t i = (k + 1) % 3;
    const std::size_t j = (k + 2) % 3;
    const ex turned = cosine * x[i] + transform.vector[k] * sine * x[j];
    x[j] = cosine * x[j] - transform.vector[k] * sine * x[i];
    x[i] = turned;
    return true;
  }
  return false;
}

/// The coordinate axis parallel to x; none if x has several non-zero components, or is 0.
std::optional<std::size_t> single_axis(const ExVector3& x) {
  std::optional<std::size_t> axis;
  for (std::size_t k = 0; k < 3; ++k) {
    if (x[k].is_zero()) continue;
    if (axis) return std::nullopt;
    axis = k;
  }
  return axis;
}

/// Splits the first translation. The component parallel to the axis of the last turn moves behind
/// this turn, because the component and the turn commute. Frames whose axes intersect then share
/// their origin, so a force passed between these frames adds no moment.
///
///     before    shift (a, d, 0), turn -pi/2 about x, turn q about z
///     after     shift (a, 0, 0), turn -pi/2 about x, turn q about z, shift (0, 0, d)
std::vector<TreeTransform> with_translation_last(std::vector<TreeTransform> transforms) {
  if (transforms.size() < 2 || transforms.front().kind != TransformKind::translation)
    return transforms;
  const TreeTransform& turn = transforms.back();
  if (turn.kind != TransformKind::turn) return transforms;
  const std::optional<std::size_t> axis = single_axis(turn.vector);
  if (!axis) return transforms;
  ExVector3 shift = transforms.front().vector;
  for (std::size_t k = 1; k + 1 < transforms.size(); ++k) {
    if (transforms[k].kind != TransformKind::turn || !undo_quarter_turn(transforms[k], shift))
      return transforms;
  }
  if (shift[*axis].is_zero()) return transforms;
  TreeTransform slide = transforms.front();
  slide.vector = {0, 0, 0};
  slide.vector[*axis] = shift[*axis];
  // From the original translation, remove the component that is parallel to the turn's axis.
  for (std::size_t k = 0; k < 3; ++k) {
    ExVector3 unit{0, 0, 0};
    unit[k] = 1;
    for (std::size_t i = 1; i + 1 < transforms.size(); ++i)
      (void)undo_quarter_turn(transforms[i], unit);
    if (!unit[*axis].is_zero()) transforms.front().vector[k] = 0;
  }
  transforms.push_back(std::move(slide));
  if (is_identity(transforms.front())) transforms.erase(transforms.begin());
  return transforms;
}

TreeTransform make_transform(const Model& model, ExpressionTranslator& translation,
                             Definitions& definitions, std::uint32_t index,
                             const ElementaryTransform& transform) {
  const std::string& name = model.frames[index].identifier;
  TreeTransform result;
  result.kind = transform.kind;
  if (transform.rotation) result.rotation = model.rotations[*transform.rotation].first_velocity;
  result.name = name;
  result.origin = {EntityKind::frame, index};
  result.vector = translation.define_vector(transform.vector, name + "_offset", result.origin);
  if (transform.kind == TransformKind::turn) {
    result.angle = translation.value(transform.angle);
    // A constant gets no symbol, because GiNaC evaluates the sine of a number, not of a symbol.
    if (!symbols_of(definitions, result.angle).empty()) {
      result.angle = define(definitions, result.angle, {name + "_angle", result.origin});
    }
  }
  for (std::size_t i = 0; transform.kind == TransformKind::quaternion && i < 4; ++i) {
    result.quaternion[i] =
        translation.define_value(transform.quaternion[i], name + "_quaternion", result.origin);
  }
  return result;
}

RigidBody make_rigid_body(const Model& model, ExpressionTranslator& translation,
                          std::uint32_t index) {
  const Body& body = model.bodies[index];
  const Entity origin{EntityKind::body, index};
  RigidBody rigid;
  rigid.origin = origin;
  rigid.is_about_origin = body.local->is_about_origin;
  if (body.mass)
    rigid.mass = translation.define_value(*body.mass, body.identifier + "_mass", origin);
  rigid.com = translation.define_vector(body.local->com.position, body.identifier + "_com", origin);
  for (const ExpressionId id : body.local->inertia) {
    rigid.inertia.push_back(translation.define_value(id, body.identifier + "_inertia", origin));
  }
  if (rigid.inertia.size() == 1) rigid.inertia = {0, 0, rigid.inertia.front(), 0, 0, 0};
  return rigid;
}

class TreeFormulation {
 public:
  TreeFormulation(const Model& model, ExpressionTranslator& translation, Lagrangian& lagrangian)
      : model_(model),
        translation_(translation),
        definitions_(lagrangian.definitions),
        lagrangian_(lagrangian),
        tree_(lagrangian.tree),
        last_transform_(model.frames.size()),
        point_places_(model.points.size()) {}

  void build() {
    for (const std::uint32_t frame : order_parents_first(model_, needed_frames(model_)))
      add_frame(frame);
    if (!needs_energy_sums(model_)) add_bodies_and_wrenches();
    add_twist_outputs();
  }

 private:
  using TransformIndex = std::optional<std::uint32_t>;

  void add_bodies_and_wrenches() {
    for (std::uint32_t i = 0; i < model_.bodies.size(); ++i) {
      const std::optional<LocalBody>& local = model_.bodies[i].local;
      if (local)
        append_body(last_transform_[local->com.frame], make_rigid_body(model_, translation_, i));
    }
    for (std::uint32_t i = 0; i < model_.points.size(); ++i) add_point_mass(i);
    for (const Force& force : model_.forces) add_wrenches(force);
  }

  void add_frame(std::uint32_t index) {
    const Frame& frame = model_.frames[index];
    std::vector<TreeTransform> transforms;
    for (const ElementaryTransform& transform : frame.transforms) {
      TreeTransform translated_step =
          make_transform(model_, translation_, definitions_, index, transform);
      if (!is_identity(translated_step)) transforms.push_back(std::move(translated_step));
    }
    TransformIndex last = frame.parent ? last_transform_[*frame.parent] : TransformIndex{};
    for (TreeTransform& transform : with_translation_last(std::move(transforms))) {
      transform.parent = last;
      last = append_transform(std::move(transform));
    }
    last_transform_[index] = last;
  }

  TransformIndex append_transform(TreeTransform transform) {
    tree_.transforms.push_back(std::move(transform));
    return static_cast<std::uint32_t>(tree_.transforms.size() - 1);
  }

  void append_body(TransformIndex transform, RigidBody body) {
    body.transform = transform;
    tree_.bodies.push_back(std::move(body));
  }

  /// The transform to which a point is fixed, and the point's position in the child frame of this
  /// transform.
  struct PointPlace {
    TransformIndex transform;
    ExVector3 at;
  };

  /// The place of a point. A point that moves relative to its frame gets an additional translation.
  const PointPlace& place_of_point(std::uint32_t index) {
    std::optional<PointPlace>& known = point_places_[index];
    if (known) return *known;
    const Point& point = model_.points[index];
    const Entity origin{EntityKind::point, index};
    known = PointPlace{last_transform_[point.local->frame],
                       translation_.define_vector(point.local->position, point.identifier, origin)};
    const bool moves = std::any_of(known->at.begin(), known->at.end(), [&](const ex& x) {
      return dependence(definitions_, x).has_any(Opcode::coordinate | Opcode::time);
    });
    if (!moves) return *known;
    TreeTransform shift;
    shift.parent = known->transform;
    shift.vector = std::exchange(known->at, {0, 0, 0});
    shift.name = point.identifier;
    shift.origin = origin;
    known->transform = append_transform(std::move(shift));
    return *known;
  }

  void add_point_mass(std::uint32_t index) {
    const Point& point = model_.points[index];
    if (!point.mass || !point.local) return;
    const Entity origin{EntityKind::point, index};
    RigidBody rigid;
    rigid.origin = origin;
    rigid.mass = translation_.define_value(*point.mass, point.identifier + "_mass", origin);
    const PointPlace& place = place_of_point(index);
    rigid.com = place.at;
    append_body(place.transform, std::move(rigid));
  }

  void add_wrenches(const Force& force) {
    ExVector3 components;
    const auto translate_components = [&] {
      for (std::size_t i = 0; i < 3; ++i) {
        const bool given = i < force.declared_value.size();
        components[i] = given ? translation_.value(force.declared_value[i]) : ex(0);
      }
    };
    const TransformIndex axes =
        force.declared_axes ? last_transform_[*force.declared_axes] : TransformIndex{};
    const auto negative = [&] { return ExVector3{-components[0], -components[1], -components[2]}; };
    if (force.frame) {
      translate_components();
      tree_.wrenches.push_back(
          {last_transform_[*force.frame], axes, {0, 0, 0}, {0, 0, 0}, components});
      if (!force.reaction_frame) return;
      const TransformIndex from = last_transform_[*force.reaction_frame];
      tree_.wrenches.push_back({from, axes, {0, 0, 0}, {0, 0, 0}, negative()});
    } else if (force.point) {
      translate_components();
      add_force_at(*force.point, axes, components);
      if (force.reaction_point) add_force_at(*force.reaction_point, axes, negative());
    }
  }

  void add_force_at(std::uint32_t index, TransformIndex axes, const ExVector3& components) {
    if (!model_.points[index].local) return;  // formulate.cpp adds this force as a PointForce
    const PointPlace& place = place_of_point(index);
    tree_.wrenches.push_back({place.transform, axes, place.at, components, {0, 0, 0}});
  }

  void add_twist_outputs() {
    for (std::size_t i = 0; i < model_.outputs.size(); ++i) {
      const UserOutput& output = model_.outputs[i];
      if (!output.frame) continue;
      lagrangian_.outputs[i].twist =
          TwistOutput{last_transform_[*output.frame], output.is_in_world};
    }
  }

  const Model& model_;
  ExpressionTranslator& translation_;
  Definitions& definitions_;
  Lagrangian& lagrangian_;
  FrameTree& tree_;
  std::vector<TransformIndex>
      last_transform_;  ///< of each frame; none if the frame coincides with the world
  std::vector<std::optional<PointPlace>> point_places_;  ///< by point, filled by place_of_point()
};

}  // namespace

void add_frame_tree(const Model& model, ExpressionTranslator& translation, Lagrangian& lagrangian) {
  TreeFormulation(model, translation, lagrangian).build();
}

}  // namespace elgen
