// introduction: the first screen of a header. The equation of motion is that of the whole model,
// also where a scene asks for some of its terms only.
#include "introduction.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cpp_spelling.hpp"
#include "decimal.hpp"
#include "layout.hpp"

namespace elgen {
namespace {

using Lines = std::vector<std::string>;

bool is_zero(const Program& program, const Function& function, std::uint32_t entry) {
  const Instruction& instruction = function.instructions[entry];
  return instruction.opcode == Opcode::constant &&
         cln::zerop(program.constants[instruction.a].value);
}

/// False where the program has the output and every entry of it is 0.
bool may_be_nonzero(const Program& program, OutputKind kind) {
  for (const Function& function : program.functions) {
    if (function.kind != kind) continue;
    const std::vector<std::uint32_t>& entries = function.fields.front().entries;
    const auto is_entry_zero = [&](std::uint32_t e) { return is_zero(program, function, e); };
    return !std::all_of(entries.begin(), entries.end(), is_entry_zero);
  }
  return true;
}

std::string joined(const Lines& terms) { return fmt::format("{}", fmt::join(terms, " + ")); }

Lines left_side(const Model& model, const Program& program) {
  const std::string t = model.uses_time ? ",t" : "";
  if (!model.quadratic) return {fmt::format("M(q,v{}) a", t), fmt::format("bias(q,v{})", t)};
  Lines terms = {fmt::format("M(q{}) a", t)};
  const auto add = [&](bool may_exist, OutputKind kind, const std::string& term) {
    if (may_exist && may_be_nonzero(program, kind)) terms.push_back(term);
  };
  add(true, OutputKind::velocity_force, fmt::format("C(q,v{}) v", t));
  add(true, OutputKind::drift, fmt::format("drift(q,v{})", t));
  add(true, OutputKind::gravity, fmt::format("g(q{})", t));
  add(model.energies.D.has_value(), OutputKind::dissipation, "dD/dv");
  return terms;
}

Lines right_side(const Model& model, const Program& program) {
  const std::string t = model.uses_time ? ",t" : "";
  Lines terms;
  if (!model.inputs.empty()) terms.push_back(fmt::format("B(q{}) u", t));
  const bool has_force = !model.forces.empty() && model.quadratic;
  if (has_force && may_be_nonzero(program, OutputKind::applied_force)) {
    terms.push_back(fmt::format("Q(q,v{})", t));
  }
  if (terms.empty()) terms.emplace_back("0");
  return terms;
}

std::string with_unit(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : fmt::format("{} [{}]", name, unit);
}

/// "(x [m], theta [rad])"; of many names the first two and the last.
std::string tuple(const Lines& names) {
  constexpr std::size_t most = 8;
  if (names.size() <= most) return fmt::format("({})", fmt::join(names, ", "));
  return fmt::format("({}, {}, ..., {})", names[0], names[1], names.back());
}

Lines variables(const Model& model) {
  Lines coordinates;
  Lines inputs;
  for (const Coordinate& c : model.coordinates) {
    coordinates.push_back(with_unit(c.name, c.unit_text));
  }
  for (const Input& input : model.inputs) inputs.push_back(with_unit(input.name, input.unit_text));
  Lines lines = {"q = " + tuple(coordinates), "v = dq/dt, a = dv/dt"};
  if (!inputs.empty()) lines.push_back("u = " + tuple(inputs));
  return lines;
}

std::string fixed_parameters(const Model& model, const Scene& scene) {
  Lines values;
  for (const auto& [index, value] : scene.specialisation.fixed) {
    values.push_back(fmt::format("{} = {}", model.parameters[index].name, exact_text(value)));
  }
  return values.empty() ? "" : fmt::format("Fixed: {}.", fmt::join(values, ", "));
}

void add_prose(Lines& lines, const std::string& text) {
  if (text.empty()) return;
  for (const std::string& line : wrap_words(text, {line_width - 3, ""}))
    lines.push_back(" " + line);
}

}  // namespace

std::string equation_of_motion(const Model& model, const Program& program) {
  return joined(left_side(model, program)) + " = " + joined(right_side(model, program));
}

std::vector<std::string> introduction(const Model& model, const Scene& scene,
                                      const Program& program) {
  Lines lines;
  add_prose(lines, comment_text(model.title));
  add_prose(lines, comment_text(model.description));
  add_prose(lines, comment_text(model.reference));
  if (!lines.empty()) lines.emplace_back();
  lines.push_back("   " + equation_of_motion(model, program));
  lines.emplace_back();
  for (const std::string& line : variables(model)) lines.push_back("   " + line);
  const std::string fixed = fixed_parameters(model, scene);
  if (!fixed.empty()) lines.emplace_back();
  add_prose(lines, fixed);
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
