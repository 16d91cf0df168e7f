// Expressions of the model language as text, with what is 0 or 1 left out.
#pragma once

#include <string>

namespace elgen::urdf {

/// A position that a coordinate gives: factor*coordinate + offset; a constant where factor is "0".
struct Coupling {
  std::string coordinate = {};
  std::string factor = "1";  ///< "1", "-1", "0" or parameters
  std::string offset = "0";

  [[nodiscard]] bool is_constant() const { return factor == "0"; }
  [[nodiscard]] bool has_sign_only() const { return factor == "1" || factor == "-1"; }

  [[nodiscard]] std::string position() const;
  [[nodiscard]] std::string rate() const;  ///< factor*dot(coordinate)
};

[[nodiscard]] std::string sum(const std::string& left, const std::string& right);
[[nodiscard]] std::string negated(const std::string& expression);
[[nodiscard]] std::string product(const std::string& factor, const std::string& expression);
[[nodiscard]] std::string quotient(const std::string& expression, const std::string& divisor);

}  // namespace elgen::urdf
