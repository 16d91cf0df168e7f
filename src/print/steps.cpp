// steps: the functions of a derivation -> page sections in textbook order: the action and its
// variation, positions, velocities, energies, constraints, then Lagrange's equation for each
// velocity.
#include "print/steps.hpp"

#include <fmt/ranges.h>

#include <algorithm>

#include "elgen/page.hpp"
#include "elgen/references.hpp"
#include "elgen/typeset.hpp"
#include "model/symbols.hpp"
#include "print/sections.hpp"

namespace elgen {
namespace {

/// Builds sections equation by equation. A section ends with the definitions of its functions.
class DerivationOutline {
 public:
  DerivationOutline(const Model& model, const ReadableDerivation& steps, bool is_opening)
      : model_(model), steps_(steps), symbols_(model), is_opening_(is_opening) {
    for (const std::string& name : steps.masses) {
      Glyphs place = read_latex("<r>");
      add_script(place, 1, symbol_of_name(name));
      places_.push_back(symbols_.make_distinct(std::move(place)));
    }
    for (std::size_t i = 0; i < steps.program.functions.size(); ++i) {
      read_.push_back(equations(model, steps.program, i));
    }
  }

  std::vector<PageSection> operator()() {
    add_action();
    for (PageSection& section : frame_sections(model_, steps_))
      outline_.push_back(std::move(section));
    std::size_t function = 0;
    if (!steps_.masses.empty()) {
      add_motions(function, "Positions", "Positions of the masses as functions of the coordinates.",
                  false);
      add_motions(function + 1, "Velocities", "Their time derivatives, by the chain rule.", true);
      function += 2;
    }
    const std::size_t constraints = function;
    if (is_constrained()) ++function;
    add_energies(function++);
    if (is_constrained()) add_constraints(constraints);
    const std::size_t first = function;
    for (const Velocity& velocity : model_.velocities) add_velocity_equations(function++, velocity);
    add_invariants(function);
    add_equations(first, constraints);
    for (PageSection& section : outline_) section.is_aligned = true;
    return std::move(outline_);
  }

 private:
  [[nodiscard]] bool is_zero(std::size_t function, std::size_t field) const {
    const Function& read = printed_function(function, field);
    return loads_zero(steps_.program, read.instructions[read.fields[field].entries.front()]);
  }
  [[nodiscard]] bool is_zero(std::size_t function, LagrangeStepField line) const {
    return is_zero(function, field_index(line));
  }

  /// True if the force in Lagrange's equation, a field of `function`, contains a multiplier.
  [[nodiscard]] bool has_multiplier(std::size_t function) const {
    const std::size_t force = field_index(LagrangeStepField::force);
    const Function& read = printed_function(function, force);
    const std::vector<bool> needed = needed_instructions(read, read.fields[force].entries);
    for (std::size_t at = 0; at < needed.size(); ++at) {
      if (needed[at] && read.instructions[at].opcode == Opcode::multiplier) return true;
    }
    return false;
  }

  /// True if a field of the function has a readable form.
  [[nodiscard]] bool is_read(std::size_t function, std::size_t field) const {
    return has_readable_form(steps_.program, function) &&
           !steps_.program.readable[function].fields[field].entries.empty();
  }
  [[nodiscard]] bool is_read(std::size_t function, LagrangeStepField line) const {
    return is_read(function, field_index(line));
  }

  /// The function that has the printed form of a field.
  [[nodiscard]] const Function& printed_function(std::size_t function, std::size_t field) const {
    return is_read(function, field) ? steps_.program.readable[function]
                                    : steps_.program.functions[function];
  }

  PageSection& add_section(Formula title, std::string doc) {
    functions_.clear();
    return outline_.emplace_back(PageSection{.title = std::move(title), .doc = std::move(doc)});
  }

  /// Adds the equation `left` = field of a function.
  void add_equation(Formula left, std::size_t function, std::size_t field, std::uint32_t rows = 1) {
    Formulas entries = read_[function].entries[field];
    entries.resize(rows);
    outline_.back().equations.push_back({std::move(left), rows, 1, std::move(entries)});
    if (std::ranges::count(functions_, function) == 0) functions_.push_back(function);
  }

  /// Appends the definitions that the section uses. A definition that several functions share is
  /// printed once.
  void end_section() {
    std::vector<std::string> known;
    for (const std::size_t function : functions_) {
      for (const auto& [name, value] : read_[function].definitions) {
        if (std::ranges::count(known, text_of(name)) > 0) continue;
        known.push_back(text_of(name));
        outline_.back().equations.push_back({name, 1, 1, {value}, true});
      }
    }
  }

