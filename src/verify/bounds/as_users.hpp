// as users compile: the code with optimisation, the machine's own instructions and contraction,
// which rounds otherwise than what is written, held to the same bounds.
#pragma once

#include <optional>
#include <set>
#include <string>

#include "elgen/certificate.hpp"
#include "verify/bounds/visit.hpp"
#include "verify/states/tally.hpp"

namespace elgen {

/// What the visits to all states say of all fields.
class AsUsersRecord {
 public:
  /// `field`: "forward_dynamics.acceleration (double)"; `at` is the number of the state. Fields of
  /// one state come one after another.
  void add(const std::string& field, const Finding& finding, const State& state, std::size_t at);

  /// One row for all fields of a scalar.
  [[nodiscard]] CertificateRow row(const Subject& subject, std::string_view scalar) const;

 private:
  Tally errors_ = {};  ///< in u B
  std::set<std::string> fields_ = {};
  std::size_t states_ = 0;
  std::optional<std::size_t> last_ = {};  ///< of the states
  std::string worst_ = {};                ///< the field of the largest
  std::string imprecision_ = {};
};

}  // namespace elgen
