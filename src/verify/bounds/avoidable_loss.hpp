// avoidable loss: digits that the code of a field loses (loss.hpp), and whether one way to write it
// keeps them.
#pragma once

#include <map>
#include <vector>

#include "elgen/certificate.hpp"
#include "verify/bounds/visit.hpp"
#include "verify/states/tally.hpp"

namespace elgen {

/// What the visits to all states say of the losses of one field.
class LossRecord {
 public:
  /// `at` is the number of the state.
  void add(const Finding& finding, const State& state, std::size_t at);

  /// Fails where one way keeps the digits of an entry where the code loses most of them, and loses
  /// nowhere else more than the code: it is better. Noted where none is: in sqrt(x^2 + l^2) - x
  /// either way loses digits, for one sign of x; where a better one costs more than digits are
  /// worth; and where the scene prefers speed. Cost: nothing without a loss, else a run of all ways
  /// at all states, of each up to the first that it loses at.
  template <class Scalar>
  [[nodiscard]] CertificateRow row(const FieldPlace& place, const Subject& subject,
                                   const std::vector<SampledState<Scalar>>& states,
                                   const VisitOptions& options) const;

 private:
  struct Lost {
    double figure = 0;   ///< of the entry, where it is largest
    std::size_t at = 0;  ///< that state
  };

  Tally figures_ = {};
  std::map<std::size_t, Lost> lossy_ = {};  ///< entries, each the worst one of a state
};

}  // namespace elgen
