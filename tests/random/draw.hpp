// Random numbers, and random constants and functions of the model language. A seed gives the same
// draws in every run of one build. Compilers may order the draws of one expression differently.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "random/expression.hpp"

namespace elgen::test::random {

class Draw {
 public:
  Draw(std::uint64_t seed, bool irrational) : engine_(seed), irrational_(irrational) {}

  int below(int count) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(count)); }
  bool chance(int percent) { return below(100) < percent; }
  template <class Items>
  const auto& one_of(const Items& items) {
    return items[static_cast<std::size_t>(below(static_cast<int>(items.size())))];
  }

  /// A non-zero dyadic number in [-reach, reach], exact in every scalar type.
  Number dyadic(int reach);

  /// A non-zero constant: rational, or in half of the models also irrational.
  Expression constant();
  /// A constant between 1/10 and 10: rational, or in half of the models also irrational.
  Expression positive();
  Expression rational();

  /// A smooth function of the arguments, bounded if all arguments are in [-1, 1].
  Expression function_of(const std::vector<Expression>& arguments);

 private:
  std::mt19937_64 engine_;
  bool irrational_;

  Expression irrational();
  Expression elementary();
};

/// The value of an expression without names.
[[nodiscard]] Number value_of(const Expression& constant);

}  // namespace elgen::test::random
