// real_terms: see real_terms.hpp. (cos + i sin)^k is expanded. Then 1 - cos^2 replaces sin^2, or
// 1 - sin^2 replaces cos^2, as requested. Only one exponential of each conjugate pair is read.
#include "forms/write/real_terms.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "forms/present/polynomial.hpp"

namespace elgen {
namespace {

using cln::cl_RA;

bool precedes(const CircularPower& x, const CircularPower& y) {
  const MonomialLess less;
  if (less(y.angle, x.angle)) return true;
  if (less(x.angle, y.angle)) return false;
  return std::tie(x.cosine, x.sine) < std::tie(y.cosine, y.sine);
}

/// One step of sin^2 = 1 - cos^2, or of cos^2 = 1 - sin^2 if `by_sines`.
CircularPolynomial reduce_squares(const CircularPolynomial& sum, bool by_sines) {
  CircularPolynomial result;
  for (const auto& [powers, value] : sum) {
    const auto [cosine, sine] = powers;
    const GaussianRational opposite{-value.real, -value.imaginary};
    if (by_sines && cosine >= 2) {
      add_term(result, {cosine - 2, sine}, value);
      add_term(result, {cosine - 2, sine + 2}, opposite);
    } else if (!by_sines && sine >= 2) {
      add_term(result, {cosine, sine - 2}, value);
      add_term(result, {cosine + 2, sine - 2}, opposite);
    } else {
      add_term(result, powers, value);
    }
  }
  return result;
}

/// (cos + i sin)^multiple
CircularPolynomial power_of_exponential(std::int32_t multiple, bool by_sines) {
  CircularPolynomial result{{{0, 0}, GaussianRational{1, 0}}};
  for (std::int32_t k = 0; k < std::abs(multiple); ++k) {
    result = reduce_squares(multiply_by_exponential(result, multiple < 0 ? -1 : 1), by_sines);
  }
  return result;
}

/// Limit of expanded products of sines and cosines, per term of the result. k unit angles in one
/// exponential give 2^k products, and almost all of them cancel.
constexpr std::size_t work_per_term = 64;

/// The highest power of a sine or cosine. cos(24 x) is a sum of 13 powers, far longer than the
/// call, and the work grows with the cube of the power.
constexpr std::int32_t highest_sinusoid_power = 24;

/// Products of sines and cosines, numbered. Most exponentials have the same products, so each
/// product is stored once, as a shorter product times one power. Number 0 is the empty product.
class CircularProducts {
 public:
  std::size_t intern_power(const CircularPower& power) {
    const auto [at, is_new] = numbers_.try_emplace(power, powers_.size());
    if (is_new) powers_.push_back(power);
    return at->second;
  }

  /// The number of product * power; `product` and `power` are numbers too.
  std::size_t multiply(std::size_t product, std::size_t power) {
    std::vector<std::size_t>& longer = products_[product].longer;
    if (longer.size() <= power) longer.resize(power + 1, 0);
    if (longer[power] != 0) return longer[power];
    const std::size_t made = longer[power] = products_.size();
    products_.push_back({product, power, {}});
    return made;
  }

  [[nodiscard]] std::vector<CircularPower> factors(std::size_t product) const {
    std::vector<CircularPower> result;
    for (; product != 0; product = products_[product].shorter) {
      result.push_back(powers_[products_[product].power]);
    }
    std::ranges::reverse(result);
    return result;
  }

 private:
  struct Product {
    std::size_t shorter = 0;
    std::size_t power = 0;
    std::vector<std::size_t> longer = {};  ///< number of this product times each power; 0: unknown
  };
  struct Precedes {
    bool operator()(const CircularPower& x, const CircularPower& y) const { return precedes(x, y); }
  };

  std::map<CircularPower, std::size_t, Precedes> numbers_ = {};
  std::vector<CircularPower> powers_ = {};
  std::vector<Product> products_ = std::vector<Product>(1);
};

class RealTermsBuilder {
 public:
  RealTermsBuilder(const Algebra& algebra, const Polynomial& sum, Trigonometry trigonometry)
      : algebra_(algebra), trigonometry_(trigonometry) {
    prefers_sines_ = trigonometry == Trigonometry::directions_by_sines ||
                     trigonometry == Trigonometry::units_by_sines;
    for (const auto& [monomial, coefficient] : sum)
      update_base_angles(split_monomial(algebra, monomial).angle);
  }

