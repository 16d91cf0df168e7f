// The two roots are written over one divisor, with the factor that both terms have taken out.
#include "analyse/frequencies.hpp"

#include <cln/integer.h>
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "analyse/rest.hpp"
#include "forms/present/arithmetic.hpp"
#include "forms/present/polynomial.hpp"

namespace elgen {
namespace {

class FrequencyFormulas {
 public:
  FrequencyFormulas(const Model& model, ClosedForms& forms, const std::vector<Fraction>& mass,
                    const std::vector<Fraction>& stiffness)
      : model_(model), forms_(forms), mass_(mass), stiffness_(stiffness) {}

  PagePart operator()() {
    PagePart part;
    for (const RestBlock& block : coupled()) {
      const std::vector<std::uint32_t>& joined = block.coordinates;
      const auto formula = joined.size() == 1   ? of_one(joined[0])
                           : joined.size() == 2 ? of_two(joined[0], joined[1])
                                                : std::nullopt;
      if (formula) part.matrices.push_back({{"w^2", "\\omega^{2}"}, 1, 1, {*formula}});
    }
    return part;
  }

 private:
  [[nodiscard]] std::size_t size() const { return model_.velocities.size(); }

  [[nodiscard]] std::optional<Printed> read(const std::optional<Fraction>& form) const {
    return printed(model_, forms_.algebra, form);
  }

  /// Coordinates that M and K join.
  [[nodiscard]] std::vector<RestBlock> coupled() const {
    std::vector<Occurrence> rows(size());
    for (std::uint32_t i = 0; i < rows.size(); ++i) {
      rows[i].coordinates.insert(i);
      for (std::uint32_t j = 0; j < i; ++j) {
        const bool is_joined = !m(i, j).numerator.empty() || !k(i, j).numerator.empty();
        if (is_joined) rows[i].coordinates.insert(j);
      }
    }
    return rest_blocks(rows);
  }

  [[nodiscard]] const Fraction& m(std::size_t i, std::size_t k) const {
    return mass_[i * size() + k];
  }
  [[nodiscard]] const Fraction& k(std::size_t i, std::size_t j) const {
    return stiffness_[i * size() + j];
  }

  /// K/M
  std::optional<Printed> of_one(std::size_t i) {
    return read(Arithmetic(forms_.algebra).divide(k(i, i), m(i, i)));
  }

  /// The roots b/2a -+ sqrt((b/2a)^2 - c/a) of a x^2 - b x + c = det(K - x M).
  std::optional<Printed> of_two(std::size_t i, std::size_t j) {
    Arithmetic at(forms_.algebra);
    const auto determinant = [&](const Fraction& x, const Fraction& y, const Fraction& z) {
      return at.subtract(at.multiply(x, y), at.multiply(z, z));
    };
    const Value a = determinant(m(i, i), m(j, j), m(i, j));
    const Value c = determinant(k(i, i), k(j, j), k(i, j));
    const Value mixed = at.multiply(fraction_of(cln::cl_RA(2)), at.multiply(m(i, j), k(i, j)));
    const Value b =
        at.subtract(at.add(at.multiply(m(i, i), k(j, j)), at.multiply(m(j, j), k(i, i))), mixed);
    const Value middle = at.divide(b, at.multiply(fraction_of(cln::cl_RA(2)), a));
    const Value square = at.subtract(at.multiply(middle, middle), at.divide(c, a));
    return middle && square ? pair_of_roots(*middle, *square) : std::nullopt;
  }

  /// middle -+ sqrt(square) over their common divisor d, with the factor s that both have:
  /// s (middle d/s -+ sqrt(square d^2/s^2))/d.
  std::optional<Printed> pair_of_roots(const Fraction& middle, const Fraction& square) {
    if (square.numerator.empty()) return read(middle);
    Arithmetic at(forms_.algebra);
    const Fraction d = whole_divisor_of(middle);
    const Value left = at.multiply(middle, d);
    const Value right = at.multiply(square, at.multiply(d, d));
    if (!left || !right) return std::nullopt;
    const Fraction s = shared_factor(*left, *right);
    const auto above = read(at.divide(left, s));
    auto root = read(at.square_root(at.divide(right, at.multiply(s, s))));
    const auto factor = read(s);
    const auto below = read(d);
    if (!above || !root || !factor || !below) return std::nullopt;
    root = at_least(*root, Binding::product);
    const bool is_centred = middle.numerator.empty();
    Printed sum{fmt::format("{}-+ {}", is_centred ? "" : above->text + " ", root->text),
                fmt::format("{}\\mp {}", is_centred ? "" : above->latex + " ", root->latex)};
    if (factor->text != "1") {
      sum = {fmt::format("{}*({})", factor->text, sum.text),
             fmt::format("{} \\left( {} \\right)", factor->latex, sum.latex)};
    }
    if (below->text == "1") return sum;
    return Printed{fmt::format("({})/({})", sum.text, below->text),
                   fmt::format("\\frac{{{}}}{{{}}}", sum.latex, below->latex)};
  }

  /// The least form that makes a sum without divisors and with whole coefficients of x.
  Fraction whole_divisor_of(const Fraction& x) {
    cln::cl_I whole = 1;
    for (const auto& [monomial, coefficient] : x.numerator) {
      whole = cln::lcm(whole, cln::denominator(coefficient.real));
    }
    Arithmetic at(forms_.algebra);
    return at.multiply(divisor_of(forms_.algebra, x), fraction_of(cln::cl_RA(whole)))
        .value_or(fraction_of(cln::cl_RA(1)));
  }

  /// The largest monomial that divides x, and whose square divides y.
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
    return fraction_of(Polynomial{{shared, Gaussian{1, 0}}});
  }

  const Model& model_;
  ClosedForms& forms_;
  const std::vector<Fraction>& mass_;
  const std::vector<Fraction>& stiffness_;
};

}  // namespace

PagePart frequency_formulas(const Model& model, ClosedForms& forms,
                            const std::vector<Fraction>& mass,
                            const std::vector<Fraction>& stiffness) {
  return FrequencyFormulas(model, forms, mass, stiffness)();
}

}  // namespace elgen
