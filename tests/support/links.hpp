// A chain of rotations about crossed axes, of any length.
#pragma once

#include "support/systems.hpp"

namespace elgen::test {

/// The text of a model of n links: each a translation, a quarter turn and a rotation, with a body
/// of general inertia. Link i turns by the coordinate q_i, or by q_(n + 1 - i) if `last_carries`.
inline std::string links_text(int n, bool last_carries = false) {
  std::string coordinates;
  std::string frames;
  for (int i = 1; i <= n; ++i) {
    const std::string number = std::to_string(i);
    const std::string parent = i == 1 ? "world" : "f" + std::to_string(i - 1);
    coordinates += (i == 1 ? "q" : " q") + number;
    frames += "[[frame]]\nname = \"f" + number + "\"\nparent = \"" + parent +
              "\"\ntranslate = [\"l\", \"0\", \"0\"]\nrotate = [[\"x\", \"pi/2\"], [\"z\", \"q" +
              (last_carries ? std::to_string(n + 1 - i) : number) + "\"]]\n[[body]]\nname = \"b" +
              number + "\"\nframe = \"f" + number +
              "\"\nmass = \"m1\"\ncom = [\"l/2\", \"l/9\", \"l/8\"]\n"
              "inertia = [\"A\", \"B\", \"C\", \"D\", \"E\", \"F\"]\n";
  }
  return frame_model("links", coordinates, frames);
}

}  // namespace elgen::test
