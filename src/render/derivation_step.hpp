// DerivationStep: a part of a derivation as it is read, a title with equations below.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace elgen {

/// `left` = one field of one function.
struct StepEquation {
  std::string text = {};
  std::string latex = {};
  std::size_t function = 0;
  std::size_t field = 0;
  std::uint32_t rows = 1;
};

/// A formula of no function, or a sentence with formulas.
struct StepLine {
  std::string text = {};
  std::string latex = {};
};

struct DerivationStep {
  std::string title = {};
  std::string title_latex = {};  ///< as SheetOutput has it
  std::string doc = {};
  std::vector<StepEquation> equations = {};
  std::vector<StepLine> lines = {};  ///< before the equations
};

}  // namespace elgen
