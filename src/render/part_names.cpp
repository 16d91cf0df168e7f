// part_names: a value is a part of the last frame that carries all bodies whose parameters it is
// made of, else of the outermost frame that its coordinates move. Frames count from 1.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "elgen/references.hpp"
#include "program/network/instructions.hpp"
#include "render/named_parts.hpp"

namespace elgen {
namespace {

constexpr std::uint32_t no_frame = UINT32_MAX;

/// The operands of a value, as far as they tell whose part it is.
struct PartOrigin {
  std::uint32_t carrier = no_frame;
  std::uint32_t outermost = 0;
  bool moves = false;  ///< by rates, accelerations, inputs or gravity
  bool divides = false;
};

class PartNames {
 public:
  PartNames(const Model& model, const Scene& scene)
      : model_(model),
        parameters_(model.parameters.size()),
        coordinates_(model.coordinates.size()),
        tells_masses_(scene.specialisation.fixed.empty()) {
    for (std::uint32_t i = 0; i < model.frames.size(); ++i) {
      for (const FrameStep& step : model.frames[i].steps) {
        const auto& [w, x, y, z] = step.quaternion;
        mark({step.vector[0], step.vector[1], step.vector[2], step.angle, w, x, y, z},
             {.outermost = i + 1});
      }
    }
    for (const Body& body : model.bodies) {
      if (body.local) add_mass(body.mass, body.local->com, body.local->inertia);
    }
    for (const Point& point : model.points) {
      if (point.local && point.mass) add_mass(point.mass, *point.local, {});
    }
    if (model.gravity) mark({model.gravity->begin(), model.gravity->end()}, {.moves = true});
  }

  [[nodiscard]] PartOrigin making(const Instruction& i,
                                  const std::vector<PartOrigin>& known) const {
    const std::size_t operands = operand_count(i);
    PartOrigin result;
    if (operands > 0) result = operands > 1 ? joined(known[i.a], known[i.b]) : known[i.a];
    if (i.opcode == Opcode::divide) result.divides = true;
    if (i.opcode == Opcode::parameter) result = parameters_[i.a];
    if (i.opcode == Opcode::coordinate) result = coordinates_[i.a];
    const bool is_rate = i.opcode == Opcode::velocity || i.opcode == Opcode::acceleration;
    if (is_rate) result = coordinates_[model_.velocities[i.a].coordinate];
    result.moves = result.moves || is_rate || i.opcode == Opcode::input;
    return result;
  }

  /// "force_link7"; nothing tells a force from a motion where masses are numbers.
  [[nodiscard]] std::string word(const PartOrigin& of) const {
    if (of.divides) return "solution";
    const bool is_carried = of.carrier != no_frame;
    const std::uint32_t frame = is_carried ? of.carrier : of.outermost;
    std::string kind = of.moves ? "motion" : "place";
    if (is_carried) kind = of.moves ? "force" : "inertia";
    if (!tells_masses_ || (frame == 0 && !is_carried)) kind = "part";
    return frame == 0 ? kind : fmt::format("{}_{}", kind, model_.frames[frame - 1].identifier);
  }

 private:
  void mark(const std::vector<ExpressionId>& roots, const PartOrigin& by) {
    for (const ExpressionId id : reached(model_, roots)) {
      const Expression& e = model_.expressions[id];
      const bool is_parameter = is_leaf(e, Opcode::parameter);
      if (!is_parameter && !is_leaf(e, Opcode::coordinate)) continue;
      PartOrigin& known = is_parameter ? parameters_[e.index] : coordinates_[e.index];
      known = joined(known, by);
    }
  }

  void add_mass(const std::optional<ExpressionId>& mass, const PlaceInFrame& place,
                std::vector<ExpressionId> values) {
    if (mass) values.push_back(*mass);
    values.insert(values.end(), place.at.begin(), place.at.end());
    mark(values, {.carrier = place.frame + 1});
    if (mass) tells_masses_ = tells_masses_ && holds_leaf(model_, *mass, Opcode::parameter);
  }

  [[nodiscard]] PartOrigin joined(const PartOrigin& a, const PartOrigin& b) const {
    PartOrigin result{std::min(a.carrier, b.carrier), std::max(a.outermost, b.outermost),
                      a.moves || b.moves, a.divides || b.divides};
    const bool are_carried = a.carrier != no_frame && b.carrier != no_frame;
    if (are_carried) result.carrier = common(a.carrier, b.carrier);
    return result;
  }

  /// The last frame that carries both.
  [[nodiscard]] std::uint32_t common(std::uint32_t a, std::uint32_t b) const {
    while (a != b) {
      std::uint32_t& later = a < b ? b : a;
      const std::optional<std::uint32_t>& parent = model_.frames[later - 1].parent;
      later = parent ? *parent + 1 : 0;
    }
    return a;
  }

  const Model& model_;
  std::vector<PartOrigin> parameters_;
  std::vector<PartOrigin> coordinates_;
  bool tells_masses_;
};

}  // namespace

Function united(const Program& program, const std::vector<std::size_t>& functions) {
  Function all;
  Instructions instructions(all);
  for (const std::size_t index : functions) {
    const Function& each = program.functions[index];
    const std::vector<std::uint32_t> places = instructions.add_all(each);
    for (Field field : each.fields) {
      for (std::uint32_t& entry : field.entries) entry = places[entry];
      all.fields.push_back(std::move(field));
    }
  }
  return all;
}

std::vector<std::string> part_names(const Model& model, const Scene& scene, const Program& program,
                                    const Function& function) {
  std::vector<std::string> names = temporary_names(program, function);
  const std::vector<std::string> told = told_names(program, function);
  std::set<std::string> taken(names.begin(), names.end());
  for_each_leaf([&taken](Opcode, std::uint32_t,
                         const std::string& leaf) { taken.insert(identifier_of(leaf)); },
                program.leaves);
  const PartNames parts(model, scene);
  std::vector<PartOrigin> makings;
  std::map<std::string, int> numbers;
  for (std::size_t at = 0; at < names.size(); ++at) {
    makings.push_back(parts.making(function.instructions[at], makings));
    if (names[at] == told[at]) continue;
    const std::string word = parts.word(makings[at]);
    for (bool is_new = false; !is_new;) {
      names[at] = fmt::format("{}_{}", word, ++numbers[word]);
      is_new = taken.insert(names[at]).second;
    }
  }
  return names;
}

}  // namespace elgen
