// Values at a random point: errors in double and in 64 digits give the same results.
#include "forms/cancel/sampled_values.hpp"

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <map>

#include "forms/cancel/gravity_program.hpp"
#include "sample/points.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

using enum SampledValue;
using Samples = std::vector<SampledValue>;

/// The values of all instructions at the random point of `seed`, which both routes must give.
Samples sampled(const Program& program, std::uint64_t seed = 1) {
  const Function& function = program.functions[0];
  const std::vector<bool> needed(function.instructions.size(), true);
  RandomPoint point{Sampler(seed).point(program.leaves)};
  point.variables.resize(needed.size());
  Samples values = sample_values(program, function, needed, point);
  CHECK(values == sample_in_64_digits(program, function, needed, point));
  return values;
}

SampledValue last_value(const std::string& instructions) {
  return sampled(gravity_program(instructions)).back();
}

/// A random program of `size` operations, in text form. Some operations compute a (b + c), a b +
/// a c and the difference, which vanishes.
std::string random_instructions(std::uint64_t seed, std::size_t size) {
  Random random(seed);
  std::vector<std::string> lines{"parameter m",  "parameter l",         "coordinate x",
                                 "coordinate y", "constant 1000000001", "constant 1/3"};
  const auto any = [&] { return random.next() % lines.size(); };
  const auto append = [&](const std::string& name, std::size_t a, std::size_t b) {
    lines.push_back(fmt::format("{} {} {}", name, a, b));
    return lines.size() - 1;
  };
  const std::vector<std::string> unary{"sin", "cos", "exp", "tanh", "log", "square_root", "negate"};
  const std::vector<std::string> binary{"add", "subtract", "multiply", "divide", "atan2"};
  while (lines.size() < size) {
    const std::uint64_t kind = random.next() % 8;
    if (kind == 0) {
      const std::size_t a = any();
      const std::size_t b = any();
      const std::size_t c = any();
      const std::size_t whole = append("multiply", a, append("add", b, c));
      const std::size_t parts = append("add", append("multiply", a, b), append("multiply", a, c));
      append("subtract", whole, parts);
    } else if (kind < 3) {
      lines.push_back(fmt::format("{} {}", unary[random.next() % unary.size()], any()));
    } else {
      append(binary[random.next() % binary.size()], any(), any());
    }
  }
  std::string text;
  std::string entries;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    text += fmt::format("  {} = {}\n", i, lines[i]);
    entries += fmt::format(" {}", i);
  }
  return text + fmt::format("  result {} 1 ={}\n", lines.size(), entries);
}

}  // namespace

TEST_CASE("errors in double decide as errors in 64 digits do, in random programs") {
  std::map<SampledValue, std::size_t> counts;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    INFO(seed);
    const Program program = gravity_program(random_instructions(seed, 60));
    for (const SampledValue value : sampled(program, seed)) ++counts[value];
  }
  // Each result occurs often.
  for (const SampledValue value : {nonzero, zero, undefined}) CHECK(counts[value] > 500);
}

TEST_CASE("a difference that vanishes is zero, and so are its products") {
  CHECK(sampled(gravity_program("  0 = coordinate x\n  1 = coordinate y\n  2 = add 0 1\n"
                                "  3 = subtract 0 1\n  4 = multiply 2 3\n  5 = multiply 0 0\n"
                                "  6 = multiply 1 1\n  7 = subtract 5 6\n  8 = subtract 4 7\n"
                                "  9 = multiply 8 0\n  10 = divide 0 8\n  11 = add 10 8\n"
                                "  result 1 3 = 9 10 11\n")) ==
        Samples{nonzero, nonzero, nonzero, nonzero, nonzero, nonzero, nonzero, nonzero, zero, zero,
                undefined, undefined});
}

TEST_CASE("numbers outside the range of double are decided in 64 digits") {
  const std::string zeros(200, '0');
  // (x/1e200)^2 is 0 in double and has an error of one denormal number; (1e200 x)^2; and
  // x/1e200 - x/1e200
  CHECK(last_value("  0 = coordinate x\n  1 = constant 1/1" + zeros +
                   "\n  2 = multiply 0 1\n  3 = multiply 2 2\n  result 1 1 = 3\n") == zero);
  CHECK(last_value("  0 = coordinate x\n  1 = constant 1" + zeros +
                   "\n  2 = multiply 0 1\n  3 = multiply 2 2\n  result 1 1 = 3\n") == nonzero);
  CHECK(last_value("  0 = coordinate x\n  1 = constant 1/1" + zeros +
                   "\n  2 = multiply 0 1\n  3 = negate 2\n  4 = add 2 3\n  result 1 1 = 4\n") ==
        zero);
}

TEST_CASE("exponential functions at remote arguments have the values of their limits") {
  // exp(-1e10 m), exp(1e10 m) and tanh(1e10 m) - 1, which hides a difference
  const std::string remote =
      "  0 = parameter m\n  1 = constant 10000000000\n  2 = multiply 0 1\n  3 = negate 2\n";
  CHECK(last_value(remote + "  4 = exp 3\n  result 1 1 = 4\n") == nonzero);
  CHECK(last_value(remote + "  4 = exp 2\n  result 1 1 = 4\n") == nonzero);
  CHECK(last_value(remote +
                   "  4 = tanh 2\n  5 = constant 1\n  6 = subtract 4 5\n  result 1 1 = 6\n") ==
        nonzero);
}

TEST_CASE("a random number replaces an instruction that is a variable") {
  const Program program =
      gravity_program("  0 = coordinate x\n  1 = subtract 0 0\n  2 = add 1 0\n  result 1 1 = 2\n");
  const Function& function = program.functions[0];
  RandomPoint point{Sampler(1).point(program.leaves)};
  point.variables = {std::nullopt, cln::cl_RA(7), std::nullopt};
  const std::vector<bool> needed(3, true);
  CHECK(sample_values(program, function, needed, point) == Samples(3, nonzero));
  point.variables = {std::nullopt, -point.leaves.q.at(0), std::nullopt};
  CHECK(sample_values(program, function, needed, point) == Samples{nonzero, nonzero, zero});
}
