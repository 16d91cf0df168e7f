// The impact of a change, the report on the change, and the words and order of impacts.
#include <catch2/catch.hpp>

#include "diff/versions.hpp"
#include "elgen/diff.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

Impact impact(const std::string& before, const std::string& after) {
  return compared(before, after).impact;
}

}  // namespace

TEST_CASE("impacts from equal to different") {
  CHECK(impact(cart, cart) == Impact::equal);
  CHECK(impact(cart, cart + "# more\n") == Impact::equal);
  CHECK(impact(spring("k*(1 - cos(x))"), spring("2*k*sin(x/2)^2")) == Impact::equal);
  CHECK(impact(spring(), replaced(spring(), "k = 3", "k = 4")) == Impact::values);
  CHECK(impact(cart, replaced(cart, "max = 25", "max = 30")) == Impact::values);
  CHECK(impact(cart, replaced(cart, "\"-g\"", "\"g\"")) == Impact::different);
}

TEST_CASE("keys for drawings change no equation, value or stamp") {
  const std::string point = "[[point]]\nname = \"end\"\nat = [\"x\", \"0\"]\n";
  const LoweredVersion old = lowered(spring() + point);
  const LoweredVersion now =
      lowered(spring() + point + "joined_to = \"origin\"\nas = \"spring\"\n");
  const SystemChange system = compare(old.version(), now.version());
  CHECK(system.impact == Impact::equal);
  CHECK(system.keys.size() == 2);
  CHECK(old.version().checked.model.canonical_text == now.version().checked.model.canonical_text);
  const std::string heavier = replaced(spring(), "dot(x)^2", "dot(x)^2 + dot(x)^2");
  for (const KeyChange& key :
       compared(spring() + point, heavier + point + "joined_to = \"origin\"\n").keys) {
    CHECK((key.impact == Impact::equal) == (key.table == "point"));
  }
}

TEST_CASE("a declared equilibrium changes values only, unless a scene expands about it") {
  const std::string rest = spring() + "[[equilibrium]]\nname = \"rest\"\nat = { x = 0 }\n";
  CHECK(impact(spring(), rest) == Impact::values);
  CHECK(impact(rest, replaced(rest, "x = 0 }", "x = \"0*k\" }")) == Impact::values);
}

TEST_CASE("the sample of an open function changes values, its arguments more") {
  const auto with_function = [](const std::string& keys) {
    return replaced(spring("U"), "[energy]", "[[function]]\nname = \"U\"\n" + keys + "[energy]");
  };
  const std::string x = "of = [\"x\"]\n";
  const std::string sampled = with_function(x + "sample = \"k*x^2\"\n");
  CHECK(impact(sampled, replaced(sampled, "k*x^2", "2*k*x^2")) == Impact::values);
  CHECK(impact(sampled, with_function(x)) == Impact::values);
  CHECK(impact(with_function(x), sampled) == Impact::values);
  CHECK(impact(sampled, replaced(sampled, "[\"x\"]", "[\"2*x\"]")) == Impact::different);
}

TEST_CASE("a scene compared with the default scene has changed keys") {
  const LoweredVersion old = lowered(spring());
  const LoweredVersion now = lowered(spring(), "[outputs]\ngravity = true\n");
  const SystemChange system = compare(old.version(), now.version());
  CHECK(system.impact == Impact::breaks);
  CHECK_FALSE(system.keys.empty());
}

TEST_CASE("a definition may have the name of a descriptive key") {
  const auto defined = [](const std::string& value) {
    return replaced(spring("k*range"), "[energy]", "[define]\nrange = \"" + value + "\"\n[energy]");
  };
  CHECK(impact(defined("x^2"), defined("x^3")) == Impact::different);
  CHECK(impact(defined("x^2"), defined("x*x")) == Impact::equal);
}

