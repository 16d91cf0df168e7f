// Loss: the digits that a formula loses, of one function at one state.
//
//     loss = max(0, |x - x*| - N eta) / (u R),     R = |x*| + K
//
// K = sum |z dx/dz| (accuracy/conditioning.hpp) is what one rounding of every input would cost, so
// that an angle of 1e15 rad, which is known to a tenth, excuses what is made of it. In solutions of
// M x = b the norm |D^1/2 x| is taken of errors and of R alike. Both are looked at only where |x -
// x*| > 2 u |x*|, and at 16 entries of a field; elsewhere |x*| stands for R, and the loss is no
// less than it would be. Where R is 0 on paper, nothing is told.
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

/// The entries of solutions x of M x = b that lose digits together, as one number: in the norm
/// |D^1/2 x|, D the diagonal of M. A small entry beside large ones has no digits of its own. Under
/// constraints M a = b + A^T y, A a = c, multipliers y have the lengths of the rows of A D^-1/2 for
/// D^1/2.
struct SolvedColumn {
  std::vector<std::size_t> entries = {};  ///< of the field
  std::vector<Real> weights = {};         ///< one for each of them
};

/// The columns of a field; empty where nothing is solved for, or M has a diagonal that is not
/// positive. Cost: n contractions of M.
[[nodiscard]] std::vector<SolvedColumn> solved_columns(const FieldPlace& place,
                                                       OracleCache& oracle);

/// sqrt(sum (w_i x_i)^2) of a column.
[[nodiscard]] Real norm(const SolvedColumn& column, const std::vector<Real>& values);

struct LostEntry {
  double figure = 0;
  std::size_t entry = 0;  ///< of the field
};

/// The entries that lose most.
struct Loss {
  LostEntry of_entry = {};  ///< in u R of its own
  LostEntry of_field = {};  ///< in u of the largest entry
  std::size_t untold = 0;   ///< entries that are off while R is 0
};

class Losses {
 public:
  /// All arguments outlive it. No loss of an entry below `least` is told.
  Losses(const Subject& subject, OracleCache& oracle, const Rounding<Real>& rounding,
         double least = 0);

  /// Whether angles are known well enough for K, which is of first order: to 1/1000 rad.
  [[nodiscard]] bool knows_angles() const;

  /// The loss of entries that are off by `errors` (without N eta) from `exact`, in a run of the
  /// place's function. 0 where K has no value.
  [[nodiscard]] Loss of_field(const FieldPlace& place, const ExactRun& run,
                              const std::vector<Real>& errors, const std::vector<Real>& exact);

 private:
  /// Entries that are judged together: one alone, or a solved column.
  struct Group {
    SolvedColumn column = {};
    double most = 0;        ///< what it may lose, as R is no less than |x*|
    std::size_t entry = 0;  ///< that of `most`
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
  std::vector<bool> fixed_;  ///< of the program's constants, those that fixed parameters have left
  std::map<const Function*, std::unique_ptr<Conditioning>> conditioning_ = {};
};

}  // namespace elgen
