// Loss: the digits that a formula loses, of one function at one state.
//
//     loss = max(0, |x - x*| - N eta) / (u R),     R = |x*| + K
//
// K = sum |z dx/dz| (accuracy/conditioning.hpp) is the error from rounding every input once. So an
// angle of 1e15 rad, which is known to 0.1 rad, excuses errors of its sine. For solutions of
// M x = b, errors and R are measured in the norm |D^1/2 x|. K and the norm are computed only if
// |x - x*| > 2 u |x*|, for at most 16 entries of a field. Otherwise R = |x*|, which gives no
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

/// Entries of a solution x of M x = b that share one loss, in the norm |D^1/2 x|, D the diagonal of
/// M: next to large entries a small one has no digits of importance. Constrained equations are
/// M a = b + A^T y, A a = c. The weights of their multipliers y are the lengths of the rows of
/// A D^-1/2.
struct SolvedColumn {
  std::vector<std::size_t> entries = {};  ///< indices in the field
  std::vector<Real> weights = {};         ///< one weight per entry
};

/// The columns of a field; empty if it is no solution, or if the diagonal of M is not positive.
/// Cost: n contractions of M.
[[nodiscard]] std::vector<SolvedColumn> solved_columns(const FieldPlace& place,
                                                       OracleCache& oracle);

/// sqrt(sum (w_i x_i)^2) of a column.
[[nodiscard]] Real norm(const SolvedColumn& column, const std::vector<Real>& values);

struct LostEntry {
  double figure = 0;
  std::size_t entry = 0;  ///< index in the field
};

/// The largest losses of a field.
struct Loss {
  LostEntry of_entry = {};            ///< in u R of the entry
  LostEntry of_field = {};            ///< in u of the largest entry
  std::size_t without_reference = 0;  ///< entries with an error but R = 0
};

class Losses {
 public:
  /// All arguments must outlive this. Losses of entries below `least` are not computed.
  Losses(const Subject& subject, OracleCache& oracle, const Rounding<Real>& rounding,
         double least = 0);

  /// True if angles are known to 1/1000 rad: K is of first order and needs that.
  [[nodiscard]] bool knows_angles() const;

  /// The losses of a field whose entries differ by `errors` (without N eta) from `exact`, in a run
  /// of the place's function. 0 if K has no value.
  [[nodiscard]] Loss of_field(const FieldPlace& place, const ExactRun& run,
                              const std::vector<Real>& errors, const std::vector<Real>& exact);

 private:
  /// Entries with one loss: a single entry, or a solved column.
  struct Group {
    SolvedColumn column = {};
    double most = 0;        ///< upper bound of the loss, because R >= |x*|
    std::size_t entry = 0;  ///< the entry with this bound
  };

  [[nodiscard]] std::vector<Group> groups(const FieldPlace& place, const std::vector<Real>& errors,
                                          const std::vector<Real>& exact);
  [[nodiscard]] std::optional<double> figure_of(const FieldPlace& place, const ExactRun& run,
                                                const Group& group, const std::vector<Real>& errors,
                                                const std::vector<Real>& exact);
  [[nodiscard]] Real conditioning(const FieldPlace& place, const ExactRun& run, std::size_t entry);
  [[nodiscard]] LostEntry of_largest(const std::vector<Real>& errors,
                                     const std::vector<Real>& exact) const;

  const Subject& subject_;
  OracleCache& oracle_;
  const Rounding<Real>& rounding_;
  double least_;
  std::vector<bool> fixed_;  ///< marks program constants from fixed parameters
  std::map<const Function*, std::unique_ptr<Conditioning>> conditioning_ = {};
};

}  // namespace elgen
