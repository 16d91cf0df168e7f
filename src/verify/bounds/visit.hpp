// StateCheck: compares a program with the oracle at one state, field by field. The exact values
// must equal the oracle's, which checks the mathematics. The rounded values must be finite; the
// digits that they lose are only reported. Code as users compile it may round differently, within
// the running error E of the program.
#pragma once

#include <array>
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

/// The bound for code as users compile it. Program and code both round once for each rounding in E:
///
///     |x_users - x| <= 16 u E + N eta
///
/// N is the number of operations, eta the smallest denormal. The factor 16 allows for library
/// functions with errors up to 4 u.
inline constexpr double max_user_code_error = 16;

/// The bound for code that computes in a wider scalar; u' is half the epsilon of the wider scalar.
/// Each rounding in E has the error u'; at the end, the result is rounded to the scalar, error u:
///
///     |x_wide - x*| <= u |x*| + 16 u' E + N eta
///
/// The figure is the left side, less N eta, divided by u |x*| + 16 u' E. For a step of length h
/// whose accelerations are in float, the bound is
///
///     |x_wide - x*| <= u |x*| + 16 u (E - |x*|) + N eta,     u E = u |x*| + h u' E_a + ...
///
/// E is the error of run_mixed_exactly(), E_a the running error of the accelerations; u |x*| is the
/// rounding of the last sum. If E is 0, as for h = 0, x_wide must be x*.
inline constexpr double max_wide_code_error = 1;

/// How exact values are compared with the oracle's.
enum class ComparisonMode : std::uint8_t {
  entries,      ///< each entry
  projections,  ///< one random contraction per field, as cheap as a few evaluations of the energies
};

/// The error of compiled code, in the unit of its check.
struct CodeFinding {
  std::optional<double> error = {};  ///< the largest of all entries; none: no such code
  std::string mistake = {};          ///< an entry whose error exceeds the bound
};

/// The result of one field at one state.
struct Finding {
  Regime regime = Regime::regular;  ///< of the program; undefined if the oracle has no value
  bool is_compared = false;         ///< the exact values were compared with the oracle's
  bool is_finite = true;            ///< all rounded values are finite
  std::string mistake = {};  ///< an exact value differs from the oracle's, or a value is not finite
  std::vector<double> errors = {};  ///< of non-zero entries, in ulp; for remainders in u E
  std::optional<Loss> loss = {};    ///< none if it is not measured or not defined
  CodeFinding user_code = {};       ///< |x_users - x| in u E
  CodeFinding wide_code = {};       ///< |x_wide - x*| / (u |x*| + 16 u' E)
};

/// The states at which losses are measured.
enum class LossStates : std::uint8_t { nowhere, inside_ranges, everywhere };

struct StateCheckOptions {
  ComparisonMode comparison = ComparisonMode::entries;
  LossStates loss_states = LossStates::nowhere;  ///< states at which losses are measured
  double min_loss = 0;  ///< losses below this are not computed, because R is costly
  const CompiledModel* user_code = nullptr;       ///< code as users compile it; may be null
  const CompiledModel* wide_code = nullptr;       ///< code in Numerics::inner; may be null
  const CompiledModel* wide_pack_code = nullptr;  ///< the same in packs; may be null
};

/// The entries of code in Numerics::inner. They are empty if there is no such code, or if the inner
/// scalar is float and some value is undefined, too large, too small or ill-conditioned.
template <class Scalar>
struct WideRun {
  std::vector<Scalar> values = {};
  std::vector<RunningValue<Real>> mixed_entries = {};  ///< if the inner scalar is float
};

/// Compares the fields of a program at one state. Scalar: double or float.
template <class Scalar>
class StateCheck {
 public:
  /// The arguments must outlive this object.
  StateCheck(const SystemUnderTest& subject, const SampledState<Scalar>& sample,
             const StateCheckOptions& options);

  [[nodiscard]] const State& state() const { return oracle_.state(); }

  /// Compares one field. `draw` gives the directions of projections. Consecutive fields of one
  /// function share a run. If exact values differ, program and oracle run again with twice the
  /// digits, up to 1024, or 256 with irrational constants. A difference that two such runs confirm
  /// is a mistake; a difference that no run decides has the regime `unsettled`.
  [[nodiscard]] Finding check_field(const ComparedField& place, Sampler& draw);

 private:
  /// A finding, and for a mistake the two numbers that differ.
  struct FieldComparison {
    Finding finding = {};
    Mismatch mismatch = {};
  };

  [[nodiscard]] FieldComparison compare_field(const ComparedField& place, Sampler& draw);
  void run_function(const ComparedField& place);
  /// The exact run of the function, memoised.
  const ExactRun& exact_run_of(const Function& function);
  [[nodiscard]] Mismatch compare_entries(const ComparedField& place, Finding& finding);
  [[nodiscard]] Mismatch compare_by_projection(const ComparedField& place, Sampler& draw);
  /// Compares with the entries first, first + 1, ... of another function, called `name` in texts.
  [[nodiscard]] Mismatch compare_with_function(const ComparedField& place, const Function& other,
                                               std::size_t first, std::string_view name);
  [[nodiscard]] bool has_finite_values(const ComparedField& place) const;
  void measure_errors(const ComparedField& place, Finding& finding) const;
  /// The largest error of `values` in u s, and an entry with an error above `max_error`.
  /// `reference_of(i)` returns the reference value of entry i, and the scale s of its error.
  template <class Reference>
  [[nodiscard]] CodeFinding compare_code(const ComparedField& place,
                                         const std::vector<Scalar>& values, double max_error,
                                         const Reference& reference_of) const;
  [[nodiscard]] CodeFinding compare_user_code(const ComparedField& place) const;
  [[nodiscard]] WideRun<Scalar> run_wide_code(const CompiledModel* code,
                                              const Numerics* packs) const;
  [[nodiscard]] CodeFinding compare_wide_code(const ComparedField& place,
                                              const WideRun<Scalar>& run) const;
  /// The loss of a field; none if an entry has no exact value.
  [[nodiscard]] std::optional<Loss> measure_loss(const ComparedField& place);
  [[nodiscard]] bool should_measure_loss(const ComparedField& place) const;

  /// Entry i of the field, in 64 digits.
  [[nodiscard]] const RunningValue<Real>& exact_entry(const ComparedField& place,
                                                      std::size_t i) const {
    return exact_->entries[place.first_entry + i];
  }

  const SystemUnderTest& subject_;
  const SampledState<Scalar>& sample_;
  StateCheckOptions options_;
  SineEvaluator<Scalar> sines_;  ///< with the algorithm of the emitted code
  OracleCache oracle_;
  LossMeter losses_;
  std::map<const Function*, ExactRun> exact_runs_ = {};
  const Function* function_ = nullptr;  ///< of the latest run
  const ExactRun* exact_ = nullptr;
  std::vector<Scalar> values_ = {};
  std::vector<Scalar> user_code_values_ = {};      ///< of the code as users compile it
  std::array<WideRun<Scalar>, 2> wide_runs_ = {};  ///< of single states and of packs
};

/// The cost of a state, in instructions: the instructions of the program, plus the oracle's exact
/// solution of constrained equations.
[[nodiscard]] std::size_t state_check_cost(const SystemUnderTest& subject);

}  // namespace elgen
