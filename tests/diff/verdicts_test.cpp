// Edits of models and scenes with their expected impact.
#include <catch2/catch.hpp>

#include "diff/versions.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

std::string word(Impact impact) { return std::string(impact_row(impact).word); }

/// A mass on a spring: `parameters` declares k, and e if needed; V is the potential.
std::string oscillator(const std::string& parameters, const std::string& V) {
  return model_text("oscillator",
                    "[[coordinate]]\nname = \"x\"\n[parameters]\nm = { value = 2, assume = "
                    "\"positive\" }\n" +
                        parameters +
                        "\n[energy]\n"
                        "T = \"1/2*m*dot(x)^2\"\nV = \"" +
                        V + "\"\n");
}

struct Oscillators {
  const char* before[2];  ///< parameters and V
  const char* after[2];
  Impact impact;
};

constexpr const char* any = "k = 3";
constexpr const char* positive = "k = { value = 3, assume = \"positive\" }";
constexpr const char* with_zero = "k = 3\ne = 0";

const Oscillators oscillators[]{
    // Roots, with and without assumptions.
    {{any, "k*x^2"}, {any, "sqrt(k^2)*x^2"}, Impact::different},
    {{positive, "k*x^2"}, {positive, "sqrt(k^2)*x^2"}, Impact::equal},
    {{positive, "k*x^2"}, {any, "sqrt(k^2)*x^2"}, Impact::different},
    {{any, "k*x^2"}, {positive, "sqrt(k^2)*x^2"}, Impact::values},
    {{positive, "k*x^2"}, {any, "k*x^2"}, Impact::values},
    {{any, "k^2*x^2"}, {any, "sqrt(k^4)*x^2"}, Impact::equal},  // undecided: k may be 0
    {{any, "k*x"}, {any, "k*sqrt(x^2)"}, Impact::different},
    {{any, "k*x^2"}, {any, "k*sqrt(x^4)"}, Impact::equal},  // undecided: x^4 may be 0
    {{positive, "k*sqrt(1 + x^2)"}, {positive, "sqrt(k^2 + k^2*x^2)"}, Impact::equal},
    {{any, "k*sqrt(1 + x^2)"}, {any, "sqrt(k^2 + k^2*x^2)"}, Impact::different},
    // Terms with a parameter of value 0.
    {{with_zero, "k*x^2 + e*x^3"}, {with_zero, "k*x^2 + e*x^4"}, Impact::different},
    {{with_zero, "k*x^2 + e*x^3"}, {with_zero, "x*e*x^2 + k*x*x"}, Impact::equal},
    {{with_zero, "k*x^2 + e*x^3"}, {with_zero, "k*x^2 + 1.000000000001*e*x^3"}, Impact::different},
    {{with_zero, "k*x^2*exp(e)"}, {with_zero, "k*x^2*exp(2*e)"}, Impact::different},
    {{with_zero, "k*x^2 + e*x^3"}, {"k = 3\ne = 1", "k*x^2 + e*x^3"}, Impact::values},
    // Terms that depend on time.
    {{any, "k*x^2"}, {any, "k*x^2 + x*sin(t)"}, Impact::breaks},
    {{any, "k*x^2 + x*sin(t)"}, {any, "k*x^2 + 2*x*sin(t/2)*cos(t/2)"}, Impact::equal},
    {{any, "k*x^2 + x*sin(t)"}, {any, "k*x^2 + x*sin(1.000000000001*t)"}, Impact::different},
    {{any, "k*x^2 + x*sin(t)"}, {any, "k*x^2"}, Impact::breaks},
    // New parameters.
    {{any, "k*x^2"}, {"k = 3\ne = 0", "k*x^2 + e*x^4"}, Impact::extended},
    {{any, "k*x^2"}, {"k = 3\ne = 5", "k*x^2 + e*x^4"}, Impact::extended},
    {{any, "k*x^2"}, {"k = 3\ne = 5", "k*x^2 + x^4 + e*x^3"}, Impact::different},
    {{any, "k*x^2"}, {"k = 3\ne = 0", "k*x^2*cos(e)"}, Impact::extended},
    {{any, "k*x^2"}, {"e = 0\nk = 3", "k*x^2 + e*x^4"}, Impact::breaks},
    {{with_zero, "k*x^2 + e*x^4"}, {any, "k*x^2"}, Impact::breaks},
};

}  // namespace

TEST_CASE("roots, zeros, time and new parameters of an oscillator have the expected impact") {
  for (const auto& [before, after, impact] : oscillators) {
    INFO(before[0] << ", " << before[1] << " -> " << after[0] << ", " << after[1]);
    CHECK(word(compared(oscillator(before[0], before[1]), oscillator(after[0], after[1])).impact) ==
          word(impact));
  }
}

