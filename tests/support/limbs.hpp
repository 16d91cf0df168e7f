// Two limbs of any length on a rotating trunk.
#pragma once

#include "support/systems.hpp"

namespace elgen::test {

namespace limbs {

/// A frame (translation, quarter turn, rotation by `angle`) and its body of general inertia.
inline std::string link(const std::string& name, const std::string& parent,
                        const std::string& angle) {
  return "[[frame]]\nname = \"" + name + "\"\nparent = \"" + parent +
         "\"\ntranslate = [\"l\", \"l/9\", \"0\"]\nrotate = [[\"x\", \"pi/2\"], [\"z\", \"" +
         angle + "\"]]\n[[body]]\nname = \"b_" + name + "\"\nframe = \"" + name +
         "\"\nmass = \"m1\"\ncom = [\"l/2\", \"l/9\", \"l/8\"]\n"
         "inertia = [\"A\", \"B\", \"C\", \"D\", \"E\", \"F\"]\n";
}

}  // namespace limbs

/// The text of a model with 1 + 2 n velocities, or 6 + 2 n if `floats`. The torque on link left1
/// contains the only input, u.
inline std::string limbs_text(int n, bool floats = false) {
  std::string coordinates;
  const auto coordinate = [&](const std::string& name, const std::string& more = "") {
    coordinates += "[[coordinate]]\nname = \"" + name + "\"\n" + more;
  };
  std::string frames;
  if (floats) {
    for (const char* name : {"x", "y", "z"}) coordinate(name);
    coordinate("e", "kind = \"rotation\"\n");
    frames = limbs::link("trunk", "world", "t/3");
    frames.replace(frames.find("rotate = "), frames.find("\n[[body]]") - frames.find("rotate = "),
                   "rotation = \"e\"");
    frames.replace(frames.find("\"l\", \"l/9\", \"0\""), 15, "\"x\", \"y\", \"z\"");
  } else {
    coordinate("q");
    frames = limbs::link("trunk", "world", "q");
  }
  for (const std::string side : {"left", "right"}) {
    for (int i = 1; i <= n; ++i) {
      const std::string name = side + std::to_string(i);
      coordinate("q_" + name);
      frames += limbs::link(name, i == 1 ? "trunk" : side + std::to_string(i - 1), "q_" + name);
    }
  }
  return model_text("limbs", coordinates + "[[input]]\nname = \"u\"\n" + frame_parameters() +
                                 frames + "[[force]]\nframe = \"left1\"\nfrom = \"trunk\"\n" +
                                 "value = [\"u\", \"l\", \"-u\"]\n" +
                                 "[energy]\nD = \"C*dot(q_left1)^2/2\"\n");
}

}  // namespace elgen::test
