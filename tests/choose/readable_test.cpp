// Expressions and how they are written for a reader.
#include "choose/readable.hpp"

#include <catch2/catch.hpp>

#include "choose/chosen.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

std::string written(const std::string& expression) {
  const std::string text =
      model_text("written",
                 "[[coordinate]]\nname = \"x\"\n[[coordinate]]\nname = \"y\"\n"
                 "[parameters]\na = 2\nb = 3\nc = 5\n[energy]\n"
                 "T = \"1/2*dot(x)^2 + 1/2*dot(y)^2\"\n[[output]]\nname = \"value\"\nvalue = \"" +
                     expression + "\"\n");
  return readable(chosen(text), "value").at(0);
}

}  // namespace

TEST_CASE("the shortest form is written") {
  const std::vector<std::pair<std::string, std::string>> rows{
      {"sin(x)^2 + cos(x)^2", "1"},
      {"a*sin(x)^2 + a*cos(x)^2 + b", "a + b"},
      {"a - a*cos(x)^2", "a*sin(x)^2"},
      {"sin(x)*cos(y) - cos(x)*sin(y)", "sin(x - y)"},
      {"cos(x)*cos(y)*a - sin(x)*sin(y)*a", "a*cos(x + y)"},
      {"2*sin(x)*cos(x)", "2*sin(x)*cos(x)"},
      {"(a^2 - b^2)/(a - b)", "a + b"},
      {"a*b + a*c", "a*(b + c)"},
      {"(a*x + b*x)/(c*x)", "(a + b)/c"},
      {"x/a + y/a^2", "(y + a*x)/a^2"},
      {"sin(x)/(1 - cos(x)^2)", "1/sin(x)"},
      {"b - a", "b - a"},
      {"-(a + b)", "-(a + b)"},
      {"sqrt(1 - x^2)/(1 - x^2)^2", "sqrt(1 - x^2)/(1 - x^2)^2"},
      {"cos(x + pi/2)", "-sin(x)"},
      {"exp(x)*exp(y)/exp(x)", "exp(y)"},
  };
  for (const auto& [expression, expected] : rows) {
    INFO(expression);
    CHECK(written(expression) == expected);
  }
}

TEST_CASE("what is shorter as it was derived is written so only where no digits are lost") {
  CHECK(written("(x + a)^3 - x^3") == "a*(3*x*(a + x) + a^2)");
  CHECK(written("(a - sqrt(x^2 + y^2))^2") == "(a - sqrt(x^2 + y^2))^2");
  // Both have as few digits as the angle has.
  CHECK(written("cos(x + pi/6)") == "cos(1/6*pi + x)");
}

TEST_CASE("no entry of any output holds both squares") {
  // The spherical pendulum: l^2 (theta'^2 + sin(theta)^2 phi'^2) out of three components.
  const Chosen c = chosen(model_text("spherical", R"toml(
[[coordinate]]
name = "theta"
[[coordinate]]
name = "phi"
[parameters]
m = { value = 2, assume = "positive" }
l = { value = 3, assume = "positive" }
[[point]]
name = "bob"
at = ["l*sin(theta)*cos(phi)", "l*sin(theta)*sin(phi)", "-l*cos(theta)"]
mass = "m"
)toml"));
  CHECK(readable(c, "mass_matrix") ==
        std::vector<std::string>{"m*l^2", "0", "0", "m*l^2*sin(theta)^2"});
  CHECK(readable(c, "velocity_force") ==
        std::vector<std::string>{"-m*l^2*sin(theta)*cos(theta)*dot(phi)^2",
                                 "2*m*l^2*sin(theta)*cos(theta)*dot(theta)*dot(phi)"});
}
