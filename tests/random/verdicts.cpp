// Verdicts of `elgen verify`: the model and its true closed forms must hold, false closed forms
// must fail.
#include <sstream>

#include "random/claims.hpp"
#include "random/trial.hpp"
#include "support/shell.hpp"

namespace elgen::test::random {

namespace {

/// The failed rows of a certificate, or the end of the text if no row failed.
std::string failed_rows(const std::string& certificate) {
  constexpr std::size_t row = 600;
  constexpr std::size_t kept = 1500;
  std::string rows;
  for (std::size_t at = certificate.find("  FAILS"); at != std::string::npos && rows.size() < kept;
       at = certificate.find("  FAILS", at + 1)) {
    rows += certificate.substr(at, row) + "\n";
  }
  if (!rows.empty() || certificate.size() <= kept) return rows.empty() ? certificate : rows;
  return certificate.substr(certificate.size() - kept);
}

Outcome verify(const std::string& file, const std::filesystem::path& folder) {
  return test::shell("timeout 300 elgen verify --quick " + file, folder);
}

/// A finding with the first failed check in its kind: smaller models must fail in the same check.
Finding verdict_finding(const std::string& kind, const Outcome& outcome) {
  constexpr std::size_t name = 60;
  const std::string rows = failed_rows(outcome.output);
  std::string first;
  if (test::starts_with(rows, "  FAILS")) {
    std::istringstream words(rows.substr(0, name));
    std::string fails;
    words >> fails >> first;
  }
  return {kind + " exit " + std::to_string(outcome.status) + (first.empty() ? "" : " " + first),
          rows + failed_rows(outcome.errors)};
}

}  // namespace

std::vector<Finding> compare_verdicts(const Trial& trial, const std::filesystem::path& folder) {
  std::vector<Finding> findings;
  const Outcome again = test::shell(
      "timeout 120 elgen generate -q --check -o out " + input_file(trial.system), folder);
  if (again.status != 0) findings.push_back(verdict_finding("another run differs,", again));
  const std::string model_file = trial.system.model.name + ".toml";
  const std::vector<Claim> claims = true_claims(trial.system.model);
  if (!claims.empty()) write_files(trial.system, folder, claims);
  const Outcome right = verify(input_file(trial.system), folder);
  if (right.status != 0) {
    findings.push_back(verdict_finding("verify", right));
  }
  if (claims.empty()) return findings;
  if (trial.system.scene.is_present) {
    const Outcome model = verify(model_file, folder);
    if (model.status != 0) findings.push_back(verdict_finding("verify model", model));
  }
  Draw draw(trial.seed + 2000003, false);
  const std::vector<Claim> wrong = falsified(claims, draw);
  write_files(trial.system, folder, wrong);
  const Outcome refused = verify(model_file, folder);
  const bool says_why = test::mentions(refused.output + refused.errors, "E510");
  if (refused.status != 1 || !says_why) {
    Finding finding = verdict_finding("false claim", refused);
    finding.text = text_of(trial.system.model, wrong) + finding.text;
    findings.push_back(finding);
  }
  return findings;
}

std::vector<Finding> all_findings(const System& system, std::uint64_t seed) {
  const test::Workspace folder;
  std::vector<Trial> trials{make_trial(system, seed)};
  std::vector<Finding> findings = compare_shown(trials[0], folder.path());
  const auto add = [&](const std::vector<Finding>& more) {
    findings.insert(findings.end(), more.begin(), more.end());
  };
  if (findings.empty()) add(compare_compiled(trials, folder.path())[0]);
  if (findings.empty()) add(compare_verdicts(trials[0], folder.path()));
  return findings;
}

}  // namespace elgen::test::random
