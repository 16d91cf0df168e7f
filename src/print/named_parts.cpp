// named_parts: sections on frames: the quantities of each frame and body (FrameSteps), and the
// recursions of src/derive/tree/ in textbook form: motions from the world outwards, forces and
// composite inertias back to the world. Featherstone, Rigid Body Dynamics Algorithms (2008),
// chapters 5 and 6. In a recursion, for each frame, let V be its twist, S the part of V that the
// frame's own motion adds, and G the inertia of all bodies that the frame carries. This gives M:
//
//     2 T = sum V.G V - (V - S).G (V - S)
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "elgen/references.hpp"
#include "model/symbols.hpp"
#include "print/sections.hpp"

namespace elgen {
namespace {

/// Both sides of an equation; `<v>` is replaced by the symbol of the velocities.
struct RecursionEquation {
  std::string_view left;
  std::string_view right;
};

constexpr std::array motion_rows{
    RecursionEquation{R"(\omega_{i})", R"(R_{i}^{\top} \omega_{p} + s_{i})"},
    RecursionEquation{R"(\nu_{i})",
                      R"(R_{i}^{\top} (\nu_{p} + \omega_{p} \times o_{i} + \dot{o}_{i}))"},
    RecursionEquation{R"(\dot{\omega}_{i})",
                      R"(R_{i}^{\top} \dot{\omega}_{p} + )"
                      R"((R_{i}^{\top} \omega_{p}) \times s_{i} + \dot{s}_{i})"},
    RecursionEquation{R"(\gamma_{i})",
                      R"(R_{i}^{\top} (\gamma_{p} + \dot{\omega}_{p} \times o_{i} + )"
                      R"(\omega_{p} \times (\omega_{p} \times o_{i}) + )"
                      R"(2 \omega_{p} \times \dot{o}_{i} + \ddot{o}_{i}))"}};

constexpr std::array force_rows{
    RecursionEquation{R"(F_{b})", R"(m_{b} (\gamma_{i} + \dot{\omega}_{i} \times c_{b} + )"
                                  R"(\omega_{i} \times (\omega_{i} \times c_{b})))"},
    RecursionEquation{R"(f_{i})", R"(\sum_{b} F_{b} + \sum_{j} R_{j} f_{j})"},
    RecursionEquation{R"(n_{i})",
                      R"(\sum_{b} (I_{b} \dot{\omega}_{i} + \omega_{i} \times I_{b} \omega_{i} )"
                      R"(+ c_{b} \times F_{b}) + )"
                      R"(\sum_{j} (R_{j} n_{j} + o_{j} \times R_{j} f_{j}))"}};

constexpr std::array inertia_rows{
    RecursionEquation{R"(m^{c}_{i})", R"(\sum_{b} m_{b} + \sum_{j} m^{c}_{j})"},
    RecursionEquation{R"(h^{c}_{i})", R"(\sum_{b} m_{b} c_{b} + )"
                                      R"(\sum_{j} (R_{j} h^{c}_{j} + m^{c}_{j} o_{j}))"},
    RecursionEquation{R"(I^{c}_{i})",
                      R"(\sum_{b} (I_{b} - m_{b} [c_{b}]_{\times}^{2}) + )"
                      R"(\sum_{j} (R_{j} I^{c}_{j} R_{j}^{\top} - )"
                      R"([o_{j}]_{\times} [R_{j} h^{c}_{j}]_{\times} - )"
                      R"([R_{j} h^{c}_{j} + m^{c}_{j} o_{j}]_{\times} [o_{j}]_{\times}))"},
    RecursionEquation{R"(G_{i}(x, y))", R"((I^{c}_{i} x + h^{c}_{i} \times y, )"
                                        R"(m^{c}_{i} y + x \times h^{c}_{i}))"}};

constexpr std::array twist_rows{
    RecursionEquation{R"(S_{ik})",
                      R"(\left( \frac{\partial s_{i}}{\partial <v>_{k}}, )"
                      R"(R_{i}^{\top} \frac{\partial \dot{o}_{i}}{\partial <v>_{k}} \right))"},
    RecursionEquation{R"(V_{ik})", R"(\left( \frac{\partial \omega_{i}}{\partial <v>_{k}}, )"
                                   R"(\frac{\partial \nu_{i}}{\partial <v>_{k}} \right))"}};

constexpr std::string_view mass_entry =
    R"(\sum_{i} (S_{ik} \cdot G_{i}(V_{il}) + V_{ik} \cdot G_{i}(S_{il}) - )"
    R"(S_{ik} \cdot G_{i}(S_{il})))";

class FrameFormulas {
 public:
  explicit FrameFormulas(const Model& model)
      : model_(model), symbols_(ModelSymbols(model).leaf_symbols()) {}

