// avoidable loss: digits that the code of a field loses (loss.hpp), and whether one way to write it
// keeps them.
#pragma once

#include <string>
#include <vector>

#include "elgen/certificate.hpp"
#include "verify/bounds/visit.hpp"
#include "verify/states/tally.hpp"

namespace elgen {

/// What the visits to all states say of the losses of one field.
class LossRecord {
 public:
  /// `at` is the number of the state.
  template <class Scalar>
  void add(const FieldPlace& place, const Finding& finding, Visit<Scalar>& visit, std::size_t at);

  /// Where the code of the field loses digits.
  [[nodiscard]] bool has_loss() const { return has_loss_; }

  /// Fails where one way keeps what is lost, and all else, at every state; noted where none
  /// does: in sqrt(x^2 + l^2) - x either way loses digits, for one sign of x. Cost: nothing without
  /// a loss, else errors of all ways at all states, of each up to the first that it fails at.
  template <class Scalar>
  [[nodiscard]] CertificateRow row(const FieldPlace& place, const Subject& subject,
                                   const std::vector<SampledState<Scalar>>& states,
                                   const VisitOptions& options) const;

 private:
  Tally figures_ = {};
  bool has_loss_ = false;
  std::size_t entry_ = 0;      ///< of the largest
  std::uint32_t culprit_ = 0;  ///< its instruction
  std::size_t worst_at_ = 0;   ///< its state
};

}  // namespace elgen
