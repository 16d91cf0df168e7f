// steps: the functions of a derivation -> a page in LaTeX, or plain text, in the order of a
// textbook: the action and what makes it stationary, positions, velocities, energies, constraints,
// then Lagrange's equation of one coordinate after the other.
#include "render/steps.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "elgen/render.hpp"
#include "elgen/typeset.hpp"
#include "render/headings.hpp"
#include "render/symbols.hpp"

namespace elgen {
namespace {

class Outline {
 public:
  Outline(const Model& model, const ReadableSteps& steps)
      : model_(model), steps_(steps), symbols_(model) {
    for (const std::string& name : steps.masses) {
      const SymbolText place{"\\mathbf{r}", "_{" + latex_symbol(name).text() + "}"};
      places_.push_back(symbols_.distinct(place).text());
    }
    for (std::size_t i = 0; i < steps.program.functions.size(); ++i) {
      text_.push_back(readable_equations(steps.program, i));
      latex_.push_back(latex_equations(model, steps.program, i));
    }
  }

  std::vector<DerivationStep> operator()() {
    add_action();
    std::size_t function = 0;
    if (!steps_.masses.empty()) {
      add_motions(function, "Positions",
                  "Where the masses are, in the coordinates." + positions_left_out(), false);
      add_motions(function + 1, "Velocities", "Their rates, by the chain rule.", true);
      function += 2;
    }
    const std::size_t constraints = function;
    if (is_constrained()) ++function;
    add_energies(function++);
    if (is_constrained()) add_constraints(constraints);
    const std::size_t first = function;
    for (const Velocity& velocity : model_.velocities) add_velocity(function++, velocity);
    add_invariants(function);
    add_equations(first, constraints);
    return std::move(outline_);
  }

  [[nodiscard]] const FunctionEquations& text_equations_of(std::size_t function) const {
    return text_[function];
  }
  [[nodiscard]] const FunctionEquations& latex_equations_of(std::size_t function) const {
    return latex_[function];
  }

 private:
  [[nodiscard]] bool is_zero(std::size_t function, std::size_t field) const {
    const Function& read = read_form(function);
    return loads_zero(steps_.program, read.instructions[read.fields[field].entries.front()]);
  }
  [[nodiscard]] bool is_zero(std::size_t function, BookLine line) const {
    return is_zero(function, field_of(line));
  }

  /// Whether a multiplier acts along the velocity of the function.
  [[nodiscard]] bool has_multiplier(std::size_t function) const {
    const Function& read = read_form(function);
    const std::vector<bool> needed =
        needed_for(read, read.fields[field_of(BookLine::force)].entries);
    for (std::size_t at = 0; at < needed.size(); ++at) {
      if (needed[at] && read.instructions[at].opcode == Opcode::multiplier) return true;
    }
    return false;
  }

  [[nodiscard]] const Function& read_form(std::size_t function) const {
    return has_book_form(function) ? steps_.program.readable[function]
                                   : steps_.program.functions[function];
  }

  [[nodiscard]] bool has_book_form(std::size_t function) const {
    return !steps_.program.readable[function].fields.empty();
  }

  /// Models in a plane are written with two components.
  [[nodiscard]] std::uint32_t dimension() const {
    for (const Point& point : model_.points) {
      if (point.dimension == 3) return 3;
    }
    for (const Body& body : model_.bodies) {
      if (body.dimension == 3) return 3;
    }
    return 2;
  }

  void add_action() {
    DerivationStep step{"Action", "", std::string(action_doc), {}, {}};
    if (!model_.rotations.empty()) step.doc += turning_variation;
    const auto add = [&](const FixedLine& line) {
      step.lines.push_back({line.text, latex_of(model_, line.latex)});
    };
    std::ranges::for_each(variation_lines, add);
    if (!is_free()) add(is_constrained() ? constrained_work : virtual_work);
    add(is_free() ? stationary : balanced_forces);
    if (is_constrained()) {
      step.lines.back().text += constraint_forces.text;
      step.lines.back().latex += latex_of(model_, constraint_forces.latex);
    }
    outline_.push_back(std::move(step));
  }

  [[nodiscard]] std::string positions_left_out() const {
    if (steps_.left_out.empty()) return {};
    return fmt::format(" Positions left out, as the energies have them {}: {}.",
                       model_.approximation ? "expanded" : "by the motion of frames",
                       fmt::join(steps_.left_out, ", "));
  }

