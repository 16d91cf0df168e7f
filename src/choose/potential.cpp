// The potential energy in one form, and its minima. Chooses which typed sums stay unexpanded
// ("whole"), and inserts V into the functions whose forms were chosen with V as a leaf.
#include <algorithm>
#include <optional>
#include <utility>

#include "choose/finish.hpp"
#include "choose/text_errors.hpp"
#include "elgen/choose.hpp"
#include "elgen/evaluate.hpp"
#include "numbers/exact_number.hpp"
#include "program/network/instructions.hpp"
#include "sample/minima.hpp"

namespace elgen {
namespace {

/// The search tries to expand at most this many of the whole sums, one after the other.
constexpr std::size_t most_expanded_sums = 16;

/// The largest number of instructions of V and its derivatives. For longer potentials, such as of
/// chains of springs, no closed form is chosen, and the search would take as long as all other
/// functions.
constexpr std::size_t longest_potential = 1'500;

/// The largest number of instructions of V, and of its first derivatives. In 64 digits, 400
/// instructions take about 0.1 ms, and a search for three coordinates evaluates them at most 1300
/// times.
constexpr std::size_t longest_searched = 400;

/// A choice of whole sums that keeps no more digits than the best choice must save a fifth of the
/// cost of the best choice.
constexpr std::size_t max_cost_fifths = 4;

/// For each sum of unexpanded_sums(): true if the sum stays whole.
using UnexpandedSums = std::vector<bool>;

struct UnexpandedChoice {
  UnexpandedSums unexpanded;
  FormChoice choice = {};
  std::size_t cost = 0;
  double loss = 0;
};

/// Searches for the choice of whole sums with the smallest loss; if losses are equal, for the
/// cheapest choice. The loss of a choice is the largest loss of all functions.
class UnexpandedSumSearch {
 public:
  UnexpandedSumSearch(const Program& potential, const Domain& domain, const Scene& scene)
      : potential_(potential),
        domain_(domain),
        scene_(scene),
        sums_(unexpanded_sums(potential)),
        zeros_(find_sum_zeros(potential, domain)) {
    for (const Function& text : potential.functions) {
      errors_.emplace_back(potential, text, comparison_points(potential, text, domain, zeros_),
                           MagnitudeScope::entry);
    }
  }

  /// The forms that choose() chooses for `program` if the sums marked in `whole` stay whole.
  [[nodiscard]] FormChoice choose_forms(const Program& program, const SumZeros& zeros,
                                        const UnexpandedSums& whole) const {
    Program sums{sums_.leaves, sums_.constants, {}};
    for (std::size_t i = 0; i < whole.size(); ++i) {
      if (whole[i]) sums.functions.push_back(sums_.functions[i]);
    }
    return *choose(program, present(program, std::move(sums)), domain_, scene_, &zeros);
  }

  [[nodiscard]] UnexpandedChoice find_best_choice() {
    const std::size_t count = sums_.functions.size();
    UnexpandedChoice best = make_choice(UnexpandedSums(count, false));
    if (count == 0) return best;
    keep_better(best, make_choice(UnexpandedSums(count, true)));
    if (count == 1 || best.loss <= tolerated_loss) return best;
    for (std::size_t i = 0; i < std::min(count, most_expanded_sums); ++i) {
      UnexpandedSums others = best.unexpanded;
      if (!others[i]) continue;
      others[i] = false;
      keep_better(best, make_choice(std::move(others)));
    }
    return best;
  }

 private:
  UnexpandedChoice make_choice(UnexpandedSums whole) {
    UnexpandedChoice made{std::move(whole)};
    made.choice = choose_forms(potential_, zeros_, made.unexpanded);
    for (std::size_t i = 0; i < errors_.size(); ++i) {
      const Function& form = made.choice.program.functions[i];
      made.cost += cost(count_operations(form));
      errors_[i].add_form(made.choice.program, form);
    }
    return made;
  }

  /// The largest loss of all functions. It is recomputed for every comparison, because a new form
  /// may have lowered the least known error.
  [[nodiscard]] double loss_of(const UnexpandedChoice& chosen) const {
    double loss = 0;
    for (std::size_t i = 0; i < errors_.size(); ++i) {
      const Program& program = chosen.choice.program;
      loss = std::max(loss, errors_[i].worst_loss(program, program.functions[i]));
    }
    return loss;
  }

  void keep_better(UnexpandedChoice& best, UnexpandedChoice other) const {
    best.loss = loss_of(best);
    other.loss = loss_of(other);
    const bool keeps_more = loses_more(best.loss, other.loss);
    const bool keeps_as_much = !loses_more(other.loss, best.loss);
    const bool is_cheaper = (max_cost_fifths + 1) * other.cost < max_cost_fifths * best.cost;
    if (keeps_more || (keeps_as_much && is_cheaper)) best = std::move(other);
  }

