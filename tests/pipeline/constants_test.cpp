// Irrational constants through the whole pipeline: shown, emitted, compiled and proved values are
// the same number, and different numbers never become equal.
#include <catch2/catch.hpp>
#include <string>

#include "support/shell.hpp"

using namespace elgen::test;

namespace {

struct Row {
  const char* potential;
  const char* gravity;  ///< dV/dq1, derived by hand
};

std::string model_of(const Row& row) {
  return std::string(
             "format = 1\n[model]\nname = \"constants\"\n[[coordinate]]\nname = \"q1\"\n"
             "[define]\na = \"1 - cos(1)\"\nb = \"-exp(1)\"\n"
             "[energy]\nT = \"dot(q1)^2\"\nV = \"") +
         row.potential + "\"\n[[expect]]\ngravity = [\"" + row.gravity + "\"]\n";
}

/// The outcome of `elgen verify -v --quick` for the model and the expectation of `row`.
Outcome verdict(const Row& row) {
  const Workspace folder;
  folder.write("constants.toml", model_of(row));
  return folder.run("elgen verify -v --quick constants.toml");
}

}  // namespace

TEST_CASE("irrational constants are proved equal to themselves") {
  const Row row = GENERATE(values<Row>(
      {{"(2 + pi)*q1^3 + 2*pi*q1^2", "3*(2 + pi)*q1^2 + 4*pi*q1"},
       {"(1/2 + pi)*q1 + pi/2*q1^2", "1/2 + pi + pi*q1"},
       {"(2 + sqrt(3))*q1 + 2*sqrt(3)*q1^2", "2 + sqrt(3) + 4*sqrt(3)*q1"},
       {"sqrt(2)*sqrt(3)*q1 + (sqrt(2) + sqrt(3))*q1^2", "sqrt(6) + 2*(sqrt(2) + sqrt(3))*q1"},
       {"(cos(1) + sin(1))*q1 + cos(1)*sin(1)*q1^2", "cos(1) + sin(1) + 2*cos(1)*sin(1)*q1"},
       {"(a + b)*q1", "1 - cos(1) - exp(1)"},
       {"(a - 2)*q1", "-1 - cos(1)"},
       {"exp(-(1 + cos(1)))*q1 + exp(-1 + cos(1))*q1^2",
        "exp(-1 - cos(1)) + 2*exp(-1 + cos(1))*q1"}}));
  INFO(row.potential);
  const Outcome outcome = verdict(row);
  INFO(outcome.output);
  CHECK(outcome.status == 0);
  CHECK(mentions(outcome.output, "proved: both have the same canonical sum"));
}

TEST_CASE("a different number is rejected, even if it is written similarly") {
  const Row row = GENERATE(values<Row>({{"(a + b)*q1", "1 + cos(1) - exp(1)"},
                                        {"(a - 2)*q1", "1 + cos(1)"},
                                        {"(a - 2)*q1", "cos(1) - 1"},
                                        {"(2 + pi)*q1", "2*pi"},
                                        {"exp(-(1 + cos(1)))*q1", "exp(-1 + cos(1))"}}));
  INFO(row.potential << ", " << row.gravity);
  const Outcome outcome = verdict(row);
  INFO(outcome.output);
  CHECK(outcome.status == 1);
  CHECK(mentions(outcome.output, "FAILS"));
}

TEST_CASE("agreement to 45 digits is no proof of equality") {
  const Outcome outcome = verdict({"cos(1e-60)*q1", "1"});
  CHECK(outcome.status == 0);
  CHECK(mentions(outcome.output, "sampled, no proof"));
}

TEST_CASE("printed constants have the signs and brackets that they need") {
  const Workspace folder;
  const auto shown = [&](const char* potential) {
    folder.write("constants.toml", model_of({potential, "0"}));
    return folder.run("elgen show -q --what gravity constants.toml").output;
  };
  CHECK(mentions(shown("(a - 2)*q1"), "gravity = -1 - cos(1)\n"));
  CHECK(mentions(shown("exp(-(1 + cos(1)))*q1"), "gravity = exp(-1 - cos(1))\n"));
  CHECK(mentions(shown("(a + b)*q1^2/2"), "gravity = (1 - exp(1))*q1 - q1*cos(1)\n"));
}

