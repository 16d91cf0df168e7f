// The equation of one angle is a polynomial in z = e^(iq). Its factors z - 1, z + 1, z - i, z + i
// are divided out. A quotient c0 (z^2 + 1) + c1 z gives cos(q), and c0 (1 - z^2) + c1 z gives
// sin(q). A pivot of linear equations is a coefficient that is not 0 at the values of the
// parameters.
#include "analyse/exact_roots.hpp"

#include <cln/integer.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "analyse/exact_generators.hpp"
#include "analyse/formulas.hpp"
#include "analyse/searched_range.hpp"
#include "forms/present/polynomial.hpp"
#include "numbers/exact_number.hpp"

namespace elgen {
namespace {

using cln::cl_RA;

/// True if two angles are equal up to whole turns.
bool is_same_angle(const Real& x, const Real& y) {
  return is_near(cos(x), cos(y)) && is_near(sin(x), sin(y));
}

/// A search for the leaf `coordinate`; without `coordinate`, for the leaves of all coordinates.
LeafSearch coordinate_search(const Algebra& algebra, std::optional<std::uint32_t> coordinate) {
  return {algebra, [coordinate](const Atom& leaf) {
            return leaf.leaf == Opcode::coordinate && (!coordinate || leaf.index == *coordinate);
          }};
}

/// k, if a power of an atom is e^(i k q) with integer k; none for other atoms.
std::optional<std::int32_t> sinusoid_power(const Algebra& algebra, const AtomPower& power,
                                           std::uint32_t coordinate) {
  const Atom& atom = algebra.atoms[power.atom];
  if (atom.kind != AtomKind::circular) return std::nullopt;
  const Atom* const leaf = find_argument_leaf(algebra, atom);
  const bool is_it =
      leaf != nullptr && leaf->leaf == Opcode::coordinate && leaf->index == coordinate;
  const cl_RA multiple = cl_RA(power.exponent) / atom.divisor;
  if (!is_it || cln::denominator(multiple) != 1) return std::nullopt;
  return static_cast<std::int32_t>(cln::cl_I_to_long(cln::numerator(multiple)));
}

/// Coefficients of z^0, z^1, …. None if the coordinate also occurs outside of e^(i k q).
using Coefficients = std::vector<Polynomial>;

std::optional<Coefficients> sinusoid_coefficients(const Algebra& algebra, const Polynomial& sum,
                                                  std::uint32_t coordinate) {
  std::map<std::int32_t, Polynomial> by_power;
  LeafSearch search = coordinate_search(algebra, coordinate);
  for (const auto& [monomial, coefficient] : sum) {
    Monomial rest;
    std::int32_t total = 0;
    for (const AtomPower& power : monomial) {
      if (const auto sinusoid = sinusoid_power(algebra, power, coordinate)) {
        total += *sinusoid;
      } else if (search.contains(power.atom)) {
        return std::nullopt;
      } else {
        rest.push_back(power);
      }
    }
    add_term(by_power[total], rest, coefficient);
  }
  std::erase_if(by_power, [](const auto& term) { return term.second.empty(); });
  if (by_power.empty()) return std::nullopt;
  Coefficients result;
  const std::int32_t first = by_power.begin()->first;
  for (const auto& [power, polynomial] : by_power) {
    result.resize(static_cast<std::size_t>(power - first) + 1);
    result.back() = polynomial;
  }
  return result;
}

/// Divides out the factor z - root as often as possible.
void divide_out_root(Coefficients& coefficients, const GaussianRational& root) {
  while (coefficients.size() > 1) {
    Coefficients quotient(coefficients.size() - 1);
    Polynomial carried;
    for (std::size_t k = coefficients.size(); k-- > 0;) {
      carried = sum(coefficients[k], multiply_by_term(carried, root));
      if (k > 0) quotient[k - 1] = carried;
    }
    if (!carried.empty()) return;
    coefficients = std::move(quotient);
  }
}

/// cos(q) = `value` if `is_cosine`, else sin(q) = `value`.
struct KnownSinusoid {
  Fraction value = {};
  bool is_cosine = true;
};

std::optional<KnownSinusoid> solve_for_sinusoid(Arithmetic& arithmetic, Coefficients coefficients) {
  for (const auto& root : std::array<GaussianRational, 4>{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}}) {
    divide_out_root(coefficients, root);
  }
  if (coefficients.size() != 3) return std::nullopt;
  const bool is_cosine = sum(coefficients[0], multiply_by_term(coefficients[2], {-1, 0})).empty();
  const bool is_sine = sum(coefficients[0], coefficients[2]).empty();
  if (!is_cosine && !is_sine) return std::nullopt;
  // c1 + 2 c2 cos(q) = 0 or c1 + 2 i c2 sin(q) = 0
  const GaussianRational factor =
      is_cosine ? GaussianRational{cl_RA(-1) / 2, 0} : GaussianRational{0, cl_RA(1) / 2};
  const OptionalFraction value = arithmetic.divide(
      fraction_of(multiply_by_term(coefficients[1], factor)), fraction_of(coefficients[2]));
  return value ? std::optional(KnownSinusoid{*value, is_cosine}) : std::nullopt;
}

/// The closed form of a root of an equation in one unknown, from the root's value in 64 digits.
class SingleUnknownRoot {
 public:
  SingleUnknownRoot(ClosedForms& forms, const Arguments<Real>& root, std::uint32_t coordinate)
      : forms_(forms),
        algebra_(forms.algebra),
        root_(root),
        coordinate_(coordinate),
        arithmetic_(forms.algebra) {}

