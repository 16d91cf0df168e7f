// The two values w^2 of a block of two coordinates are s (x -+ sqrt(y))/d, with a common factor s
// and a common divisor d. If y is a square, each value has a formula without a root.
#include "analyse/frequencies.hpp"

#include <cln/integer.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "analyse/exact_roots.hpp"
#include "analyse/formulas.hpp"
#include "analyse/rest.hpp"
#include "forms/present/polynomial.hpp"

namespace elgen {
namespace {

class FrequencySolver {
 public:
  FrequencySolver(ClosedForms& forms, const RestMatrices& at_rest, std::size_t size)
      : forms_(forms), at_rest_(at_rest), size_(size) {}

  std::vector<SquaredFrequency> operator()() {
    std::vector<SquaredFrequency> all;
    for (const RestBlock& block : coupled_blocks()) {
      const std::vector<std::uint32_t>& joined = block.coordinates;
      if (joined.size() == 1) add_single_frequency(all, joined[0]);
      if (joined.size() == 2) add_block_frequencies(all, joined[0], joined[1]);
    }
    return all;
  }

 private:
  /// The blocks of coordinates that M and K couple.
  [[nodiscard]] std::vector<RestBlock> coupled_blocks() const {
    std::vector<CoordinateOccurrence> rows(size_);
    for (std::uint32_t i = 0; i < rows.size(); ++i) {
      rows[i].coordinates.insert(i);
      for (std::uint32_t j = 0; j < i; ++j) {
        const bool is_joined = !mass(i, j).numerator.empty() || !stiffness(i, j).numerator.empty();
        if (is_joined) rows[i].coordinates.insert(j);
      }
    }
    return rest_blocks(rows);
  }

  [[nodiscard]] const Fraction& mass(std::size_t i, std::size_t k) const {
    return at_rest_.mass[i * size_ + k];
  }
  [[nodiscard]] const Fraction& stiffness(std::size_t i, std::size_t j) const {
    return at_rest_.stiffness[i * size_ + j];
  }

  /// Adds w^2 = K_ii/M_ii.
  void add_single_frequency(std::vector<SquaredFrequency>& all, std::size_t i) {
    const OptionalFraction square = Arithmetic(forms_.algebra).divide(stiffness(i, i), mass(i, i));
    if (square) all.push_back({*square});
  }

  /// Adds the roots b/2a -+ sqrt((b/2a)^2 - c/a) of a x^2 - b x + c = det(K - x M).
  void add_block_frequencies(std::vector<SquaredFrequency>& all, std::size_t i, std::size_t j) {
    Arithmetic at(forms_.algebra);
    const auto determinant = [&](const Fraction& x, const Fraction& y, const Fraction& z) {
      return at.subtract(at.multiply(x, y), at.multiply(z, z));
    };
    const OptionalFraction a = determinant(mass(i, i), mass(j, j), mass(i, j));
    const OptionalFraction c = determinant(stiffness(i, i), stiffness(j, j), stiffness(i, j));
    const OptionalFraction mixed =
        at.multiply(fraction_of(cln::cl_RA(2)), at.multiply(mass(i, j), stiffness(i, j)));
    const OptionalFraction b = at.subtract(
        at.add(at.multiply(mass(i, i), stiffness(j, j)), at.multiply(mass(j, j), stiffness(i, i))),
        mixed);
    const OptionalFraction middle = at.divide(b, at.multiply(fraction_of(cln::cl_RA(2)), a));
    const OptionalFraction square = at.subtract(at.multiply(middle, middle), at.divide(c, a));
    if (middle && square) add_root_pair(all, *middle, *square);
  }

  /// Adds middle -+ sqrt(square), with the common divisor d and the common factor s:
  ///     s (middle d/s -+ sqrt(square d^2/s^2))/d
  /// If `square` d^2 is the square of a sum, adds two formulas without a root. The sign of the sum
  /// does not matter, because both signs occur.
  void add_root_pair(std::vector<SquaredFrequency>& all, const Fraction& middle,
                     const Fraction& square) {
    if (square.numerator.empty()) {
      all.push_back({middle});
      return;
    }
    Arithmetic at(forms_.algebra);
    const Fraction d = integer_denominator(middle);
    const OptionalFraction left = at.multiply(middle, d);
    const OptionalFraction right = at.multiply(square, at.multiply(d, d));
    if (!left || !right) return;
    if (const auto sum = exact_square_root(*right)) {
      const OptionalFraction root = at.divide(*sum, d);
      const OptionalFraction first = at.subtract(middle, root);
      const OptionalFraction second = at.add(middle, root);
      if (!first || !second) return;
      all.push_back({*first});
      all.push_back({*second});
      return;
    }
    const Fraction s = shared_factor(*left, *right);
    const OptionalFraction above = at.divide(left, s);
    const OptionalFraction root = at.square_root(at.divide(right, at.multiply(s, s)));
    if (above && root) all.push_back({*above, root, s, d});
  }