TEST_CASE("an assumption that changes entries makes the equations different") {
  const std::string positive = spring("k*sqrt(m^2)*x");
  CHECK(impact(positive, replaced(positive, ", assume = \"positive\"", "")) == Impact::different);
  CHECK(impact(spring(), replaced(spring(), ", assume = \"positive\"", "")) == Impact::values);
}

TEST_CASE("another value of a parameter that a scene fixes is a change of values") {
  const std::string scene = "[outputs]\npotential_energy = true\n[parameters]\nfixed = \"all\"\n";
  const LoweredVersion old = lowered(spring(), scene);
  const LoweredVersion now = lowered(replaced(spring(), "k = 3", "k = 4"), scene);
  const SystemChange system = compare(old.version(), now.version());
  CHECK(system.impact == Impact::values);
  CHECK(entries_of(system, "potential_energy").size() == 1);
}

TEST_CASE("an equal value in another notation is no change") {
  CHECK(impact(spring(), replaced(spring(), "k = 3", "k = \"6/2\"")) == Impact::equal);
  const std::string scene = "[outputs]\ngravity = true\n[parameters]\nfixed = { k = ";
  const LoweredVersion old = lowered(spring(), scene + "3 }\n");
  const LoweredVersion now = lowered(spring(), scene + "\"6/2\" }\n");
  CHECK(compare(old.version(), now.version()).impact == Impact::equal);
}

TEST_CASE("a new term with its own parameter extends") {
  const SystemChange system =
      compared(spring(), replaced(spring("1/2*k*x^2 + c*x^4"), "k = 3", "k = 3\nc = 0"));
  CHECK(system.impact == Impact::extended);
  CHECK(system.extension == "at c = 0 all entries equal the old entries (proved)");
}

TEST_CASE("a new parameter that changes existing terms does not extend") {
  const SystemChange system =
      compared(spring(), replaced(spring("k*x^2 + c*x^4"), "k = 3", "k = 3\nc = 0"));
  CHECK(system.impact == Impact::different);
  CHECK(system.extension.empty());
}

TEST_CASE("a parameter renamed by --rename breaks callers, but changes no key") {
  const std::string other = replaced(replaced(spring(), "k = 3", "c = 3"), "1/2*k", "1/2*c");
  const SystemChange named = compared(spring(), other, {{"k", "c"}});
  CHECK(named.keys.empty());
  CHECK(named.impact == Impact::breaks);
}

TEST_CASE("expectations that no longer hold are listed, unless they never held") {
  const auto broken = compared(cart, replaced(cart, "\"-g\"", "\"g\"")).broken_expectations;
  CHECK(std::ranges::count(broken, "gravity[2]") == 1);
  CHECK(std::ranges::count(broken, "mass_matrix[1,1]") == 0);
  const std::string wrong = replaced(cart, "[\"0\", \"-m*g*l*sin(theta)\"]", "[\"0\", \"0\"]");
  const auto again = compared(wrong, replaced(wrong, "\"-g\"", "\"g\"")).broken_expectations;
  CHECK(std::ranges::count(again, "gravity[2]") == 0);
}

TEST_CASE("new warnings are reported") {
  const SystemChange system = compared(cart, replaced(cart, "\"-g\"", "\"g\""));
  REQUIRE(system.warnings.size() == 1);
  CHECK(code_row(system.warnings[0].code).name == "E512");
  CHECK(compared(replaced(cart, "\"-g\"", "\"g\""), cart).warnings.empty());
}

TEST_CASE("an impact is found by its word") {
  for (const Impact impact : {Impact::equal, Impact::values, Impact::breaks}) {
    CHECK(find_impact(impact_row(impact).word) == impact);
  }
  CHECK_FALSE(find_impact("worse"));
}

TEST_CASE("breaks is the worst impact") {
  CHECK(Impact::equal < Impact::values);
  CHECK(Impact::extended < Impact::different);
  CHECK(Impact::different < Impact::breaks);
}