  void add_line(std::string_view latex) {
    outline_.back().lines.push_back(latex_formula(model_, latex));
  }

  void add_action() {
    PageSection& section = add_section(prose("Action"), std::string(action_doc));
    if (!model_.rotations.empty()) section.doc += rotation_variation_note;
    for (const std::string& line : principle_lines(model_)) add_line(line);
  }

  void add_motions(std::size_t function, const char* title, std::string doc, bool are_rates) {
    add_section(prose(title), std::move(doc));
    for (std::size_t i = 0; i < steps_.masses.size(); ++i) {
      const std::string& name = steps_.masses[i];
      Glyphs place = are_rates ? read_latex("\\frac{d}{dt}") : Glyphs{};
      append(place, places_[i], true);
      add_equation(
          symbol_formula(are_rates ? fmt::format("d({})/dt", name) : name, std::move(place)),
          function, i, has_plane_vectors(model_) ? 2U : 3U);
    }
    end_section();
  }

  void add_energies(std::size_t function) {
    const bool is_whole = has_combined_lagrangian(model_);
    const char* doc =
        has_routhian(model_)
            ? "Routh's function, which contains the momenta of the cyclic coordinates."
        : is_whole ? "The Lagrangian as given."
                   : "Kinetic and potential energy, L = T - V.";
    PageSection& section = add_section(prose(std::string(energies_title)), doc);
    const bool has_places = !model_.points.empty() || !model_.bodies.empty();
    if (has_places && (model_.approximation || has_routhian(model_))) {
      section.doc += fmt::format(
          " Positions are omitted, because {}.",
          model_.approximation ? "the energies are expanded" : "Routh's function replaces T and V");
    }
    const std::string_view names = is_whole ? "L" : "TVL";
    for (std::size_t i = 0; i < names.size(); ++i) {
      add_equation(latex_formula(names.substr(i, 1)), function, i);
    }
    add_dissipation();
    end_section();
  }

  /// Adds D as typed, with the definitions whose names it contains.
  void add_dissipation() {
    const std::vector<ExpressionId> roots = dissipation_roots(model_);
    if (roots.empty()) return;
    FunctionEquations typed;
    Formulas terms;
    for (const ExpressionId root : roots) terms.push_back(expression_formula(model_, root));
    typed.entries.push_back({sum_of(std::move(terms))});
    for (const ExpressionId id : reachable_expressions(model_, roots)) {
      const Expression& e = model_.expressions[id];
      if (!refers_to_entry(e, NamedKind::definition) && !refers_to_entry(e, NamedKind::prescribed))
        continue;
      typed.definitions.push_back(
          {expression_formula(model_, id), expression_formula(model_, *value_of_name(model_, e))});
    }
    read_.push_back(std::move(typed));
    add_equation(latex_formula("D"), read_.size() - 1, 0);
  }

  /// Adds the functions f and phi of all constraints, L + lambda f for constraints on positions,
  /// and a note on constraints on velocities.
  void add_constraints(std::size_t function) {
    PageSection& section = add_section(prose("Constraints"), std::string(constraints_doc));
    Formulas sum = {latex_formula("L")};
    bool has_velocities = false;
    for (std::uint32_t i = 0; i < model_.constraints.size(); ++i) {
      const Constraint& constraint = model_.constraints[i];
      const std::string name = (constraint.is_position ? "f_" : "phi_") + constraint.name;
      const Formula symbol = symbol_formula(name, symbol_of_name(name));
      add_equation(symbol, function, i);
      has_velocities = has_velocities || !constraint.is_position;
      if (!constraint.is_position) continue;
      sum.push_back(product_of({symbols_.leaf_symbols().multipliers[i], symbol}));
    }
    if (sum.size() > 1) {
      section.lines.push_back(
          row_of({sum_of(std::move(sum)), prose("instead of"), latex_formula("L"),
                  prose("gives the same"), latex_formula(model_, "A^{\\top} <lambda>")}));
    }
    if (has_velocities) add_line(velocity_constraint_note);
    end_section();
  }

  [[nodiscard]] static std::size_t field_index(LagrangeStepField line) {
    return static_cast<std::size_t>(line);
  }

