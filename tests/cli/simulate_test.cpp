// elgen simulate: printed and written results.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/cli_testing.hpp"

namespace elgen::test {

TEST_CASE("a short run needs no compiler and prints its last state and drifts") {
  const Outcome outcome =
      run("CXX=/nowhere elgen simulate -q --time 2 --method midpoint --step 0.01 --state theta=1 " +
          models + "/simple_pendulum.toml");
  INFO(outcome.errors);
  CHECK(outcome.status == 0);
  CHECK(starts_with(outcome.output, "simple_pendulum by midpoint: 200 steps to t = 2\n  theta  "));
  CHECK(mentions(outcome.output, "\n  E - E0: worst "));
  CHECK(mentions(outcome.output, " ns per step in the evaluator\n"));
}

TEST_CASE("a run reports the drift of the conserved quantities of the model, with units") {
  const std::string command =
      "elgen simulate -q --time 2 --method midpoint --step 0.01 " + models + "/kepler_polar.toml";
  const Outcome outcome = run(command);
  INFO(outcome.errors);
  CHECK(mentions(outcome.output, "\n  p(phi) = "));
  CHECK(mentions(outcome.output, " kg*m^2/s at the start, drift "));
  CHECK(mentions(outcome.output, "\n  E = "));
  const auto conserved = nlohmann::json::parse(run(command + " --format json").output)["conserved"];
  REQUIRE(conserved.size() == 4);
  CHECK(conserved[0]["text"] == "p(phi)");
  CHECK(conserved[0]["drift"] < 1e-9);
  CHECK(conserved[1]["unit"] == "J");
  CHECK(conserved[2]["unit"] == "m^3/s^2");
}

TEST_CASE("a run without projection may leave the constraints") {
  const std::string command = "elgen simulate -q --time 2 --method rk4 --step 0.05 --format json " +
                              models + "/pendulum_xy.toml --project ";
  const auto offset = [&](const std::string& word) {
    const Outcome outcome = run(command + word);
    INFO(outcome.errors);
    REQUIRE(outcome.status == 0);
    return nlohmann::json::parse(outcome.output)["constraints"]["position"].get<double>();
  };
  CHECK(offset("on") < 1e-12);
  CHECK(offset("off") > 1e-11);
  CHECK(run(command + "maybe").status != 0);
}

TEST_CASE("the file extension sets the format of rows, and existing files need --force") {
  const Workspace workspace;
  const auto run = [&](const std::string& rest) {
    return workspace.run("elgen simulate -q --time 1 " + rest + " " + models + "/cart_pole.toml");
  };
  REQUIRE(run("--every 0.5 --input 'u=-3*theta' -o x.csv").status == 0);
  const std::string table = workspace.read("x.csv");
  CHECK(starts_with(table, "t,x,theta,dot(x),dot(theta),u,E\n0,"));
  CHECK(std::count(table.begin(), table.end(), '\n') == 4);
  CHECK(run("-o x.csv").status == 4);
  CHECK(run("--force -o x.csv").status == 0);
  REQUIRE(run("-o x.json").status == 0);
  const auto object = nlohmann::json::parse(workspace.read("x.json"));
  CHECK(object["rows"].size() == 1001);
  CHECK(object["model"] == "cart_pole");
  CHECK(object["columns"].back()["unit"] == "J");
  REQUIRE(run("-o x.svg").status == 0);
  CHECK(starts_with(workspace.read("x.svg"), "<svg "));
}

TEST_CASE("rows have multipliers, and rates, multipliers and paths are drawn on request") {
  const Workspace workspace;
  const auto run = [&](const std::string& rest) {
    return workspace.run("elgen simulate -q --time 0.2 " + rest + " " + models +
                         "/pendulum_xy.toml");
  };
  const Outcome table = run("-o x.csv");
  CHECK(table.status == 0);
  CHECK(mentions(table.output, " ns per step in the evaluator\n"));
  CHECK(starts_with(workspace.read("x.csv"), "t,x,y,dot(x),dot(y),lambda_rod,E\n0,"));
  REQUIRE(run("-o x.json").status == 0);
  const auto columns = nlohmann::json::parse(workspace.read("x.json"))["columns"];
  CHECK(columns[5]["name"] == "lambda_rod");
  CHECK(columns[5]["unit"] == "kg/s^2");
  REQUIRE(run("-o x.svg").status == 0);
  CHECK_FALSE(mentions(workspace.read("x.svg"), "λ_rod"));
  REQUIRE(run("--show 'dot(x),lambda_rod' --force -o x.svg").status == 0);
  CHECK(mentions(workspace.read("x.svg"), ">x\u0307 [m/s]<"));
  CHECK(mentions(workspace.read("x.svg"), ">λ_rod [kg/s²]<"));
  REQUIRE(run("--path bob -o path.svg").status == 0);
  CHECK(mentions(workspace.read("path.svg"), ">x(bob) [m]<"));
}

TEST_CASE("curves that do not exist or cannot be drawn are refused") {
  const auto refused = [&](const std::string& rest) {
    const Outcome outcome =
        run("elgen simulate -q --time 0.2 " + rest + " " + models + "/pendulum_xy.toml");
    CHECK(outcome.status == 2);
    return outcome.errors;
  };
  CHECK(mentions(refused("--show lambda_rot -o x.svg"),
                 "error[E201]: unknown column `lambda_rot`\n      did you mean `lambda_rod`?\n"));
  CHECK(mentions(refused("--path bop -o x.svg"),
                 "error[E201]: unknown point `bop`\n      did you mean `bob`?\n"));
  for (const char* file : {"-o x.csv", "-o x.json", "-o x.html", ""}) {
    const std::string said =
        "error[E913]: `--show` and `--path` apply to plots: give `-o FILE.svg`\n";
    CHECK(mentions(refused(std::string("--path bob ") + file), said));
    CHECK(mentions(refused(std::string("--show x ") + file), said));
  }
  CHECK(mentions(refused("--show x --path bob -o x.svg"), "[E913]"));
}

TEST_CASE("a constant input may exceed its limits, a law is clipped to them") {
  const Workspace workspace;
  workspace.write("block.toml",
                  "format = 1\n[model]\nname = \"block\"\n[[coordinate]]\nname = \"x\"\n"
                  "[parameters]\nm = { value = 2 }\n[energy]\nT = \"1/2*m*dot(x)^2\"\n"
                  "[[input]]\nname = \"u\"\non = \"x\"\nlimits = [-1, 1]\n");
  const std::string command = "elgen simulate -q --time 1 --method rk4 --step 0.1 block.toml ";
  const auto last = [&](const std::string& law) {
    const Outcome outcome = workspace.run(command + "--format json --input 'u=" + law + "'");
    INFO(outcome.errors);
    return nlohmann::json::parse(outcome.output)["rows"].back()[3];
  };
  CHECK(last("5") == 5);
  CHECK(last("-3*m") == -6);
  CHECK(last("5 + x") == 1);
  CHECK(last("5 + t") == 1);
  const std::string said =
      "warning[E518]: `3*m` is beyond [-1, 1], the limits of `u`, but is applied unchanged";
  CHECK(mentions(workspace.run(command + "--input 'u=3*m'").errors, said));
  CHECK(workspace.run(command + "--input 'u=m/2'").errors.empty());
  CHECK(workspace.run(command + "--input 'u=5 + x'").errors.empty());
}

TEST_CASE("the plot of a run subtracts the work from E") {
  const Workspace workspace;
  const std::string command =
      "elgen simulate -q --time 1 --method rk4 --step 0.1 -o run.svg " + models + "/cart_pole.toml";
  REQUIRE(workspace.run(command + " --input u=3").status == 0);
  CHECK(mentions(workspace.read("run.svg"), ">E − E₀ − work [J]<"));
}

TEST_CASE("a run that ends early writes nothing and exits with 1") {
  const Workspace workspace;
  workspace.write("runaway.toml", R"toml(format = 1
[model]
name = "runaway"
[[coordinate]]
name = "x"
start = { value = 1, rate = 0 }
[energy]
T = "dot(x)^2"
V = "-x^4"
)toml");
  const Outcome outcome =
      workspace.run("elgen simulate -q --time 9 --method rk4 --step 0.1 -o x.csv runaway.toml");
  CHECK(outcome.status == 1);
  CHECK(mentions(outcome.errors, "[E624]"));
  CHECK(workspace.files() == "./runaway.toml\n");
}

TEST_CASE("a run ends at a singular configuration, unless fixed steps may go through it") {
  const std::string fall = " -q --time 0.3 " + models + "/five_bar.toml";
  const Outcome stopped = run("elgen simulate" + fall);
  CHECK(stopped.status == 1);
  CHECK(stopped.output.empty());
  CHECK(mentions(stopped.errors, "error[E624]: rank is "));
  CHECK(mentions(stopped.errors, " t = 0.26"));
  const Outcome through = run("elgen simulate --through singular --method rk4 --step 1e-4" + fall);
  INFO(through.errors);
  CHECK(through.status == 0);
  CHECK(mentions(through.output, "\n  a1            = 3.385315865 rad\n"));
  CHECK(run("elgen simulate --through thick --method rk4 --step 1e-4" + fall).status != 0);
  CHECK(run("elgen tradeoff --trajectory 0.3 " + models + "/five_bar.toml").status == 1);
}

TEST_CASE("a long run reports its expected duration before its limit ends it") {
  const Outcome outcome =
      run("elgen simulate --time 1e9 --method rk4 --step 0.1 --limit seconds=12 " + models +
          "/cart_pole.toml");
  CHECK(outcome.status == 3);
  CHECK(mentions(outcome.errors, "the whole run will take about"));
  CHECK(mentions(outcome.errors, "[E909]"));
}

TEST_CASE("scenes for any emitted code run, with their locked and fixed values") {
  const Workspace workspace;
  workspace.write("held.scene.toml",
                  "format = 1\nmodel = \"" + models + "/two_link_arm.toml\"\nname = \"held\"\n" +
                      "[outputs]\nbias = { rename = \"forward_dynamics\" }\n"
                      "[lock]\nq2 = { value = \"1/2\" }\n[numeric]\nscalar = [\"float\"]\n"
                      "[emit]\nlanguage = \"c99\"\n");
  const Outcome outcome = workspace.run("elgen simulate -q --time 1 held.scene.toml");
  INFO(outcome.errors);
  CHECK(outcome.status == 0);
  CHECK(starts_with(outcome.output, "two_link_arm_held by dopri5: "));
  CHECK_FALSE(mentions(outcome.output, "q2"));
}

TEST_CASE("every model runs from its declared start") {
  const Outcome outcome =
      run("for m in " + models + "/*.toml; do elgen simulate -q --time 0.1 $m || echo $m; done");
  INFO(outcome.output + outcome.errors);
  CHECK_FALSE(mentions(outcome.errors, "error["));
  CHECK_FALSE(mentions(outcome.output, "\n/"));
}

TEST_CASE("commands that run a system accept scenes in C, in float and with a step") {
  const Workspace workspace;
  workspace.write("c.scene.toml",
                  "format = 1\nmodel = \"" ELGEN_SOURCE_DIR
                  "/models/simple_pendulum.toml\"\n"
                  "name = \"c\"\n[outputs]\ngravity = true\nstep = { method = \"rk4\" }\n"
                  "[numeric]\nscalar = [\"float\"]\n[emit]\nlanguage = \"c99\"\n");
  for (const char* method : {"dopri5", "verlet --step 0.01"}) {
    CHECK(failure_of(workspace.run(
              std::string("elgen simulate -q --time 0.1 c.scene.toml --method ") + method)) == "");
  }
}

}  // namespace elgen::test
