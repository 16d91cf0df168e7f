// Polynomial: a sum of   (x + i y) * atoms^exponents   with positive or negative exponents, as one
// sorted array of terms. A term stores up to six factors inline, so that most sums are one block of
// memory. Addition and multiplication merge sorted blocks.
#pragma once

#include <cln/rational.h>

#include <algorithm>
#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <utility>
#include <vector>

namespace elgen {

using AtomId = std::uint32_t;

struct AtomPower {
  AtomId atom = 0;
  std::int32_t exponent = 1;
  friend auto operator<=>(const AtomPower&, const AtomPower&) = default;
};

/// A product of powers of atoms, by ascending atom; no exponent is 0.
class Monomial {
 public:
  using value_type = AtomPower;
  using iterator = AtomPower*;
  using const_iterator = const AtomPower*;

  Monomial() = default;
  Monomial(std::initializer_list<AtomPower> powers) {
    for (const AtomPower& power : powers) push_back(power);
  }

  [[nodiscard]] bool empty() const { return size() == 0; }
  [[nodiscard]] std::size_t size() const { return many_.empty() ? count_ : many_.size(); }
  [[nodiscard]] iterator begin() { return many_.empty() ? few_.data() : many_.data(); }
  [[nodiscard]] iterator end() { return begin() + size(); }
  [[nodiscard]] const_iterator begin() const { return many_.empty() ? few_.data() : many_.data(); }
  [[nodiscard]] const_iterator end() const { return begin() + size(); }
  [[nodiscard]] const AtomPower& front() const { return *begin(); }
  [[nodiscard]] const AtomPower& operator[](std::size_t i) const { return begin()[i]; }

  void push_back(AtomPower power) {
    if (many_.empty() && count_ < few_.size()) {
      few_[count_++] = power;
      return;
    }
    if (many_.empty()) many_.assign(few_.begin(), few_.end());
    count_ = 0;
    many_.push_back(power);
  }

  friend bool operator==(const Monomial& x, const Monomial& y) {
    return std::equal(x.begin(), x.end(), y.begin(), y.end());
  }
  template <class Drop>
  friend void erase_if(Monomial& x, Drop drop) {
    Monomial kept;
    for (const AtomPower& power : x) {
      if (!drop(power)) kept.push_back(power);
    }
    x = std::move(kept);
  }
  /// Compares factor by factor. The terms of a Polynomial have another order: MonomialLess.
  friend std::strong_ordering operator<=>(const Monomial& x, const Monomial& y) {
    return std::lexicographical_compare_three_way(x.begin(), x.end(), y.begin(), y.end());
  }

 private:
  std::array<AtomPower, 6> few_ = {};
  std::size_t count_ = 0;
  std::vector<AtomPower> many_ = {};  ///< all factors, if they do not fit into few_
};

/// The lexicographic order of the exponents. Multiplying x and y by the same monomial preserves
/// their order.
[[nodiscard]] inline std::strong_ordering compare_exponents(const Monomial& x, const Monomial& y) {
  const auto [i, j] = std::mismatch(x.begin(), x.end(), y.begin(), y.end());
  const bool x_decides = i != x.end() && (j == y.end() || i->atom <= j->atom);
  const bool y_decides = j != y.end() && (i == x.end() || j->atom <= i->atom);
  return (x_decides ? i->exponent : 0) <=> (y_decides ? j->exponent : 0);
}

struct MonomialLess {
  [[nodiscard]] bool operator()(const Monomial& x, const Monomial& y) const {
    return compare_exponents(x, y) < 0;
  }
};

/// The number real + i imaginary, a coefficient of a Polynomial.
struct GaussianRational {
  cln::cl_RA real = 0;
  cln::cl_RA imaginary = 0;
  friend bool operator==(const GaussianRational&, const GaussianRational&) = default;
};

/// Terms ascending by MonomialLess; no coefficient is 0, and the empty sum is 0. Unlike the
/// types of sums for pages and code, a Polynomial is canonical: equal sums have equal terms.
class Polynomial {
 public:
  using key_type = Monomial;
  using value_type = std::pair<Monomial, GaussianRational>;
  using Terms = std::vector<value_type>;
  using iterator = Terms::iterator;
  using const_iterator = Terms::const_iterator;

  Polynomial() = default;
  /// `terms` must be ascending.
  explicit Polynomial(Terms terms) : terms_(std::move(terms)) {}
  Polynomial(std::initializer_list<value_type> terms) {
    for (const auto& [monomial, coefficient] : terms) try_emplace(monomial, coefficient);
  }

  [[nodiscard]] bool empty() const { return terms_.empty(); }
  [[nodiscard]] std::size_t size() const { return terms_.size(); }
  [[nodiscard]] iterator begin() { return terms_.begin(); }
  [[nodiscard]] iterator end() { return terms_.end(); }
  [[nodiscard]] const_iterator begin() const { return terms_.begin(); }
  [[nodiscard]] const_iterator end() const { return terms_.end(); }
  [[nodiscard]] auto rbegin() const { return terms_.rbegin(); }
  [[nodiscard]] auto rend() const { return terms_.rend(); }

  [[nodiscard]] const_iterator find(const Monomial& monomial) const {
    const auto at = std::lower_bound(begin(), end(), monomial, is_before);
    return at != end() && at->first == monomial ? at : end();
  }

  /// Inserts a term unless the monomial exists. Returns the term and whether it is new. Cost:
  /// linear in the number of higher terms.
  std::pair<iterator, bool> try_emplace(const Monomial& monomial,
                                        const GaussianRational& coefficient) {
    const bool is_last = terms_.empty() || is_before(terms_.back(), monomial);
    const auto at = is_last ? end() : std::lower_bound(begin(), end(), monomial, is_before);
    if (!is_last && at->first == monomial) return {at, false};
    return {terms_.emplace(at, monomial, coefficient), true};
  }
  iterator erase(const_iterator at) { return terms_.erase(at); }
  template <class Drop>
  friend void erase_if(Polynomial& x, Drop drop) {
    std::erase_if(x.terms_, drop);
  }

  friend bool operator==(const Polynomial&, const Polynomial&) = default;

 private:
  [[nodiscard]] static bool is_before(const value_type& term, const Monomial& monomial) {
    return compare_exponents(term.first, monomial) < 0;
  }

  Terms terms_ = {};
};

}  // namespace elgen
