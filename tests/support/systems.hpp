// Named models of tests/models that tests visit one after another.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "support/models.hpp"

namespace elgen::test {

using NamedText = std::pair<std::string, std::string>;

inline std::vector<NamedText> named_models(const std::vector<std::string>& names) {
  std::vector<NamedText> all;
  for (const std::string& name : names) all.emplace_back(name, read_model(name));
  return all;
}

inline const std::vector<NamedText>& systems() {
  static const std::vector<NamedText> all =
      named_models({"cart_pole", "chain", "everything", "relativistic", "gyroscope"});
  return all;
}

/// Models with bodies on frames.
inline const std::vector<NamedText>& frame_systems() {
  static const std::vector<NamedText> all =
      named_models({"two_turns", "three_turns", "sliders", "turntable", "quaternion", "two_arms",
                    "planar", "hung"});
  return all;
}

}  // namespace elgen::test
