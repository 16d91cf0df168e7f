// arrange: converts closed forms to sums of products as in textbooks.
//
//     factor_out         1/2 m r'^2 + 1/2 m r^2 phi'^2   ->   1/2 m (r'^2 + r^2 phi'^2)
//     collect_by_rates   no common factor; one coefficient for each product of rates,
//                        accelerations first
//
// Typed sums of the model stay together: k (r - l0)^2. Each product of parameters has a coefficient
// in its own shortest trigonometric form, so that A sin^2 + C cos^2 stays as typed instead of
// becoming C + (A - C) sin^2. TypedForms hold the properties of a model that closed forms lose:
// which sums were typed, the order and signs of their terms, and the order of the parameters of a
// product.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <vector>

#include "elgen/closed_forms.hpp"
#include "elgen/model.hpp"
#include "forms/typeset/book_sum.hpp"

namespace elgen {

/// A sum, such as r - l0, in an expression that the author of the model typed.
struct TypedSum {
  Polynomial value = {};
  std::vector<AtomId> atoms = {};  ///< of the value, ascending
  Polynomial square = {};  ///< value^2 if the value contains a root, as in sqrt(x^2 + y^2) - l
  std::vector<Fraction> terms = {};  ///< as typed, with signs
  /// The index in Model::definitions of a definition with this value.
  std::optional<std::uint32_t> definition = {};
};

struct TypedForms {
  std::vector<TypedSum> sums = {};  ///< longest first, without duplicates
  /// The position of each parameter among the factors of a product: as in the products of the
  /// model, otherwise as declared, with gravity after the masses (m g l).
  std::vector<std::uint32_t> parameter_places = {};
  std::vector<bool> are_accelerations = {};  ///< by parameter: true for g and other accelerations
  /// For each prescribed function: its value if the value is a single term with a root or a call;
  /// otherwise the empty sum. In an angle, the name of the function replaces this value.
  std::vector<Polynomial> prescribed_values = {};
};

/// Cost: one closed form per typed sum. A model with more than 200 sums, such as a robot, gets no
/// typed sums.
[[nodiscard]] TypedForms typed_forms(Algebra& algebra, const Model& model,
                                     const FixedParameters& fixed);

/// Thrown for a sum with more terms than anyone reads.
struct TextbookLengthError : std::length_error {
  TextbookLengthError() : std::length_error("a sum of too many terms") {}
};

/// The most operations of an entry, and the most factors of a typed sum, if common subexpressions
/// are written out. Each level of nested functions doubles the number of operations.
inline constexpr std::size_t longest_textbook_entry = 5'000;

/// The rank of sums that are not typed in the model.
inline constexpr std::uint32_t untyped_rank = 10'000;

/// Longer sums are not searched for common factors: readers would not notice these factors.
inline constexpr std::size_t most_collected_terms = 40;

class Arranger {
 public:
  Arranger(const Algebra& algebra, const TypedForms& typed) : algebra_(algebra), typed_(typed) {}

  [[nodiscard]] TextbookSum factor_out(const Fraction& form);
  /// Arranges each summand separately.
  [[nodiscard]] TextbookSum factor_out_each(const std::vector<Fraction>& summands);
  /// Arranges the terms with rates or momenta first, then the other terms: T before V in an energy.
  [[nodiscard]] TextbookSum split_by_motion(const Fraction& form);
  /// Collects the coefficient of each product of rates. `own` is the velocity whose acceleration
  /// comes first.
  [[nodiscard]] TextbookSum collect_by_rates(const Fraction& form,
                                             std::optional<std::uint32_t> own = {});
  /// One product if a typed sum divides the form; otherwise collect_by_rates().
  [[nodiscard]] TextbookSum arrange_summand(const Fraction& form, std::uint32_t own);
  /// above / below. Each term of `above` is reduced by the powers that it shares with `below`.
  [[nodiscard]] TextbookSum arrange_quotient(const Fraction& above, const Fraction& below);
  /// True if the form is written as a single product without brackets.
  [[nodiscard]] bool is_one_product(const Fraction& form);

 private:
  /// A sum with real sines and cosines.
  using RealTermSum = std::vector<RealTerm>;

  /// front * rest.
  struct SplitSum {
    TextbookProduct front;
    Polynomial rest = {};
  };

  [[nodiscard]] SplitSum split_sum(Polynomial sum);
  void take_monomial(Polynomial& sum, TextbookProduct& front) const;
  bool take_typed_sums(Polynomial& sum, TextbookProduct& front);
  void take_square(SplitSum& split);
  bool take_coefficient(SplitSum& split);
  [[nodiscard]] TextbookFactor typed_factor(std::size_t typed);

  [[nodiscard]] TextbookSum product_with_typed_sum(const Fraction& form);
  [[nodiscard]] TextbookProduct book_product(const Polynomial& sum);
  [[nodiscard]] TextbookProduct book_product(const SplitSum& split);
  [[nodiscard]] TextbookProduct book_product(const Fraction& form);
  void divide(TextbookProduct& product, const Fraction& form);
  void divide(TextbookProduct& product, const Polynomial& factor, std::int32_t exponent);

  [[nodiscard]] TextbookSum arrange_fraction_parts(const Fraction& form,
                                                   std::optional<std::uint32_t> own = {});
  [[nodiscard]] TextbookSum arrange_terms(const Polynomial& sum,
                                          std::optional<std::uint32_t> own = {});
  [[nodiscard]] TextbookSum arrange_rateless_terms(const Polynomial& sum);
  [[nodiscard]] RealTermSum real_term_sum(const Polynomial& sum);
  [[nodiscard]] const TextbookSum& collected_sum(const RealTermSum& sum);
  [[nodiscard]] TextbookSum collect_terms(const RealTermSum& sum);
  [[nodiscard]] TextbookProduct shared_powers(const RealTermSum& sum) const;
  [[nodiscard]] TextbookSum group_by_coordinates(const RealTermSum& sum);
  [[nodiscard]] std::optional<TextbookSum> collect_by_parameter(const RealTermSum& sum);
  [[nodiscard]] TextbookProduct book_product(RealTermSum sum);
  [[nodiscard]] TextbookProduct book_product(const RealTerm& term) const;

  void multiply(TextbookProduct& product, const Monomial& powers) const;
  void multiply(TextbookProduct& product, TextbookSum sum, std::int32_t exponent) const;
  void multiply_by_sum(TextbookProduct& product, TextbookSum sum) const;
  [[nodiscard]] FactorPlace place_of_sum(const TextbookSum& sum, std::uint32_t rank) const;
  [[nodiscard]] TextbookFactor atom_factor(const AtomPower& power) const;

  const Algebra& algebra_;
  const TypedForms& typed_;
  std::size_t first_typed_ = 0;   ///< index in typed_.sums of the first sum to try
  std::size_t work_ = 1'000'000;  ///< budget of term products for divisions
  /// Memoised by index in typed_.sums, because nested sums recur.
  std::shared_ptr<std::map<std::size_t, TextbookFactor>> typed_factors_ =
      std::make_shared<std::map<std::size_t, TextbookFactor>>();
  std::map<RealTermSum, TextbookSum> collected_ = {};  ///< memoised
};

}  // namespace elgen
