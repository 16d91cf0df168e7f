// Visit: a program at one state, field by field. Its exact values must be the oracle's (the
// mathematics is right); its rounded ones are measured by 8 u B.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "elgen/toolchain.hpp"
#include "numbers/random.hpp"
#include "sample/states.hpp"
#include "verify/bounds/field_place.hpp"
#include "verify/bounds/loss.hpp"
#include "verify/bounds/oracle_cache.hpp"
#include "verify/bounds/solution_bound.hpp"

namespace elgen {

/// The promise: |x - x*| <= 8 u B + N eta, u half the scalar's epsilon, eta its smallest denormal,
/// N operations.
inline constexpr double promised_bounds = 8;

/// How exact values are compared with the oracle's.
enum class Comparison : std::uint8_t {
  entries,      ///< each of them
  projections,  ///< one random contraction of a field, at the cost of a few evaluations of energies
};

/// The result of one state for one field.
struct Finding {
  /// Of the program and its judge together; regular too where a norm bounds what they do not.
  Regime regime = Regime::regular;
  std::string mistake = {};                ///< an exact value that is not the oracle's
  std::optional<double> error = {};        ///< largest, in u B; none where nothing bounds it
  bool in_norm = false;                    ///< that of solutions, not of entries
  std::string imprecision = {};            ///< the entry of an error that breaks the promise
  double cancellation = 0;                 ///< largest B/|x|
  std::vector<double> ulps = {};           ///< of entries that are not 0
  std::optional<Loss> loss = {};           ///< none where it is not asked for, or cannot be told
  std::optional<double> users_error = {};  ///< of the code as users compile it, where there is one
  std::string users_imprecision = {};
};

/// The states at which losses are measured.
enum class Losing : std::uint8_t { nowhere, inside_ranges, everywhere };

/// How a program is looked at.
struct VisitOptions {
  Comparison comparison = Comparison::entries;
  const Program* parts = nullptr;           ///< of SolutionBounds
  Losing losing = Losing::nowhere;          ///< where losses are looked at
  const CompiledModel* as_users = nullptr;  ///< measured by the same bounds; has the scalar
};

/// Scalar: double or float.
template <class Scalar>
class Visit {
 public:
  /// All that is referred to outlives the visit.
  Visit(const Subject& subject, const SampledState<Scalar>& sample, const VisitOptions& options);

  [[nodiscard]] const State& state() const { return oracle_.state(); }

  /// `random` gives the directions of projections. Fields of one function one after another cost
  /// one run of it. Where exact values differ, program and oracle are run again with twice the
  /// digits, up to 1000: a mistake is what two looks say alike, unsettled where none does.
  [[nodiscard]] Finding look_at(const FieldPlace& place, Random& random);

 private:
  /// Bounds of the field's entries by whoever judges them.
  struct Judged {
    Regime regime = Regime::regular;
    std::vector<Bound> entries = {};         ///< of the field
    std::vector<SolvedColumn> columns = {};  ///< where norms judge
  };

  [[nodiscard]] Finding found(const FieldPlace& place, Random& random);
  void run(const FieldPlace& place);
  [[nodiscard]] Judged judged(const FieldPlace& place);
  [[nodiscard]] Mismatch differing_entry(const FieldPlace& place, const Judged& judged,
                                         Finding& finding);
  /// Whether all entries of the field have exact values.
  [[nodiscard]] bool is_defined(const FieldPlace& place) const;
  [[nodiscard]] Mismatch differing_projection(const FieldPlace& place, const Judged& judged,
                                              Random& random);
  [[nodiscard]] Mismatch differing_from(const FieldPlace& place, const std::vector<Bound>& others,
                                        std::string_view of) const;
  void measure(const FieldPlace& place, const Judged& judged, Finding& finding) const;
  void measure_users(const FieldPlace& place, const Judged& judged, Finding& finding);
  /// Errors of a field, without N eta, and its exact entries.
  struct Deviations {
    std::vector<Real> errors = {};
    std::vector<Real> exact = {};
  };
  /// None where an entry has no exact value.
  [[nodiscard]] std::optional<Deviations> deviations(const FieldPlace& place, const Judged& judged,
                                                     std::span<const Scalar> values,
                                                     std::size_t operations) const;
  [[nodiscard]] std::optional<Loss> measured_loss(const FieldPlace& place, const Judged& judged);
  void add_error(const FieldPlace& place, std::size_t entry, double error, Finding& finding) const;
  [[nodiscard]] double error_in_norm(const FieldPlace& place, const SolvedColumn& column) const;
  [[nodiscard]] std::optional<double> error_of(const FieldPlace& place,
                                               const SolvedColumn& column) const;

  const Subject& subject_;
  const SampledState<Scalar>& sample_;
  VisitOptions options_;
  OracleCache oracle_;
  SolutionBounds solutions_;
  Losses losses_;
  const Function* function_ = nullptr;  ///< of the following runs
  BoundedRun exact_ = {};
  std::vector<Scalar> values_ = {};
  std::vector<Scalar> users_values_ = {};  ///< of the code as users compile it
  Mismatch mismatch_ = {};                 ///< of the last field
  const Function* judge_ = nullptr;
  BoundedRun judge_run_ = {};
  std::map<std::string, std::vector<Bound>> known_ = {};  ///< entries of functions of one field
};

/// The work of a state: instructions, and the oracle's exact solution of constrained equations.
[[nodiscard]] std::size_t work_of_state(const Subject& subject);

}  // namespace elgen
