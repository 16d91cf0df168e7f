// Certificate: one row per check, with what was compared, where it was worst, and why its tolerance
// is what it is.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "elgen/closed_forms.hpp"
#include "elgen/diagnostic.hpp"
#include "elgen/emitted_files.hpp"
#include "elgen/model.hpp"
#include "elgen/program.hpp"
#include "elgen/scene.hpp"
#include "elgen/toolchain.hpp"

namespace elgen {

enum class Verdict : std::uint8_t { holds, fails, skipped };

struct CertificateRow {
  std::string check;    ///< "program vs oracle", "mass matrix symmetric", "[[expect]] gravity"
  std::string subject;  ///< output or entry
  std::string formula;  ///< what was evaluated
  std::size_t samples = 0;
  std::string worst;      ///< the figure, with its unit: "2.1 u B"
  std::string where;      ///< the state of the worst value, empty where nothing was sampled
  std::string tolerance;  ///< the bound and its reason
  Verdict verdict = Verdict::holds;
};

struct Certificate {
  std::string model;
  std::string scene;
  std::uint64_t seed = 0;
  std::vector<CertificateRow> rows = {};
};

struct VerifyOptions {
  /// Random states per output; 256 where none is said, fewer for long programs.
  std::optional<std::size_t> samples = {};
  bool quick = false;  ///< 16 states, no compiler
  std::uint64_t seed = 1;
  /// Prove [[expect]]; parallel to the program's functions. Without them, and where they do not
  /// decide, it is sampled.
  ClosedForms* forms = nullptr;
};

/// Compares oracle, program, and compiled code, and checks the structure of M, C and energies.
/// Without `compiled` headers (quick) their rows are absent.
/// Diagnostics: wrong [[expect]] with witness point.
struct Verification {
  Certificate certificate;
  Diagnostics diagnostics;
};
[[nodiscard]] Verification verify(const Model& model, const Scene& scene, const Program& program,
                                  const CompiledHeaders& compiled, const VerifyOptions& options);

/// E618 where what was dropped from M may be more than half its smallest eigenvalue, M scaled to a
/// diagonal of 1, at a state sampled over the ranges: the reduced M could then be indefinite.
[[nodiscard]] Diagnostics check_definiteness(const Model& model, const Scene& scene,
                                             const Reduction& reduction);

[[nodiscard]] bool holds(const Certificate& certificate);
[[nodiscard]] std::string to_text(const Certificate& certificate);

/// The check that precedes every write: every output projected on random rational vectors, as many
/// states (2 … 32) as fit into `seconds`; one where it takes longer by itself.
struct SelfCheck {
  std::size_t states = 0;  ///< at which an output was compared
  /// Largest error in u B, of the closed form, or of the recursive program; none where rounding has
  /// no bound at any state.
  std::optional<double> worst = {};
  std::string failure =
      {};  ///< empty when it holds; otherwise the output, the state and both values
  std::size_t sampled_zeros = 0;   ///< entries that rest on zeros which are not proved
  std::size_t outside = 0;         ///< states at which an output is undefined, and rightly so
  bool lacks_value = false;        ///< the failure: an output is undefined at all states
  std::optional<Span> place = {};  ///< then: the first expression of it that is
};
[[nodiscard]] SelfCheck self_check(const Model& model, const Scene& scene, const Program& program,
                                   double seconds);

/// "checked 32 states against 60 digits: 2.1 uB", or "without a bound of rounding"; "; 3 outside
/// the domain" where some are; and "2 entries rest on zeros found at 64 points, not proved".
[[nodiscard]] std::string receipt(const SelfCheck& result);

}  // namespace elgen
