// unit_text: kg*m^2/s^2 as pages print it: kg m²/s².
#pragma once

#include <string>
#include <string_view>

namespace elgen {

/// `times` stands between factors; `exponent_text` writes an exponent: "2", "-1", "1/2".
[[nodiscard]] std::string unit_text(std::string unit, std::string_view times,
                                    std::string (*exponent_text)(const std::string& exponent));

}  // namespace elgen
