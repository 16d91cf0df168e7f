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
  /// More than half of the digits are lost; all states are on one side of a kink; an expected
  /// equation is an identity; or a set of expected equations is incomplete.
  noted,
};

/// Why a state is skipped.
enum class SkipReason : std::uint8_t {
  overflow,   ///< an exact intermediate value is near the scalar's largest number
  undefined,  ///< outside the domain: 1/0, sqrt(-1)
  singular,   ///< M is singular: a pole, a gimbal
  undecided,  ///< in 1000 digits, program and oracle still cannot be compared: 1 - cos(1e-300)
  off_constraints,  ///< Newton's method does not put the state onto the constraints
};

/// The evidence for a row of the certificate.
enum class Evidence : std::uint8_t {
  states,  ///< values agree at `samples` states
  proof,   ///< canonical forms are equal, so the row holds at every state
  zeros,   ///< entries that elgen replaced by 0 are below rounding error at `samples` random points
  numbers,  ///< `samples` numbers that emitted code declares are bit-identical to the model's
};

struct SkippedStates {
  SkipReason reason = SkipReason::overflow;
  std::size_t states = 0;
  friend bool operator==(const SkippedStates&, const SkippedStates&) = default;
};

/// An incomplete set of equations of motion in [[expect]].
struct StatedEquations {
  std::size_t stated = 0;  ///< number of independent equations
  std::size_t needed = 0;  ///< number of equations that determine all accelerations
};

struct CertificateRow {
  std::string check = {};   ///< "program vs oracle", "mass matrix symmetric", "[[expect]]"
  std::string output = {};  ///< the function; "[[expect]] gravity"
  /// The part of the output: "forward_dynamics.acceleration (float)", "gravity[2]".
  std::string subject = {};
  std::string formula = {};  ///< the evaluated formula
  Evidence evidence = Evidence::states;
  std::size_t samples = 0;                  ///< number of states (or numbers) that were compared
  std::vector<SkippedStates> skipped = {};  ///< number of skipped states for each reason
  std::size_t skipped_in_ranges = 0;  ///< number of skipped states inside the ranges; double only
  /// max |x - x*| / (u R) over the entries x, at most 10^(digits of the scalar). x* is the exact
  /// entry, u the unit roundoff, and R is |x*| + the effect of rounded inputs and parameters on x.
  std::optional<double> loss = {};
  /// max |x - x*| / (u X) over the entries x with exact values x*. u is the unit roundoff, X the
  /// largest |x*| of the field of x.
  std::optional<double> loss_of_field = {};
  /// The worst value as text, or the reason why nothing was compared.
  std::string worst_value = {};
  std::string worst_state = {};  ///< the state of the worst value; empty without samples
  std::string tolerance = {};    ///< the bound and its reason
  Verdict verdict = Verdict::holds;
  std::vector<std::string> findings = {};  ///< explanations of the wrong values of foreign code
  std::optional<StatedEquations> stated = {};
};

struct Certificate {
  std::string model;
  std::string scene;
  std::uint64_t seed = 0;
  std::vector<CertificateRow> rows = {};
};

struct VerifyOptions {
  /// Number of random states per output. Up to 64 more are near zeros of typed sums, and up
  /// to 64 more at large losses. None: 256, fewer for long programs.
  std::optional<std::size_t> samples = {};
  /// True: check only 16 random states and all extremes (fewer for long programs), check one
  /// contraction per output instead of all entries, and compile no code.
  bool is_quick = false;
  std::uint64_t seed = 1;
  std::size_t jobs = 1;  ///< number of processes; the certificate does not depend on it
  /// Closed forms that prove [[expect]], parallel to the functions of the program. If the pointer
  /// is null, or if the forms prove nothing, samples decide.
  ClosedForms* forms = nullptr;
  /// True: lost digits are also measured outside the declared ranges. False: only inside them, and
  /// near zeros of typed sums.
  bool checks_extremes = false;
  /// The verdicts on every [[equilibrium]]; may be null.
  const std::vector<EquilibriumVerdict>* equilibrium_verdicts = nullptr;
  /// Called before each step of the work, with a text: "accuracy in double, state 3 of 36".
  std::function<void(const std::string&)> on_step = {};
  bool only_expectations = false;  ///< true: check only [[expect]]
};

