// RoundedProgram: evaluates a program in Scalar. The constructor rounds the constants, so that
// calls do not round them again.
#pragma once

#include <vector>

#include "elgen/evaluate.hpp"

namespace elgen {

template <class Scalar>
class RoundedProgram {
 public:
  explicit RoundedProgram(const Program& program) : program_(program) {
    for (const Constant& constant : program.constants) {
      constants_.push_back(ScalarTraits<Scalar>::from_real(constant.value));
    }
  }

  /// The entries of a function of the program.
  [[nodiscard]] std::vector<Scalar> evaluate(const Function& function,
                                             const Arguments<Scalar>& arguments) const {
    const Rules rules{{arguments}, program_.constants.data(), constants_};
    return entries_of(function, fold<Scalar>(rules, program_, function));
  }

 private:
  struct Rules : interpreter::NumberRules<Scalar> {
    const Constant* first;
    const std::vector<Scalar>& constants;

    [[nodiscard]] Scalar constant(const Constant& constant) const {
      return constants[static_cast<std::size_t>(&constant - first)];
    }
  };

  const Program& program_;
  std::vector<Scalar> constants_ = {};
};

}  // namespace elgen