  std::optional<RestCoordinate> find(const Fraction& row) {
    if (const auto sinusoids = sinusoid_coefficients(algebra_, row.numerator, coordinate_)) {
      const auto sinusoid = solve_for_sinusoid(arithmetic_, *sinusoids);
      return sinusoid ? matching_angle(*sinusoid) : std::nullopt;
    }
    return linear_root(row.numerator);
  }

 private:
  [[nodiscard]] const Real& root_value() const { return root_.q[coordinate_]; }

  /// The root as an angle: one of the two angles with this cosine or sine.
  std::optional<RestCoordinate> matching_angle(const KnownSinusoid& sinusoid) {
    const FunctionId inverse = sinusoid.is_cosine ? FunctionId::acos : FunctionId::asin;
    const OptionalFraction square = arithmetic_.multiply(sinusoid.value, sinusoid.value);
    const OptionalFraction other =
        arithmetic_.square_root(arithmetic_.subtract(fraction_of(cl_RA(1)), square));
    const OptionalFraction first = arithmetic_.call(inverse, sinusoid.value, {});
    const auto second = sinusoid.is_cosine ? arithmetic_.negate(first)
                                           : arithmetic_.subtract(arithmetic_.pi(), first);
    for (const auto& [angle, signed_other] :
         {std::pair{first, other}, std::pair{second, arithmetic_.negate(other)}}) {
      if (!angle || !is_same_angle(evaluate_form(algebra_, *angle, root_), root_value())) continue;
      if (!signed_other) return std::nullopt;
      const CosineAndSine sinusoids = sinusoid.is_cosine
                                          ? CosineAndSine{sinusoid.value, *signed_other}
                                          : CosineAndSine{*signed_other, sinusoid.value};
      return RestCoordinate{false, root_value().value(), angle, sinusoid.value, sinusoids};
    }
    return std::nullopt;
  }

  std::optional<RestCoordinate> linear_root(const Polynomial& row) {
    const auto solution =
        linear_solution(forms_, {fraction_of(row)}, {{coordinate_}, {SearchKind::none}}, root_);
    if (!solution || !solution->is_solvable) return std::nullopt;
    const RestCoordinate& value = solution->values[0];
    if (value.is_arbitrary || !is_near(Real(value.value), root_value())) return std::nullopt;
    return RestCoordinate{false, root_value().value(), value.closed_form};
  }

  ClosedForms& forms_;
  Algebra& algebra_;
  const Arguments<Real>& root_;
  std::uint32_t coordinate_;
  Arithmetic arithmetic_;
};

/// The root if it is 0 or, for an angle, a multiple of a quarter turn; else none.
std::optional<RestCoordinate> quarter_turn_value(Algebra& algebra, SearchKind kind,
                                                 const Real& root) {
  Arithmetic arithmetic(algebra);
  if (is_near(root, Real())) return RestCoordinate{false, 0, Fraction{}};
  if (kind != SearchKind::turn) return std::nullopt;
  for (const cl_RA& count : {cl_RA(1), cl_RA(1) / 2, cl_RA(-1) / 2}) {
    const Real angle = whole_turn() * Real(count / 2);
    if (!is_same_angle(angle, root)) continue;
    const OptionalFraction form = arithmetic.multiply(arithmetic.pi(), fraction_of(count));
    return RestCoordinate{false, angle.value(), form};
  }
  return std::nullopt;
}

bool is_solved(Algebra& algebra, const std::vector<Fraction>& rows,
               const Replacements& replacements) {
  return std::ranges::all_of(rows, [&](const Fraction& row) {
    const OptionalFraction value = substitute(algebra, row, replacements);
    return value && value->numerator.empty();
  });
}

// Linear equations.

/// Closed forms, with pivots that are not 0 at the values of the parameters.
class NumericPivotField : public FormField {
 public:
  NumericPivotField(Algebra& algebra, const Arguments<Real>& at)
      : FormField(algebra, ClosedFormBudget{}.products, ClosedFormBudget{}.terms),
        algebra_(algebra),
        at_(at) {}