  /// The frames, their parents and poses. For a recursion, frames have numbers; the world has 0.
  [[nodiscard]] PageTable frames_table(bool has_numbers) const {
    const auto symbol = [](const Frame& frame) {
      return symbol_formula(frame.name, symbol_of_name(frame.name));
    };
    PageTable table{{prose("frame"), prose("parent"), latex_formula("H")}};
    if (has_numbers)
      table.heads = {latex_formula("i"), {}, latex_formula("p"), latex_formula("H_{i}")};
    for (std::uint32_t i = 0; i < model_.frames.size(); ++i) {
      const Frame& frame = model_.frames[i];
      if (has_numbers) table.cells.push_back(number_formula(i + 1));
      table.cells.push_back(symbol(frame));
      table.cells.push_back(has_numbers    ? number_formula(frame.parent ? *frame.parent + 1 : 0U)
                            : frame.parent ? symbol(model_.frames[*frame.parent])
                                           : prose("world"));
      table.cells.push_back(pose_formula(frame));
    }
    return table;
  }

  [[nodiscard]] PageTable bodies_table() const {
    PageTable table{{latex_formula("i"), latex_formula("m_{b}"), latex_formula("c_{b}"),
                     latex_formula("I_{b}")}};
    for (const Body& body : model_.bodies) {
      add_body_row(table, body.local->com, body.mass);
      const Formulas x = formulas(body.local->inertia);
      const Formula zero = number_formula(0);
      if (x.size() == 1) table.cells.back() = tuple_of({zero, zero, x[0]});
      if (x.size() == 6) table.cells.back() = tuple_of({x[0], x[1], x[2]});
      const bool has_products = x.size() == 6 && std::count_if(x.begin() + 3, x.end(), is_zero) < 3;
      if (has_products) {
        table.cells.insert(table.cells.end(), {{}, {}, {}, tuple_of({x[3], x[4], x[5]})});
      }
      if (!body.local->is_about_origin) continue;
      table.cells.back() =
          sum_of({table.cells.back(), latex_formula("m_{b} [c_{b}]_{\\times}^{2}")});
    }
    for (const Point& point : model_.points) {
      if (point.mass) add_body_row(table, *point.local, point.mass);
    }
    return table;
  }

  template <class List>
  [[nodiscard]] Formula vector_formula(const List& ids) const {
    return tuple_of(formulas(ids));
  }

  [[nodiscard]] Formula formula(ExpressionId id) const {
    return formula_of(model_, id, [this](ExpressionId named) -> Formula {
      const Expression& e = model_.expressions[named];
      if (e.kind == ExpressionKind::pi) return pi_formula();
      if (e.kind == ExpressionKind::leaf) return leaf_of(symbols_, e.leaf, e.index);
      return formula(references(model_, named).front());
    });
  }

 private:
  static bool is_zero(const Formula& formula) { return is_number(formula, 0); }
  static bool is_number(const Formula& formula, int value) {
    return formula.kind == FormulaKind::number && formula.text.empty() && formula.number == value;
  }

  void add_body_row(PageTable& table, const PointInFrame& place,
                    const std::optional<ExpressionId>& mass) const {
    table.cells.insert(table.cells.end(),
                       {number_formula(place.frame + 1), mass ? formula(*mass) : number_formula(0),
                        vector_formula(place.position), number_formula(0)});
  }

  template <class List>
  [[nodiscard]] Formulas formulas(const List& ids) const {
    Formulas result;
    for (const ExpressionId id : ids) result.push_back(formula(id));
    return result;
  }

  [[nodiscard]] Formula pose_formula(const Frame& frame) const {
    Formulas motions;
    for (const ElementaryTransform& transform : frame.transforms)
      motions.push_back(motion_formula(transform));
    Formula product = row_of(std::move(motions));
    return product.is_empty() ? number_formula(1) : product;
  }