TEST_CASE("an added body extends, because its mass may be 0, whatever its value") {
  const std::string before = model_text("pendulum", R"toml([[coordinate]]
name = "q1"
[[coordinate]]
name = "q2"
[parameters]
m = { value = 2, assume = "positive" }
l = { value = "1/2", assume = "positive" }
g = 9.81
[[point]]
name = "upper"
at = ["l*sin(q1)", "-l*cos(q1)"]
mass = "m"
[[point]]
name = "lower"
at = ["x(upper) + l*sin(q2)", "y(upper) - l*cos(q2)"]
mass = "m"
[gravity]
vector = ["0", "-g"]
)toml");
  for (const std::string value : {"0", "1/2"}) {
    const std::string after = replaced(
        replaced(before, "[[point]]", "mt = \"" + value + "\"\n[[point]]"), "[gravity]",
        "[[point]]\nname = \"tool\"\nat = [\"x(lower)\", \"y(lower) - l\"]\nmass = \"mt\"\n"
        "[gravity]");
    const SystemChange found = compared(before, after);
    CHECK(word(found.impact) == "extended");
    CHECK(found.extension == "at mt = 0 all entries equal the old entries (proved)");
    const std::string wrong = replaced(after, "mass = \"m\"", "mass = \"1.000000000001*m\"");
    CHECK(word(compared(before, wrong).impact) == "different");
  }
}

TEST_CASE("with a given renaming parameters and coordinates are matched") {
  const std::string before = spring("1/2*k*x^2");
  const std::string m = replaced(replaced(before, "m = {", "mass = {"), "2*m*dot", "2*mass*dot");
  const std::string wrong = replaced(m, "2*mass*dot", "2.000000000002*mass*dot");
  const Renames renames{{"m", "mass"}};
  const SystemChange found = compared(before, m, renames);
  CHECK(word(found.impact) == "breaks");
  CHECK(count_of(found, EntryVerdict::different) == 0);
  CHECK(count_of(compared(before, wrong, renames), EntryVerdict::different) > 0);

  const std::string y = replaced(
      replaced(replaced(before, "name = \"x\"", "name = \"y\""), "dot(x)", "dot(y)"), "k*x", "k*y");
  const Renames moved{{"x", "y"}};
  CHECK(word(compared(before, y, moved).impact) == "values");
  CHECK(count_of(compared(before, y, moved), EntryVerdict::different) == 0);
  CHECK(breaks_silently(compared(before, y)));
}

TEST_CASE("an arm of seven joints is compared beyond the limit of closed forms") {
  const std::string before = model_file("panda7");
  const std::string after =
      replaced(before, R"(["I5xx", "I5yy", "I5zz", "I5xy", "I5xz", "I5yz"])",
               R"toml(["I5xx + m5*(c5y^2 + c5z^2)", "I5yy + m5*(c5x^2 + c5z^2)",
                 "I5zz + m5*(c5x^2 + c5y^2)", "I5xy - m5*c5x*c5y", "I5xz - m5*c5x*c5z",
                 "I5yz - m5*c5y*c5z"]
inertia_about = "origin")toml");
  const SystemChange found = compared(before, after);
  CHECK(word(found.impact) == "equal");
  const auto is_sampled = [](const OutputChange& output) {
    return std::ranges::any_of(output.entries, [](const EntryChange& entry) {
      return entry.verdict == EntryVerdict::equal && !entry.is_proved;
    });
  };
  CHECK(std::ranges::any_of(found.outputs, is_sampled));
  const SystemChange wrong =
      compared(before, replaced(after, "m5*c5x*c5z", "1.000000000001*m5*c5x*c5z"));
  CHECK(word(wrong.impact) == "different");
}

namespace {

/// An edit of a scene or of its model (`other` replaces `part`), and the expected impact.
struct SceneEdit {
  const char* model;
  const char* scene;
  const char* part;
  const char* other;
  Impact impact;
};

constexpr const char* fixed = "[outputs]\nbias = true\n[parameters]\nfixed = { g = 9.81 }\n";
constexpr const char* locked = "[lock]\ntheta = { value = \"pi/6\" }\n";
constexpr const char* expanded = "[approximate]\norder = 1\nabout = { theta = 0 }\n";
constexpr const char* emitted =
    "[outputs]\nbias = true\n[numeric]\nscalar = [\"double\"]\n[emit]\neigen = true\n";
constexpr const char* held = "[outputs]\nbias = true\n[routh]\nphi = true\n";
constexpr const char* stepped = "[outputs]\nstep = { method = \"rk4\" }\n";

const SceneEdit scene_edits[]{
    {"cart_pole", fixed, "9.81 }", "9.80665 }", Impact::values},
    {"cart_pole", fixed, "9.81 }", "\"981/100\" }", Impact::equal},
    {"cart_pole", fixed, "fixed = { g = 9.81 }", "", Impact::extended},
    {"cart_pole", fixed, "g = 9.81 }", "g = 9.81, m = 0.1 }", Impact::breaks},
    {"cart_pole", fixed, "g = 9.81 }", "g = 9.81, m = 1 }", Impact::breaks},
    {"cart_pole", fixed, "bias = true", "bias = true\ngravity = true", Impact::extended},
    {"cart_pole", fixed, "bias", "gravity", Impact::breaks},
    {"cart_pole", fixed, "true", "{ rename = \"h\" }", Impact::breaks},
    {"cart_pole", fixed, "[outputs]", "# needed\n[outputs]", Impact::equal},
    {"cart_pole", locked, "pi/6", "1/6*pi", Impact::equal},
    {"cart_pole", locked, "pi/6", "pi/7", Impact::different},
    {"cart_pole", locked, "\"pi/6\"", "\"pi/6\", reaction = true", Impact::extended},
    {"cart_pole", expanded, "order = 1", "order = 3", Impact::different},
    {"cart_pole", expanded, "theta = 0", "theta = \"pi\"", Impact::different},
    {"cart_pole", expanded, "theta = 0", "theta = \"1 - 1\"", Impact::equal},
    {"cart_pole", emitted, "eigen = true", "storage = \"column-major\"", Impact::breaks},
    {"cart_pole", emitted, "eigen = true", "eigen = true\nbatch = true", Impact::extended},
    {"cart_pole", emitted, "eigen = true", "language = \"c99\"", Impact::breaks},
    {"cart_pole", emitted, "eigen = true", "eigen = true\nnamespace = \"cart\"", Impact::breaks},
    {"cart_pole", emitted, "[\"double\"]", "[\"double\", \"float\"]", Impact::values},
    {"cart_pole", stepped, "rk4", "midpoint", Impact::different},
    {"kepler_polar", held, "phi = true", "phi = \"0.6\"", Impact::equal},
    {"kepler_polar", held, "phi = true", "phi = \"0.7\"", Impact::values},
    {"kepler_polar", held, "[routh]\nphi = true\n", "", Impact::breaks},
    {"chain", "[sizes]\nn = 3\n", "n = 3", "n = 4", Impact::breaks},
};

}  // namespace

