// Certificate: one row per check, with the compared values, the worst state and the reason for the
// tolerance.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "elgen/analyse.hpp"
#include "elgen/closed_forms.hpp"
#include "elgen/diagnostic.hpp"
#include "elgen/emitted_files.hpp"
#include "elgen/model.hpp"
#include "elgen/program.hpp"
#include "elgen/scene.hpp"
#include "elgen/toolchain.hpp"

namespace elgen {

enum class Verdict : std::uint8_t {
  holds,
  fails,
  skipped,
  noted,  ///< more than half of the digits are lost, or no state was on one side of a kink
};

/// Why a state is skipped.
enum class Obstacle : std::uint8_t {
  overflow,   ///< an exact intermediate is near the scalar's largest number
  undefined,  ///< outside the domain: 1/0, sqrt(-1)
  singular,   ///< M is singular: a pole, a gimbal
  unsettled,  ///< 1000 digits do not decide whether program and oracle agree: 1 - cos(1e-300)
  unmet,      ///< Newton's method does not put the state onto the constraints
};

/// The evidence for a row.
enum class Evidence : std::uint8_t {
  states,   ///< a comparison at `samples` states
  proof,    ///< equal canonical forms, for every state
  zeros,    ///< entries replaced by 0 are below rounding at `samples` random points
  numbers,  ///< `samples` numbers in the files, compared exactly
};

struct SkippedStates {
  Obstacle obstacle = Obstacle::overflow;
  std::size_t states = 0;
  friend bool operator==(const SkippedStates&, const SkippedStates&) = default;
};

struct CertificateRow {
  std::string check = {};   ///< "program vs oracle", "mass matrix symmetric", "[[expect]]"
  std::string output = {};  ///< the function; "[[expect]] gravity"
  /// Part of the output: "forward_dynamics.acceleration (float)", "gravity[2]"
  std::string subject = {};
  std::string formula = {};  ///< the evaluated formula
  Evidence evidence = Evidence::states;
  std::size_t samples = 0;                   ///< states at which values were compared
  std::vector<SkippedStates> skipped = {};   ///< states that were skipped
  std::size_t skipped_inside = 0;            ///< skipped states in double inside the ranges
  std::optional<double> loss = {};           ///< largest, in u R; at most 10^digits of the scalar
  std::optional<double> loss_of_field = {};  ///< largest, in u times the largest entry of the field
  std::string worst = {};                    ///< the figure, or why nothing was compared
  std::string where = {};      ///< the state of the worst value; empty without samples
  std::string tolerance = {};  ///< the bound and its reason
  Verdict verdict = Verdict::holds;
  std::vector<std::string> findings = {};  ///< about foreign code with wrong values
};

struct Certificate {
  std::string model;
  std::string scene;
  std::uint64_t seed = 0;
  std::vector<CertificateRow> rows = {};
};

struct VerifyOptions {
  /// Random states per output, and at most 64 of them again near zeros of typed sums. None: 256,
  /// fewer for long programs.
  std::optional<std::size_t> samples = {};
  /// Check 16 random states and all extremes, fewer for long programs; one contraction per output
  /// instead of all entries; no compiled code.
  bool quick = false;
  std::uint64_t seed = 1;
  std::size_t jobs = 1;  ///< processes that share the states; the certificate does not depend on it
  /// Closed forms to prove [[expect]] with, parallel to the functions of the program. If they are
  /// null or do not decide, samples decide.
  ClosedForms* forms = nullptr;
  /// Also measure lost digits outside the declared ranges. Default: inside, and near zeros of typed
  /// sums.
  bool extremes = false;
  /// The verdicts on every [[equilibrium]]; may be null.
  const std::vector<EquilibriumVerdict>* claims = nullptr;
  /// Is called with each step: "accuracy in double, state 3 of 36".
  std::function<void(const std::string&)> on_step = {};
};

/// Compares oracle, program and compiled code, and checks the structure of M, C and the energies.
/// `compiled` may be empty (quick); its rows are absent then. Headers of Build::as_users have to
/// agree with the program within its running errors, all other headers in every bit. Rounding fails
/// no check: lost digits are only reported. A value fails if it is NaN or infinite although exact
/// arithmetic stays inside the range of the scalar. Diagnostics: each wrong [[expect]] with a
/// witness state.
struct Verification {
  Certificate certificate;
  Diagnostics diagnostics;
};
[[nodiscard]] Verification verify(const Model& model, const Scene& scene, const Program& program,
                                  const CompiledHeaders& compiled, const VerifyOptions& options);

[[nodiscard]] std::size_t count(const Certificate& certificate, Verdict verdict);
[[nodiscard]] bool holds(const Certificate& certificate);

/// "cart_pole, scene balance: 41 checks hold, 0 fail, 2 skipped"; ", 1 noted" if a row is noted.
[[nodiscard]] std::string verdict_line(const Certificate& certificate);
/// One line per output, every failed or skipped row in full, and the verdict.
[[nodiscard]] std::string to_text(const Certificate& certificate);
/// All rows in full.
[[nodiscard]] std::string to_full_text(const Certificate& certificate);
[[nodiscard]] std::string to_json(const Certificate& certificate);

/// The check before every write: random rational projections of every output at 4 to 32 states,
/// fewer for long programs. States outside the domain are replaced, at most eight draws for each
/// state.
struct SelfCheck {
  std::size_t states = 0;  ///< at which an output was compared
  /// Lost digits of the worst entry, inside the ranges; none if no state determines them.
  std::optional<double> digits_lost = {};
  std::string failure = {};  ///< empty: passed; otherwise the output, the state and both values
  std::size_t sampled_zeros = 0;      ///< entries that depend on zeros without a proof
  std::size_t outside = 0;            ///< states at which oracle and program both have no value
  bool has_undefined_output = false;  ///< the failure: an output has no value at any state
  std::optional<Span> place = {};  ///< in that case: the first of its expressions without a value
  std::string remedy = {};         ///< in that case: a hint
  std::size_t inside = 0;          ///< states visited inside the ranges
  std::size_t infinite = 0;        ///< states among these with a value that overflows double
};
[[nodiscard]] SelfCheck self_check(const Model& model, const Scene& scene, const Program& program);

/// "at most 0.4 digits lost", "no digit lost".
[[nodiscard]] std::string lost_text(double digits);

/// "compared with 60-digit arithmetic at 32 states; at most 0.4 digits lost". Further parts, if
/// they apply: "; 3 outside the domain"; "; not finite in double at 11 of 16 states inside the
/// ranges" if these exceed a tenth; "2 entries rest on zeros found at 64 points, not proved".
[[nodiscard]] std::string receipt(const SelfCheck& result);

}  // namespace elgen
