// Loss: how many digits a formula loses, for one function at one state.
//
//     loss = max(0, |x - x*| - N eta) / (u R),     R = |x*| + K
//
// x is an entry, x* its exact value, u the unit roundoff, N the number of operations, eta the
// smallest denormal. K = sum |z dx/dz| over all inputs z (accuracy/conditioning.hpp): u K is the
// error of x if every input is rounded once. Example: a double near 1e15 rad is exact to 0.1 rad
// only, so errors of its sine count as no loss. For solutions of M x = b, errors and R are measured
// in the norm |D^1/2 x|, D the diagonal of M. K and the norm are computed only if
// |x - x*| > 2 u |x*|, for at most 16 entries of a field. Otherwise R = |x*|, which never gives a
// smaller loss. If R is exactly 0, no loss is reported.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "accuracy/conditioning.hpp"
#include "verify/bounds/exact_run.hpp"
#include "verify/bounds/field_place.hpp"
#include "verify/bounds/oracle_cache.hpp"

namespace elgen {

/// Entries of a solution x of M x = b that share one loss, measured in the norm |D^1/2 x|, D the
/// diagonal of M. In this norm, errors of a small entry do not matter if the column has large
/// entries. Constrained equations are M a = b + A^T y, A a = c; the weights of the multipliers y
/// are the lengths of the rows of A D^-1/2.
struct SolvedColumn {
  std::vector<std::size_t> entries = {};  ///< indices in the field
  std::vector<Real> weights = {};         ///< one weight per entry
};

/// The columns of a field; empty if the field is not a solution, or if an entry of the diagonal of
/// M is not positive. Cost: OracleCache::diagonal_of_mass().
[[nodiscard]] std::vector<SolvedColumn> solved_columns(const ComparedField& place,
                                                       OracleCache& oracle);

/// sqrt(sum (w_i x_i)^2) of a column.
[[nodiscard]] Real weighted_norm(const SolvedColumn& column, const std::vector<Real>& values);

struct LostEntry {
  double loss = 0;
  std::size_t entry = 0;  ///< index in the field
};

/// The largest losses of a field.
struct Loss {
  LostEntry relative_to_entry = {};  ///< relative to u R of the entry
  LostEntry relative_to_field = {};  ///< relative to u times the largest entry of the field
  std::size_t entries_without_reference = 0;  ///< number of entries that have an error, but R = 0
};

class LossMeter {
 public:
  /// The arguments must outlive this object. Losses smaller than `least` are not computed.
  LossMeter(const SystemUnderTest& subject, OracleCache& oracle,
            const RoundingConstants<Real>& rounding, double least = 0);

  /// True if rounding changes no angle by more than 1/1000 rad. Otherwise K, a first-order
  /// estimate, is invalid.
  [[nodiscard]] bool has_accurate_angles() const;

  /// The losses of a field in `run`, an exact run of place.function. `exact`: the exact entries;
  /// `errors`: their differences from the rounded entries, without N eta. The loss is 0 if K is
  /// undefined.
  [[nodiscard]] Loss field_loss(const ComparedField& place, const ExactRun& run,
                                const std::vector<Real>& errors, const std::vector<Real>& exact);

 private:
  /// Entries that share one loss: a single entry, or a solved column.
  struct LossGroup {
    SolvedColumn column = {};
    double max_loss = 0;    ///< upper bound of the loss, because R >= |x*|
    std::size_t entry = 0;  ///< index of the entry whose bound is `max_loss`
  };

  [[nodiscard]] std::vector<LossGroup> group_entries(const ComparedField& place,
                                                     const std::vector<Real>& errors,
                                                     const std::vector<Real>& exact);
  [[nodiscard]] std::optional<double> group_loss(const ComparedField& place, const ExactRun& run,
                                                 const LossGroup& group,
                                                 const std::vector<Real>& errors,
                                                 const std::vector<Real>& exact);
  [[nodiscard]] Real conditioning(const ComparedField& place, const ExactRun& run,
                                  std::size_t entry);
  [[nodiscard]] LostEntry loss_of_largest_entry(const std::vector<Real>& errors,
                                                const std::vector<Real>& exact) const;

  const SystemUnderTest& subject_;
  OracleCache& oracle_;
  const RoundingConstants<Real>& rounding_;
  double min_loss_;
  std::vector<bool> depends_on_fixed_;  ///< marks program constants that depend on fixed parameters
  std::map<const Function*, std::unique_ptr<Conditioning>> conditioning_ = {};
};

}  // namespace elgen