  void add_velocity_equations(std::size_t function, const Velocity& velocity) {
    const std::string& q = velocity.name;
    const bool is_angular = velocity.rotation.has_value();
    const Glyphs glyphs =
        is_angular ? symbol_of_name(q) : glyphs_of(symbols_.leaf_symbols().q[velocity.coordinate]);
    const Formula symbol = symbol_formula(q, glyphs);
    const Formula rate = symbol_formula(fmt::format("dot({})", q), add_dots(glyphs, "˙"));
    const Formula slope = partial_derivative("L", rate);
    PageSection& section = add_section(row_of({prose("Equation of"), symbol}),
                                       is_angular ? std::string(rotation_doc) : "");
    const bool has_constraint_force = has_multiplier(function);
    if (!is_angular && !has_constraint_force && is_zero(function, LagrangeStepField::partial)) {
      section.lines.push_back(conservation_line(function, slope, symbol));
    }
    add_equation(slope, function, field_index(LagrangeStepField::momentum));
    add_equation(row_of({latex_formula("\\frac{d}{dt}"), slope}), function,
                 field_index(LagrangeStepField::momentum_rate));
    add_equation(partial_derivative("L", symbol), function,
                 field_index(LagrangeStepField::partial));
    if (!is_zero(function, LagrangeStepField::dissipation)) {
      add_equation(partial_derivative("D", rate), function,
                   field_index(LagrangeStepField::dissipation));
    }
    if (!is_zero(function, LagrangeStepField::force)) {
      Glyphs force = read_latex("Q");
      add_script(force, 1, glyphs);
      Glyphs held = latex_glyphs(model_, "(A^{\\top} <lambda>)");
      add_script(held, 1, glyphs);
      Formulas terms;
      if (has_applied_force(model_)) terms.push_back(symbol_formula("Q_" + q, std::move(force)));
      if (has_constraint_force)
        terms.push_back(symbol_formula("(A^T lambda)_" + q, std::move(held)));
      add_equation(sum_of(std::move(terms)), function, field_index(LagrangeStepField::force));
    }
    add_lagrange_equation(function);
    end_section();
  }

  /// Adds Lagrange's equation d/dt dL/dv - dL/dq + dD/dv = Q + A^T lambda of one velocity, in
  /// coordinates.
  void add_lagrange_equation(std::size_t function) {
    add_equation(read_[function].entries[field_index(LagrangeStepField::left)].front(), function,
                 field_index(LagrangeStepField::force));
  }

  /// Adds the row of one velocity to the list of all equations; false if the row is too long. If
  /// another field of the function is too long, the row brings only its own definitions, because
  /// definitions of several functions may share a name.
  bool add_row(std::size_t function) {
    if (!is_read(function, LagrangeStepField::left) ||
        !is_read(function, LagrangeStepField::force)) {
      return false;
    }
    const std::vector<Field>& fields = steps_.program.readable[function].fields;
    const auto is_short = [](const Field& field) { return !field.entries.empty(); };
    if (std::ranges::all_of(fields, is_short)) {
      add_lagrange_equation(function);
      return true;
    }
    const auto entry = [&fields](LagrangeStepField line) {
      return fields[field_index(line)].entries.front();
    };
    FunctionEquations row =
        equations_of_entries(model_, steps_.program, function,
                             {entry(LagrangeStepField::force), entry(LagrangeStepField::left)});
    const Formula left = row.entries.back().front();
    if (!is_short_on_paper(left, row)) return false;
    read_.push_back(std::move(row));
    add_equation(left, read_.size() - 1, 0);
    return true;
  }

  /// Adds the equations of all velocities, then the constraints and the solved accelerations.
  void add_equations(std::size_t first, std::size_t constraints) {
    PageSection& section = add_section(prose(std::string(equations_title)), "");
    const std::size_t count = model_.velocities.size();
    std::vector<std::string> long_rows;
    for (std::size_t i = 0; i < count; ++i) {
      if (!add_row(first + i)) long_rows.push_back(model_.velocities[i].name);
    }
    if (!long_rows.empty()) {
      section.doc = fmt::format(
          "Omitted rows, too long to read in one piece: {}. {} in parts.",
          fmt::join(long_rows, ", "),
          is_opening_ ? "elgen show --what steps prints each" : "Their own sections print them");
    }
    const bool are_read = has_readable_form(steps_.program, constraints);
    for (std::size_t i = 0; are_read && i < model_.constraints.size(); ++i) {
      add_equation(read_[constraints].entries[i].front(), constraints, model_.constraints.size());
    }
    add_accelerations(first + count + 1);
    end_section();
    if (section.equations.empty() && section.doc.empty()) outline_.pop_back();
  }

