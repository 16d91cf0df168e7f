// player_model: what the script of a page knows of a system beside its functions, as JSON.
#pragma once

#include <string>
#include <vector>

#include "elgen/pipeline.hpp"
#include "elgen/real.hpp"
#include "elgen/simulate.hpp"

namespace elgen {

/// The nearest double.
[[nodiscard]] inline double nearest(const cln::cl_R& value) {
  return ScalarTraits<double>::from_real(value);
}

/// A start at rest that has a button.
struct ShownStart {
  std::string name = {};  ///< "At rest: theta = 0 (stable)", "Mode of 4.43 rad/s: theta = 0"
  std::vector<double> q = {};
};

/// The points of rest, and a tenth along each normal mode about stable ones. None along rotations.
[[nodiscard]] std::vector<ShownStart> shown_starts(const Model& model, const Products& read);

/// Names, units, starts, places, laws and points of rest, without markup of HTML.
[[nodiscard]] std::string player_model(const CheckedModel& checked, const Program& program,
                                       const Products& read, const SimulationOptions& options);

}  // namespace elgen