  void add_motions(std::size_t function, const char* title, const std::string& doc,
                   bool are_rates) {
    DerivationStep step{title, "", doc, {}, {}};
    for (std::size_t i = 0; i < steps_.masses.size(); ++i) {
      const std::string& name = steps_.masses[i];
      const std::string& place = places_[i];
      step.equations.push_back({are_rates ? fmt::format("d({})/dt", name) : name,
                                are_rates ? fmt::format("\\frac{{d}}{{dt}} {}", place) : place,
                                function, i, dimension()});
    }
    outline_.push_back(std::move(step));
  }

  void add_energies(std::size_t function) {
    const bool is_whole = has_whole_lagrangian(model_);
    const char* doc = has_routhian(model_)
                          ? "Routh's function, with the momenta of cyclic coordinates."
                      : is_whole ? "The Lagrangian as given."
                                 : "Kinetic and potential energy, L = T - V.";
    DerivationStep step{std::string(energies_title), "", doc, {}, {}};
    if (steps_.masses.empty()) step.doc += positions_left_out();
    const std::vector<std::string> names =
        is_whole ? std::vector<std::string>{"L"} : std::vector<std::string>{"T", "V", "L"};
    for (std::size_t i = 0; i < names.size(); ++i) {
      step.equations.push_back({names[i], names[i], function, i});
    }
    outline_.push_back(std::move(step));
  }

  /// L + lambda f of positions, what velocities have instead, and f and phi.
  void add_constraints(std::size_t function) {
    DerivationStep step{"Constraints", "", std::string(constraints_doc), {}, {}};
    StepLine sum{"L", "L"};
    bool has_velocities = false;
    for (std::uint32_t i = 0; i < model_.constraints.size(); ++i) {
      const Constraint& constraint = model_.constraints[i];
      const std::string name = (constraint.is_position ? "f_" : "phi_") + constraint.name;
      const std::string symbol = latex_symbol(name).text();
      step.equations.push_back({name, symbol, function, i});
      has_velocities = has_velocities || !constraint.is_position;
      if (!constraint.is_position) continue;
      sum.text += fmt::format(" + {} {}", leaf_text(model_, Opcode::multiplier, i), name);
      sum.latex += fmt::format(" + {} {}", symbols_.leaves().multipliers[i], symbol);
    }
    if (sum.text != "L") {
      step.lines.push_back({sum.text + " in the place of L gives the same A^T lambda",
                            sum.latex + latex_of(model_, R"(\text{ in the place of } L )"
                                                         R"(\text{ gives the same } )"
                                                         R"(A^{\top} <lambda>)")});
    }
    if (has_velocities) {
      const auto& [text, latex] = of_velocities;
      step.lines.push_back({text, latex_of(model_, latex)});
    }
    outline_.push_back(std::move(step));
  }

  [[nodiscard]] static std::size_t field_of(BookLine line) {
    return static_cast<std::size_t>(line);
  }

  void add_velocity(std::size_t function, const Velocity& velocity) {
    const std::string& q = velocity.name;
    const bool is_angular = velocity.rotation.has_value();
    const SymbolText symbol =
        is_angular ? latex_symbol(q) : symbols_.coordinates()[velocity.coordinate];
    const std::string rate = fmt::format("\\dot{{{}}}{}", symbol.base, symbol.scripts);
    const std::string slope = fmt::format("\\frac{{\\partial L}}{{\\partial {}}}", rate);
    DerivationStep step{fmt::format("Equation of {}", q),
                        fmt::format("\\text{{Equation of }}{}", symbol.text()),
                        is_angular ? std::string(turning_doc) : "",
                        {},
                        {}};
    const bool is_held = has_multiplier(function);
    if (!is_angular && !is_held && is_zero(function, BookLine::partial)) {
      step.lines.push_back(
          conservation(function, {fmt::format("dL/d(dot({}))", q), slope}, {q, symbol.text()}));
    }
    const auto add = [&](const std::string& text, const std::string& latex, BookLine line) {
      step.equations.push_back({text, latex, function, field_of(line)});
    };
    add(fmt::format("dL/d(dot({}))", q), slope, BookLine::momentum);
    add(fmt::format("d/dt dL/d(dot({}))", q), "\\frac{d}{dt} " + slope, BookLine::momentum_rate);
    add(fmt::format("dL/d{}", q),
        fmt::format("\\frac{{\\partial L}}{{\\partial {}}}", symbol.text()), BookLine::partial);
    if (!is_zero(function, BookLine::dissipation)) {
      add(fmt::format("dD/d(dot({}))", q),
          fmt::format("\\frac{{\\partial D}}{{\\partial {}}}", rate), BookLine::dissipation);
    }
    if (!is_zero(function, BookLine::force)) {
      const std::string force = fmt::format("Q_{{{}}}", symbol.text());
      add(is_held ? fmt::format("Q_{0} + (A^T lambda)_{0}", q) : "Q_" + q,
          is_held ? force + latex_of(model_,
                                     fmt::format(" + (A^{{\\top}} <lambda>)_{{{}}}", symbol.text()))
                  : force,
          BookLine::force);
    }
    step.equations.push_back(row(function));
    outline_.push_back(std::move(step));
  }