  const Program& potential_;
  const Domain& domain_;
  const Scene& scene_;
  Program sums_;
  SumZeros zeros_;
  std::vector<FormErrors> errors_ = {};  ///< by function
};

/// True if V or a derivative differs from both its recursive form and its fully expanded closed
/// form.
bool has_distinct_form(const UnexpandedChoice& best, std::size_t function) {
  if (std::ranges::find(best.unexpanded, true) != best.unexpanded.end()) return true;
  if (!best.choice.program.functions[function].rewritten.empty()) return true;
  const FormCosts& costs = best.choice.costs[function];
  const bool is_text = costs.chosen_form == Form::recursive && costs.closed;
  return is_text && cost(*costs.closed) < cost(costs.recursive);
}

bool is_open_value_from(std::uint32_t first, const Instruction& i) {
  return i.opcode == Opcode::open_value && i.a >= first;
}

/// Inserts the entries of V and its derivatives into a function, in place of open values
/// (Opcode::open_value).
class PotentialInserter {
 public:
  PotentialInserter(const Program& potential, std::uint32_t first, Program& to)
      : potential_(potential), first_open_value_(first), target_(to) {
    for (std::uint32_t i = 0; i < potential.functions.size(); ++i) {
      for (const std::uint32_t entry : entries_of(potential.functions[i])) {
        entries_.emplace_back(i, entry);
      }
    }
  }

  /// Returns `from` with its open values replaced. `program` has the constants of `from`.
  [[nodiscard]] Function operator()(const Program& program, const Function& from) {
    Function result = from;
    result.instructions.clear();
    result.names.clear();
    InstructionBuilder instructions(result);
    std::vector<std::uint32_t> places;
    for (std::size_t at = 0; at < from.instructions.size(); ++at) {
      const Instruction& i = from.instructions[at];
      if (is_open_value_from(first_open_value_, i)) {
        const auto [function, entry] = entries_[i.a - first_open_value_];
        const Function value = with_entries(potential_.functions[function], {entry});
        places.push_back(
            append_function(potential_, value, instructions)[value.fields[0].entries[0]]);
        continue;
      }
      const Instruction next = renumber_operands(import_constant(program, i), places);
      places.push_back(at < first_repeated_instruction(from)
                           ? instructions.add(without_negation(result, next))
                           : instructions.append(next));
      merge_name(result.names[places.back()], from.names[at]);
    }
    for (Field& field : result.fields) {
      for (std::uint32_t& entry : field.entries) entry = places[entry];
    }
    return with_trigonometry_first(eliminate_dead_code(result));
  }

 private:
  /// x - y for x + (-y) and (-y) + x, x + y for x - (-y); any other instruction is unchanged.
  static Instruction without_negation(const Function& function, Instruction i) {
    if (!is_sum(i)) return i;
    const Instruction& second = function.instructions[i.b];
    const Instruction& first = function.instructions[i.a];
    const bool is_add = i.opcode == Opcode::add;
    if (second.opcode == Opcode::negate) {
      i.opcode = is_add ? Opcode::subtract : Opcode::add;
      i.b = second.a;
    } else if (is_add && first.opcode == Opcode::negate) {
      i = {.opcode = Opcode::subtract, .a = i.b, .b = first.a};
    }
    return i;
  }

  [[nodiscard]] Instruction import_constant(const Program& program, Instruction i) {
    if (i.opcode == Opcode::constant)
      i.a = intern_constant(program.constants[i.a], target_.constants);
    return i;
  }

  std::vector<std::uint32_t> append_function(const Program& program, Function function,
                                             InstructionBuilder& instructions) {
    for (Instruction& i : function.instructions) i = import_constant(program, i);
    return instructions.add_all(function);
  }

