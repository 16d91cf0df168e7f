// solution: the equations that end a derivation (steps.hpp).
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string_view>

#include "model/symbols.hpp"
#include "print/display.hpp"
#include "print/sections.hpp"
#include "print/steps.hpp"

namespace elgen {
namespace {

constexpr std::size_t most_lines = 12;

bool is_short(const NamedFormula& equation) {
  const PageEquation shown{equation.name, 1, 1, {equation.value}};
  return line_count(lay_out_equation(typeset_equation(shown))) <= most_lines;
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
  return is_short({left, equations.entries.front().front()}) &&
         std::ranges::all_of(equations.definitions, is_short);
}

PaperSolution solution_on_paper(const Model& model, const Program& forward_dynamics) {
  PaperSolution result;
  std::vector<std::uint32_t> shown;
  const auto add_field = [&](std::string_view field_name, const Formulas& names,
                             std::string_view noun, const auto& owners) {
    std::vector<std::uint32_t> entries;
    if (has_readable_form(forward_dynamics, 0)) {
      const std::vector<Field>& fields = forward_dynamics.readable.front().fields;
      const auto field = std::ranges::find(fields, field_name, &Field::name);
      if (field != fields.end()) entries = field->entries;
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (i < entries.size() &&
          is_short_on_paper(names[i],
                            equations_of_entries(model, forward_dynamics, 0, {entries[i]}))) {
        shown.push_back(entries[i]);
        result.left.push_back(names[i]);
      } else {
        result.omitted.push_back(fmt::format("{} of {}", noun, owners[i].name));
      }
    }
  };
  const ModelSymbols symbols(model);
  add_field("acceleration", symbols.leaf_symbols().a, "acceleration", model.velocities);
  add_field("multipliers", symbols.leaf_symbols().multipliers, "multiplier", model.constraints);
  if (!shown.empty()) result.equations = equations_of_entries(model, forward_dynamics, 0, shown);
  return result;
}

}  // namespace elgen
