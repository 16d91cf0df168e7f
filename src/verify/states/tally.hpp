// Tally: the largest of many figures, the state that has it, and the number of states without a
// figure.
#pragma once

#include <cmath>
#include <optional>
#include <string>

#include "elgen/certificate.hpp"
#include "program/evaluate/subject.hpp"

namespace elgen {

class Tally {
 public:
  /// Adds a figure; true if it is the worst so far.
  bool add(double figure, const State& state) {
    ++samples_;
    // A NaN is worse than any number.
    if (worst_state_ && (std::isnan(worst_) || figure <= worst_)) return false;
    worst_ = figure;
    worst_state_ = state;
    return true;
  }
  void count_skipped() { ++skipped_; }

  [[nodiscard]] std::size_t samples() const { return samples_; }
  [[nodiscard]] double worst() const { return worst_; }
  [[nodiscard]] std::string worst_state_text(const SystemUnderTest& subject) const {
    return worst_state_ ? describe_state(subject, *worst_state_) : std::string();
  }
  /// `skipped` without figures; otherwise `holds` if no figure exceeds the tolerance. A NaN fails.
  [[nodiscard]] Verdict verdict(double tolerance) const {
    if (samples_ == 0) return Verdict::skipped;
    return worst_ <= tolerance ? Verdict::holds : Verdict::fails;
  }
  /// Writes counts, worst state and verdict into a row. `obstacle`: why states were skipped.
  void write_result(CertificateRow& row, const SystemUnderTest& subject, double tolerance,
                    SkipReason obstacle = SkipReason::undefined) const {
    row.samples = samples_;
    row.worst_state = worst_state_text(subject);
    row.verdict = verdict(tolerance);
    if (skipped_ > 0) row.skipped = {{obstacle, skipped_}};
  }

 private:
  std::size_t samples_ = 0;
  std::size_t skipped_ = 0;
  double worst_ = 0.0;
  std::optional<State> worst_state_ = {};
};

}  // namespace elgen
