// Certificate: one row per check, with what was compared, where it was worst, and why its tolerance
// is what it is.
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
  noted,  ///< half of the digits are lost, or a side of a kink was not seen
};

/// Why nothing is said at a state.
enum class Obstacle : std::uint8_t {
  overflow,   ///< an exact intermediate is near the scalar's largest number
  undefined,  ///< outside of the domain: 1/0, sqrt(-1)
  singular,   ///< M is singular: a pole, a gimbal
  unsettled,  ///< 1000 digits do not tell whether program and oracle are one: 1 - cos(1e-300)
  unmet,      ///< no step of Newton puts it on the constraints
};

/// The evidence for a row.
enum class Evidence : std::uint8_t {
  states,   ///< a comparison at `samples` states
  proof,    ///< canonical forms that are equal, whatever the state
  zeros,    ///< entries taken for 0 are below rounding at `samples` random points
  numbers,  ///< `samples` numbers that are written once, compared exactly
};

struct SkippedStates {
  Obstacle obstacle = Obstacle::overflow;
  std::size_t states = 0;
  friend bool operator==(const SkippedStates&, const SkippedStates&) = default;
};

struct CertificateRow {
  std::string check = {};    ///< "program vs oracle", "mass matrix symmetric", "[[expect]]"
  std::string output = {};   ///< the function; "[[expect]] gravity"
  std::string subject = {};  ///< of it: "forward_dynamics.acceleration (float)", "gravity[2]"
  std::string formula = {};  ///< what was evaluated
  Evidence evidence = Evidence::states;
  std::size_t samples = 0;                   ///< states at which it was compared
  std::vector<SkippedStates> skipped = {};   ///< and at which it could not be
  std::size_t skipped_inside = 0;            ///< of these, in double and inside the ranges
  std::optional<double> loss = {};           ///< largest, in u R; 10^digits of the scalar at most
  std::optional<double> loss_of_field = {};  ///< the same in u of the largest entry of its field
  std::string worst = {};                    ///< the figure; why nothing was compared
  std::string where = {};      ///< the state of the worst value, empty where nothing was sampled
  std::string tolerance = {};  ///< the bound and its reason
  Verdict verdict = Verdict::holds;
  std::vector<std::string> findings = {};  ///< about foreign code that is wrong
};

struct Certificate {
  std::string model;
  std::string scene;
  std::uint64_t seed = 0;
  std::vector<CertificateRow> rows = {};
};

struct VerifyOptions {
  /// Random states per output, and at most as many (64) near zeros of typed sums; 256 where none
  /// is said, fewer for long programs.
  std::optional<std::size_t> samples = {};
  /// 16 random states with all extremes, fewer of both for long programs; one contraction of an
  /// output instead of all entries; no compiler.
  bool quick = false;
  std::uint64_t seed = 1;
  std::size_t jobs = 1;  ///< processes that share the states; the certificate is the same
  /// Prove [[expect]]; parallel to the program's functions. Without them, and where they do not
  /// decide, it is sampled.
  ClosedForms* forms = nullptr;
  /// Lost digits are those inside the declared ranges, near zeros of typed sums too; with
  /// `extremes` also beyond.
  bool extremes = false;
  /// The verdicts about every [[equilibrium]]; may be null.
  const std::vector<JudgedEquilibrium>* claims = nullptr;
  /// Told of each step: "accuracy in double, state 3 of 36".
  std::function<void(const std::string&)> on_step = {};
};

/// Compares oracle, program, and compiled code, and checks the structure of M, C and energies.
/// Without `compiled` headers (quick) their rows are absent. Those of Build::as_users are held to
/// the running errors of the program, all others to its bits. Rounding fails nothing: digits lost
/// are a figure. A value fails that is NaN or infinite while exact arithmetic stays inside the
/// scalar's range.
/// Diagnostics: wrong [[expect]] with witness point.
struct Verification {
  Certificate certificate;
  Diagnostics diagnostics;
};
[[nodiscard]] Verification verify(const Model& model, const Scene& scene, const Program& program,
                                  const CompiledHeaders& compiled, const VerifyOptions& options);

[[nodiscard]] std::size_t count(const Certificate& certificate, Verdict verdict);
[[nodiscard]] bool holds(const Certificate& certificate);

/// "cart_pole, scene balance: 41 checks hold, 0 fail, 2 skipped", and ", 1 noted" where some are
[[nodiscard]] std::string verdict_line(const Certificate& certificate);
/// A line per output, what fails or is skipped in full, and the verdict.
[[nodiscard]] std::string to_text(const Certificate& certificate);
/// All rows in full.
[[nodiscard]] std::string to_full_text(const Certificate& certificate);
[[nodiscard]] std::string to_json(const Certificate& certificate);

/// The check that precedes every write: every output projected on random rational vectors at 4 to
/// 32 states, fewer of long programs. States outside the domain are drawn anew, up to eight times
/// as many in all.
struct SelfCheck {
  std::size_t states = 0;  ///< at which an output was compared
  /// Digits lost by the entry that loses most, inside the ranges; none where no state tells.
  std::optional<double> digits_lost = {};
  std::string failure =
      {};  ///< empty when it holds; otherwise the output, the state and both values
  std::size_t sampled_zeros = 0;   ///< entries that rest on zeros which are not proved
  std::size_t outside = 0;         ///< states at which an output is undefined, and rightly so
  bool lacks_value = false;        ///< the failure: an output is undefined at all states
  std::optional<Span> place = {};  ///< then: the first expression of it that is
  std::string remedy = {};         ///< and what may be done
  std::size_t inside = 0;          ///< states visited inside the ranges
  std::size_t infinite = 0;        ///< of these, with a value that overflows double
};
[[nodiscard]] SelfCheck self_check(const Model& model, const Scene& scene, const Program& program);

/// "at most 0.4 digits lost", "no digit lost".
[[nodiscard]] std::string lost_text(double digits);

/// "compared with 60-digit arithmetic at 32 states; at most 0.4 digits lost"; "; 3 outside the
/// domain" if some are; "; not finite in double at 11 of 16 states inside the ranges" if these are
/// more than a tenth; and "2 entries rest on zeros found at 64 points, not proved".
[[nodiscard]] std::string receipt(const SelfCheck& result);

}  // namespace elgen
