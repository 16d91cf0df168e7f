// L D L^T of symbols, evaluated.
#include <catch2/catch.hpp>

#include "elgen/evaluate.hpp"
#include "program/steps/composition.hpp"

namespace elgen::test {
namespace {

/// n velocities; on a chain of frames, or on two limbs.
Model model_of(std::size_t n, bool branches) {
  Model model;
  model.velocities.resize(n);
  model.frames.resize(3);
  model.frames[1].parent = 0;
  model.frames[2].parent = branches ? 0 : 1;
  return model;
}

/// x of M x = r; the entries of both are parameters, but those that are 0.
class Solved {
 public:
  Solved(const Model& model, std::vector<double> entries, std::size_t n)
      : numbers_(std::move(entries)) {
    Function function{.kind = OutputKind::bias, .name = "bias"};
    program_.leaves.parameters.resize(numbers_.size(), "m");
    Composition compose(program_, function);
    Places all;
    for (std::uint32_t i = 0; i < numbers_.size(); ++i) {
      all.push_back(numbers_[i] == 0 ? compose.number(0) : compose.leaf(Opcode::parameter, i));
    }
    const auto middle = all.begin() + static_cast<std::ptrdiff_t>(n * n);
    Places x = Factorised(compose, model, {all.begin(), middle}).solve({middle, all.end()});
    function.fields = {{"", static_cast<std::uint32_t>(n), 1, std::move(x)}};
    program_.functions.push_back(std::move(function));
  }

  [[nodiscard]] std::vector<double> x() const {
    Arguments<double> at;
    at.parameters = numbers_;
    return evaluate(program_, program_.functions.front(), at);
  }

  [[nodiscard]] OperationCounts counts() const {
    return count_operations(program_.functions.front());
  }

 private:
  std::vector<double> numbers_;
  Program program_ = {};
};

/// Of an arrow: the first velocity is coupled with both others, these with nothing else.
const std::vector<double> arrow{5, 2, 1, 2, 3, 0, 1, 0, 4, 9, 8, 13};

void check_arrow(const std::vector<double>& x) {
  // 5 x1 + 2 x2 + x3 = 9, 2 x1 + 3 x2 = 8, x1 + 4 x3 = 13
  REQUIRE(x.size() == 3);
  CHECK(5 * x[0] + 2 * x[1] + x[2] == Approx(9).epsilon(1e-14));
  CHECK(2 * x[0] + 3 * x[1] == Approx(8).epsilon(1e-14));
  CHECK(x[0] + 4 * x[2] == Approx(13).epsilon(1e-14));
}

}  // namespace

TEST_CASE("x solves M x = r, in either order") {
  check_arrow(Solved(model_of(3, false), arrow, 3).x());
  check_arrow(Solved(model_of(3, true), arrow, 3).x());
}

TEST_CASE("where limbs branch, zeros between them stay and cost nothing") {
  const OperationCounts filled = Solved(model_of(3, false), arrow, 3).counts();
  const OperationCounts kept = Solved(model_of(3, true), arrow, 3).counts();
  // L_21, L_31 of M, and L_32 where it fills in: 1/D_i each, L_ij, W_ij, and two substitutions.
  CHECK(kept.div == 3);
  CHECK(kept.mul == 11);
  CHECK(filled.mul > kept.mul);
}

TEST_CASE("a diagonal matrix is divided by") {
  const Solved diagonal(model_of(2, false), {2, 0, 0, 4, 6, 6}, 2);
  CHECK(diagonal.x() == std::vector<double>{3, 1.5});
  CHECK(diagonal.counts() == OperationCounts{.mul = 2, .div = 2});
}

}  // namespace elgen::test
