// Loss: the digits that a formula loses, of one function at one state.
//
//     loss = max(0, |x - x*| - N eta) / (u R),     R = |x*| + K
//
// Where x* is 0 on paper the largest |x*| of the field takes its place in R, as errors are noise
// beside it.
// K = sum |z dx/dz| (accuracy/conditioning.hpp) is what one rounding of every input would cost, so
// that an angle of 1e15 rad, which is known to a tenth, excuses what is made of it. In solutions of
// M x = b the norm |D^1/2 x| is taken of errors and of R alike. It is looked at only where |x - x*|
// > 64 u |x*|; elsewhere it is less.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "accuracy/conditioning.hpp"
#include "accuracy/running_errors.hpp"
#include "verify/bounds/field_place.hpp"
#include "verify/bounds/solution_bound.hpp"

namespace elgen {

struct LostEntry {
  double figure = 0;
  std::size_t entry = 0;  ///< of the field
};

/// The entries that lose most.
struct Loss {
  LostEntry of_entry = {};  ///< in u R of its own
  LostEntry of_field = {};  ///< in u of the largest entry
};

class Losses {
 public:
  /// All arguments outlive it.
  Losses(const Subject& subject, const State& state, const Rounding& rounding);

  /// Whether angles are known well enough for K, which is of first order: to 1/1000 rad.
  [[nodiscard]] bool knows_angles() const;

  /// Of entries that are off by `errors` (without N eta) from `exact`; those of `columns` are
  /// judged by their norms. 0 where K has no value.
  [[nodiscard]] Loss of_field(const FieldPlace& place, const std::vector<Real>& errors,
                              const std::vector<Real>& exact,
                              const std::vector<SolvedColumn>& columns);

 private:
  const std::vector<Running>& errors(const Function& function);
  Real conditioning(const FieldPlace& place, std::size_t entry);
  [[nodiscard]] double of_entry(const FieldPlace& place, std::size_t entry,
                                const std::vector<Real>& errors, const std::vector<Real>& scales,
                                const std::vector<SolvedColumn>& columns);
  [[nodiscard]] LostEntry of_largest(const std::vector<Real>& errors,
                                     const std::vector<Real>& scales) const;
  Real norm_of_references(const FieldPlace& place, const SolvedColumn& column,
                          std::vector<Real> scales);

  const Subject& subject_;
  const State& state_;
  const Rounding& rounding_;
  std::vector<bool> fixed_;  ///< of the program's constants, those that fixed parameters have left
  std::map<const Function*, std::vector<Running>> errors_ = {};  ///< of all instructions
  std::map<const Function*, std::unique_ptr<Conditioning>> conditioning_ = {};
};

}  // namespace elgen
