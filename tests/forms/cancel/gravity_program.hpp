// Programs with one function of two coordinates and two parameters.
#pragma once

#include <string>

#include "program/read_program.hpp"

namespace elgen::test {

inline Program gravity_program(const std::string& instructions) {
  const std::string text = "parameters m l\ncoordinates x y\nfunction gravity\n" + instructions;
  return read_program(text);
}

}  // namespace elgen::test