  /// Adds the accelerations and multipliers that are short enough. Either forward dynamics or the
  /// rows solved one by one give them, because both may use the same names of definitions.
  void add_accelerations(std::size_t rows) {
    PaperSolution solution;
    if (steps_.solution) solution = solution_on_paper(model_, *steps_.solution);
    const std::vector<Formulas>& solved = read_[rows].entries;
    const auto solved_rows = static_cast<std::size_t>(
        std::ranges::count(solved, false, [](const Formulas& row) { return row.empty(); }));
    if (solution.left.size() >= std::max<std::size_t>(solved_rows, 1)) {
      read_.push_back(std::move(solution.equations));
      for (std::size_t i = 0; i < solution.left.size(); ++i) {
        add_equation(solution.left[i], read_.size() - 1, i);
      }
    } else {
      const bool lists_rows = steps_.solution && solved_rows > 0;
      if (lists_rows) solution.omitted.clear();
      for (std::uint32_t i = 0; i < solved.size(); ++i) {
        if (!solved[i].empty()) {
          add_equation(symbols_.leaf_symbols().a[i], rows, i);
        } else if (lists_rows) {
          solution.omitted.push_back("acceleration of " + model_.velocities[i].name);
        }
      }
    }
    if (solution.omitted.empty()) return;
    std::string& doc = outline_.back().doc;
    doc +=
        fmt::format("{}Too long for this page: {}. elgen show --what forward_dynamics prints them.",
                    doc.empty() ? "" : " ", fmt::join(solution.omitted, ", "));
  }

  /// The sentence of Noether's theorem: "L does not contain q, so p_q = `slope` is conserved".
  [[nodiscard]] Formula conservation_line(std::size_t function, const Formula& slope,
                                          const Formula& q) const {
    const bool is_unforced = is_zero(function, LagrangeStepField::force) &&
                             is_zero(function, LagrangeStepField::dissipation);
    const char* condition = is_unforced ? "" : " if no force and no dissipation act on it";
    Glyphs momentum = read_latex("p");
    add_script(momentum, 1, glyphs_of(q));
    return row_of({latex_formula("L"), prose("does not contain"), q, prose(", so"),
                   relation(symbol_formula("p_" + text_of(q), std::move(momentum)), slope),
                   prose(fmt::format("is conserved{}", condition))});
  }

  [[nodiscard]] bool is_constrained() const { return !model_.constraints.empty(); }

  void add_invariants(std::size_t function) {
    const bool is_autonomous = is_zero(function, 1);
    PageSection& section = add_section(prose("Energy function"), "");
    const char* contains = is_autonomous ? "does not contain" : "contains";
    const std::string verdict = is_autonomous ? energy_conservation(model_) : "is not conserved";
    section.lines = {row_of({latex_formula("L"), prose(contains), latex_formula("t"), prose(", so"),
                             latex_formula("E"), prose(verdict)})};
    add_line(energy_rate(model_, is_autonomous));
    const Glyphs definition =
        latex_glyphs(model_, R"(E = <v>^{\top} \frac{\partial L}{\partial <v>} - L)");
    add_equation(symbol_formula("E = sum of v dL/dv - L", definition), function, 0);
    if (!is_autonomous) {
      add_equation(
          symbol_formula("dL/dt at fixed q and v", read_latex("\\frac{\\partial L}{\\partial t}")),
          function, 1);
    }
    end_section();
  }

  const Model& model_;
  const ReadableDerivation& steps_;
  ModelSymbols symbols_;
  bool is_opening_;  ///< true: the equations of motion open a page without the other sections
  std::vector<Glyphs> places_ = {};           ///< symbols of the positions of masses
  std::vector<FunctionEquations> read_ = {};  ///< per function
  std::vector<std::size_t> functions_ = {};   ///< used in the current section
  std::vector<PageSection> outline_ = {};
};

}  // namespace

std::vector<PageSection> derivation_sections(const Model& model, const ReadableDerivation& steps,
                                             std::string_view title) {
  std::vector<PageSection> sections = DerivationOutline(model, steps, !title.empty())();
  if (!title.empty()) {
    std::erase_if(sections,
                  [title](const PageSection& section) { return text_of(section.title) != title; });
  }
  return sections;
}

Page derivation_page(const Model& model, const Scene& scene, const ReadableDerivation& steps,
                     std::string_view title) {
  Page result = model_page(model, scene, {});
  result.equation_of_motion = latex_formula(model, lagrange_equation(model));
  result.sections = derivation_sections(model, steps, title);
  return result;
}

}  // namespace elgen