  /// The motion of an elementary transform; empty for the identity.
  [[nodiscard]] Formula motion_formula(const ElementaryTransform& transform) const {
    if (transform.kind == TransformKind::translation) {
      Formula by = vector_formula(transform.vector);
      return std::ranges::all_of(by.parts, is_zero) ? Formula{} : applied("Trans", by);
    }
    if (transform.kind == TransformKind::turn) {
      const Formula angle = formula(transform.angle);
      if (is_zero(angle)) return {};
      return applied("Rot", tuple_of({angle}), axis_formula(transform));
    }
    if (!transform.rotation) return applied("Rot", vector_formula(transform.quaternion));
    const Rotation& rotation = model_.rotations[*transform.rotation];
    const Glyphs symbol = symbol_of_name(rotation.name, rotation.latex);
    return applied("Rot", tuple_of({symbol_formula(rotation.name, symbol)}));
  }

  /// "Rot_z(theta)"
  [[nodiscard]] static Formula applied(std::string name, const Formula& arguments,
                                       const Formula& axis = {}) {
    Glyphs symbol = make_row({GlyphKind::word, name});
    if (!axis.is_empty()) {
      add_script(symbol, 1, glyphs_of(axis));
      name += "_" + text_of(axis);
    }
    append(symbol, glyphs_of(arguments), false);
    return symbol_formula(name + text_of(arguments), std::move(symbol));
  }

  /// "z"; all three components if the axis is not a coordinate axis.
  [[nodiscard]] Formula axis_formula(const ElementaryTransform& turn) const {
    Formula unit = vector_formula(turn.vector);
    const auto one =
        std::ranges::find_if(unit.parts, [](const Formula& part) { return is_number(part, 1); });
    const bool is_axis = one != unit.parts.end() && std::ranges::count_if(unit.parts, is_zero) == 2;
    return is_axis ? latex_formula(std::string(1, "xyz"[one - unit.parts.begin()])) : unit;
  }