  const Program& potential_;
  std::uint32_t first_open_value_;
  Program& target_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> entries_ = {};  ///< (function, instruction)
};

/// The indices of the entries that depend on open values from `first` on.
std::vector<std::uint32_t> dependent_entries(const Function& function, std::uint32_t first) {
  std::vector<bool> holds;
  for (const Instruction& i : function.instructions) {
    bool found = is_open_value_from(first, i);
    for (std::size_t k = 0; k < operand_count(i); ++k) found = found || holds[k == 0 ? i.a : i.b];
    holds.push_back(found);
  }
  std::vector<std::uint32_t> entries;
  const std::vector<std::uint32_t> all = entries_of(function);
  for (std::uint32_t i = 0; i < all.size(); ++i) {
    if (holds[all[i]]) entries.push_back(i);
  }
  return entries;
}

}  // namespace

std::vector<std::vector<double>> find_potential_minima(const Program& potential,
                                                       const Domain& domain, const Scene& scene) {
  const Model& model = domain.model;
  const Function& energy = potential.functions[0];
  const Function& derivatives = potential.functions[1];
  std::vector<std::uint32_t> variables = coordinates_of(energy);
  std::ranges::sort(variables);
  const std::size_t length = std::max(energy.instructions.size(), derivatives.instructions.size());
  // After the derivatives by coordinates, there may be one by t.
  const bool is_searched = scene.numerics.prefer != Preference::speed &&
                           model.open_values.empty() && length <= longest_searched &&
                           !variables.empty() && entry_count(derivatives) >= variables.size();
  if (!is_searched) return {};
  std::vector<std::uint32_t> searched;
  for (std::uint32_t i = 0; i < model.coordinates.size(); ++i) {
    const bool matters = !model.constraints.empty() || std::ranges::binary_search(variables, i);
    if (matters && !model.coordinates[i].rotation) searched.push_back(i);
  }
  Arguments<Real> state =
      map_leaves([](double x) { return Real(exact_value(x)); }, domain.states.front());
  const auto values_at = [&](const std::vector<Real>& q) -> std::optional<PotentialValues> {
    state.q = q;
    PotentialValues values{evaluate(potential, energy, state).front()};
    const std::vector<Real> all = evaluate(potential, derivatives, state);
    std::vector<Real> slopes(q.size());
    for (std::size_t k = 0; k < variables.size(); ++k) slopes[variables[k]] = all[k];
    for (const std::uint32_t i : searched) values.slopes.push_back(slopes[i]);
    return values;
  };
  return find_minima(values_at, searched, domain);
}

std::optional<RewrittenPotential> rewrite_potential(const Program& potential, const Domain& domain,
                                                    const Scene& scene) {
  std::size_t length = 0;
  for (const Function& function : potential.functions) length += function.instructions.size();
  if (scene.numerics.prefer == Preference::speed || length > longest_potential) return std::nullopt;
  Scene unnamed = scene;
  unnamed.outputs.clear();
  // V and dV/dx contain the same sums as the second derivatives, so the search omits the latter.
  Program without_second = potential;
  without_second.functions.resize(2);
  UnexpandedSumSearch search(without_second, domain, unnamed);
  UnexpandedChoice best = search.find_best_choice();
  const bool has_slopes = has_distinct_form(best, 1);
  if (!has_distinct_form(best, 0) && !has_slopes) return std::nullopt;
  const bool has_second = potential.functions.size() > 2;
  if (!has_second) return RewrittenPotential{std::move(best.choice.program), has_slopes};
  const SumZeros zeros = find_sum_zeros(potential, domain);
  return RewrittenPotential{search.choose_forms(potential, zeros, best.unexpanded).program,
                            has_slopes};
}

Domain with_open_potential(Domain domain, const Program& potential) {
  for (LeafValues<double>& state : domain.states) {
    std::vector<double> values;
    for (const Function& function : potential.functions) {
      for (const double value : evaluate(potential, function, state)) values.push_back(value);
    }
    state.f.insert(state.f.end(), values.begin(), values.end());
  }
  domain.ranges.f.resize(domain.states.front().f.size(), Range{});
  domain.minima.clear();
  return domain;
}

void insert_potential(const RewrittenPotential& potential, const FormChoice& open,
                      const Domain& domain, FormChoice& choice) {
  FormChoice result = choice;
  const auto first = static_cast<std::uint32_t>(choice.program.leaves.f.size());
  PotentialInserter insert(potential.program, first, result.program);
  for (const Function& function : open.program.functions) {
    const std::vector<std::uint32_t> entries = dependent_entries(function, first);
    const bool stays =
        !potential.has_derivatives && !dependent_entries(function, first + 1).empty();
    if (entries.empty() || stays) continue;
    Function own = insert(open.program, function);
    const auto named = std::ranges::find(choice.program.functions, function.name, &Function::name);
    const auto i = static_cast<std::size_t>(named - choice.program.functions.begin());
    const Function& old = *named;
    FormErrors errors(choice.program, old, comparison_points(choice.program, old, domain));
    if (errors.first_inaccurate_entry(result.program, own)) return;
    errors.add_form(result.program, own);
    own.rewritten = entries;
    FormCosts& costs = result.costs[i];
    const bool is_closed = own.form == Form::closed;
    costs.chosen_form = own.form;
    (is_closed ? costs.closed.emplace() : costs.recursive) = count_operations(own);
    (is_closed ? costs.closed_loss : costs.recursive_loss) = errors.worst_loss(result.program, own);
    result.program.functions[i] = std::move(own);
  }
  choice = std::move(result);
}

}  // namespace elgen
