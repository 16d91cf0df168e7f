// closed_pivots: all forms first, then the function, instruction by instruction.
#include "choose/closed_pivots.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "base/random.hpp"
#include "choose/ways.hpp"
#include "elgen/evaluate.hpp"
#include "lower/graph/prune.hpp"
#include "lower/network/cheapest.hpp"
#include "lower/network/instructions.hpp"
#include "lower/network/linearise.hpp"

namespace elgen {
namespace {

/// D_i by the place of its form, and the instruction that computes it.
using PlaceOfForm = std::map<std::uint32_t, std::size_t>;

constexpr std::size_t random_points = 3;

/// The pivots at a point.
std::vector<Real> pivots_at(const Program& program, const Function& forward_dynamics,
                            const std::vector<ClosedPivot>& pivots, const Arguments<Real>& point) {
  const std::vector<Real> values = evaluate_instructions(program, forward_dynamics, point);
  const std::vector<Field>& fields = forward_dynamics.fields;
  std::vector<Real> result;
  for (const ClosedPivot& pivot : pivots) {
    const Real& relative = values[fields[1].entries[pivot.velocity]];
    result.push_back(relative * values[fields.back().entries[pivot.velocity]]);
  }
  return result;
}

bool is_same(const Real& x, const Real& y) {
  static const Real negligible(power_of_ten(-50));
  return x.is_defined() && y.is_defined() && abs(x - y).value() <= (abs(y) * negligible).value();
}

/// The first instruction that has the values of each pivot.
PlaceOfForm places_of(const Program& program, const Function& function,
                      const Function& forward_dynamics, const std::vector<ClosedPivot>& pivots) {
  Random random(1);
  std::vector<std::vector<Real>> values;
  std::vector<std::vector<Real>> wanted;
  for (std::size_t i = 0; i < random_points; ++i) {
    const auto point = draw_leaves(program.leaves, [&] { return Real(abs(random.rational())); });
    values.push_back(evaluate_instructions(program, function, point));
    wanted.push_back(pivots_at(program, forward_dynamics, pivots, point));
  }
  PlaceOfForm places;
  for (std::size_t pivot = 0; pivot < pivots.size(); ++pivot) {
    for (std::uint32_t at = 0; at < function.instructions.size(); ++at) {
      bool is_here = true;
      for (std::size_t i = 0; i < random_points; ++i)
        is_here = is_here && is_same(values[i][at], wanted[i][pivot]);
      if (!is_here) continue;
      places.emplace(at, pivot);
      break;
    }
  }
  return places;
}

/// D_i of all forms.
Function forms_of(const std::vector<ClosedPivot>& pivots, Program& program) {
  Expressions all;
  Function function;
  Field& field = function.fields.emplace_back(Field{"", 1, 1, {}});
  for (const ClosedPivot& pivot : pivots) {
    const Ref relative = copied(all.graph, pivot.relative);
    const Ref diagonal = copied(all.graph, pivot.diagonal);
    field.entries.push_back(static_cast<std::uint32_t>(all.values.size()));
    all.values.push_back(all.graph.product({{relative, 1}, {diagonal, 1}}));
  }
  field.columns = static_cast<std::uint32_t>(field.entries.size());
  linearise(cheapest_network(all, function, Splits::sums), program, function);
  return function;
}

/// Appends instructions with new numbers.
class Appender {
 public:
  explicit Appender(Function& to) : to_(to), instructions_(to) {}

  /// Where each instruction of a function has gone; `known` says where some are already.
  std::vector<std::uint32_t> append(const Function& from,
                                    const std::map<std::uint32_t, std::uint32_t>& known) {
    std::vector<std::uint32_t> places;
    for (std::uint32_t at = 0; at < from.instructions.size(); ++at) {
      const auto replaced = known.find(at);
      if (replaced != known.end()) {
        places.push_back(replaced->second);
        continue;
      }
      Instruction i = from.instructions[at];
      if (operand_count(i) > 0) i.a = places[i.a];
      if (operand_count(i) > 1) i.b = places[i.b];
      places.push_back(instructions_.add(i));
      if (to_.names[places.back()].empty()) to_.names[places.back()] = from.names[at];
    }
    return places;
  }

 private:
  Function& to_;
  Instructions instructions_;
};

}  // namespace

std::vector<ClosedPivot> closed_pivots(const Program& program, const Function& forward_dynamics,
                                       const ClosedForms& forms, const ClosedFunction& closed,
                                       const ComparisonPoints& points) {
  std::vector<ClosedPivot> pivots;
  if (closed.fields.size() < 3) return pivots;
  const std::vector<std::optional<Fraction>>& relative = closed.fields[1].entries;
  const std::vector<std::optional<Fraction>>& diagonal = closed.fields.back().entries;
  Function relative_pivots = forward_dynamics;
  relative_pivots.fields = {forward_dynamics.fields[1]};
  const std::vector<double> losses = possible_losses(program, pruned(relative_pivots), points);
  for (std::size_t i = 0; i < relative.size(); ++i) {
    if (losses[i] <= tolerated_loss || !relative[i] || !diagonal[i]) continue;
    auto way = more_precise(forms.algebra, *relative[i], nullptr, {.loss = losses[i]}, points);
    const auto of_diagonal = collected_ways(forms.algebra, *diagonal[i]);
    if (!way || of_diagonal.empty()) continue;
    const auto shortest = std::ranges::min_element(of_diagonal, {}, &Collected::length);
    pivots.push_back({i, std::move(*way), shortest->expressions});
  }
  return pivots;
}

Function with_closed_pivots(const Function& function, const Function& forward_dynamics,
                            const std::vector<ClosedPivot>& pivots, Program& program) {
  const PlaceOfForm places = places_of(program, function, forward_dynamics, pivots);
  if (places.empty()) return function;
  const Function forms = forms_of(pivots, program);
  Function result = function;
  result.instructions.clear();
  result.names.clear();
  Appender appender(result);
  const std::vector<std::uint32_t> forms_at = appender.append(forms, {});
  std::map<std::uint32_t, std::uint32_t> known;
  for (const auto& [at, pivot] : places) known[at] = forms_at[forms.fields[0].entries[pivot]];
  const std::vector<std::uint32_t> moved = appender.append(function, known);
  for (Field& field : result.fields) {
    for (std::uint32_t& entry : field.entries) entry = moved[entry];
  }
  return pruned(result);
}

}  // namespace elgen
