// A pivot is a coefficient that is not 0 at the values of the parameters.
#include "analyse/linear_solution.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "analyse/exact_generators.hpp"
#include "analyse/formulas.hpp"

namespace elgen {
namespace {

/// Closed forms at values of the parameters: a pivot is a coefficient that is not 0 there.
class FormsAt : public FormField {
 public:
  FormsAt(Algebra& algebra, const Arguments<Real>& at)
      : FormField(algebra, PresentBudget{}.products, PresentBudget{}.terms),
        algebra_(algebra),
        at_(at) {}

  [[nodiscard]] Real number(const Fraction& fraction) const {
    return value_of(algebra_, fraction, at_);
  }
  [[nodiscard]] bool vanishes(const Fraction& fraction) const {
    return is_near(number(fraction), Real());
  }

  /// The first one. Coefficients that are 0 at these values alone leave the column open: 64 digits
  /// do not prove that they are 0.
  [[nodiscard]] const PivotCandidate<Value>* best(const Candidates& candidates, std::size_t) {
    for (const PivotCandidate<Value>& candidate : candidates) {
      if (!vanishes(**candidate.entry)) return &candidate;
    }
    is_open_ = true;
    return nullptr;
  }
  [[nodiscard]] bool is_open() const { return is_open_; }

 private:
  const Algebra& algebra_;
  const Arguments<Real>& at_;
  bool is_open_ = false;
};

/// Columns are the unknowns from the last to the first, so that the first ones are any where some
/// are; then what is left of the equation.
using RestEchelon = Echelon<FormsAt>;

/// The unknown whose pivot left this row.
std::optional<CoordinateAtRest> solved_for(FormsAt& field, const RestEchelon::Row& row,
                                           const std::vector<std::uint32_t>& unknowns) {
  const std::size_t n = unknowns.size();
  Value value = Fraction{};
  for (auto entry = row.rbegin(); entry != row.rend(); ++entry) {
    Value term = entry->value;
    if (entry->column < n) {
      const Value other = field.leaf(Opcode::coordinate, unknowns[n - 1 - entry->column]);
      term = field.multiply(term, other);
    }
    value = field.add(value, field.negate(term));
  }
  if (!value) return std::nullopt;
  const Real number = field.number(*value);
  if (!number.is_defined()) return std::nullopt;
  return CoordinateAtRest{false, number.value(), value};
}

std::optional<LinearSolution> solution_of(FormsAt& field, std::vector<RestEchelon::Row> rows,
                                          const std::vector<std::uint32_t>& unknowns,
                                          const Arguments<Real>& at) {
  const std::size_t n = unknowns.size();
  const RestEchelon echelon(field, std::move(rows), n);
  if (!echelon.is_defined() || field.is_open()) return std::nullopt;
  LinearSolution solution;
  for (const Value& rest : echelon.contradictions()) {
    if (field.vanishes(*rest)) return std::nullopt;
    solution.is_solvable = false;
  }
  for (const std::uint32_t unknown : unknowns) {
    solution.values.push_back({true, at.q[unknown].value()});
  }
  for (auto pivot = echelon.pivots().rbegin(); pivot != echelon.pivots().rend(); ++pivot) {
    const std::optional<CoordinateAtRest> value = solved_for(field, echelon.rest(*pivot), unknowns);
    if (!value) return std::nullopt;
    solution.values[n - 1 - pivot->column] = *value;
  }
  return solution;
}

/// A row times the powers of the unknowns that stand below in it; these go into `poles`.
Value without_poles(Algebra& algebra, const Fraction& row, const Unknowns& unknowns,
                    std::set<std::uint32_t>& poles) {
  Monomial powers;
  for (const AtomPower& power : divisor_powers(row)) {
    const Atom& atom = algebra.atoms[power.atom];
    const bool is_unknown =
        atom.kind == AtomKind::leaf && atom.leaf == Opcode::coordinate &&
        std::ranges::find(unknowns.coordinates, atom.index) != unknowns.coordinates.end();
    if (!is_unknown) continue;
    poles.insert(atom.index);
    powers.push_back(power);
  }
  if (powers.empty()) return row;
  return Arithmetic(algebra).multiply(row, fraction_of(Polynomial{{powers, Gaussian{1, 0}}}));
}

/// Whether an unknown that no value may make 0 is 0.
bool is_at_pole(const LinearSolution& solution, const Unknowns& unknowns,
                const std::set<std::uint32_t>& poles) {
  for (std::size_t i = 0; i < solution.values.size(); ++i) {
    const CoordinateAtRest& value = solution.values[i];
    const bool is_zero = !value.is_any && is_near(Real(value.value), Real());
    if (is_zero && poles.contains(unknowns.coordinates[i])) return true;
  }
  return false;
}

}  // namespace

std::optional<LinearSolution> linear_solution(ClosedForms& forms, const std::vector<Fraction>& rows,
                                              const Unknowns& unknowns, const Arguments<Real>& at) {
  FormsAt field(forms.algebra, at);
  const std::size_t n = unknowns.coordinates.size();
  std::vector<RestEchelon::Row> equations;
  Replacements origin;
  for (const std::uint32_t coordinate : unknowns.coordinates) {
    origin[{Opcode::coordinate, coordinate}] = {};
  }
  std::set<std::uint32_t> poles;
  for (const Fraction& given : rows) {
    const Value row = without_poles(forms.algebra, given, unknowns, poles);
    if (!row) return std::nullopt;
    RestEchelon::Row equation;
    for (const std::uint32_t coordinate : unknowns.coordinates) {
      const auto slope = partial_derivative(forms, *row, coordinate, at.q.size());
      if (!slope || holds_coordinate(forms.algebra, *slope)) return std::nullopt;
      equation.push_back({n - 1 - equation.size(), *slope});
    }
    const Value rest = substituted(forms.algebra, row, origin);
    if (!rest) return std::nullopt;
    std::ranges::reverse(equation);
    equation.push_back({n, *rest});
    equations.push_back(std::move(equation));
  }
  std::optional<LinearSolution> solution =
      solution_of(field, std::move(equations), unknowns.coordinates, at);
  if (solution && is_at_pole(*solution, unknowns, poles)) solution->is_solvable = false;
  return solution;
}

}  // namespace elgen
