// RangeBounds: what closed forms are at most over the ranges a model declares.
//
//     1/4 m x e^(i theta) + its conjugate,  m = 2, x in [-3, 1]     ->     [-3, 3]
//
// Parameters lie in [min, max], or are at their value; coordinates lie in `range`, rates in
// `rate_range`.
#pragma once

#include <map>

#include "drop/enclosure.hpp"
#include "elgen/closed_forms.hpp"
#include "elgen/model.hpp"

namespace elgen {

/// Each pair of conjugate exponentials, and each other monomial, as a fraction of its own.
[[nodiscard]] std::vector<Fraction> terms_of(const Algebra& algebra, const Fraction& x);

/// What the terms of a closed form are at most.
struct TermBounds {
  cln::cl_RA largest = 0;   ///< any one of them
  cln::cl_RA together = 0;  ///< their sum, whatever their signs
};

class RangeBounds {
 public:
  /// `algebra` may grow while this lives.
  RangeBounds(const Algebra& algebra, const Model& model) : algebra_(algebra), model_(model) {}

  /// None where there is no bound; missing() then says why.
  [[nodiscard]] std::optional<Enclosure> of(const Fraction& x);

  [[nodiscard]] std::optional<TermBounds> of_terms(const Fraction& x);

  /// E616 of the last bound that there was not.
  [[nodiscard]] const Diagnostic& missing() const { return missing_; }

 private:
  std::optional<Enclosure> of(const Polynomial& sum);
  std::optional<Enclosure> of(const Monomial& monomial);
  std::optional<Enclosure> of_atom(AtomId id);
  template <class Owner>
  std::optional<Enclosure> of_range(const Owner& owner, std::optional<Interval> Owner::*range,
                                    std::string_view key, std::string_view reason);
  std::optional<Enclosure> of_leaf(const Atom& atom);
  std::optional<Enclosure> of_call(const Atom& atom);
  std::nullopt_t miss(const Span& span, std::string message, std::string hint = {});

  const Algebra& algebra_;
  const Model& model_;
  std::map<AtomId, Enclosure> known_ = {};
  Diagnostic missing_{Code::E616, {}, {}};
};

}  // namespace elgen
