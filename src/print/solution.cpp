// solution: see solution.hpp.
#include "print/solution.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "model/symbols.hpp"
#include "print/display.hpp"
#include "print/sections.hpp"

namespace elgen {
namespace {

constexpr std::size_t most_lines = 12;

/// A field of forward dynamics that paper shows.
struct SolvedField {
  std::string_view name;
  Opcode leaf;
  std::string_view noun;
};

constexpr std::array solved_fields{
    SolvedField{"acceleration", Opcode::acceleration, "accelerations"},
    SolvedField{"multipliers", Opcode::multiplier, "multipliers"}};

/// The entries of a field in the readable form; none if there is no such form.
std::vector<std::uint32_t> readable_entries(const Program& program, std::string_view name) {
  if (!has_readable_form(program, 0)) return {};
  const std::vector<Field>& fields = program.readable.front().fields;
  const auto field = std::ranges::find(fields, name, &Field::name);
  return field == fields.end() ? std::vector<std::uint32_t>{} : field->entries;
}

bool is_short(const Formula& left, const Formula& right) {
  return line_count(lay_out_equation(typeset_equation({left, 1, 1, {right}}))) <= most_lines;
}

}  // namespace

FunctionEquations equations_of_entries(const Model& model, const Program& program,
                                       std::size_t index,
                                       const std::vector<std::uint32_t>& entries) {
  Function book = program.readable[index];
  book.fields.clear();
  for (const std::uint32_t entry : entries) book.fields.push_back({"", 1, 1, {entry}});
  book = eliminate_dead_code(book);
  return equations(model, {program.leaves, program.constants, {book}, {book}}, 0);
}

bool is_short_on_paper(const Formula& left, const FunctionEquations& equations) {
  const auto is_short_definition = [](const NamedFormula& definition) {
    return is_short(definition.name, definition.value);
  };
  return is_short(left, equations.entries.front().front()) &&
         std::ranges::all_of(equations.definitions, is_short_definition);
}

PaperSolution solution_on_paper(const Model& model, const Program& forward_dynamics) {
  PaperSolution result;
  const ModelSymbols symbols(model);
  std::vector<std::uint32_t> shown;
  for (const auto& [field, leaf, noun] : solved_fields) {
    const std::vector<std::uint32_t> entries = readable_entries(forward_dynamics, field);
    const Formulas& names = *leaf_list(symbols.leaf_symbols(), leaf);
    std::vector<std::string_view> omitted;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (i < entries.size() &&
          is_short_on_paper(names[i],
                            equations_of_entries(model, forward_dynamics, 0, {entries[i]}))) {
        shown.push_back(entries[i]);
        result.left.push_back(names[i]);
      } else {
        omitted.push_back(leaf == Opcode::acceleration ? model.velocities[i].name
                                                       : model.constraints[i].name);
      }
    }
    if (!omitted.empty()) {
      result.omitted.push_back(fmt::format("{} of {}", noun, fmt::join(omitted, ", ")));
    }
  }
  if (!shown.empty()) result.equations = equations_of_entries(model, forward_dynamics, 0, shown);
  return result;
}

}  // namespace elgen
