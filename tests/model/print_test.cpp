// Printing: what is printed parses back to the same expression.
#include <rapidcheck.h>

#include <catch2/catch.hpp>
#include <utility>

#include "check/check_testing.hpp"

namespace elgen::test {
namespace {

std::string printed(const std::string& text) {
  const std::string head =
      "format = 1\n[model]\nname = \"a\"\n[[coordinate]]\nname = \"x\"\n"
      "[[coordinate]]\nname = \"y\"\n[energy]\nT = \"dot(x)^2 + dot(y)^2\"\nV = \"";
  const Model model = checked(head + text + "\"\n").model;
  return to_string(model, *model.energies.V);
}

TEST_CASE("brackets are printed where they are needed") {
  const std::vector<std::pair<std::string, std::string>> rows{
      {"x + y*2", "x + y*2"},
      {"(x + y)*2", "(x + y)*2"},
      {"x - (y - 2)", "x - (y - 2)"},
      {"x - y - 2", "x - y - 2"},
      {"-x*y", "-x*y"},
      {"-(x + y)", "-(x + y)"},
      {"(-x)^2", "(-x)^2"},
      {"-x^2", "-x^2"},
      {"x/y/2", "x/y/2"},
      {"x/(y*2)", "x/(y*2)"},
      {"x*(y/2)", "x*(y/2)"},
      {"(x/y)*2", "x/y*2"},
      {"x^(1/3)", "x^(1/3)"},
      {"x^-1", "x^(-1)"},
      {"sqrt(x + y)", "sqrt(x + y)"},
      {"(x^2)^3", "(x^2)^3"},
      {"sin(x)^2*atan2(x, y)", "sin(x)^2*atan2(x, y)"},
      {"0.5*x", "1/2*x"},
      {"x*0.5", "x*(1/2)"},
      {"pi*t*x", "pi*t*x"},
      {"x*(-y)", "x*(-y)"},
  };
  for (const auto& [text, expected] : rows) {
    INFO(text);
    CHECK(printed(text) == expected);
    CHECK(printed(printed(text)) == expected);
  }
}

/// A random expression over x, y, t and small numbers.
std::string random_expression(int depth) {
  const std::vector<std::string> leaves{"x", "y", "t", "2", "0.5", "pi", "1/3"};
  if (depth == 0) {
    return *rc::gen::elementOf(leaves);
  }
  const std::string a = random_expression(depth - 1);
  const std::string b = random_expression(depth - 1);
  switch (*rc::gen::inRange(0, 8)) {
    case 0:
      return "(" + a + ") + (" + b + ")";
    case 1:
      return "(" + a + ") - (" + b + ")";
    case 2:
      return "(" + a + ")*(" + b + ")";
    case 3:
      return "(" + a + ")/(x + (" + b + ")^2)";
    case 4:
      return "-(" + a + ")";
    case 5:
      return "(2 + (" + a + ")^2)^(1/3)";
    case 6:
      return "sin(" + a + ")";
    default:
      return "sqrt(3 + (" + b + ")^2)";
  }
}

TEST_CASE("what is printed parses back and prints the same") {
  CHECK(rc::check("print, parse, print", [] {
    const std::string once = printed("x + " + random_expression(3));
    RC_ASSERT(printed(once) == once);
  }));
}

}  // namespace
}  // namespace elgen::test
