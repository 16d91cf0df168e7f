// Pairs of forces that agree at most points but differ elsewhere must not be called equal. Pairs
// that are the same analytic function must be called equal.
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

/// Pairs that are equal in [-1, 1] and differ outside; {} is replaced by a number above 1.
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

/// Pairs that differ on one side of a point, at many points of [-1, 1], or at one point.
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

/// Pairs that are equal everywhere, for any number above 1 in place of {}.
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

/// Pairs that agree at all sampled points and are not proved equal.
constexpr std::array not_told_apart{
    Forms{"abs(x)^2", "x^2"},
    Forms{"abs(x)", "sqrt(x^2)"},
    Forms{"abs(k*x)", "abs(k)*abs(x)"},
    Forms{"asin(x)", "pi/2 - acos(x)"},
    Forms{"asin(x/10)", "pi/2 - acos(x/10)"},
    Forms{"asin(sin(k)/2)*x", "(pi/2 - acos(sin(k)/2))*x"},
    Forms{"abs(x)*sqrt(x^2 + k^2)", "sqrt(x^2*(x^2 + k^2))"},
    Forms{"hypot(x, 2)*abs(x)", "sqrt(x^4 + 4*x^2)"},
    Forms{"max(x, 0)", "(x + abs(x))/2"},
    Forms{"min(x, k)", "-max(-x, -k)"},
    Forms{"max(x, 1e9)", "1e9"},
};

constexpr std::array<const char*, 6> numbers{"(3/2)", "(2)", "(3)", "(5)", "(10)", "(40)"};

std::string force_model(const std::string& force) {
  return model_text("pushed",
                    "[[coordinate]]\nname = \"x\"\n[parameters]\nk = 3\n[energy]\n"
                    "T = \"1/2*dot(x)^2\"\n[[force]]\non = \"x\"\nvalue = \"" +
                        force + "\"\n");
}

Impact impact_of(const std::string& before, const std::string& after) {
  return compared(force_model(before), force_model(after)).impact;
}

}  // namespace

TEST_CASE("forces that differ beyond [-1, 1] are different") {
  for (const Forms& forms : different_beyond) {
    for (const char* const number : numbers) {
      const std::string before = replaced_all(forms.before, "{}", number);
      const std::string after = replaced_all(forms.after, "{}", number);
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

TEST_CASE("forces that are the same analytic function are equal") {
  for (const Forms& forms : equal_everywhere) {
    for (const char* const number : numbers) {
      const std::string before = replaced_all(forms.before, "{}", number);
      const std::string after = replaced_all(forms.after, "{}", number);
      INFO(before << ", " << after);
      CHECK(impact_of(before, after) == Impact::equal);
    }
  }
}

TEST_CASE("roots and kinks in another form are undecided, or different if strict") {
  for (const Forms& forms : not_told_apart) {
    INFO(forms.before << ", " << forms.after);
    const SystemChange change = compared(force_model(forms.before), force_model(forms.after));
    CHECK((change.impact == Impact::equal || change.impact == Impact::extended));
    CHECK_FALSE(change.is_certain);
    CHECK(count_of(change, EntryVerdict::different) == 0);
    for (const OutputChange& output : change.outputs) {
      for (const EntryChange& entry : output.entries) {
        const bool is_open = entry.verdict == EntryVerdict::undecided;
        CHECK(entry.is_certain == !is_open);
        CHECK_FALSE(entry.witness);
      }
    }
    const LoweredVersion old = lowered(force_model(forms.before));
    const LoweredVersion now = lowered(force_model(forms.after));
    const SystemChange strict = compare(old.version(), now.version(), {.is_strict = true});
    CHECK(strict.impact == Impact::different);
    CHECK(strict.is_certain);
  }
}

TEST_CASE("a difference below rounding errors inside the ranges has no witness") {
  const std::string before =
      replaced(force_model("sqrt((x - 2)^2)"), "name = \"x\"", "name = \"x\"\nrange = [-1, 1]");
  const SystemChange change = compared(before, replaced(before, "sqrt((x - 2)^2)", "2 - x"));
  CHECK(change.impact == Impact::different);
  for (const EntryChange& entry : entries_of(change, "applied_force")) {
    CHECK(entry.verdict == EntryVerdict::different);
    CHECK_FALSE(entry.witness);
  }
}

TEST_CASE("a function that is defined only inside the ranges is compared there") {
  const std::string before =
      replaced(force_model("asin(x - 50)"), "name = \"x\"", "name = \"x\"\nrange = [49.5, 50.5]");
  const SystemChange same =
      compared(before, replaced(before, "asin(x - 50)", "pi/2 - acos(x - 50)"));
  CHECK(same.impact == Impact::equal);
  CHECK_FALSE(same.is_certain);
  const SystemChange other =
      compared(before, replaced(before, "asin(x - 50)", "1.000000000001*asin(x - 50)"));
  CHECK(other.impact == Impact::different);
}
