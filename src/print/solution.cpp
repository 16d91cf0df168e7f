// solution: see solution.hpp.
#include "print/solution.hpp"

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
};

constexpr std::array solved_fields{SolvedField{"acceleration", Opcode::acceleration},
                                   SolvedField{"multipliers", Opcode::multiplier}};

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

/// The equations of some entries of the readable form, as fields of one entry each.
FunctionEquations equations_of(const Model& model, Program program,
                               const std::vector<std::uint32_t>& entries) {
  Function& book = program.readable.front();
  book.fields.clear();
  for (const std::uint32_t entry : entries) book.fields.push_back({"", 1, 1, {entry}});
  book = eliminate_dead_code(std::move(book));
  program.functions.front() = book;
  return equations(model, program, 0);
}

bool is_short(const Formula& left, const FunctionEquations& solved) {
  const auto is_short_definition = [](const NamedFormula& definition) {
    return is_short(definition.name, definition.value);
  };
  return is_short(left, solved.entries.front().front()) &&
         std::ranges::all_of(solved.definitions, is_short_definition);
}

}  // namespace

PaperSolution solution_on_paper(const Model& model, const Program& forward_dynamics) {
  PaperSolution result;
  const ModelSymbols symbols(model);
  std::vector<std::uint32_t> shown;
  for (const auto& [field, leaf] : solved_fields) {
    const std::vector<std::uint32_t> entries = readable_entries(forward_dynamics, field);
    const Formulas& names = *leaf_list(symbols.leaf_symbols(), leaf);
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (i < entries.size() &&
          is_short(names[i], equations_of(model, forward_dynamics, {entries[i]}))) {
        shown.push_back(entries[i]);
        result.left.push_back(names[i]);
      } else {
        result.omitted.push_back(text_of(names[i]));
      }
    }
  }
  if (!shown.empty()) result.equations = equations_of(model, forward_dynamics, shown);
  return result;
}

}  // namespace elgen
