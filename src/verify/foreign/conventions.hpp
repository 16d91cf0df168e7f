// Conventions: choices of coordinates and inputs that other code may have made, all of the form
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

/// A square matrix of signs and small integers.
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
  IntegerMatrix inverse = {};
  std::vector<int> half_turns = {};  ///< c
  IntegerMatrix U = {};              ///< its own inverse
};

/// Signs and half turns of one coordinate or input, then of two; relative and absolute angles;
/// other orders of up to three coordinates. For models with rotations: signs of inputs only.
[[nodiscard]] std::vector<Convention> conventions(const Model& model);

/// Our state, given the state in their convention.
[[nodiscard]] State our_state(const Convention& convention, State theirs);

/// Our values of a field of an output, in their convention.
[[nodiscard]] std::vector<cln::cl_R> their_values(const Model& model, const Convention& convention,
                                                  const OutputRequest& output,
                                                  const ForeignField& field,
                                                  const std::vector<cln::cl_R>& ours);

}  // namespace elgen
