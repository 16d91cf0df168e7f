// elgen verify: certificates and exit codes.
#include <catch2/catch.hpp>

#include "support/shell.hpp"

namespace elgen::test {

namespace {

const std::string models = std::string(ELGEN_SOURCE_DIR) + "/models";

}  // namespace

TEST_CASE("verify: all closed forms of the models hold, a wrong one exits with 1") {
  const Workspace workspace;
  const Outcome good = shell("elgen verify --quick " + models + "/*.toml", workspace.path());
  INFO(good.output + good.errors);
  CHECK(good.status == 0);
  prepare("sed 's/\"m\\*g\\*l\\*sin(theta)\"/\"m*g*l*cos(theta)\"/' " + models +
              "/simple_pendulum.toml > wrong.toml",
          workspace.path());
  const Outcome wrong = shell("elgen verify --quick wrong.toml", workspace.path());
  CHECK(wrong.status == 1);
  CHECK(mentions(wrong.errors, "[E510]"));
}

TEST_CASE("the Jacobian of a frame is judged as that of its twist") {
  const Workspace workspace;
  write_text(workspace.path() / "arm.toml", R"toml(format = 1
[model]
name = "arm"
[[coordinate]]
name = "q"
unit = "rad"
[[coordinate]]
name = "r"
kind = "rotation"
[parameters]
l = { value = 0.4, unit = "m" }
m = { value = 2, unit = "kg" }
i = { value = 0.1, unit = "kg*m^2" }
[[frame]]
name = "arm"
parent = "world"
rotate = [[["1", "1", "0"], "q"]]
[[frame]]
name = "ball"
parent = "arm"
translate = ["l", "0", "0"]
rotation = "r"
[[body]]
name = "load"
frame = "ball"
mass = "m"
inertia = ["i", "i", "i"]
[[output]]
name = "pose"
frame = "ball"
jacobian = true
)toml");
  const Outcome judged = shell("elgen verify --samples 16 arm.toml", workspace.path());
  INFO(judged.output + judged.errors);
  CHECK(judged.status == 0);
  CHECK(mentions(judged.output, "J = d(omega; dp/dt)/dv, [omega]x = dR/dt R^T"));
}

TEST_CASE(
    "the oracle's rounding of what does not depend on q is no failure, however slow the motion") {
  const Workspace workspace;
  write_text(workspace.path() / "turn.toml", R"toml(format = 1
[model]
name = "turn"
[[coordinate]]
name = "q1"
[[frame]]
name = "F1"
parent = "world"
rotate = [["z", "q1"]]
[[body]]
name = "B1"
frame = "F1"
mass = "1"
com = ["0", "1", "0"]
inertia = ["2", "1", "2"]
inertia_about = "origin"
)toml");
  const Outcome outcome = shell("elgen verify -q --quick turn.toml", workspace.path());
  INFO(outcome.output);
  CHECK(outcome.status == 0);
}

TEST_CASE("every file that is emitted is compiled and run, in every storage") {
  const Workspace workspace;
  const auto judged = [&](const std::string& emission) {
    write_text(workspace.path() / "one.scene.toml",
               "format = 1\nmodel = \"" + models + "/cart_pole.toml\"\nname = \"one\"\n" +
                   "[outputs]\ninput_matrix = true\nmass_matrix = true\nlinearization = true\n" +
                   "[numeric]\nscalar = [\"double\"]\n[emit]\n" + emission);
    const Outcome outcome = shell("elgen verify --samples 16 one.scene.toml", workspace.path());
    INFO(emission << outcome.output << outcome.errors);
    CHECK(outcome.status == 0);
    return outcome.output;
  };
  for (const std::string storage : {"row-major", "column-major"}) {
    const std::string line = "storage = \"" + storage + "\"\n";
    const std::string on_eigen = judged(line + "eigen = true\n");
    CHECK(mentions(on_eigen, "input_matrix (double) "));
    CHECK(mentions(on_eigen, "input_matrix (double, Eigen) "));
    CHECK(mentions(on_eigen, "linearization (float, Eigen) "));
    CHECK(mentions(judged(line + "language = \"c99\"\n"), "input_matrix (double) "));
  }
}

TEST_CASE("a model whose numbers do not fit float is verified in double alone") {
  const Workspace workspace;
  write_text(workspace.path() / "star.toml",
             "format = 1\n[model]\nname = \"star\"\n[[coordinate]]\nname = \"x\"\nunit = \"m\"\n"
             "[parameters]\nm = { value = 1e39, unit = \"kg\" }\nk = { value = 1e39, unit = "
             "\"N/m\" }\n[energy]\nT = \"1/2*m*dot(x)^2\"\nV = \"1/2*k*x^2\"\n");
  const Outcome outcome = shell("elgen verify star.toml", workspace.path());
  INFO(outcome.output + outcome.errors);
  CHECK(outcome.status == 0);
  CHECK(mentions(outcome.output, "mass_matrix (double)"));
  CHECK_FALSE(mentions(outcome.output, "(float)"));
}

TEST_CASE("-o writes the certificates, and over a file with --force only") {
  const Workspace workspace;
  prepare("cp " + models + "/simple_pendulum.toml a.toml", workspace.path());
  const std::string model = read_text(workspace.path() / "a.toml");
  const Outcome refused = shell("elgen verify --quick a.toml -o a.toml", workspace.path());
  CHECK(refused.status == 4);
  CHECK(mentions(refused.errors, "error[E703]: `a.toml` exists\n      --force overwrites it"));
  CHECK(read_text(workspace.path() / "a.toml") == model);

  const std::string command = "elgen verify --quick a.toml -o new/c.txt";
  const Outcome first = shell(command, workspace.path());
  CHECK(first.status == 0);
  CHECK(read_text(workspace.path() / "new/c.txt") == first.output);
  CHECK(shell(command, workspace.path()).status == 4);
  write_text(workspace.path() / "new/c.txt", "old\n");
  CHECK(shell(command + " --force", workspace.path()).status == 0);
  CHECK(read_text(workspace.path() / "new/c.txt") == first.output);
}

TEST_CASE("where a certificate is missing no file is written") {
  const Workspace workspace;
  prepare("cp " + models + "/simple_pendulum.toml a.toml && echo old > c.txt", workspace.path());
  const std::string command = "elgen verify --quick --force -o c.txt a.toml ";
  CHECK(shell(command + "missing.toml", workspace.path()).status == 2);
  CHECK(shell(command + "--stop-after check", workspace.path()).status == 0);
  CHECK(read_text(workspace.path() / "c.txt") == "old\n");
}

TEST_CASE("--samples is a positive number of states, -v prints the equations") {
  const Workspace workspace;
  const std::string model = models + "/simple_pendulum.toml";
  CHECK(shell("elgen verify --samples 0 " + model, workspace.path()).status == 2);
  const Outcome few = shell("elgen verify --samples 4 -v " + model, workspace.path());
  CHECK(few.status == 0);
  CHECK(few.output != shell("elgen verify --samples 8 " + model, workspace.path()).output);
  CHECK(mentions(few.errors, shell("elgen show " + model, workspace.path()).output));
}

}  // namespace elgen::test