/// The result of verify(), which compares oracle, program and compiled code, and checks the
/// structure of M, C and the energies. If `compiled` is empty (quick), the certificate has no rows
/// on compiled code. Headers of BuildFlags::user_flags must agree with the program within the
/// running errors of the program, all other headers bit by bit. Lost digits are reported, but never
/// fail a check. A value fails if it is NaN or infinite although all exact intermediate values are
/// inside the range of the scalar. Each wrong [[expect]] has a diagnostic with a state as witness.
struct Verification {
  Certificate certificate;
  Diagnostics diagnostics;
};
[[nodiscard]] Verification verify(const Model& model, const Scene& scene, const Program& program,
                                  const CompiledHeaders& compiled, const VerifyOptions& options);

[[nodiscard]] std::size_t count_rows(const Certificate& certificate, Verdict verdict);
[[nodiscard]] bool holds(const Certificate& certificate);

/// "cart_pole, scene balance: 41 checks hold, 0 fail, 2 skipped"; ", 1 noted" if a row is noted.
[[nodiscard]] std::string verdict_line(const Certificate& certificate);
/// One line per output, every failed or skipped row in full, and the verdict.
[[nodiscard]] std::string to_text(const Certificate& certificate);
/// All rows of `certificate` in full, and the verdict below or above them.
[[nodiscard]] std::string to_full_text(const Certificate& certificate, bool verdict_first = false);
[[nodiscard]] std::string to_json(const Certificate& certificate);

/// The result of the check before files are written. The check compares random rational projections
/// of every output with the oracle at 4 to 32 states, fewer for long programs; beyond 20
/// velocities, relative pivots at one state. States outside the domain are drawn again, with at
/// most eight draws per state.
struct SelfCheck {
  std::size_t states = 0;  ///< number of states at which an output was compared
  /// The most decimal digits that an entry loses inside the ranges; none if no state determines the
  /// loss.
  std::optional<double> digits_lost = {};
  std::string failure = {};  ///< empty: passed; otherwise the output, the state and both values
  std::size_t sampled_zeros = 0;      ///< number of entries that rely on zeros found by sampling
  std::size_t undefined_states = 0;   ///< number of states without value in oracle and program
  bool has_undefined_output = false;  ///< the check failed: an output has no value at any state
  std::optional<Span> place = {};     ///< the first expression without value, or the output
  std::string remedy = {};            ///< hint if has_undefined_output
  std::size_t states_in_ranges = 0;   ///< number of checked states inside the ranges
  /// Number of states inside the ranges with a value that overflows double.
  std::size_t overflowing_states = 0;
};

/// The check of `program`. `unrequested`: the functions of outputs_for_self_check(). Without them
/// the oracle computes M, at the cost of n^2/18 energies for n velocities.
[[nodiscard]] SelfCheck self_check(const Model& model, const Scene& scene, const Program& program,
                                   const Program& unrequested = {});

/// Inverse dynamics, from which self_check() computes M to compare relative pivots. None if no
/// function has relative pivots, if the program has M or inverse dynamics, or if the oracle
/// computes M: up to four velocities, or with constraints.
[[nodiscard]] std::vector<OutputRequest> outputs_for_self_check(const Model& model,
                                                                const Program& program);

/// "at most 0.4 digits lost", "no digit lost".
[[nodiscard]] std::string lost_digits_text(double digits);

/// "compared with 60-digit arithmetic at 32 states; at most 0.4 digits lost", and if they apply:
/// "; 3 outside the domain"; "; not finite in double at 11 of 16 states inside the ranges" (if more
/// than a tenth); "; 2 entries rely on zeros sampled at 64 points, not proved: `elgen verify -v`
/// names them and compares them at more states".
[[nodiscard]] std::string self_check_text(const SelfCheck& result);

}  // namespace elgen