  /// The highest power of a sine or cosine in the expansion of the exponentials of `monomial`.
  [[nodiscard]] std::int32_t highest_power(const Monomial& monomial) const {
    const Monomial angle = split_monomial(algebra_, monomial).angle;
    if (angle.empty() || trigonometry_ == Trigonometry::multiple_angles) return 0;
    if (!expands_units())
      return common_divisor(angle) / base_of_direction_.at(primitive_angle(angle));
    std::int32_t highest = 0;
    for (const AtomPower& part : angle) {
      highest = std::max(highest, std::abs(part.exponent) / base_of_unit_.at(part.atom));
    }
    return highest;
  }

  void add(const Monomial& monomial, const GaussianRational& coefficient) {
    const auto [powers, angle] = split_monomial(algebra_, monomial);
    if (!angle.empty() && angle.front().exponent < 0) return;  // its conjugate is added instead
    RealSum& sum = sums_[powers];
    if (angle.empty()) return add_real(sum, 0, coefficient.real);
    const NumberedSum& products = expansion_of(angle);
    product_count_ += products.size();
    const GaussianRational twice{coefficient.real * 2, coefficient.imaginary * 2};
    for (const auto& [number, value] : products) {
      add_real(sum, number, value.real * twice.real - value.imaginary * twice.imaginary);
    }
  }

  /// The number of products added so far.
  [[nodiscard]] std::size_t product_count() const { return product_count_; }

  [[nodiscard]] std::size_t size() const { return size_; }

  [[nodiscard]] std::vector<RealTerm> extract_terms() const {
    std::vector<RealTerm> terms;
    for (const auto& [powers, sum] : sums_) {
      const auto first = static_cast<std::ptrdiff_t>(terms.size());
      for (const auto& [number, value] : sum) {
        if (!cln::zerop(value)) terms.push_back({value, powers, circular_.factors(number)});
      }
      std::sort(terms.begin() + first, terms.end(), [](const RealTerm& x, const RealTerm& y) {
        return std::ranges::lexicographical_compare(x.circular, y.circular, precedes);
      });
    }
    return terms;
  }

 private:
  /// Pairs of a product's number and its coefficient.
  using NumberedSum = std::vector<std::pair<std::size_t, GaussianRational>>;
  /// Zero coefficients are kept, because terms reappear often and erasing terms costs more.
  using RealSum = std::unordered_map<std::size_t, cl_RA>;

  [[nodiscard]] bool expands_units() const {
    return trigonometry_ == Trigonometry::units_by_cosines ||
           trigonometry_ == Trigonometry::units_by_sines;
  }

  void add_real(RealSum& sum, std::size_t number, const cl_RA& value) {
    if (cln::zerop(value)) return;
    cl_RA& own = sum.try_emplace(number, 0).first->second;
    if (cln::zerop(own)) ++size_;
    own = own + value;
    if (cln::zerop(own)) --size_;
  }

  /// The expansion of e^(i angle), memoised.
  const NumberedSum& expansion_of(const Monomial& angle) {
    const auto [known, is_new] = expansions_.try_emplace(angle);
    if (is_new) known->second = expand_exponential(angle);
    return known->second;
  }

  /// Updates the base of the direction of `angle`, and of each unit in `angle`: the greatest common
  /// divisor of whole_angle_units and all multiples so far.
  void update_base_angles(const Monomial& angle) {
    if (angle.empty()) return;
    for (const AtomPower& part : angle) {
      std::int32_t& base = base_of_unit_.try_emplace(part.atom, whole_angle_units).first->second;
      base = std::gcd(base, part.exponent);
    }
    const std::int32_t multiple = common_divisor(angle);
    std::int32_t& base =
        base_of_direction_.try_emplace(primitive_angle(angle), whole_angle_units).first->second;
    base = std::gcd(base, multiple);
  }

  NumberedSum expand_exponential(const Monomial& angle) {
    const NumberedSum one{{0, GaussianRational{1, 0}}};
    if (trigonometry_ == Trigonometry::multiple_angles) return times_exponential(one, angle, 1);
    if (!expands_units()) {
      const Monomial along = primitive_angle(angle);
      const std::int32_t base = base_of_direction_.at(along);
      return times_exponential(one, power(along, base), common_divisor(angle) / base);
    }
    NumberedSum result = one;
    for (const AtomPower& part : angle) {
      const std::int32_t base = base_of_unit_.at(part.atom);
      result = times_exponential(result, {{part.atom, base}}, part.exponent / base);
    }
    return result;
  }

