// elgen verify at the limit of precision: correct code does not fail, and undecided states are
// counted.
#include <catch2/catch.hpp>

#include "cli/cli_testing.hpp"

namespace elgen::test {

TEST_CASE("correct code that loses digits by cancellation does not fail") {
  const Workspace workspace;
  const auto write = [&workspace](const std::string& name, const std::string& parameters,
                                  const std::string& potential, const std::string& range = "") {
    workspace.write(name + ".toml",
                    "format = 1\n[model]\nname = \"" + name + "\"\n[[coordinate]]\nname = \"x\"\n" +
                        range + "[parameters]\n" + parameters +
                        "[energy]\nT = \"1/2*dot(x)^2\"\nV = \"" + potential + "\"\n");
  };
  write("strut", "k = 40.0\na = 1.0\nb = 1.0\n", "k*sqrt(a^2 + b^2 - 2*a*b*cos(x))");
  write("sinc_well", "k = { value = 3.0, assume = \"positive\" }\n", "k*(1 - sin(x)/x)",
        "range = [1e-06, 3]\n");
  write("cosc_well", "", "(1 - cos(x))/x^2");
  write("equal_sides", "a = 1.5\nk = 40\n", "k*sqrt(a^2 + a^2 - 2*a*a*cos(x))");
  write("hyperbolic", "", "(cosh(x) - 1)/x^2");
  write("cubic", "k = 2\n", "k*(x - sin(x))/x^3");
  for (const std::string seed : {"1", "3", "8"}) {
    const Outcome outcome = workspace.run("elgen verify --quick --seed " + seed + " *.toml");
    INFO(outcome.output + outcome.errors);
    CHECK(outcome.status == 0);
    CHECK_FALSE(mentions(outcome.output, "FAILS"));
  }
}

TEST_CASE("functions of doubles with a wider inner scalar have all digits") {
  const Workspace workspace;
  workspace.write("rod.toml",
                  "format = 1\n[model]\nname = \"rod\"\n[[coordinate]]\nname = \"x\"\n"
                  "range = [-30, 30]\n[parameters]\nk = { value = 3.0, assume = \"positive\" }\n"
                  "r = { value = 0.5, assume = \"positive\" }\n[energy]\nT = \"1/2*dot(x)^2\"\n"
                  "V = \"k*log((x + sqrt(x^2 + r^2))/r)\"\n");
  workspace.write("cubic.toml",
                  "format = 1\n[model]\nname = \"cubic\"\n[[coordinate]]\nname = \"x\"\n"
                  "range = [0.01, 3]\n[energy]\nT = \"1/2*dot(x)^2\"\n"
                  "V = \"(tan(x/2) - sin(x)/2)/x + sinc(x) - cosc(x)\"\n");
  const std::string inner = GENERATE("long double", "double-double");
  for (const std::string name : {"rod", "cubic"}) {
    workspace.write(name + ".scene.toml", "format = 1\nmodel = \"" + name +
                                              ".toml\"\nname = \"wide\"\n[numeric]\ninner = \"" +
                                              inner + "\"\n");
    const Outcome outcome =
        workspace.run("elgen verify --build users --samples 16 " + name + ".scene.toml");
    INFO(outcome.output + outcome.errors);
    CHECK(outcome.status == 0);
    CHECK(mentions(outcome.output, "  holds    in " + inner));
  }
}

TEST_CASE("states at which the oracle is undecided with all its digits are counted") {
  const Workspace workspace;
  // 1 - cos(x)^2 needs 300 digits, pi has 200. (1 - cos(x) would be rewritten as cosc(x).)
  workspace.write("tiny.toml",
                  "format = 1\n[model]\nname = \"tiny\"\n[[coordinate]]\nname = \"x\"\n"
                  "range = [\"1e-150\", \"2e-150\"]\n[energy]\nT = \"1/2*dot(x)^2\"\n"
                  "V = \"pi*(1 - cos(x)^2)/x^2\"\n");
  const Outcome outcome = workspace.run("elgen verify --quick -v tiny.toml");
  INFO(outcome.output + outcome.errors);
  CHECK(outcome.status == 0);
  CHECK(mentions(outcome.output, " undecided by the oracle"));
}

TEST_CASE("generate and verify report ranges in which values overflow") {
  const Workspace workspace;
  const auto write = [&workspace](const std::string& name, const std::string& range,
                                  const std::string& potential) {
    workspace.write(name + ".toml", "format = 1\n[model]\nname = \"" + name +
                                        "\"\n[[coordinate]]\nname = \"x\"\nrange = " + range +
                                        "\n[parameters]\nF = 5\n"
                                        "w = { value = 0.05, assume = \"positive\" }\n"
                                        "[energy]\nT = \"1/2*dot(x)^2\"\nV = \"" +
                                        potential + "\"\n");
  };
  write("soft_distance", "[-50, 50]", "F*w*log(cosh(x/w))");
  write("wall", "[-50, 50]", "F*w*exp(x/w)");
  write("near_wall", "[-5, 5]", "F*w*exp(x/w)");
  for (const std::string name : {"soft_distance", "wall", "near_wall"}) {
    const Outcome written = workspace.run("elgen generate -o out " + name + ".toml");
    const Outcome verified = workspace.run("elgen verify --quick " + name + ".toml");
    INFO(written.errors + verified.output);
    CHECK(written.status == 0);
    CHECK(verified.status == 0);
    const bool overflows = name != "near_wall";
    CHECK(mentions(written.errors, "; not finite in double at ") == overflows);
    CHECK(mentions(verified.output, " inside the ranges skipped") == overflows);
  }
}

}  // namespace elgen::test
