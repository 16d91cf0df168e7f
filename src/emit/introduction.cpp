// introduction: the first screen of a header. Rates are named where some function knows of them.
#include "introduction.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "dropped_terms.hpp"
#include "elgen/render.hpp"
#include "entry_units.hpp"
#include "layout.hpp"

namespace elgen {
namespace {

using Lines = std::vector<std::string>;

std::string with_unit(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : fmt::format("{} [{}]", name, unit);
}

/// "(x [m], theta [rad])"; of many names the first two and the last.
std::string tuple(const Lines& names) {
  constexpr std::size_t most = 8;
  if (names.size() <= most) return fmt::format("({})", fmt::join(names, ", "));
  return fmt::format("({}, {}, ..., {})", names[0], names[1], names.back());
}

/// "dot(x) [m/s]", "attitude[1] [rad/s]"
Lines rates(const Model& model) {
  Lines names;
  for (const Velocity& velocity : model.velocities) {
    const std::string name = velocity.rotation ? velocity.name : "dot(" + velocity.name + ")";
    names.push_back(with_unit(name, velocity_unit(model, velocity)));
  }
  return names;
}

Lines variables(const Model& model, const Program& program) {
  Lines coordinates;
  Lines inputs;
  for (const Coordinate& c : model.coordinates) {
    coordinates.push_back(with_unit(c.name, c.unit_text));
  }
  for (const Input& input : model.inputs) inputs.push_back(with_unit(input.name, input.unit_text));
  Lines lines = {"q = " + tuple(coordinates)};
  if (!knows_motion(model, program)) {
    lines.emplace_back("at rest");
  } else if (model.rotations.empty()) {
    lines.push_back("v = dq/dt, a = dv/dt");
  } else {
    lines.push_back("v = " + tuple(rates(model)) + ", a = dv/dt");
    lines.push_back("dq/dt = N(q) v: coordinate_rates");
  }
  if (!inputs.empty()) lines.push_back("u = " + tuple(inputs));
  return lines;
}

void add_prose(Lines& lines, const std::string& text) {
  if (text.empty()) return;
  for (const std::string& line : wrap_words(text, {line_width - 3, ""}))
    lines.push_back(" " + line);
}

}  // namespace

std::vector<std::string> introduction(const Model& model, const Scene& scene,
                                      const Program& program) {
  Lines lines;
  add_prose(lines, comment_text(model.title));
  add_prose(lines, comment_text(model.description));
  add_prose(lines, comment_text(model.reference));
  if (!lines.empty()) lines.emplace_back();
  lines.push_back("   " + equation_of_motion(model, program).text);
  lines.emplace_back();
  for (const std::string& line : variables(model, program)) lines.push_back("   " + line);
  const Lines notes = scene_notes(model, scene);
  if (!notes.empty()) lines.emplace_back();
  for (const std::string& note : notes) add_prose(lines, comment_text(note));
  const std::string dropped = dropped_summary(program);
  if (!dropped.empty()) lines.emplace_back();
  add_prose(lines, dropped);
  return lines;
}

std::vector<std::string> operation_table(const Program& program) {
  std::size_t width = std::string_view("function").size();
  for (const Function& function : program.functions) width = std::max(width, function.name.size());
  constexpr std::string_view row = "{:<{}}  {:>6} {:>6} {:>5} {:>5} {:>6} {:>5}  {:>11}  {}";
  Lines lines = {fmt::format(row, "function", width, "add", "mul", "div", "sqrt", "sincos", "other",
                             "definitions", "form")};
  for (const Function& function : program.functions) {
    const OperationCounts n = count_operations(function);
    const std::vector<std::string> names = temporary_names(program, function);
    const auto unnamed = std::count(names.begin(), names.end(), std::string());
    lines.push_back(fmt::format(row, function.name, width, n.add, n.mul, n.div, n.sqrt, n.sincos,
                                n.other, names.size() - static_cast<std::size_t>(unnamed),
                                name_of(function.form)));
  }
  return lines;
}

}  // namespace elgen
