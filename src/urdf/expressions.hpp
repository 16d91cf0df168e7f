// Expressions of the model language as text, with what is 0 or 1 left out.
#pragma once

#include <string>

namespace elgen::urdf {

/// A position that a coordinate gives: factor*coordinate + offset.
struct Coupling {
  std::string coordinate = {};
  std::string factor = "1";  ///< "1", "-1", "0" or a parameter
  std::string offset = "0";

  [[nodiscard]] std::string position() const;
  [[nodiscard]] std::string rate() const;  ///< factor*dot(coordinate)
};

[[nodiscard]] std::string sum(const std::string& left, const std::string& right);
[[nodiscard]] std::string negated(const std::string& expression);
[[nodiscard]] std::string product(const std::string& factor, const std::string& expression);
[[nodiscard]] std::string quotient(const std::string& expression, const std::string& divisor);

}  // namespace elgen::urdf