  /// x e^(i multiple angle); x must not contain this angle.
  NumberedSum times_exponential(const NumberedSum& x, const Monomial& angle,
                                std::int32_t multiple) {
    NumberedSum result;
    const auto [known, is_new] = powers_.try_emplace(multiple);
    if (is_new) known->second = power_of_exponential(multiple, prefers_sines_);
    for (const auto& [powers, b] : known->second) {
      const bool is_one = powers.first == 0 && powers.second == 0;
      const std::size_t power = circular_.intern_power({angle, powers.first, powers.second});
      for (const auto& [own, a] : x) {
        result.emplace_back(is_one ? own : circular_.multiply(own, power), product(a, b));
      }
    }
    return result;
  }

  const Algebra& algebra_;
  Trigonometry trigonometry_;
  bool prefers_sines_ = false;
  std::size_t product_count_ = 0;
  std::size_t size_ = 0;
  std::map<AtomId, std::int32_t> base_of_unit_;
  std::map<Monomial, std::int32_t, MonomialLess> base_of_direction_;
  std::map<Monomial, NumberedSum, MonomialLess> expansions_;
  std::map<std::int32_t, CircularPolynomial> powers_ = {};  ///< expansions of exponentials
  CircularProducts circular_;
  std::map<Monomial, RealSum, MonomialLess> sums_;
};

}  // namespace

std::int32_t common_divisor(const Monomial& angle) {
  std::int32_t result = 0;
  for (const AtomPower& part : angle) result = std::gcd(result, part.exponent);
  return result;
}

Monomial primitive_angle(const Monomial& angle) {
  const std::int32_t divisor = common_divisor(angle);
  Monomial result = angle;
  for (AtomPower& part : result) part.exponent /= angle.front().exponent < 0 ? -divisor : divisor;
  return result;
}

CircularPolynomial multiply_by_exponential(const CircularPolynomial& x, int sign) {
  const GaussianRational i{0, sign};
  CircularPolynomial result;
  for (const auto& [powers, value] : x) {
    add_term(result, {powers.first + 1, powers.second}, value);
    add_term(result, {powers.first, powers.second + 1}, product(value, i));
  }
  return result;
}

std::optional<std::vector<RealTerm>> real_terms(const Algebra& algebra, const Polynomial& sum,
                                                Trigonometry trigonometry, std::size_t most) {
  if (trigonometry == Trigonometry::homogeneous) return homogeneous_terms(algebra, sum, most);
  RealTermsBuilder terms(algebra, sum, trigonometry);
  for (const auto& [monomial, coefficient] : sum) {
    if (terms.highest_power(monomial) > highest_sinusoid_power) return std::nullopt;
    terms.add(monomial, coefficient);
    // Later terms may cancel some of the terms so far, but not most of them.
    if (terms.size() > 4 * most || terms.product_count() > work_per_term * most)
      return std::nullopt;
  }
  if (terms.size() > most) return std::nullopt;
  return terms.extract_terms();
}

namespace {

std::size_t circular_length(const Algebra& algebra, const CircularPower& power) {
  std::size_t angle = call_length + power.angle.size() - 1;
  for (const AtomPower& part : power.angle) {
    const bool is_itself = algebra.atoms[part.atom].divisor == std::abs(part.exponent);
    if (!is_itself) angle += multiple_length;
  }
  std::size_t length = 0;
  for (const std::int32_t exponent : {power.cosine, power.sine}) {
    if (exponent > 0) length += angle + (exponent > 1 ? 1 : 0);
  }
  return length;
}

}  // namespace

std::size_t written_length(const Algebra& algebra, const std::vector<RealTerm>& terms) {
  std::size_t length = 0;
  for (const RealTerm& term : terms) {
    length += term.powers.size() + 1;
    if (cln::abs(term.coefficient) != 1) ++length;
    for (const CircularPower& power : term.circular) length += 1 + circular_length(algebra, power);
  }
  return length;
}

std::optional<std::vector<RealTerm>> shortest_terms(const Algebra& algebra, const Polynomial& sum,
                                                    std::size_t most) {
  std::optional<std::vector<RealTerm>> best;
  std::size_t least = 0;
  for (const Trigonometry trigonometry : trigonometries) {
    auto terms = real_terms(algebra, sum, trigonometry, most);
    if (!terms) continue;
    const std::size_t length = written_length(algebra, *terms);
    if (best && length >= least) continue;
    least = length;
    best = std::move(terms);
  }
  return best;
}

}  // namespace elgen