  /// A square root of x that is a sum with rational coefficients; none if x has no such root.
  static std::optional<Fraction> exact_square_root(const Fraction& x) {
    const GaussianRational& lead = x.numerator.rbegin()->second;
    cln::cl_RA root;
    const bool is_square = x.denominator.empty() && cln::zerop(lead.imaginary) &&
                           cln::plusp(lead.real) && cln::sqrtp(lead.real, &root);
    if (!is_square) return std::nullopt;
    const auto sum = square_root(multiply_by_term(x.numerator, {cln::recip(lead.real), 0}));
    return sum ? std::optional(fraction_of(multiply_by_term(*sum, {root, 0}))) : std::nullopt;
  }

  /// The smallest form whose product with x has no divisors and only integer coefficients.
  Fraction integer_denominator(const Fraction& x) {
    cln::cl_I whole = 1;
    for (const auto& [monomial, coefficient] : x.numerator) {
      whole = cln::lcm(whole, cln::denominator(coefficient.real));
    }
    Arithmetic at(forms_.algebra);
    return at.multiply(full_denominator(forms_.algebra, x), fraction_of(cln::cl_RA(whole)))
        .value_or(fraction_of(cln::cl_RA(1)));
  }

  /// The largest monomial that divides x and whose square divides y.
  static Fraction shared_factor(const Fraction& x, const Fraction& y) {
    const auto common = [](const Fraction& form) {
      std::optional<std::map<AtomId, std::int32_t>> result;
      for (const auto& [monomial, coefficient] : form.numerator) {
        std::map<AtomId, std::int32_t> own;
        for (const AtomPower& power : monomial) {
          const std::int32_t known = result ? (*result)[power.atom] : power.exponent;
          own[power.atom] = std::min(known, power.exponent);
        }
        result = std::move(own);
      }
      return result.value_or(std::map<AtomId, std::int32_t>{});
    };
    std::map<AtomId, std::int32_t> of_x = common(x);
    Monomial shared;
    for (const auto& [atom, exponent] : common(y)) {
      const std::int32_t power =
          x.numerator.empty() ? exponent / 2 : std::min(of_x[atom], exponent / 2);
      if (power > 0) shared.push_back({atom, power});
    }
    return fraction_of(Polynomial{{shared, GaussianRational{1, 0}}});
  }

  ClosedForms& forms_;
  const RestMatrices& at_rest_;
  std::size_t size_;
};

}  // namespace

RestMatrices rest_matrices(const Model& model, ClosedForms& forms, const RestPoint& point) {
  std::vector<std::uint32_t> coordinates(point.coordinates.size());
  std::iota(coordinates.begin(), coordinates.end(), 0);
  const Replacements place = coordinate_replacements(coordinates, point.coordinates);
  const ClosedField rows = forms.functions[0].fields[0];
  const ClosedField masses = forms.functions[1].fields[0];
  RestMatrices found;
  const auto add = [&](std::vector<Fraction>& list, const OptionalFraction& form) {
    const OptionalFraction value = substitute(forms.algebra, form, place);
    if (value && !contains_coordinate(forms.algebra, *value)) list.push_back(*value);
  };
  const std::size_t n = model.velocities.size();
  for (std::size_t i = 0; i < n * n; ++i) {
    const auto& row = rows.entries[i / n];
    const bool has_slope = row && model.rotations.empty();
    add(found.stiffness, has_slope
                             ? partial_derivative(forms, *row, model.velocities[i % n].coordinate,
                                                  point.coordinates.size())
                             : std::nullopt);
    add(found.mass, masses.entries[i]);
  }
  if (found.mass.size() < n * n) found.mass.clear();
  if (found.stiffness.size() < n * n) found.stiffness.clear();
  return found;
}

std::vector<SquaredFrequency> squared_frequencies(ClosedForms& forms, const RestMatrices& at_rest,
                                                  std::size_t size) {
  if (at_rest.mass.empty() || at_rest.stiffness.empty()) return {};
  return FrequencySolver(forms, at_rest, size)();
}

}  // namespace elgen
