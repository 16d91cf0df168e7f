// elgen evaluate and elgen vectors: options, files and messages.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/cli_testing.hpp"

namespace elgen::test {
namespace {

const std::string one_pendulum = models + "/simple_pendulum.toml";

Outcome evaluate(const std::string& rest) {
  return run("elgen evaluate " + one_pendulum + " " + rest);
}

}  // namespace

TEST_CASE("settings may be one word, several words or several options") {
  const std::string expected =
      "simple_pendulum at theta = 0.1, dot(theta) = 2.0\nmomentum\n  theta  0.1 kg*m^2/s\n";
  for (const std::string state :
       {"--state 'theta=0.1,dot(theta)=2'", "--state theta=0.1 'dot(theta)=2'",
        "--state theta=0.1, 'dot(theta)=2'", "--state=theta=0.1 'dot(theta)=2'",
        "--state theta=0.1 --state 'dot(theta)=2'"}) {
    const Outcome outcome = evaluate("--set m=0.2 --what momentum " + state);
    INFO(state << "\n" << outcome.errors);
    CHECK(outcome.status == 0);
    CHECK(outcome.output == expected);
  }
  const Outcome before =
      run("elgen evaluate --set m=0.2 --what momentum --state theta=0.1 'dot(theta)=2' " +
          one_pendulum);
  CHECK(before.output == expected);
}

TEST_CASE("values are printed as text, JSON or CSV, without `dynamics`") {
  const std::string options = "--state theta=0.1 --what gravity ";
  CHECK(evaluate(options + "--as csv").output ==
        "function,field,row,column,unit,value,digits,state,m,l,g,theta\n"
        "gravity,,theta,,N*m,0.48968290865269209,,state,1.0,0.5,9.81,0.1\n");
  const auto json = nlohmann::json::parse(evaluate(options + "--format json").output);
  CHECK(json["functions"][0]["fields"][0]["units"] == nlohmann::json{"N*m"});
  CHECK(json["values"][0]["q"] == nlohmann::json{0.1});
  CHECK(starts_with(evaluate(options + "--format json --as text").output, "simple_pendulum at"));
  const Outcome all = evaluate("");
  INFO(all.errors);
  CHECK(all.status == 0);
  CHECK(mentions(all.output, "\nforward_dynamics.acceleration\n"));
  CHECK_FALSE(mentions(all.output, "\ndynamics"));
}

TEST_CASE("digits are between 1 and 60") {
  CHECK(mentions(evaluate("--state theta=0.1 --what gravity --digits 40").output,
                 "0.4896829086526920870649"));
  CHECK(mentions(evaluate("--state theta=0.1 --what gravity --digits 3").output, " 0.49 N*m"));
  for (const std::string digits : {"0", "61"}) {
    const Outcome outcome = evaluate("--digits " + digits);
    CHECK(outcome.status == 2);
    CHECK(outcome.errors == "elgen: error[E913]: --digits: Value " + digits +
                                " not in range 1 to 60\n      see `elgen evaluate --help`\n");
  }
}

TEST_CASE("the file extension sets the format of vectors, and existing files need --force") {
  const Workspace workspace;
  const auto vectors = [&](const std::string& rest) {
    return workspace.run("elgen vectors --outputs gravity --samples 2 " + rest + " " +
                         one_pendulum);
  };
  const Outcome printed = vectors("");
  INFO(printed.errors);
  REQUIRE(printed.status == 0);
  REQUIRE(vectors("-o x.json").status == 0);
  CHECK(workspace.read("x.json") == printed.output);
  CHECK(vectors("-o x.json").status == 4);
  CHECK(vectors("--force --seed 2 -o x.json").status == 0);
  CHECK(workspace.read("x.json") != printed.output);
  REQUIRE(vectors("-o x.csv").status == 0);
  CHECK(starts_with(workspace.read("x.csv"),
                    "function,field,row,column,unit,value,digits,state,m,l,g,theta\n"
                    "gravity,,theta,,N*m,2.3515822668536158,15,start,1.0,0.5,"));
  CHECK(vectors("-o x.txt").errors ==
        "elgen: error[E913]: `x.txt` ends in none of .csv, .json and .h\n"
        "      the ending selects the format\n");
}

TEST_CASE("the header of vectors compiles as C and C++ without warnings and has the values") {
  const Workspace workspace;
  workspace.prepare("elgen vectors --samples 4 -o vectors.h " + models + "/cart_pole.toml");
  const std::string program = R"(#include "vectors.h"
#include <math.h>
#include <stdio.h>
int main(void) {
  unsigned long i = 0;
  const unsigned long count = sizeof cart_pole_gravity_vectors / sizeof *cart_pole_gravity_vectors;
  for (i = 0; i < count; ++i) {
    const struct cart_pole_gravity_vector *const at = &cart_pole_gravity_vectors[i];
    const double size = at->p[1] * at->p[2] * at->p[3];
    const double expected = fabs(size * sin(at->q[1]));
    if (fabs(fabs(at->value[1]) - expected) > 1e-14 * size) return 1;
    if (at->digits[1] < 14) return 2;
  }
  printf("%lu %lu", count, (unsigned long)(sizeof cart_pole_forward_dynamics_vectors[0].u));
  return 0;
}
)";
  workspace.write("main.c", program);
  workspace.write("main.cpp", program);
  const std::string strict =
      " -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Werror ";
  workspace.prepare("cc -std=c99" + strict + "main.c -o of_c -lm");
  workspace.prepare("c++ -std=c++17" + strict + "main.cpp -o of_cpp");
  CHECK(workspace.run("./of_c").output == "4 8");
  CHECK(workspace.run("./of_cpp").output == "4 8");
}

}  // namespace elgen::test
