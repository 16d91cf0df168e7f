// SPDX-License-Identifier: GPL-3.0-or-later
// Forces that agree where one happens to look, and are other functions elsewhere: none of them is
// called equal. Forces that are one function are, where they are analytic.
#include <fmt/format.h>

#include <array>

#include "diff/versions.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

struct Forms {
  const char* before;
  const char* after;
};

/// With {} for a number above 1: alike in [-1, 1].
constexpr std::array different_beyond{
    Forms{"max(x - {}, 0)", "0*x"},
    Forms{"min(x, {})", "x"},
    Forms{"abs(x - {})", "{} - x"},
    Forms{"sqrt((x - {})^2)", "{} - x"},
    Forms{"sign(x - {})*x", "-x"},
    Forms{"sqrt((x + {})^2)", "x + {}"},
    Forms{"log(({} + x)^2)", "2*log({} + x)"},
    Forms{"max(x, -{})", "x"},
};

/// Different on one side, at many points of [-1, 1] or at one of them.
constexpr std::array different_somewhere{
    Forms{"-k*max(x - pi/2, 0)", "-2*k*max(x - pi/2, 0)"},
    Forms{"atan2(sin(x), cos(x))", "x"},
    Forms{"asin(sin(x))", "x"},
    Forms{"acos(cos(x))", "x"},
    Forms{"atan(tan(x))", "x"},
    Forms{"sqrt(x^2)", "x"},
    Forms{"abs(x)", "x"},
    Forms{"sqrt(1 + 1/x^2)*x", "sqrt(x^2 + 1)"},
    Forms{"atan(x) + atan(1/x)", "pi/2"},
    Forms{"sign(x)^2*k", "k"},
    Forms{"abs(x^2 - 4)", "4 - x^2"},
    Forms{"max(x, 1e5)", "1e5"},
};

/// With {} for a number above 1, wherever x is.
constexpr std::array equal_everywhere{
    Forms{"(x - {})^2", "x^2 - 2*{}*x + {}^2"},
    Forms{"exp(x + {})", "exp(x)*exp({})"},
    Forms{"sqrt(x^2 + {})*sqrt(x^2 + {})", "x^2 + {}"},
    Forms{"log(exp(x)*{})", "x + log({})"},
    Forms{"sqrt((x^2 + {})^2)", "x^2 + {}"},
    Forms{"{}*cosh(x)^2 - {}*sinh(x)^2", "{}"},
    Forms{"sin({}*x + x)", "sin({}*x)*cos(x) + cos({}*x)*sin(x)"},
    Forms{"atan2(x*(x^2 + {}), x^2 + {})", "atan(x)"},
    Forms{"sqrt({}*exp(2*x))", "exp(x)*sqrt({})"},
};

constexpr std::array<const char*, 6> numbers{"3/2", "2", "3", "5", "10", "40"};

/// Every {} replaced.
std::string with_number(std::string text, const std::string& number) {
  for (std::size_t at = 0; (at = text.find("{}", at)) != std::string::npos;) {
    text.replace(at, 2, "(" + number + ")");
  }
  return text;
}

Impact impact_of(const std::string& before, const std::string& after) {
  const auto pushed = [](const std::string& force) {
    return model_text("pushed",
                      "[[coordinate]]\nname = \"x\"\n[parameters]\nk = 3\n[energy]\n"
                      "T = \"1/2*dot(x)^2\"\n[[force]]\non = \"x\"\nvalue = \"" +
                          force + "\"\n");
  };
  return compared(pushed(before), pushed(after)).impact;
}

}  // namespace

TEST_CASE("forces that differ beyond [-1, 1] are different") {
  for (const Forms& forms : different_beyond) {
    for (const char* const number : numbers) {
      const std::string before = with_number(forms.before, number);
      const std::string after = with_number(forms.after, number);
      INFO(before << ", " << after);
      CHECK(impact_of(before, after) == Impact::different);
    }
  }
}

TEST_CASE("forces that differ on one side, or at one point, are different") {
  for (const Forms& forms : different_somewhere) {
    INFO(forms.before << ", " << forms.after);
    CHECK(impact_of(forms.before, forms.after) == Impact::different);
  }
}

TEST_CASE("forces that are one analytic function are equal") {
  for (const Forms& forms : equal_everywhere) {
    for (const char* const number : numbers) {
      const std::string before = with_number(forms.before, number);
      const std::string after = with_number(forms.after, number);
      INFO(before << ", " << after);
      CHECK(impact_of(before, after) == Impact::equal);
    }
  }
}

TEST_CASE("an entry that agrees at all points and is not proved is told as that") {
  const std::string before =
      model_text("pushed",
                 "[[coordinate]]\nname = \"x\"\n[energy]\nT = \"1/2*dot(x)^2\"\n"
                 "[[force]]\non = \"x\"\nvalue = \"max(x, 1e5)\"\n");
  const SystemChange change = compared(before, edited(before, "max(x, 1e5)", "1e5"));
  for (const OutputChange& output : change.outputs) {
    for (const EntryChange& entry : output.entries) {
      CHECK(entry.is_told_apart == (entry.verdict == EntryVerdict::added));
    }
  }
}
