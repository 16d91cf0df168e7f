// A pivot is a coefficient that is not 0 at the values of the parameters.
#include "analyse/linear_solution.hpp"

#include <algorithm>
#include <set>

#include "analyse/formulas.hpp"

namespace elgen {
namespace {

/// The closed forms of a linear system, solved by elimination from the last unknown to the first,
/// so that the first ones are any where some are.
class LinearSystem {
 public:
  LinearSystem(Algebra& algebra, std::vector<std::uint32_t> unknowns, const Arguments<Real>& at)
      : algebra_(algebra), unknowns_(std::move(unknowns)), at_(at), arithmetic_(algebra) {}

  void add(std::vector<Fraction> coefficients, const Fraction& rest) {
    coefficients.push_back(rest);
    rows_.push_back(std::move(coefficients));
  }

  std::optional<LinearSolution> operator()() {
    const std::size_t n = unknowns_.size();
    std::vector<std::optional<std::size_t>> pivots(n);
    std::vector<bool> is_used(rows_.size(), false);
    for (std::size_t column = n; column-- > 0;) {
      const auto row = pivot_row(column, is_used);
      if (!row && holds_open(column, is_used)) return std::nullopt;
      if (!row) continue;
      is_used[*row] = true;
      pivots[column] = row;
      if (!eliminate(column, *row)) return std::nullopt;
    }
    LinearSolution solution;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const bool is_constant = !is_used[i] && !rows_[i][n].numerator.empty();
      if (is_constant && vanishes(rows_[i][n])) return std::nullopt;
      if (is_constant) solution.is_solvable = false;
    }
    for (std::size_t k = 0; k < n; ++k) {
      const std::optional<CoordinateAtRest> value = value_at(k, pivots[k]);
      if (!value) return std::nullopt;
      solution.values.push_back(*value);
    }
    return solution;
  }

 private:
  [[nodiscard]] bool vanishes(const Fraction& form) const {
    return is_near(value_of(algebra_, form, at_), Real());
  }

  [[nodiscard]] std::optional<std::size_t> pivot_row(std::size_t column,
                                                     const std::vector<bool>& is_used) const {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (is_used[i] || rows_[i][column].numerator.empty()) continue;
      if (!vanishes(rows_[i][column])) return i;
    }
    return std::nullopt;
  }

  /// Whether a coefficient that is 0 at these parameters alone stands in the column: 64 digits do
  /// not prove that it is 0.
  [[nodiscard]] bool holds_open(std::size_t column, const std::vector<bool>& is_used) const {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (!is_used[i] && !rows_[i][column].numerator.empty()) return true;
    }
    return false;
  }

  /// Takes the column out of all other rows, and scales the pivot to 1.
  bool eliminate(std::size_t column, std::size_t pivot) {
    const Fraction divisor = rows_[pivot][column];
    for (Fraction& entry : rows_[pivot]) {
      const Value scaled = arithmetic_.divide(entry, divisor);
      if (!scaled) return false;
      entry = *scaled;
    }
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const Fraction factor = rows_[i][column];
      if (i == pivot || factor.numerator.empty()) continue;
      for (std::size_t k = 0; k < rows_[i].size(); ++k) {
        const Value reduced =
            arithmetic_.subtract(rows_[i][k], arithmetic_.multiply(factor, rows_[pivot][k]));
        if (!reduced) return false;
        rows_[i][k] = *reduced;
      }
    }
    return true;
  }

  std::optional<CoordinateAtRest> value_at(std::size_t column, std::optional<std::size_t> row) {
    if (!row) return CoordinateAtRest{true, at_.q[unknowns_[column]].value()};
    Value value = arithmetic_.negate(rows_[*row].back());
    for (std::size_t k = 0; k < unknowns_.size(); ++k) {
      if (k == column || rows_[*row][k].numerator.empty()) continue;
      const Value other = arithmetic_.leaf(Opcode::coordinate, unknowns_[k]);
      value = arithmetic_.subtract(value, arithmetic_.multiply(rows_[*row][k], other));
    }
    if (!value) return std::nullopt;
    const Real number = value_of(algebra_, *value, at_);
    if (!number.is_defined()) return std::nullopt;
    return CoordinateAtRest{false, number.value(), value};
  }

  Algebra& algebra_;
  std::vector<std::uint32_t> unknowns_;
  const Arguments<Real>& at_;
  Arithmetic arithmetic_;
  std::vector<std::vector<Fraction>> rows_;  ///< coefficients, then what is left of the equation
};

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
  LinearSystem system(forms.algebra, unknowns.coordinates, at);
  Replacements origin;
  for (const std::uint32_t coordinate : unknowns.coordinates) {
    origin[{Opcode::coordinate, coordinate}] = {};
  }
  std::set<std::uint32_t> poles;
  for (const Fraction& given : rows) {
    const Value row = without_poles(forms.algebra, given, unknowns, poles);
    if (!row) return std::nullopt;
    std::vector<Fraction> coefficients;
    for (const std::uint32_t coordinate : unknowns.coordinates) {
      const auto slope = partial_derivative(forms, *row, coordinate, at.q.size());
      if (!slope || holds_coordinate(forms.algebra, *slope)) return std::nullopt;
      coefficients.push_back(*slope);
    }
    const Value rest = substituted(forms.algebra, *row, origin);
    if (!rest) return std::nullopt;
    system.add(std::move(coefficients), *rest);
  }
  std::optional<LinearSolution> solution = system();
  if (solution && is_at_pole(*solution, unknowns, poles)) solution->is_solvable = false;
  return solution;
}

}  // namespace elgen
