// Visit: a program at one state, field by field. Its exact values must be the oracle's: the
// mathematics is right. Its rounded ones must be numbers; the digits that they lose are a figure.
// The code as users compile it may round otherwise, within the running error E of the program.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "elgen/toolchain.hpp"
#include "program/evaluate/sines.hpp"
#include "sample/points.hpp"
#include "sample/states.hpp"
#include "verify/bounds/field_place.hpp"
#include "verify/bounds/loss.hpp"
#include "verify/bounds/oracle_cache.hpp"

namespace elgen {

/// The code as users compile it and the program each round once where E counts a rounding:
///
///     |x_users - x| <= 16 u E + N eta
///
/// N operations, eta the smallest denormal. Functions of a library are off by up to 4 u.
inline constexpr double most_of_users = 16;

/// Code in a wider scalar, of which u' is half the epsilon, rounds once to the scalar; before that
/// its roundings are those of E:
///
///     |x_wide - x*| <= u |x*| + 16 u' E + N eta
///
/// The figure is the quotient of both sides, without N eta.
inline constexpr double most_of_wide = 1;

/// How exact values are compared with the oracle's.
enum class Comparison : std::uint8_t {
  entries,      ///< each of them
  projections,  ///< one random contraction of a field, at the cost of a few evaluations of energies
};

/// How far compiled code is off, in the units of its check.
struct CodeFinding {
  std::optional<double> error = {};  ///< the largest of the entries, where there is such code
  std::string mistake = {};          ///< an entry that is further off than the check allows
};

/// The result of one state for one field.
struct Finding {
  Regime regime = Regime::regular;  ///< of the program, or of the oracle where that has no value
  bool is_compared = false;         ///< exact values with the oracle's
  bool is_finite = true;            ///< all rounded values
  std::string mistake = {};         ///< an exact value that is not the oracle's, or no number
  std::vector<double> errors = {};  ///< of entries that are not 0, in ulp; of remainders in u E
  std::optional<Loss> loss = {};    ///< none where it is not asked for, or cannot be told
  CodeFinding users = {};           ///< |x_users - x| in u E
  CodeFinding wide = {};            ///< |x_wide - x*| / (u |x*| + 16 u' E)
};

/// The states at which losses are measured.
enum class Losing : std::uint8_t { nowhere, inside_ranges, everywhere };

/// The options of a visit.
struct VisitOptions {
  Comparison comparison = Comparison::entries;
  Losing losing = Losing::nowhere;          ///< where losses are looked at
  double least_loss = 0;                    ///< no smaller one is told, for R takes time
  const CompiledModel* as_users = nullptr;  ///< compared with the program; has the scalar
  const CompiledModel* wide = nullptr;      ///< compared with exact values; has the scalar
};

/// Scalar: double or float.
template <class Scalar>
class Visit {
 public:
  /// All that is referred to outlives the visit.
  Visit(const Subject& subject, const SampledState<Scalar>& sample, const VisitOptions& options);

  [[nodiscard]] const State& state() const { return oracle_.state(); }

  /// `draw` gives the directions of projections. Fields of one function one after another cost
  /// one run of it. Where exact values differ, program and oracle are run again with twice the
  /// digits, up to 1000: a mistake is what two looks say alike, unsettled where none does.
  [[nodiscard]] Finding look_at(const FieldPlace& place, Sampler& draw);

 private:
  /// A finding, and the two numbers that differ where it is a mistake.
  struct Look {
    Finding finding = {};
    Mismatch mismatch = {};
  };

  [[nodiscard]] Look found(const FieldPlace& place, Sampler& draw);
  void run(const FieldPlace& place);
  /// Exact runs, each made once.
  const ExactRun& exact_run_of(const Function& function);
  [[nodiscard]] Mismatch differing_entry(const FieldPlace& place, Finding& finding);
  [[nodiscard]] Mismatch differing_projection(const FieldPlace& place, Sampler& draw);
  /// Against the entries from `first` on that another function has.
  [[nodiscard]] Mismatch differing_from(const FieldPlace& place, const Function& other,
                                        std::size_t first, std::string_view name);
  [[nodiscard]] bool has_finite_values(const FieldPlace& place) const;
  void measure(const FieldPlace& place, Finding& finding) const;
  /// `judge`: what entry i has to be, and the size that its error is measured in, times u.
  template <class Judge>
  [[nodiscard]] CodeFinding judged(const FieldPlace& place, const std::vector<Scalar>& values,
                                   double most, const Judge& judge) const;
  [[nodiscard]] CodeFinding judged_users(const FieldPlace& place) const;
  [[nodiscard]] CodeFinding judged_wide(const FieldPlace& place) const;
  /// Whether the inner scalar has all numbers on the way; sets the errors that it makes of them.
  bool suits_inner();
  /// None where an entry has no exact value.
  [[nodiscard]] std::optional<Loss> measured_loss(const FieldPlace& place);
  [[nodiscard]] bool may_lose(const FieldPlace& place) const;

  /// Entry i of the field, in 64 digits.
  [[nodiscard]] const Running<Real>& exact(const FieldPlace& place, std::size_t i) const {
    return exact_->entries[place.first + i];
  }

  const Subject& subject_;
  const SampledState<Scalar>& sample_;
  VisitOptions options_;
  Sines<Scalar> sines_;  ///< as code has them
  OracleCache oracle_;
  Losses losses_;
  std::map<const Function*, ExactRun> exact_runs_ = {};
  const Function* function_ = nullptr;  ///< of the following runs
  const ExactRun* exact_ = nullptr;
  std::vector<Scalar> values_ = {};
  std::vector<Scalar> users_values_ = {};  ///< of the code as users compile it
  std::vector<Scalar> wide_values_ = {};   ///< of code in a wider scalar; empty where it lacks it
  std::vector<Running<Real>> in_float_ = {};  ///< the entries, where the inner scalar is float
};

/// The work of a state: instructions, and the oracle's exact solution of constrained equations.
[[nodiscard]] std::size_t work_of_state(const Subject& subject);

}  // namespace elgen
