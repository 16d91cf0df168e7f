// symmetries_page: a row for each symmetry with its change and its integral; the claim (conserved
// quantities, evidence, completeness); and the integrals in the form of [[expect]].
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <span>

#include "analyse/formulas.hpp"
#include "analyse/generators.hpp"
#include "elgen/analysis_pages.hpp"
#include "elgen/leaf_names.hpp"
#include "formula/glyphs.hpp"
#include "model/symbols.hpp"
#include "print/analyses/page_parts.hpp"

namespace elgen {
namespace {

Formula formula_or_placeholder(const PageForms& known, const OptionalFraction& form) {
  return known.to_formula(form).value_or(latex_formula("\\text{a long expression}"));
}

Formula symmetries_title(const CheckedModel& checked, const Symmetries& symmetries) {
  return row_of(
      {analysis_title(checked, "symmetries of L with"),
       latex_symbol("dq = A q + b + c t", "{\\delta} q = A q + b + c t"),
       checked.model.rotations.empty()
           ? Formula{}
           : row_of({prose(", rotations by"), latex_symbol("R^T s + b", "R^{\\top} s + b")}),
       prose(","), latex_symbol("dt", "{\\delta} t"),
       prose(fmt::format("constant: {}", symmetries.symmetries.size()))});
}

/// The symbol of the coordinate if only one coordinate changes, else the kind of symmetry in words.
Formula name_of(const PageForms& known, const Symmetry& symmetry) {
  if (symmetry.kind != SymmetryKind::coordinate) return prose(name_of(symmetry.kind));
  const auto moved = std::ranges::find_if(symmetry.displacement,
                                          [](const Fraction& x) { return !x.numerator.empty(); });
  const auto velocity = static_cast<std::size_t>(moved - symmetry.displacement.begin());
  return known.symbols.q[known.model.velocities[velocity].coordinate];
}

/// Appends "dx = -y" or "dt = 1" to `changes`, unless `along` is 0.
void add_displacement(Formulas& changes, const PageForms& known, const Formula& symbol,
                      const Fraction& along) {
  if (along.numerator.empty()) return;
  Glyphs glyphs = read_latex("{\\delta}");
  append(glyphs, glyphs_of(symbol), true);
  changes.push_back(relation(symbol_formula("d" + text_of(symbol), std::move(glyphs)),
                             formula_or_placeholder(known, along)));
}

/// "(0, 0, 1)"; empty if all entries are 0.
Formula turn_vector(const PageForms& known, const Symmetry& symmetry, std::size_t first) {
  const std::span entries = std::span(symmetry.generator).subspan(first, axis_count);
  const auto is_zero = [](const Fraction& entry) { return entry.numerator.empty(); };
  if (std::ranges::all_of(entries, is_zero)) return {};
  Formulas parts;
  for (const Fraction& entry : entries) {
    parts.push_back(known.to_formula(entry).value_or(latex_formula("?")));
  }
  return tuple_of(std::move(parts));
}

/// Appends "attitude rotated by R^T (0, 0, 1)" to `changes`, if `symmetry` turns the rotation.
void add_rotation_change(Formulas& changes, const PageForms& known, const Symmetry& symmetry,
                         std::size_t rotation) {
  const GeneratorLayout all(known.model);
  Formula world = turn_vector(known, symmetry, all.world_turn_index(rotation, 0));
  Formula body = turn_vector(known, symmetry, all.body_turn_index(rotation, 0));
  if (world.is_empty() && body.is_empty()) return;
  Formulas parts{prose(known.model.rotations[rotation].name + " rotated by")};
  if (!world.is_empty()) {
    parts.push_back(latex_symbol("R^T", "R^{\\top}"));
    parts.push_back(std::move(world));
    if (!body.is_empty()) parts.push_back(latex_formula("+"));
  }
  parts.push_back(std::move(body));
  changes.push_back(row_of(std::move(parts)));
}

Formula change_formula(const PageForms& known, const Symmetry& symmetry) {
  const GeneratorLayout all(known.model);
  Formulas changes;
  for (std::size_t i = 0; i < all.scalar_count(); ++i) {
    add_displacement(changes, known, known.symbols.q[all.coordinates[i]],
                     symmetry.displacement[all.velocities[i]]);
  }
  for (std::size_t r = 0; r < all.rotations.size(); ++r)
    add_rotation_change(changes, known, symmetry, r);
  add_displacement(changes, known, known.symbols.t, symmetry.generator.back());
  return list_of(std::move(changes));
}

/// The symbol F of an integral such as p(x)*t - F. If the model has a value "F", the first unused
/// name of "F_1", "F_2", ….
std::string total_symbol_name(const Model& model) {
  std::string name = "F";
  for (int i = 1; has_value_named(model, name); ++i) name = fmt::format("F_{}", i);
  return name;
}

/// A symbol that differs, as LaTeX, from the symbols of all values of the model.
Formula unused_symbol(const Model& model, const std::string& name) {
  return symbol_formula(name, ModelSymbols(model).make_distinct(symbol_of_name(name)));
}

/// An integral as left side, equation and note: "p(x)" = "m*dot(x)"; "p(x)*t - F" with the equation
/// "F" = "m*x"; or "E" = "…" with a note.
struct IntegralLine {
  Formula left = {};
  std::optional<PageEquation> equation = {};
  Formula note = {};
};

PageEquation make_equation(Formula left, Formula right) {
  return {std::move(left), 1, 1, {std::move(right)}};
}

Formula one_line_formula(const PageEquation& equation) {
  return relation(equation.left, equation.entries[0]);
}

Formula one_line_formula(const IntegralLine& integral) {
  Formulas parts{integral.left};
  if (integral.equation) {
    if (!integral.left.is_empty()) parts.insert(parts.end(), {prose(","), wide_blank()});
    parts.push_back(one_line_formula(*integral.equation));
  }
  if (!integral.note.is_empty()) parts.insert(parts.end(), {wide_blank(), integral.note});
  return row_of(std::move(parts));
}

/// True if a symmetry turns a rotation, about an axis of the world or of the body.
bool turns_rotation(const Model& model, const Symmetry& symmetry) {
  const GeneratorLayout all(model);
  return std::any_of(
      symmetry.generator.begin() + static_cast<std::ptrdiff_t>(all.world_turn_index(0, 0)),
      symmetry.generator.begin() + static_cast<std::ptrdiff_t>(all.time_index()),
      [](const Fraction& unknown) { return !unknown.numerator.empty(); });
}

Formula integral_note(const Symmetry& symmetry, bool loses_energy) {
  if (symmetry.is_rounded) return prose("(to six digits, only at these values of the parameters)");
  if (symmetry.is_at_values_only) return prose("(only at these values of the parameters)");
  if (symmetry.kind != SymmetryKind::time || !loses_energy) return {};
  return latex_symbol("(T + V is not conserved)", "(T + V \\text{ is not conserved})");
}

IntegralLine integral_line(const PageForms& known, const Symmetry& symmetry, bool loses_energy) {
  Formula names = formula_or_placeholder(known, symmetry.momentum_form);
  IntegralLine result{.note = integral_note(symmetry, loses_energy)};
  if (!is_zero_form(symmetry.gauge_function)) {
    const Formula total = unused_symbol(known.model, total_symbol_name(known.model));
    Formulas terms = names.kind == FormulaKind::sum ? names.parts : Formulas{names};
    terms.push_back(negative_of(total));
    result.left = sum_of(std::move(terms));
    if (symmetry.gauge_function) {
      result.equation =
          make_equation(total, formula_or_placeholder(known, symmetry.gauge_function));
    } else {
      result.left =
          row_of({std::move(result.left), prose(","), total, prose("has no closed form")});
    }
  } else if (turns_rotation(known.model,
                            symmetry)) {  // the closed form would repeat the components
    result.equation = make_equation(unused_symbol(known.model, "I"), std::move(names));
  } else if (std::optional<Formula> closed = known.to_formula(symmetry.velocity_form)) {
    result.equation = make_equation(std::move(names), std::move(*closed));
  } else {
    result.left = std::move(names);
  }
  return result;
}

/// "d/dt" = "u*t": the rate by which forces change the integral; none if the rate is 0.
std::optional<PageEquation> rate_equation(const PageForms& known, const Symmetry& symmetry) {
  if (is_zero_form(symmetry.rate)) return std::nullopt;
  const Formula otherwise =
      latex_symbol("(dq - v dt).(B u + Q - dD/dv)",
                   "({\\delta} q - v {\\delta} t) \\cdot (B u + Q - \\partial D/\\partial v)");
  return make_equation(latex_symbol("d/dt", "\\text{d/dt}"),
                       known.to_formula(symmetry.rate).value_or(otherwise));
}

/// A row of the table, or a block of lines.
struct SymmetryRow {
  Formula name = {};
  Formula change = {};
  IntegralLine integral = {};
  std::optional<PageEquation> rate = {};
};

/// The lines and equations of one symmetry. An example of the first line is
/// "rotation: dx = -y, dy = x".
PageSection symmetry_block(const SymmetryRow& row) {
  PageSection block{.lines = {row_of({row.name, prose(":"), row.change})}};
  for (const Formula& line : {row.integral.left, row.integral.note}) {
    if (!line.is_empty()) block.lines.push_back(line);
  }
  for (const std::optional<PageEquation>& equation : {row.integral.equation, row.rate}) {
    if (equation) block.equations.push_back(*equation);
  }
  return block;
}

PageTable symmetry_table(const std::vector<SymmetryRow>& rows, const Symmetries& symmetries) {
  const bool has_change = !std::ranges::all_of(symmetries.symmetries, [](const Symmetry& symmetry) {
    return symmetry.kind == SymmetryKind::time;
  });
  const bool has_rate =
      std::ranges::any_of(rows, [](const SymmetryRow& row) { return row.rate.has_value(); });
  PageTable table;
  table.heads.resize(2U + (has_change ? 1U : 0U) + (has_rate ? 1U : 0U));
  for (const SymmetryRow& row : rows) {
    table.cells.push_back(row.name);
    if (has_change) table.cells.push_back(row.change);
    table.cells.push_back(one_line_formula(row.integral));
    if (has_rate) table.cells.push_back(row.rate ? one_line_formula(*row.rate) : Formula{});
  }
  return table;
}

std::size_t table_width(const PageTable& table) {
  std::vector<std::size_t> widths(table.heads.size(), 0);
  for (std::size_t i = 0; i < table.cells.size(); ++i) {
    std::size_t& width = widths[i % widths.size()];
    width = std::max(width, text_of(table.cells[i]).size());
  }
  return std::accumulate(widths.begin(), widths.end(), std::size_t{0});
}

/// One table row per symmetry, or a block per symmetry if a row would be too wide to read.
std::vector<PageSection> symmetry_sections(const PageForms& known, const Symmetries& symmetries) {
  constexpr std::size_t widest = 120;
  std::vector<SymmetryRow> rows;
  for (const Symmetry& symmetry : symmetries.symmetries) {
    rows.push_back({name_of(known, symmetry), change_formula(known, symmetry),
                    integral_line(known, symmetry, symmetries.loses_energy),
                    rate_equation(known, symmetry)});
  }
  PageTable table = symmetry_table(rows, symmetries);
  std::vector<PageSection> sections;
  if (table_width(table) <= widest) {
    sections.push_back({.table = std::move(table)});
  } else {
    std::ranges::transform(rows, std::back_inserter(sections), symmetry_block);
  }
  return sections;
}

/// "sampled at 8 states in 160 digits"
std::string sampled_text(const Symmetries& symmetries) {
  return fmt::format("sampled at {} states in 160 digits", symmetries.states);
}

/// The verdict on the integrals, which begins symmetries_claim(): "conserved: proved; ".
std::string integrals_verdict(const Model& model, const Symmetries& symmetries) {
  if (symmetries.symmetries.empty()) return {};
  const bool are_proved = std::ranges::all_of(symmetries.symmetries, &Symmetry::is_proved);
  const bool is_free = std::ranges::all_of(symmetries.symmetries, is_zero_form, &Symmetry::rate);
  return fmt::format("{}: {}; ", is_free ? "conserved" : "conserved if d/dt is 0",
                     are_proved ? "proved"
                     : symmetries.is_exact
                         ? fmt::format("dL = d{}/dt is proved", total_symbol_name(model))
                         : sampled_text(symmetries));
}

/// "conserved: proved; these are all symmetries of this form (9 unknown coefficients, exact)"
std::string symmetries_claim(const Model& model, const Symmetries& symmetries) {
  const std::size_t count = symmetries.symmetries.size();
  if (!symmetries.is_exact && symmetries.states == 0) {
    return "not decided: no sampled state within the ranges has a value";
  }
  const std::string unknowns = fmt::format("{} unknown coefficients", symmetries.unknowns);
  const std::string subject = count == 0 ? "there are no symmetries" : "these are all symmetries";
  const bool is_generic = symmetries.sampled_elsewhere == count &&
                          std::ranges::none_of(symmetries.symmetries, &Symmetry::is_at_values_only);
  const bool agrees = symmetries.states > 0 && symmetries.sampled == count;
  std::string line = integrals_verdict(model, symmetries);
  if (symmetries.is_complete) {
    line += fmt::format("{} of this form ({}, exact)", subject, unknowns);
  } else if (is_generic) {
    line += fmt::format("{} of this form ({}, sampled)", subject, unknowns);
  } else if (agrees) {
    line +=
        fmt::format("{} of this form at the parameters' values ({}, sampled)", subject, unknowns);
  } else {
    line += fmt::format("there may be more symmetries of this form ({})", unknowns);
  }
  if (symmetries.states == 0 || agrees) return line;
  return line + fmt::format("; at the parameters' values there {} {} ({})",
                            symmetries.sampled == 1 ? "is" : "are", symmetries.sampled,
                            sampled_text(symmetries));
}

}  // namespace

const char* name_of(SymmetryKind kind) {
  switch (kind) {
    case SymmetryKind::coordinate:
    case SymmetryKind::translation:
      return "translation";
    case SymmetryKind::boost:
      return "boost";
    case SymmetryKind::rotation:
      return "rotation";
    case SymmetryKind::body_rotation:
      return "turn";
    case SymmetryKind::other:
      return "other";
    case SymmetryKind::time:
      return "time";
  }
  return "";
}

std::vector<std::string> stated_integrals(const CheckedModel& checked, PageForms& known,
                                          const Symmetries& symmetries) {
  std::vector<std::string> result;
  if (!checked.scene.canonical_text.empty()) return result;
  Arithmetic arithmetic(known.forms.algebra);
  LeafSearch quaternions(known.forms.algebra, [&known](const Atom& leaf) {
    return leaf.leaf == Opcode::coordinate && known.model.coordinates[leaf.index].rotation;
  });
  for (const Symmetry& symmetry : symmetries.symmetries) {
    if (symmetry.is_at_values_only || !symmetry.gauge_function ||
        !is_zero_form(symmetry.unforced_rate))
      continue;
    const OptionalFraction whole =
        arithmetic.subtract(symmetry.momentum_form, *symmetry.gauge_function);
    if (!whole || quaternions.contains(*whole)) continue;
    if (const auto formula = known.to_formula(whole)) result.push_back(text_of(*formula));
  }
  return result;
}

Page symmetries_page(const CheckedModel& checked, const Symmetries& symmetries) {
  PageForms known(checked.model, symmetries.forms);
  Page page{.title = symmetries_title(checked, symmetries)};
  if (!symmetries.symmetries.empty()) page.sections = symmetry_sections(known, symmetries);
  page.sections.push_back({.doc = symmetries_claim(checked.model, symmetries)});
  std::string list;
  for (const std::string& name : stated_integrals(checked, known, symmetries)) {
    list += fmt::format("{}\"{}\"", list.empty() ? "" : ", ", name);
  }
  if (list.empty()) return page;
  page.sections.push_back(
      {.title = prose("[[expect]]"), .doc = fmt::format("conserved = [{}]", list)});
  return page;
}

}  // namespace elgen
