// The symbolic factorisation M = L D L^T, evaluated with numbers.
#include <catch2/catch.hpp>

#include "elgen/evaluate.hpp"
#include "program/steps/composition.hpp"

namespace elgen::test {
namespace {

/// A model with n velocities, on a chain of frames or on two branches.
Model model_of(std::size_t n, bool branches) {
  Model model;
  model.velocities.resize(n);
  model.frames.resize(3);
  model.frames[1].parent = 0;
  model.frames[2].parent = branches ? 0 : 1;
  return model;
}

/// Solves M x = r. Non-zero entries of M and r are parameters.
class LinearSolution {
 public:
  LinearSolution(const Model& model, std::vector<double> entries, std::size_t n)
      : numbers_(std::move(entries)) {
    Function function{.kind = OutputKind::bias, .name = "bias"};
    program_.leaves.parameters.resize(numbers_.size(), "m");
    Composition compose(program_, function);
    InstructionIndices all;
    for (std::uint32_t i = 0; i < numbers_.size(); ++i) {
      all.push_back(numbers_[i] == 0 ? compose.add_number(0)
                                     : compose.add_leaf(Opcode::parameter, i));
    }
    const auto middle = all.begin() + static_cast<std::ptrdiff_t>(n * n);
    const MassFactorisation mass(compose, elimination_order(model), {all.begin(), middle});
    InstructionIndices x = mass.solve({middle, all.end()});
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

/// An arrow matrix and its right side: x2 and x3 are coupled with x1, but not with each other.
const std::vector<double> arrow{5, 2, 1, 2, 3, 0, 1, 0, 4, 9, 8, 13};

void check_arrow(const std::vector<double>& x) {
  // 5 x1 + 2 x2 + x3 = 9, 2 x1 + 3 x2 = 8, x1 + 4 x3 = 13
  REQUIRE(x.size() == 3);
  CHECK(5 * x[0] + 2 * x[1] + x[2] == Approx(9).epsilon(1e-14));
  CHECK(2 * x[0] + 3 * x[1] == Approx(8).epsilon(1e-14));
  CHECK(x[0] + 4 * x[2] == Approx(13).epsilon(1e-14));
}

}  // namespace

TEST_CASE("x solves M x = r in both orders of elimination") {
  check_arrow(LinearSolution(model_of(3, false), arrow, 3).x());
  check_arrow(LinearSolution(model_of(3, true), arrow, 3).x());
}

TEST_CASE("zeros between branches stay zero and cost nothing") {
  const OperationCounts filled = LinearSolution(model_of(3, false), arrow, 3).counts();
  const OperationCounts kept = LinearSolution(model_of(3, true), arrow, 3).counts();
  // Three reciprocals 1/D_i and 11 products. The two entries L_ij need 2 products in L, 2 in D and
  // 4 in the substitutions; the 1/D_i need 3. On a chain L_32 is not 0.
  CHECK(kept.div == 3);
  CHECK(kept.mul == 11);
  CHECK(filled.mul > kept.mul);
}

TEST_CASE("a diagonal matrix only needs divisions") {
  const LinearSolution diagonal(model_of(2, false), {2, 0, 0, 4, 6, 6}, 2);
  CHECK(diagonal.x() == std::vector<double>{3, 1.5});
  CHECK(diagonal.counts() == OperationCounts{.mul = 2, .div = 2});
}

namespace {

/// Solves M x = c for many columns c. M has 4, 5, 6 on its diagonal and `coupling` elsewhere. The
/// integers -2 ... 6 in M and c are parameters.
struct Columns {
  Columns(const std::vector<std::vector<int>>& columns, int coupling) {
    for (int i = -2; i <= 6; ++i) numbers.push_back(i);
    program.leaves.parameters.resize(numbers.size(), "m");
    program.leaves.v = {"x", "y", "z"};
    Function function{.kind = OutputKind::bias, .name = "bias"};
    Composition compose(program, function);
    const auto place = [&](int number) {
      return number == 0
                 ? compose.add_number(0)
                 : compose.add_leaf(Opcode::parameter, static_cast<std::uint32_t>(number + 2));
    };
    InstructionIndices mass;
    for (const int entry : {4, coupling, coupling, coupling, 5, coupling, coupling, coupling, 6})
      mass.push_back(place(entry));
    std::vector<InstructionIndices> right;
    for (const std::vector<int>& column : columns) {
      InstructionIndices& places = right.emplace_back();
      for (const int entry : column) places.push_back(place(entry));
    }
    const MassFactorisation factors(compose, {2, 1, 0}, mass);
    InstructionIndices entries;
    for (const InstructionIndices& x : factors.solve_columns(right)) {
      entries.insert(entries.end(), x.begin(), x.end());
    }
    function.fields = {{"", static_cast<std::uint32_t>(columns.size()), 3, std::move(entries)}};
    program.functions.push_back(eliminate_dead_code(function));
  }

  [[nodiscard]] std::uint32_t repetitions() const { return program.functions[0].repeated.count; }

  std::vector<double> numbers = {};
  Program program = {};
};

std::vector<std::vector<int>> columns_of(int count) {
  std::vector<std::vector<int>> columns;
  for (int i = 0; i < count; ++i) columns.push_back({i % 7 - 2, 5 * i % 9 - 2, i % 5 - 1});
  return columns;
}

}  // namespace

TEST_CASE("many columns become repetitions, even if some have zeros") {
  CHECK(Columns(columns_of(15), 1).repetitions() == 0);
  std::vector<std::vector<int>> right = columns_of(20);
  right.insert(right.begin() + 4, {0, 0, 0});
  const Columns many(right, 1);
  CHECK(many.repetitions() == 20);
  CHECK(find_invariant_violation(many.program) == "");
  Arguments<double> at;
  at.parameters = many.numbers;
  const std::vector<double> x = evaluate(many.program, many.program.functions[0], at);
  for (std::size_t i = 0; i < right.size(); ++i) {
    const double* const y = &x[3 * i];
    CHECK(4 * y[0] + y[1] + y[2] == Approx(right[i][0]).margin(1e-14));
    CHECK(y[0] + 5 * y[1] + y[2] == Approx(right[i][1]).margin(1e-14));
    CHECK(y[0] + y[1] + 6 * y[2] == Approx(right[i][2]).margin(1e-14));
  }
}

TEST_CASE("unit columns with a diagonal M become straight-line code") {
  std::vector<std::vector<int>> columns;
  for (int i = 0; i < 18; ++i) columns.push_back({i % 3 == 0, i % 3 == 1, i % 3 == 2});
  CHECK(Columns(columns, 0).repetitions() == 0);
}

}  // namespace elgen::test