TEST_CASE("different constants have different functions in emitted code") {
  const Workspace folder;
  folder.write("constants.toml",
               model_of({"(2 + pi)*q1^3/3 + pi*q1^2 + 2*cos(1)*q1 + (2 + cos(1))*q1^4", "0"}));
  folder.prepare("elgen generate -q -o out --outputs gravity constants.toml");
  const std::string header = folder.read("out/constants/constants.hpp");
  for (const char* number : {"/// 2 + pi\n", "/// 2*pi\n", "/// 2*cos(1)\n"}) {
    INFO(number);
    CHECK(mentions(header, number));
  }
}

TEST_CASE("emitted code calls cos(0.7) beside cos(y - 0.7), in every language") {
  const Workspace folder;
  folder.write("rest.toml",
               "format = 1\n[model]\nname = \"rest\"\n[[coordinate]]\nname = \"x\"\n"
               "[[coordinate]]\nname = \"y\"\n"
               "[energy]\nT = \"dot(x)^2 + dot(y)^2\"\n"
               "V = \"x^2 + y^2\"\n[[output]]\nname = \"drop\"\n"
               "value = \"cos(y - 0.7)*cos(x) - cos(0.7)\"\n");
  const auto emitted = [&folder](const std::string& language, const std::string& file) {
    folder.prepare("elgen generate -q -o out --outputs drop --language " + language + " rest.toml");
    return folder.read("out/rest/" + file);
  };
  CHECK(mentions(emitted("c++17", "rest.hpp"), "at_run_time<Scalar>(number_0p7<Scalar>())"));
  CHECK(mentions(emitted("c99", "rest.h"), "rest_cosine_of(rest_at_run_time(0.7))"));
  CHECK(mentions(emitted("python", "rest.py"), "cos(0.7)"));
  CHECK(mentions(folder.run("elgen show -q --what drop rest.toml").output, "cos(7/10)"));
}

TEST_CASE("a parameter fixed at an irrational value keeps its form") {
  const Workspace folder;
  folder.write("fixed.toml",
               "format = 1\n[model]\nname = \"fixed\"\n[[coordinate]]\nname = \"q1\"\n"
               "[parameters]\nk = \"sqrt(2)\"\nr = 3\n"
               "[energy]\nT = \"k*dot(q1)^2\"\nV = \"r*q1\"\n"
               "[[expect]]\nmass_matrix = [[\"2*k\"]]\n");
  folder.write("one.scene.toml",
               "format = 1\nmodel = \"fixed.toml\"\nname = \"one\"\n"
               "[parameters]\nfixed = { k = \"sqrt(2)\", r = \"1 - cos(1)\" }\n");
  const Outcome shown = folder.run("elgen show -q one.scene.toml");
  CHECK(mentions(shown.output, "mass_matrix = 2*sqrt(2)\n"));
  CHECK(mentions(shown.output, "gravity = 1 - cos(1)\n"));
  const Outcome all = folder.run("elgen show -q --fix all fixed.toml");
  CHECK(mentions(all.output, "mass_matrix = 2*sqrt(2)\n"));
  const Outcome verified = folder.run("elgen verify -v --quick one.scene.toml");
  INFO(verified.output);
  CHECK(verified.status == 0);
  CHECK(mentions(verified.output, "proved: both have the same canonical sum"));
}

TEST_CASE("a slide in an oblique frame has a single Coriolis matrix") {
  const Workspace folder;
  folder.write("slide.toml", R"toml(format = 1
[model]
name = "slide"
[[coordinate]]
name = "a"
[[coordinate]]
name = "b"
[parameters]
m = 2
[[frame]]
name = "W"
parent = "world"
rotate = [["z", "a"]]
[[frame]]
name = "S"
parent = "W"
translate = [0, 1, 0]
rotate = [["y", 0.5]]
[[frame]]
name = "L"
parent = "S"
translate = [0, "b", 0]
[[body]]
name = "B"
frame = "L"
mass = "m"
[[expect]]
coriolis_matrix = [["m*(1 + b)*dot(b)", "m*(1 + b)*dot(a)"], ["-m*(1 + b)*dot(a)", "0"]]
)toml");
  const Outcome shown = folder.run("elgen show -q --what coriolis_matrix slide.toml");
  CHECK(mentions(shown.output, "coriolis_matrix[1,2] = m*(1 + b)*dot(a)\n"));
  CHECK(failure_of(folder.run("elgen verify -v --quick slide.toml")) == "");
}
