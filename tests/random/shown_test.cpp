// Reading of shown equations: the grammar of the model language, and the size of terms.
#include "random/shown.hpp"

#include <catch2/catch.hpp>

using namespace elgen::test::random;

TEST_CASE("expressions are read with the precedence of the language") {
  const Names names{{"x", {3, 3}}, {"dot(x)", {2, 2}}, {"l[2]", {5, 5}}};
  const auto value = [&](const char* text) {
    return static_cast<double>(read_expression(text, names).value);
  };
  CHECK(value("-x^2") == -9);
  CHECK(value("2^3^2") == 512);
  CHECK(value("1 - x - 1") == -3);
  CHECK(value("12/x/2*l[2]") == 10);
  CHECK(value("-(x - dot(x))*-2") == 2);
  CHECK(value("4^(-1/2)") == 0.5);
  CHECK(value("sqrt(x + 1) + max(x, 1.5e1)") == 17);
  CHECK(static_cast<double>(read_expression("x - 3", names).size) == 6);
  CHECK_THROWS(read_expression("2x", names));
  CHECK_THROWS(read_expression("1.5L0*x", names));
  CHECK_THROWS(read_expression("y", names));
}

TEST_CASE("printed expressions are read back to the same value") {
  const Expression x = name("x");
  const Expression e = (number(1) - (x - -number("0.5"))) / (x * (x / number(2))) - raised(-x, 3);
  const Names names{{"x", {Number(7), Number(7)}}};
  const Number expected = (1 - Number(15) / 2) / (Number(49) / 2) + 343;
  CHECK(abs(read_expression(printed(e), names).value - expected) < Number("1e-70"));
}
