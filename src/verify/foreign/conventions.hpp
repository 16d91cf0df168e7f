// Conventions: other choices of coordinates and inputs, as foreign code may have. All have the form
//
//     q' = S q + pi c,   v' = S v,   a' = S a,   p' = S^-T p,   forces f' = S^-T f,   u' = U u
#pragma once

#include <cln/real.h>

#include <cstddef>
#include <string>
#include <vector>

#include "elgen/model.hpp"
#include "elgen/oracle.hpp"
#include "verify/foreign/fields.hpp"

namespace elgen {

/// A square matrix of small integers.
struct IntegerMatrix {
  std::size_t size = 0;
  std::vector<int> entries = {};  ///< row by row

  [[nodiscard]] int& at(std::size_t row, std::size_t column) {
    return entries[row * size + column];
  }
  [[nodiscard]] int at(std::size_t row, std::size_t column) const {
    return entries[row * size + column];
  }
};

struct Convention {
  std::string name = {};  ///< "its `theta` is `theta + pi`"
  IntegerMatrix S = {};
  IntegerMatrix S_inverse = {};
  std::vector<int> half_turns = {};  ///< c, by coordinate
  IntegerMatrix U = {};              ///< diagonal of signs, so it is its own inverse
};

/// The conventions that are tried: another sign or zero of one coordinate or input; relative or
/// absolute angles; other orders of up to three coordinates; then pairs of signs or zeros. With
/// rotations or more than 16 coordinates, only the signs of inputs.
[[nodiscard]] std::vector<Convention> candidate_conventions(const Model& model);

/// Converts a state from their convention to ours.
[[nodiscard]] State to_our_state(const Convention& convention, State theirs);

/// Converts our values of one field of an output to their convention.
[[nodiscard]] std::vector<cln::cl_R> to_their_values(const Model& model,
                                                     const Convention& convention,
                                                     const OutputRequest& output,
                                                     const ForeignField& field,
                                                     const std::vector<cln::cl_R>& ours);

}  // namespace elgen