  /// d/dt dL/dv - dL/dq + dD/dv = Q + A^T lambda, written out.
  [[nodiscard]] StepEquation row(std::size_t function) const {
    const std::size_t left = field_of(BookLine::left);
    return {text_[function].entries[left].front(), latex_[function].entries[left].front(), function,
            field_of(BookLine::force)};
  }

  /// The rows of all velocities, and what they are solved for, or the constraints.
  void add_equations(std::size_t first, std::size_t constraints) {
    DerivationStep step{std::string(equations_title), "", "", {}, {}};
    const std::size_t count = model_.velocities.size();
    std::vector<std::string> long_rows;
    for (std::size_t i = 0; i < count; ++i) {
      // Definitions of several derivations may have one name: such a row stands in its own section.
      if (has_book_form(first + i)) {
        step.equations.push_back(row(first + i));
      } else {
        long_rows.push_back(model_.velocities[i].name);
      }
    }
    if (!long_rows.empty()) {
      step.doc = fmt::format(
          "Rows left out, as too long to be read at once: {}. elgen show --what steps has each in "
          "parts.",
          fmt::join(long_rows, ", "));
    }
    for (std::size_t i = 0; i < model_.constraints.size() && has_book_form(constraints); ++i) {
      step.equations.push_back({text_[constraints].entries[i].front(),
                                latex_[constraints].entries[i].front(), constraints,
                                model_.constraints.size()});
    }
    const std::size_t accelerations = first + count + 1;
    for (std::uint32_t i = 0; i < count; ++i) {
      if (text_[accelerations].entries[i].empty()) continue;
      step.equations.push_back(
          {leaf_text(model_, Opcode::acceleration, i), symbols_.leaves().a[i], accelerations, i});
    }
    if (!step.equations.empty() || !step.doc.empty()) outline_.push_back(std::move(step));
  }

  /// Noether's line of a cyclic coordinate.
  [[nodiscard]] StepLine conservation(std::size_t function, const StepLine& slope,
                                      const StepLine& q) const {
    const bool is_free =
        is_zero(function, BookLine::force) && is_zero(function, BookLine::dissipation);
    const char* condition = is_free ? "" : " wherever no force and no dissipation act on it";
    return {fmt::format("L does not contain {0}, so p_{0} = {1} is conserved{2}", q.text,
                        slope.text, condition),
            fmt::format("L \\text{{ does not contain }} {0} \\text{{, so }} p_{{{0}}} = {1} "
                        "\\text{{ is conserved{2}}}",
                        q.latex, slope.latex, condition)};
  }

  [[nodiscard]] bool is_free() const {
    return model_.forces.empty() && model_.inputs.empty() && !model_.energies.D &&
           !is_constrained();
  }
  [[nodiscard]] bool is_constrained() const { return !model_.constraints.empty(); }

  void add_invariants(std::size_t function) {
    const bool is_autonomous = is_zero(function, 1);
    const char* doc = is_free()          ? energy_of_free
                      : is_constrained() ? energy_of_constrained
                                         : energy_of_driven;
    DerivationStep step{"Energy function", "", doc, {}, {}};
    const char* contains = is_autonomous ? "does not contain" : "contains";
    const char* verdict = !is_autonomous     ? "is not conserved"
                          : is_free()        ? "is conserved"
                          : is_constrained() ? conserved_unless_constrained
                                             : conserved_unless_driven;
    step.lines = {
        {fmt::format("L {} t, so E {}", contains, verdict),
         fmt::format("L \\text{{ {} }} t \\text{{, so }} E \\text{{ {}}}", contains, verdict)}};
    step.equations.push_back(
        {"E = sum of v dL/dv - L",
         latex_of(model_, R"(E = \dot{<q>}^{\top} \frac{\partial L}{\partial \dot{<q>}} - L)"),
         function, 0});
    if (!is_autonomous) {
      step.equations.push_back(
          {"dL/dt at fixed q and v", "\\frac{\\partial L}{\\partial t}", function, 1});
    }
    outline_.push_back(std::move(step));
  }

