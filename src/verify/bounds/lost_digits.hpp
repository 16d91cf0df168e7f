// lost digits: how many of its digits an output loses, a figure and never a failure.
#pragma once

#include <optional>
#include <string>

#include "elgen/certificate.hpp"
#include "verify/bounds/visit.hpp"

namespace elgen {

/// Collects the losses of one output in one scalar over all states.
class LostDigits {
 public:
  /// `at` is the number of the state. Fields of one state come one after another.
  void add(const FieldPlace& place, const Finding& finding, const Subject& subject,
           const State& state, std::size_t at);

  [[nodiscard]] bool is_empty() const { return states_ == 0; }

  /// The entry that loses most and its state, both of what one rounding of the inputs would cost,
  /// and of the largest entry of its field. Noted where that is more than half of `digits`, those
  /// of the scalar.
  [[nodiscard]] CertificateRow row(double digits) const;

 private:
  struct Worst {
    double figure = 0;
    std::string entry = {};  ///< "mass_matrix[7,7]"
    std::string where = {};
  };

  std::size_t states_ = 0;
  std::optional<std::size_t> last_ = {};  ///< of the states
  Worst of_entry_ = {};
  Worst of_field_ = {};
};

}  // namespace elgen
