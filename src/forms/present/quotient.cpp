// Exact division of sparse sums by a heap of products (M. Monagan, R. Pearce: Sparse polynomial
// division using a heap, 2011). The division stops as soon as no exact quotient is possible.
#include <algorithm>
#include <utility>

#include "forms/present/polynomial.hpp"

namespace elgen {
namespace {

/// The range of exponents of each atom, in ascending order of atoms.
using ExponentBox = std::vector<ExponentRange>;

/// The range of an atom; a missing atom is inserted with exponent 0.
ExponentRange& find_or_insert_range(ExponentBox& box, AtomId atom) {
  const auto at = std::ranges::lower_bound(box, atom, {}, &ExponentRange::atom);
  return at != box.end() && at->atom == atom ? *at : *box.insert(at, ExponentRange{.atom = atom});
}

/// The range of exponents that each atom can have in x / y; none if y cannot divide x.
std::optional<ExponentBox> quotient_box(const Polynomial& x, const Polynomial& y) {
  ExponentBox box = exponent_ranges(x);
  for (const ExponentRange& divisor : exponent_ranges(y)) {
    ExponentRange& own = find_or_insert_range(box, divisor.atom);
    own.least -= divisor.least;
    own.greatest -= divisor.greatest;
  }
  const bool is_empty = std::ranges::any_of(
      box, [](const ExponentRange& side) { return side.least > side.greatest; });
  if (is_empty) return std::nullopt;
  return box;
}

bool is_inside(const Monomial& monomial, const ExponentBox& box) {
  auto factor = monomial.begin();
  for (const ExponentRange& side : box) {
    const bool is_present = factor != monomial.end() && factor->atom == side.atom;
    const std::int32_t exponent = is_present ? (factor++)->exponent : 0;
    if (exponent < side.least || exponent > side.greatest) return false;
  }
  return factor == monomial.end();
}

/// The products of each term of x, the sum in [first, last), with each term of another sum, in
/// descending order. The heap holds the next product of every term of x. Terms may be added to the
/// other sum during the division, each below all earlier terms.
class ProductHeap {
 public:
  ProductHeap(Polynomial::const_iterator first, Polynomial::const_iterator last)
      : heads_(static_cast<std::size_t>(last - first)) {
    for (HeapEntry& head : heads_) head.term = &*first++;
  }

  [[nodiscard]] bool empty() const { return heap_.empty(); }
  [[nodiscard]] const Monomial& greatest_monomial() const { return heap_.front()->monomial; }

  /// Removes the greatest product and returns its coefficient.
  GaussianRational pop_greatest() {
    std::ranges::pop_heap(heap_, MonomialLess(), &HeapEntry::monomial);
    HeapEntry& head = *heap_.back();
    heap_.pop_back();
    const GaussianRational value = product(head.term->second, other_[head.next].second);
    if (++head.next < other_.size()) push(head);
    return value;
  }

  void add_quotient_term(Polynomial::value_type term) {
    other_.push_back(std::move(term));
    for (HeapEntry& head : heads_) {
      if (head.next + 1 == other_.size()) push(head);
    }
  }

  Polynomial::Terms take_quotient_terms() && { return std::move(other_); }

 private:
  struct HeapEntry {
    const Polynomial::value_type* term = nullptr;  ///< term of x
    std::size_t next = 0;                          ///< index in the other sum
    Monomial monomial = {};                        ///< of *term times other_[next]
  };

  void push(HeapEntry& head) {
    head.monomial = product(head.term->first, other_[head.next].first);
    heap_.push_back(&head);
    std::ranges::push_heap(heap_, MonomialLess(), &HeapEntry::monomial);
  }

  std::vector<HeapEntry> heads_;
  std::vector<HeapEntry*> heap_ = {};
  Polynomial::Terms other_ = {};  ///< descending
};

}  // namespace

std::vector<ExponentRange> exponent_ranges(const Polynomial& x) {
  ExponentBox box;
  for (const auto& [monomial, coefficient] : x) {
    for (const AtomPower& factor : monomial) {
      ExponentRange& side = find_or_insert_range(box, factor.atom);
      const bool is_first = side.terms++ == 0;
      side.least = is_first ? factor.exponent : std::min(side.least, factor.exponent);
      side.greatest = is_first ? factor.exponent : std::max(side.greatest, factor.exponent);
    }
  }
  for (ExponentRange& side : box) {
    if (side.terms == x.size()) continue;
    side.least = std::min(side.least, 0);
    side.greatest = std::max(side.greatest, 0);
  }
  return box;
}

Monomial common_powers(const Polynomial& x) {
  Monomial powers;
  for (const ExponentRange& range : exponent_ranges(x)) {
    if (range.least != 0) powers.push_back({range.atom, range.least});
  }
  return powers;
}

std::optional<Polynomial> quotient(const Polynomial& x, const Polynomial& y, std::size_t& work) {
  const std::optional<ExponentBox> box = quotient_box(x, y);
  if (!box) return std::nullopt;
  const Monomial inverse_lead = power(y.rbegin()->first, -1);
  const GaussianRational inverse_coefficient = reciprocal(y.rbegin()->second);
  const Monomial last = product(x.begin()->first, power(y.begin()->first, -1));
  if (!is_inside(last, *box)) return std::nullopt;
  // The products of the quotient with all terms of y below its leading term. They are subtracted
  // from x one by one, so no remainder is stored.
  ProductHeap products(y.begin(), y.end() - 1);
  auto own = x.rbegin();
  while (own != x.rend() || !products.empty()) {
    const bool is_own =
        products.empty() ||
        (own != x.rend() && compare_exponents(own->first, products.greatest_monomial()) >= 0);
    Polynomial::value_type lead{is_own ? own->first : products.greatest_monomial(),
                                GaussianRational{}};
    if (is_own) lead.second = (own++)->second;
    while (!products.empty() && products.greatest_monomial() == lead.first) {
      const GaussianRational value = products.pop_greatest();
      lead.second = {lead.second.real - value.real, lead.second.imaginary - value.imaginary};
    }
    if (is_zero(lead.second)) continue;
    Monomial monomial = product(lead.first, inverse_lead);
    if (!is_inside(monomial, *box) || work < y.size()) return std::nullopt;
    work -= y.size();
    products.add_quotient_term({std::move(monomial), product(lead.second, inverse_coefficient)});
  }
  Polynomial::Terms terms = std::move(products).take_quotient_terms();
  std::ranges::reverse(terms);
  return Polynomial(std::move(terms));
}

void cancel_common_factors(Fraction& x, const Algebra& algebra, std::size_t& work) {
  for (auto& [factor, exponent] : x.denominator) {
    while (exponent > 0 && x.numerator.size() > 1) {
      auto divided = quotient(x.numerator, algebra.factors[factor].shown, work);
      if (!divided) break;
      x.numerator = std::move(*divided);
      --exponent;
    }
  }
  std::erase_if(x.denominator, [](const auto& factor) { return factor.second == 0; });
}

}  // namespace elgen
