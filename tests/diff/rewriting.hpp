// One system, written in two ways by hand.
#pragma once

#include <sstream>

#include "diff/versions.hpp"

namespace elgen::test {

struct Rewriting {
  const char* what;
  const char* coordinates;  ///< names; `attitude` is a rotation
  int links;                ///< of a chain q[1] ... q[links] instead of these; 0: none
  const char* before;       ///< what follows the parameters
  const char* after;
  const char* part;  ///< of `after`
  const char* wrong;
};

inline std::string text_of(const Rewriting& pair, const char* rest) {
  std::string text;
  if (pair.links > 0) {
    text = "[sizes]\nn = " + std::to_string(pair.links) +
           "\n[[coordinate]]\nfor = \"i in 1..n\"\nname = \"q[i]\"\n";
  }
  std::istringstream names(pair.coordinates);
  for (std::string name; names >> name;) {
    text += "[[coordinate]]\nname = \"" + name + "\"\n";
    if (name == "attitude") text += "kind = \"rotation\"\n";
  }
  return model_text("pair", text + R"toml([parameters]
m = { value = 2, assume = "positive" }
l = { value = "1/2", assume = "positive" }
c = { value = 3, assume = "positive" }
k = 4
A = { value = "1/20" }
C = { value = "1/50" }
g = 9.81
)toml" + rest);
}

/// Two pairs: the second writing is equal, and is not with one thing wrong.
inline void check_pairs(const Rewriting& pair) {
  INFO(pair.what);
  const std::string before = text_of(pair, pair.before);
  const std::string after = text_of(pair, pair.after);
  CHECK(impact_row(compared(before, after).impact).word == "equal");
  const std::string wrong = edited(after, pair.part, pair.wrong);
  CHECK(impact_row(compared(before, wrong).impact).word == "different");
}

}  // namespace elgen::test