TEST_CASE("edits of scenes have the expected impact") {
  for (const auto& [model, scene, part, other, impact] : scene_edits) {
    INFO(model << ": " << part << " -> " << other);
    const std::string text = model_file(model);
    const Goal goal = std::string(scene) == stepped ? Goal::choose : Goal::lower;
    const LoweredVersion old = lowered(text, scene, goal);
    const LoweredVersion now = lowered(text, replaced(scene, part, other), goal);
    CHECK(word(compare(old.version(), now.version()).impact) == word(impact));
  }
}

TEST_CASE("a model is compared as specialised by its scene") {
  const std::string before = model_file("two_mass_damper");
  const std::string moved = replaced(before, "1/2*kc*(x1 - x2)^2", "1/2*kc*(x1 + x2)^2");
  const auto verdict = [&](const std::string& after, const std::string& scene) {
    const LoweredVersion old = lowered(before, scene);
    const LoweredVersion now = lowered(after, scene);
    return word(compare(old.version(), now.version()).impact);
  };
  CHECK(verdict(moved, "[parameters]\nfixed = { kc = 0 }\n") == "equal");
  CHECK(verdict(moved, "[parameters]\nfixed = { kc = 1 }\n") == "different");
  const std::string value = replaced(before, "kc = { value = 1,", "kc = { value = 2,");
  CHECK(verdict(value, "[parameters]\nfixed = \"all\"\n") == "values");
  CHECK(verdict(value, "[parameters]\nfixed = { kc = 3 }\n") == "values");
}

TEST_CASE("a parameter fixed at its own value changes no entry") {
  const std::string outputs = "[outputs]\nmass_matrix = true\nbias = true\n[parameters]\n";
  const LoweredVersion old = lowered(cart, outputs);
  for (const std::string value : {"0.1", "\"1/10\""}) {
    const LoweredVersion now = lowered(cart, outputs + "fixed = { m = " + value + " }\n");
    for (const bool is_new : {true, false}) {
      const SystemChange found =
          is_new ? compare(old.version(), now.version()) : compare(now.version(), old.version());
      CHECK(count_of(found, EntryVerdict::different) == 0);
      CHECK(word(found.impact) == "breaks");  // a member of Parameters disappears or appears
    }
  }
  const LoweredVersion other = lowered(cart, outputs + "fixed = { m = 0.2 }\n");
  CHECK(count_of(compare(old.version(), other.version()), EntryVerdict::different) > 0);
}

TEST_CASE("a parameter that no output uses may be fixed or renamed") {
  const std::string outputs = "[outputs]\ngravity = true\n[parameters]\n";
  const LoweredVersion old = lowered(spring(), outputs);
  for (const std::string value : {"2", "7"}) {
    const LoweredVersion now = lowered(spring(), outputs + "fixed = { m = " + value + " }\n");
    CHECK(word(compare(old.version(), now.version()).impact) == "values");
  }
  const LoweredVersion named =
      lowered(replaced(replaced(spring(), "k = 3", "c = 3"), "1/2*k", "1/2*c"),
              outputs + "fixed = { c = 3 }\n");
  const SystemChange found = compare(old.version(), named.version(), {.renames = {{"k", "c"}}});
  CHECK(count_of(found, EntryVerdict::different) == 0);
  CHECK(count_of(compare(named.version(), old.version(), {.renames = {{"c", "k"}}}),
                 EntryVerdict::different) == 0);
}