  const Model& model_;
  const ReadableSteps& steps_;
  ModelSymbols symbols_;
  std::vector<std::string> places_ = {};      ///< of masses
  std::vector<FunctionEquations> text_ = {};  ///< of each function
  std::vector<FunctionEquations> latex_ = {};
  std::vector<DerivationStep> outline_;
};

/// "(x, y)" of the first `rows` components, or the one value.
std::string tuple(const std::vector<std::string>& entries, std::uint32_t rows) {
  if (rows == 1) return entries.front();
  const auto end = entries.begin() + rows;
  return fmt::format("({})", fmt::join(entries.begin(), end, ", "));
}

/// The definitions that the lines of a step refer to, each once.
template <class EquationsOf>
std::vector<EquationLine> definitions_of(const DerivationStep& step, const EquationsOf& equations) {
  std::vector<EquationLine> lines;
  for (const StepEquation& equation : step.equations) {
    for (const EquationLine& line : equations(equation.function).definitions) {
      const bool is_known = std::ranges::count(lines, line.name, &EquationLine::name) > 0;
      if (!is_known) lines.push_back(line);
    }
  }
  return lines;
}

}  // namespace

std::string steps_text(const Model& model, const ReadableSteps& steps, std::string_view title) {
  Outline outline(model, steps);
  std::string text;
  for (const DerivationStep& step : outline()) {
    if (!title.empty() && step.title != title) continue;
    text += fmt::format("{}{}\n", text.empty() ? "" : "\n", step.title);
    if (!step.doc.empty()) text += fmt::format("  {}\n", step.doc);
    for (const StepLine& line : step.lines) text += fmt::format("  {}\n", line.text);
    for (const StepEquation& equation : step.equations) {
      const auto& entries = outline.text_equations_of(equation.function).entries[equation.field];
      text += fmt::format("  {} = {}\n", equation.text, tuple(entries, equation.rows));
    }
    const auto equations = [&outline](std::size_t function) -> const FunctionEquations& {
      return outline.text_equations_of(function);
    };
    for (const EquationLine& line : definitions_of(step, equations)) {
      text += fmt::format("  where {} = {}\n", line.name, line.value);
    }
  }
  return text;
}

std::vector<SheetOutput> steps_sections(const Model& model, const ReadableSteps& steps,
                                        std::string_view title) {
  std::vector<SheetOutput> sections;
  Outline outline(model, steps);
  for (const DerivationStep& step : outline()) {
    if (!title.empty() && step.title != title) continue;
    SheetOutput section{
        .title = step.title, .doc = step.doc, .title_latex = step.title_latex, .is_aligned = true};
    for (const StepLine& line : step.lines) section.lines.push_back(line.latex);
    for (const StepEquation& equation : step.equations) {
      std::vector<std::string> entries =
          outline.latex_equations_of(equation.function).entries[equation.field];
      entries.resize(equation.rows);
      section.equations.push_back({equation.latex, equation.rows, 1, std::move(entries)});
    }
    const auto equations = [&outline](std::size_t function) -> const FunctionEquations& {
      return outline.latex_equations_of(function);
    };
    for (const EquationLine& line : definitions_of(step, equations)) {
      section.equations.push_back({line.name, 1, 1, {line.value}});
    }
    sections.push_back(std::move(section));
  }
  return sections;
}

Sheet steps_sheet(const Model& model, const Scene& scene, const ReadableSteps& steps,
                  std::string_view title) {
  Sheet result = sheet(model, scene, {});
  result.equation_of_motion = latex_of(model, lagrange);
  if (!model.constraints.empty()) {
    result.equation_of_motion += latex_of(model, constraint_forces.latex);
  }
  result.outputs = steps_sections(model, steps, title);
  return result;
}

}  // namespace elgen