  const Model& model_;
  const LeafValues<Formula> symbols_;
};

PageEquation recursion_equation(const Model& model, std::string_view left, std::string_view right) {
  return {latex_formula(model, left), 1, 1, {latex_formula(model, right)}};
}

template <class Rows>
PageSection recursion_section(const Model& model, const std::string& doc, const Rows& rows) {
  PageSection result{.doc = doc};
  for (const RecursionEquation& row : rows)
    result.equations.push_back(recursion_equation(model, row.left, row.right));
  return result;
}

/// M and the left side of the equations of motion, with weight as the only potential force.
std::vector<PageEquation> mass_and_force_equations(const Model& model, const FrameFormulas& writer,
                                                   bool has_weights) {
  std::vector<PageEquation> result;
  const bool has_armature = std::ranges::any_of(
      model.coordinates, [](const Coordinate& c) { return c.armature.has_value(); });
  result.push_back(recursion_equation(model, "M_{kl}",
                                      std::string(mass_entry) + (has_armature ? " + A_{kl}" : "")));
  for (const Coordinate& c : model.coordinates) {
    if (!c.armature) continue;
    result.push_back({latex_formula(fmt::format("A_{{{0}, {0}}}", c.velocity + 1)),
                      1,
                      1,
                      {writer.formula(*c.armature)}});
  }
  result.push_back(recursion_equation(
      model,
      fmt::format("(M <a> + C <v>{}{})_{{k}}", model.may_drift ? " + \\mathrm{drift}" : "",
                  has_weights ? " + g" : ""),
      fmt::format("\\sum_{{i}} S_{{ik}} \\cdot (n_{{i}}, f_{{i}}){}",
                  has_armature ? " + (A <a>)_{k}" : "")));
  if (has_weights)
    result.push_back(recursion_equation(model, "V_{0}", "\\gamma_{0} \\cdot h^{c}_{0}"));
  return result;
}

/// Appends `section` with the quantities from kind `from` to kind `to`. A quantity with definitions
/// ends its section, because definitions of other quantities may have the same names. The next
/// section has no title.
void append_quantities(const Model& model, const ReadableDerivation& steps,
                       std::pair<FrameQuantity, FrameQuantity> kinds, PageSection section,
                       std::vector<PageSection>& sections) {
  const auto [from, to] = kinds;
  ModelSymbols symbols(model);
  for (std::size_t i = 0; i < steps.frame_quantities.size(); ++i) {
    if (steps.frame_quantities[i] < from || steps.frame_quantities[i] > to) continue;
    const std::string& name = steps.frames.functions[i].name;
    const FunctionEquations read = equations(model, steps.frames, i);
    const Formulas& entries = read.entries.front();
    section.equations.push_back({symbol_formula(name, symbols.make_distinct(symbol_of_name(name))),
                                 static_cast<std::uint32_t>(entries.size()), 1, entries});
    for (const auto& [symbol, value] : read.definitions)
      section.equations.push_back({symbol, 1, 1, {value}, true});
    if (!read.definitions.empty()) sections.push_back(std::exchange(section, {}));
  }
  if (!section.equations.empty()) sections.push_back(std::move(section));
}

}  // namespace

bool has_frame_recursion(const Model& model) {
  const auto is_carried = [](const Point& p) { return !p.mass || p.local; };
  return !model.frames.empty() && std::ranges::all_of(model.points, is_carried) &&
         std::ranges::all_of(model.bodies, [](const Body& b) { return b.local.has_value(); }) &&
         model.is_quadratic && !model.energies.T && !has_combined_lagrangian(model) &&
         !model.approximation;
}

std::vector<PageSection> frame_sections(const Model& model, const ReadableDerivation& steps) {
  if (model.frames.empty()) return {};
  std::vector<PageSection> sections{PageSection{
      .title = prose("Frames"),
      .doc = "Pose H of each frame in its parent: translations and rotations, in order.",
      .table = FrameFormulas(model).frames_table(false)}};
  using enum FrameQuantity;
  const auto has = [&steps](FrameQuantity kind) {
    return std::ranges::count(steps.frame_quantities, kind) > 0;
  };
  PageSection spins{.title = prose("Angular velocities"),
                    .doc = "omega: angular velocity of a frame, in its axes."};
  if (has(origin_rate)) spins.doc += " nu: velocity of its origin, in its axes.";
  append_quantities(model, steps, {spin, origin_rate}, std::move(spins), sections);
  PageSection centres{.title = prose("Centres of mass"),
                      .doc = "r: position in the world. v: its rate, if it is not 0."};
  if (has(centre))
    centres.doc +=
        " If these are too long: position c in the frame, and v in the axes of the frame.";
  append_quantities(model, steps, {position, velocity}, std::move(centres), sections);
  append_quantities(
      model, steps, {energy, energy},
      {.title = prose("Kinetic energies"),
       .doc = "T of each body; I is the inertia about the centre of mass.",
       .lines = {latex_formula(R"(T = \frac{1}{2} m v^{2} + \frac{1}{2} \omega^{\top} I \omega)")}},
      sections);
  return sections;
}

std::vector<PageSection> recursion_sections(const Model& model) {
  const FrameFormulas writer(model);
  const bool has_weights = model.gravity && !model.energies.V;
  PageSection opening{.title = prose("Named parts")};
  opening.doc =
      "Formulas too long for this page are given by their definition; elgen show --as text prints "
      "them in full.";
  PageSection frames{.doc =
                         "Frame i in its parent frame p (0: the world): pose H, axes R, origin o."};
  frames.table = writer.frames_table(true);
  PageSection bodies{
      .doc = "Body b in the axes of frame i: mass, centre, inertia (xx, yy, zz; xy, xz, yz)."};
  bodies.table = writer.bodies_table();
  PageSection motions = recursion_section(
      model,
      "Motion of frame i in its own axes. omega is its angular velocity, and s the part relative "
      "to p. nu is the velocity of its origin, gamma the acceleration of its origin minus gravity.",
      motion_rows);
  Formula weight =
      has_weights ? negative_of(writer.vector_formula(*model.gravity)) : number_formula(0);
  motions.equations.push_back({latex_formula("\\gamma_{0}"), 1, 1, {std::move(weight)}});
  PageSection results =
      recursion_section(model,
                        "V_ik is the derivative of the twist of frame i with respect to velocity "
                        "k, S_ik the derivative "
                        "of the twist relative to p. M and the equations of motion follow.",
                        twist_rows);
  const std::vector<PageEquation> last = mass_and_force_equations(model, writer, has_weights);
  results.equations.insert(results.equations.end(), last.begin(), last.end());
  return {
      opening,
      frames,
      bodies,
      motions,
      recursion_section(model, "Force and moment on frame i with its bodies b and child frames j.",
                        force_rows),
      recursion_section(
          model, "Mass, first moment and inertia of frame i with its bodies and child frames.",
          inertia_rows),
      results};
}

}  // namespace elgen
