// Quaternions of any length come back with length 1.
#include "choose/scaled_length.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "elgen/evaluate.hpp"
#include "lower/read_program.hpp"

using namespace elgen;

namespace {

/// x, and the quaternion w, i, j, k.
Program program() {
  const std::string text =
      "coordinates x w i j k\nfunction normalized\n  0 = coordinate x\n  1 = coordinate w\n"
      "  2 = coordinate i\n  3 = coordinate j\n  4 = coordinate k\n  5 = multiply 1 1\n"
      "  6 = multiply 2 2\n  7 = multiply 3 3\n  8 = multiply 4 4\n  9 = add 5 6\n"
      "  10 = add 9 7\n  11 = add 10 8\n  12 = square_root 11\n  13 = divide 1 12\n"
      "  14 = divide 2 12\n  15 = divide 3 12\n  16 = divide 4 12\n"
      "  result 5 1 = 0 13 14 15 16\n";
  return testing::read_program(text);
}

}  // namespace

TEST_CASE("a length may be as small or as large as numbers get") {
  Program scaled = program();
  scaled.functions[0] = with_scaled_lengths(scaled.functions[0], "normalized");
  CHECK(check_invariants(scaled).empty());
  for (const double size : {1e-300, 1e-160, 1e-3, 1.0, 1e160, 1e300}) {
    Arguments<double> at;
    at.q = {7, size, -2 * size, 2 * size, 4 * size};
    const std::vector<double> e = evaluate(scaled, scaled.functions[0], at);
    CAPTURE(size);
    CHECK(e[0] == 7);
    CHECK(e[1] == Approx(0.2).epsilon(1e-15));
    CHECK(e[2] == Approx(-0.4).epsilon(1e-15));
    CHECK(e[4] == Approx(0.8).epsilon(1e-15));
  }
}

TEST_CASE("no direction is no number") {
  Program scaled = program();
  scaled.functions[0] = with_scaled_lengths(scaled.functions[0], "normalized");
  Arguments<double> at;
  at.q = {7, 0, 0, 0, 0};
  CHECK(std::isnan(evaluate(scaled, scaled.functions[0], at)[1]));
}

TEST_CASE("in `dynamics` the field of that name alone is scaled") {
  Program scaled = program();
  Function& function = scaled.functions[0];
  function.kind = OutputKind::dynamics;
  function.fields.push_back({"unit", 5, 1, function.fields[0].entries});
  function = with_scaled_lengths(function, "unit");
  CHECK(check_invariants(scaled).empty());
  Arguments<double> at;
  at.q = {7, 1e-200, 0, 0, 0};
  const std::vector<double> e = evaluate(scaled, function, at);
  CHECK(std::isinf(e[1]));
  CHECK(e[6] == 1);
}