  [[nodiscard]] Real evaluate(const Fraction& fraction) const {
    return evaluate_form(algebra_, fraction, at_);
  }
  [[nodiscard]] bool vanishes_numerically(const Fraction& fraction) const {
    return is_near(evaluate(fraction), Real());
  }

  /// The first candidate that is not 0 in 64 digits. If all candidates are 0 in 64 digits, the
  /// elimination is undecided, because this does not prove that they are 0.
  [[nodiscard]] const PivotCandidate<OptionalFraction>* best_pivot(const Candidates& candidates,
                                                                   std::size_t) {
    for (const PivotCandidate<OptionalFraction>& candidate : candidates) {
      if (!vanishes_numerically(**candidate.entry)) return &candidate;
    }
    is_undecided_ = true;
    return nullptr;
  }
  [[nodiscard]] bool is_undecided() const { return is_undecided_; }

 private:
  const Algebra& algebra_;
  const Arguments<Real>& at_;
  bool is_undecided_ = false;
};

/// Columns: the unknowns from last to first, so that the first unknowns remain arbitrary; then the
/// constant term.
using RestEchelon = Echelon<NumericPivotField>;

/// The value of the unknown of a pivot. `row` is the row of the pivot without the pivot itself.
std::optional<RestCoordinate> solve_pivot_row(NumericPivotField& field, const RestEchelon::Row& row,
                                              const std::vector<std::uint32_t>& unknowns) {
  const std::size_t n = unknowns.size();
  OptionalFraction value = Fraction{};
  for (auto entry = row.rbegin(); entry != row.rend(); ++entry) {
    OptionalFraction term = entry->value;
    if (entry->column < n) {
      const OptionalFraction other =
          field.leaf(Opcode::coordinate, unknowns[n - 1 - entry->column]);
      term = field.multiply(term, other);
    }
    value = field.subtract(value, term);
  }
  if (!value) return std::nullopt;
  const Real number = field.evaluate(*value);
  if (!number.is_defined()) return std::nullopt;
  return RestCoordinate{false, number.value(), value};
}

std::optional<LinearSolution> solve_rows(NumericPivotField& field,
                                         std::vector<RestEchelon::Row> rows,
                                         const std::vector<std::uint32_t>& unknowns,
                                         const Arguments<Real>& at) {
  const std::size_t n = unknowns.size();
  const RestEchelon echelon(field, std::move(rows), n);
  if (!echelon.is_defined() || field.is_undecided()) return std::nullopt;
  LinearSolution solution;
  for (const OptionalFraction& rest : echelon.contradictions()) {
    if (field.vanishes_numerically(*rest)) return std::nullopt;
    solution.is_solvable = false;
  }
  for (const std::uint32_t unknown : unknowns) {
    solution.values.push_back({true, at.q[unknown].value()});
  }
  for (auto pivot = echelon.pivots().rbegin(); pivot != echelon.pivots().rend(); ++pivot) {
    const std::optional<RestCoordinate> value =
        solve_pivot_row(field, echelon.row_without_pivot(*pivot), unknowns);
    if (!value) return std::nullopt;
    solution.values[n - 1 - pivot->column] = *value;
  }
  return solution;
}

/// `row` times the powers of unknowns in its denominators. Adds the unknowns in the denominators to
/// `poles`.
OptionalFraction clear_poles(Algebra& algebra, const Fraction& row, const Unknowns& unknowns,
                             std::set<std::uint32_t>& poles) {
  Monomial powers;
  for (const AtomPower& power : monomial_denominator(row)) {
    const Atom& atom = algebra.atoms[power.atom];
    const bool is_unknown =
        atom.kind == AtomKind::leaf && atom.leaf == Opcode::coordinate &&
        std::ranges::find(unknowns.coordinates, atom.index) != unknowns.coordinates.end();
    if (!is_unknown) continue;
    poles.insert(atom.index);
    powers.push_back(power);
  }
  if (powers.empty()) return row;
  return Arithmetic(algebra).multiply(row,
                                      fraction_of(Polynomial{{powers, GaussianRational{1, 0}}}));
}

/// True if the solution sets an unknown of `poles` to 0, which is a division by 0.
bool is_at_pole(const LinearSolution& solution, const Unknowns& unknowns,
                const std::set<std::uint32_t>& poles) {
  for (std::size_t i = 0; i < solution.values.size(); ++i) {
    const RestCoordinate& value = solution.values[i];
    const bool is_zero = !value.is_arbitrary && is_near(Real(value.value), Real());
    if (is_zero && poles.contains(unknowns.coordinates[i])) return true;
  }
  return false;
}

}  // namespace

