// Texts of a URDF to names of a model.
#include "urdf/names.hpp"

#include <algorithm>
#include <array>

#include "base/ascii.hpp"
#include "check/names/reserved_names.hpp"

namespace elgen::urdf {

namespace {

/// A parameter is a member of a struct, whose initialisers call these.
constexpr std::array<std::string_view, 5> names_of_headers{"Parameters", "Scalar", "constant",
                                                           "detail", "std"};

bool is_reserved(const std::string& name) {
  return !reserved_reason(name).empty() ||
         std::find(names_of_headers.begin(), names_of_headers.end(), name) !=
             names_of_headers.end();
}

}  // namespace

std::string well_formed(std::string_view text) {
  std::string name;
  for (const char c : text) {
    if (is_letter(c) || is_digit(c)) {
      name += c;
    } else if (!name.empty() && name.back() != '_') {
      name += '_';
    }
  }
  while (!name.empty() && name.back() == '_') name.pop_back();
  if (name.empty()) return "unnamed";
  return is_digit(name.front()) ? "n" + name : name;
}

std::string Names::claim(std::string_view wanted, std::string_view kind) {
  std::string name = well_formed(wanted);
  if (is_reserved(name) || taken_.count(name) > 0) name = std::string(kind) + "_" + name;
  const std::string stem = name;
  for (std::size_t i = 2; is_reserved(name) || !taken_.insert(name).second; ++i) {
    name = stem + "_" + std::to_string(i);
  }
  return name;
}

std::string model_name(std::string_view robot) {
  std::string name = well_formed(robot);
  std::transform(name.begin(), name.end(), name.begin(), in_lower_case);
  return is_reserved(name) ? "robot_" + name : name;
}

}  // namespace elgen::urdf
