// A sheet with what needs care in every notation.
#pragma once

#include <string>

#include "elgen/render.hpp"

namespace elgen::testing {

inline Sheet small_sheet() {
  Sheet sheet;
  sheet.title = "A & B_1";
  sheet.description = "100 % of x < y";
  sheet.equation_of_motion = "M \\ddot{q} = 0";
  sheet.parameters = {{"m_{1}", "m1", "kg", "0.5", "mass | of *one*"}};
  sheet.outputs = {
      {"Gravity", "gravity", OutputKind::gravity, "Slope.", "", {{"g", 2, 1, {"0", "m_{1} g"}}}}};
  return sheet;
}

inline bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace elgen::testing
