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
LeafSearch search_of(const Algebra& algebra, std::optional<std::uint32_t> coordinate) {
  return {algebra, [coordinate](const Atom& leaf) {
            return leaf.leaf == Opcode::coordinate && (!coordinate || leaf.index == *coordinate);
          }};
}

/// k, if a power of an atom is e^(i k q) with integer k; none for other atoms.
std::optional<std::int32_t> sinusoid_power(const Algebra& algebra, const AtomPower& power,
                                           std::uint32_t coordinate) {
  const Atom& atom = algebra.atoms[power.atom];
  if (atom.kind != AtomKind::circular) return std::nullopt;
  const Atom* const leaf = leaf_within(algebra, atom);
  const bool is_it =
      leaf != nullptr && leaf->leaf == Opcode::coordinate && leaf->index == coordinate;
  const cl_RA multiple = cl_RA(power.exponent) / atom.divisor;
  if (!is_it || cln::denominator(multiple) != 1) return std::nullopt;
  return static_cast<std::int32_t>(cln::cl_I_to_long(cln::numerator(multiple)));
}

/// Coefficients of z^0, z^1, …. None if the coordinate also occurs outside of e^(i k q).
using Coefficients = std::vector<Polynomial>;

std::optional<Coefficients> in_sinusoids(const Algebra& algebra, const Polynomial& sum,
                                         std::uint32_t coordinate) {
  std::map<std::int32_t, Polynomial> by_power;
  LeafSearch search = search_of(algebra, coordinate);
  for (const auto& [monomial, coefficient] : sum) {
    Monomial rest;
    std::int32_t total = 0;
    for (const AtomPower& power : monomial) {
      if (const auto sinusoid = sinusoid_power(algebra, power, coordinate)) {
        total += *sinusoid;
      } else if (search.holds(power.atom)) {
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
void divide_out_root(Coefficients& coefficients, const Gaussian& root) {
  while (coefficients.size() > 1) {
    Coefficients quotient(coefficients.size() - 1);
    Polynomial carried;
    for (std::size_t k = coefficients.size(); k-- > 0;) {
      carried = sum(coefficients[k], scaled(carried, root));
      if (k > 0) quotient[k - 1] = carried;
    }
    if (!carried.empty()) return;
    coefficients = std::move(quotient);
  }
}

/// cos(q) = c or sin(q) = c.
struct KnownSinusoid {
  Fraction value = {};
  bool is_cosine = true;
};

std::optional<KnownSinusoid> sinusoid_of(Arithmetic& arithmetic, Coefficients coefficients) {
  for (const Gaussian& root : std::array<Gaussian, 4>{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}}) {
    divide_out_root(coefficients, root);
  }
  if (coefficients.size() != 3) return std::nullopt;
  const bool is_cosine = sum(coefficients[0], scaled(coefficients[2], {-1, 0})).empty();
  const bool is_sine = sum(coefficients[0], coefficients[2]).empty();
  if (!is_cosine && !is_sine) return std::nullopt;
  // c1 + 2 c2 cos(q) = 0 or c1 + 2 i c2 sin(q) = 0
  const Gaussian factor = is_cosine ? Gaussian{cl_RA(-1) / 2, 0} : Gaussian{0, cl_RA(1) / 2};
  const Value value =
      arithmetic.divide(fraction_of(scaled(coefficients[1], factor)), fraction_of(coefficients[2]));
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

  std::optional<CoordinateAtRest> of(const Fraction& row) {
    if (const auto sinusoids = in_sinusoids(algebra_, row.numerator, coordinate_)) {
      const auto sinusoid = sinusoid_of(arithmetic_, *sinusoids);
      return sinusoid ? angle(*sinusoid) : std::nullopt;
    }
    return linear(row.numerator);
  }

 private:
  [[nodiscard]] const Real& number() const { return root_.q[coordinate_]; }

  /// Of the two angles with this cosine or sine, the angle that equals the root.
  std::optional<CoordinateAtRest> angle(const KnownSinusoid& sinusoid) {
    const FunctionId inverse = sinusoid.is_cosine ? FunctionId::acos : FunctionId::asin;
    const Value square = arithmetic_.multiply(sinusoid.value, sinusoid.value);
    const Value other =
        arithmetic_.square_root(arithmetic_.subtract(fraction_of(cl_RA(1)), square));
    const Value first = arithmetic_.call(inverse, sinusoid.value, {});
    const Value second = sinusoid.is_cosine ? arithmetic_.negate(first)
                                            : arithmetic_.subtract(arithmetic_.pi(), first);
    for (const auto& [angle, signed_other] :
         {std::pair{first, other}, std::pair{second, arithmetic_.negate(other)}}) {
      if (!angle || !is_same_angle(value_of(algebra_, *angle, root_), number())) continue;
      if (!signed_other) return std::nullopt;
      const CosineAndSine sinusoids = sinusoid.is_cosine
                                          ? CosineAndSine{sinusoid.value, *signed_other}
                                          : CosineAndSine{*signed_other, sinusoid.value};
      return CoordinateAtRest{false, number().value(), angle, sinusoid.value, sinusoids};
    }
    return std::nullopt;
  }

  std::optional<CoordinateAtRest> linear(const Polynomial& row) {
    const auto solution =
        linear_solution(forms_, {fraction_of(row)}, {{coordinate_}, {SearchKind::none}}, root_);
    if (!solution || !solution->is_solvable) return std::nullopt;
    const CoordinateAtRest& value = solution->values[0];
    if (value.is_any || !is_near(Real(value.value), number())) return std::nullopt;
    return CoordinateAtRest{false, number().value(), value.form};
  }

  ClosedForms& forms_;
  Algebra& algebra_;
  const Arguments<Real>& root_;
  std::uint32_t coordinate_;
  Arithmetic arithmetic_;
};

/// The root if it is 0 or, for an angle, a multiple of a quarter turn; else none.
std::optional<CoordinateAtRest> plain_value(Algebra& algebra, SearchKind kind, const Real& root) {
  Arithmetic arithmetic(algebra);
  if (is_near(root, Real())) return CoordinateAtRest{false, 0, Fraction{}};
  if (kind != SearchKind::turn) return std::nullopt;
  for (const cl_RA& count : {cl_RA(1), cl_RA(1) / 2, cl_RA(-1) / 2}) {
    const Real angle = whole_turn() * Real(count / 2);
    if (!is_same_angle(angle, root)) continue;
    const Value form = arithmetic.multiply(arithmetic.pi(), fraction_of(count));
    return CoordinateAtRest{false, angle.value(), form};
  }
  return std::nullopt;
}

bool is_solved(Algebra& algebra, const std::vector<Fraction>& rows,
               const Replacements& replacements) {
  return std::ranges::all_of(rows, [&](const Fraction& row) {
    const Value value = substituted(algebra, row, replacements);
    return value && value->numerator.empty();
  });
}

// Linear equations.

/// Closed forms, with pivots that are not 0 at the values of the parameters.
class FormsAtParameters : public FormField {
 public:
  FormsAtParameters(Algebra& algebra, const Arguments<Real>& at)
      : FormField(algebra, PresentBudget{}.products, PresentBudget{}.terms),
        algebra_(algebra),
        at_(at) {}

  [[nodiscard]] Real number(const Fraction& fraction) const {
    return value_of(algebra_, fraction, at_);
  }
  [[nodiscard]] bool vanishes(const Fraction& fraction) const {
    return is_near(number(fraction), Real());
  }

  /// The first candidate that is not 0 in 64 digits. If all candidates are 0 in 64 digits, the
  /// elimination is undecided, because this does not prove that they are 0.
  [[nodiscard]] const PivotCandidate<Value>* best(const Candidates& candidates, std::size_t) {
    for (const PivotCandidate<Value>& candidate : candidates) {
      if (!vanishes(**candidate.entry)) return &candidate;
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
using RestEchelon = Echelon<FormsAtParameters>;

/// The value of the unknown of a pivot. `row` is the row of the pivot without the pivot itself.
std::optional<CoordinateAtRest> solved_for(FormsAtParameters& field, const RestEchelon::Row& row,
                                           const std::vector<std::uint32_t>& unknowns) {
  const std::size_t n = unknowns.size();
  Value value = Fraction{};
  for (auto entry = row.rbegin(); entry != row.rend(); ++entry) {
    Value term = entry->value;
    if (entry->column < n) {
      const Value other = field.leaf(Opcode::coordinate, unknowns[n - 1 - entry->column]);
      term = field.multiply(term, other);
    }
    value = field.subtract(value, term);
  }
  if (!value) return std::nullopt;
  const Real number = field.number(*value);
  if (!number.is_defined()) return std::nullopt;
  return CoordinateAtRest{false, number.value(), value};
}

std::optional<LinearSolution> solution_of(FormsAtParameters& field,
                                          std::vector<RestEchelon::Row> rows,
                                          const std::vector<std::uint32_t>& unknowns,
                                          const Arguments<Real>& at) {
  const std::size_t n = unknowns.size();
  const RestEchelon echelon(field, std::move(rows), n);
  if (!echelon.is_defined() || field.is_undecided()) return std::nullopt;
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

/// Multiplies a row by the powers of unknowns in its denominators, and adds these unknowns to
/// `poles`.
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

/// True if an unknown that occurs in a denominator is 0.
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
  FormsAtParameters field(forms.algebra, at);
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

bool holds_coordinate(const Algebra& algebra, const Fraction& form,
                      std::optional<std::uint32_t> coordinate) {
  return search_of(algebra, coordinate).holds(form);
}

Replacements replacements_of(const std::vector<std::uint32_t>& coordinates,
                             const std::vector<CoordinateAtRest>& values) {
  Replacements result;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!values[i].form) continue;
    result[{Opcode::coordinate, coordinates[i]}] = {*values[i].form, values[i].sinusoids};
  }
  return result;
}

std::optional<std::vector<CoordinateAtRest>> exact_root(ClosedForms& forms,
                                                        const std::vector<Fraction>& rows,
                                                        const Unknowns& unknowns,
                                                        const Arguments<Real>& root) {
  Algebra& algebra = forms.algebra;
  std::vector<CoordinateAtRest> values(unknowns.coordinates.size());
  std::optional<std::size_t> open;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto plain = plain_value(algebra, unknowns.kinds[i], root.q[unknowns.coordinates[i]]);
    if (plain) {
      values[i] = *plain;
    } else if (open) {
      return std::nullopt;
    } else {
      open = i;
    }
  }
  if (!open && is_solved(algebra, rows, replacements_of(unknowns.coordinates, values))) {
    return values;
  }
  // A root may be pi/2 only at these values of the parameters, such as asin(tau/(m g l)).
  if (!open && values.size() == 1) open = 0;
  if (!open) return std::nullopt;
  values[*open] = {};
  const Replacements known = replacements_of(unknowns.coordinates, values);
  for (const Fraction& row : rows) {
    const Value left = substituted(algebra, row, known);
    if (!left || !search_of(algebra, unknowns.coordinates[*open]).holds(*left)) continue;
    const auto value = SingleUnknownRoot(forms, root, unknowns.coordinates[*open]).of(*left);
    if (!value) continue;
    values[*open] = *value;
    if (is_solved(algebra, rows, replacements_of(unknowns.coordinates, values))) return values;
  }
  return std::nullopt;
}

}  // namespace elgen