std::optional<LinearSolution> linear_solution(ClosedForms& forms, const std::vector<Fraction>& rows,
                                              const Unknowns& unknowns, const Arguments<Real>& at) {
  NumericPivotField field(forms.algebra, at);
  const std::size_t n = unknowns.coordinates.size();
  std::vector<RestEchelon::Row> equations;
  Replacements origin;
  for (const std::uint32_t coordinate : unknowns.coordinates) {
    origin[{Opcode::coordinate, coordinate}] = {};
  }
  std::set<std::uint32_t> poles;
  for (const Fraction& given : rows) {
    const OptionalFraction row = clear_poles(forms.algebra, given, unknowns, poles);
    if (!row) return std::nullopt;
    RestEchelon::Row equation;
    for (const std::uint32_t coordinate : unknowns.coordinates) {
      const auto slope = partial_derivative(forms, *row, coordinate, at.q.size());
      if (!slope || contains_coordinate(forms.algebra, *slope)) return std::nullopt;
      equation.push_back({n - 1 - equation.size(), *slope});
    }
    const OptionalFraction rest = substitute(forms.algebra, row, origin);
    if (!rest) return std::nullopt;
    std::ranges::reverse(equation);
    equation.push_back({n, *rest});
    equations.push_back(std::move(equation));
  }
  std::optional<LinearSolution> solution =
      solve_rows(field, std::move(equations), unknowns.coordinates, at);
  if (solution && is_at_pole(*solution, unknowns, poles)) solution->is_solvable = false;
  return solution;
}

bool contains_coordinate(const Algebra& algebra, const Fraction& form,
                         std::optional<std::uint32_t> coordinate) {
  return coordinate_search(algebra, coordinate).contains(form);
}

Replacements coordinate_replacements(const std::vector<std::uint32_t>& coordinates,
                                     const std::vector<RestCoordinate>& values) {
  Replacements result;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!values[i].closed_form) continue;
    result[{Opcode::coordinate, coordinates[i]}] = {*values[i].closed_form,
                                                    values[i].cosine_and_sine};
  }
  return result;
}

std::optional<std::vector<RestCoordinate>> exact_root(ClosedForms& forms,
                                                      const std::vector<Fraction>& rows,
                                                      const Unknowns& unknowns,
                                                      const Arguments<Real>& root) {
  Algebra& algebra = forms.algebra;
  std::vector<RestCoordinate> values(unknowns.coordinates.size());
  std::optional<std::size_t> open;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto plain =
        quarter_turn_value(algebra, unknowns.kinds[i], root.q[unknowns.coordinates[i]]);
    if (plain) {
      values[i] = *plain;
    } else if (open) {
      return std::nullopt;
    } else {
      open = i;
    }
  }
  if (!open && is_solved(algebra, rows, coordinate_replacements(unknowns.coordinates, values))) {
    return values;
  }
  // A root may be pi/2 only at these values of the parameters: asin(tau/(m g l)) at tau = m g l.
  if (!open && values.size() == 1) open = 0;
  if (!open) return std::nullopt;
  values[*open] = {};
  const Replacements known = coordinate_replacements(unknowns.coordinates, values);
  for (const Fraction& row : rows) {
    const OptionalFraction left = substitute(algebra, row, known);
    if (!left || !coordinate_search(algebra, unknowns.coordinates[*open]).contains(*left)) continue;
    const auto value = SingleUnknownRoot(forms, root, unknowns.coordinates[*open]).find(*left);
    if (!value) continue;
    values[*open] = *value;
    if (is_solved(algebra, rows, coordinate_replacements(unknowns.coordinates, values)))
      return values;
  }
  return std::nullopt;
}

}  // namespace elgen
