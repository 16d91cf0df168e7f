// elgen verify: certificates and exit codes; samples are shared by processes.
#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/cli_testing.hpp"

namespace elgen::test {
namespace {

/// One output, so that a thousand visits take a moment.
void write_rotor(const Workspace& workspace) {
  write_text(workspace.path() / "rotor.toml",
             "format = 1\n[model]\nname = \"rotor\"\n[[coordinate]]\nname = \"q\"\nunit = \"rad\"\n"
             "[parameters]\nJ = { value = 2, unit = \"kg*m^2\" }\nk = { value = 3, unit = \"J\" }\n"
             "[energy]\nT = \"1/2*J*dot(q)^2\"\nV = \"k*(1 - cos(q))\"\n");
  write_text(workspace.path() / "one.scene.toml",
             "format = 1\nmodel = \"rotor.toml\"\nname = \"one\"\n[outputs]\nbias = true\n");
}

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
  const Outcome judged = shell("elgen verify -v --samples 16 arm.toml", workspace.path());
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
    const Outcome outcome = shell("elgen verify -v --samples 16 one.scene.toml", workspace.path());
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
  const Outcome outcome = shell("elgen verify -v star.toml", workspace.path());
  INFO(outcome.output + outcome.errors);
  CHECK(outcome.status == 0);
  CHECK(mentions(outcome.output, "mass_matrix (double)"));
  CHECK_FALSE(mentions(outcome.output, "(float)"));
}

TEST_CASE("option -o writes the certificates, and over a file with --force only") {
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
  const std::string full = shell("elgen verify --quick -v a.toml", workspace.path()).output;
  CHECK(read_text(workspace.path() / "new/c.txt") == full);
  CHECK(shell(command, workspace.path()).status == 4);
  write_text(workspace.path() / "new/c.txt", "old\n");
  CHECK(shell(command + " --force", workspace.path()).status == 0);
  CHECK(read_text(workspace.path() / "new/c.txt") == full);
}

TEST_CASE("where a certificate is missing no file is written") {
  const Workspace workspace;
  prepare("cp " + models + "/simple_pendulum.toml a.toml && echo old > c.txt", workspace.path());
  const std::string command = "elgen verify --quick --force -o c.txt a.toml ";
  CHECK(shell(command + "missing.toml", workspace.path()).status == 2);
  CHECK(shell(command + "--stop-after check", workspace.path()).status == 0);
  CHECK(read_text(workspace.path() / "c.txt") == "old\n");
}

TEST_CASE("option --samples is a positive number of states, -v prints the equations") {
  const Workspace workspace;
  const std::string model = models + "/simple_pendulum.toml";
  CHECK(shell("elgen verify --samples 0 " + model, workspace.path()).status == 2);
  CHECK(shell("elgen verify --jobs 0 " + model, workspace.path()).status == 2);
  const Outcome few = shell("elgen verify --samples 4 -v " + model, workspace.path());
  CHECK(few.status == 0);
  CHECK(few.output != shell("elgen verify --samples 8 " + model, workspace.path()).output);
  CHECK(mentions(few.errors, "\n  M = m l^2\n"));
}

TEST_CASE(
    "there is a line per output, -v says all, -q the verdict alone, --format json everything") {
  const Workspace workspace;
  const std::string verify = "elgen verify --quick " + models + "/simple_pendulum.toml ";
  const Outcome lines = shell(verify, workspace.path());
  CHECK(mentions(lines.output, "\n  holds    mass_matrix "));
  CHECK(mentions(lines.output, "\n  holds    [[expect]] gravity            1 check, proved\n"));
  CHECK(mentions(lines.output, " checks hold, 0 fail, 0 skipped\n"));
  CHECK_FALSE(mentions(lines.output, "tolerance"));
  const Outcome full = shell(verify + "-v", workspace.path());
  CHECK(mentions(full.output, "           tolerance  8 u B + N eta"));
  CHECK(mentions(full.output, "           decided    for every state, by proof"));
  const Outcome verdict = shell(verify + "-q", workspace.path());
  CHECK(starts_with(verdict.output, "simple_pendulum: "));
  CHECK(std::count(verdict.output.begin(), verdict.output.end(), '\n') == 1);
  const Outcome as_json = shell(verify + "--format json", workspace.path());
  const auto json = nlohmann::json::parse(as_json.output);
  CHECK(json.at("model") == "simple_pendulum");
  CHECK(json.at("fails") == 0);
  CHECK(json.at("checks").size() == json.at("holds"));
}

TEST_CASE("what is skipped is counted with its reason, and --strict makes it count") {
  const Workspace workspace;
  // M is regular on paper, and singular to 1e-18 of its entries.
  write_text(workspace.path() / "light.toml",
             "format = 1\n[model]\nname = \"light\"\n[[coordinate]]\nname = \"x\"\nunit = \"m\"\n"
             "[[coordinate]]\nname = \"y\"\nunit = \"m\"\n[parameters]\n"
             "m = { value = 1, unit = \"kg\" }\nd = { value = 1e-18, unit = \"kg\" }\n"
             "[energy]\nT = \"1/2*m*(dot(x) + dot(y))^2 + 1/2*d*dot(y)^2\"\nV = \"0\"\n");
  const std::string verify = "elgen verify --quick light.toml";
  const Outcome lenient = shell(verify, workspace.path());
  INFO(lenient.output + lenient.errors);
  CHECK(lenient.status == 0);
  CHECK(mentions(lenient.output,
                 "           skipped: mass matrix positive definite, mass_matrix\n"
                 "           because    "));
  CHECK(mentions(lenient.output, " singular\n"));
  CHECK_FALSE(mentions(lenient.output, ", 0 skipped"));
  CHECK(shell(verify + " --strict", workspace.path()).status == 1);
  CHECK(shell("elgen verify --quick --strict " + models + "/simple_pendulum.toml", workspace.path())
            .status == 0);
}

TEST_CASE("the forward dynamics of arms is bounded") {
  const Workspace workspace;
  for (const std::string name : {"panda7", "ur5", "chain"}) {
    const Outcome outcome = shell(
        "elgen verify --quick --format json " + models + "/" + name + ".toml", workspace.path());
    INFO(name << outcome.errors);
    REQUIRE(outcome.status == 0);
    const auto json = nlohmann::json::parse(outcome.output);
    CHECK(json.at("skipped") == 0);
    for (const auto& row : json.at("checks")) {
      if (row.at("check") != "program vs oracle" || row.at("output") != "forward_dynamics")
        continue;
      INFO(row.dump(2));
      CHECK(row.at("error_in_bounds") > 0);
      // Extremes may be: angles of 1e4 in float, a mass 1e12 times its value.
      CHECK(row.at("skipped_states").value("ill_conditioned", 0) <= 2);
      CHECK(row.at("samples") >= 7);
    }
  }
}

TEST_CASE("option --timings has the times of verify too") {
  const Workspace workspace;
  const std::string model = models + "/simple_pendulum.toml";
  const Outcome outcome = shell("elgen verify --samples 2 --timings " + model, workspace.path());
  CHECK(outcome.status == 0);
  CHECK(mentions(outcome.errors, "     compile "));
  CHECK(mentions(outcome.errors, "      verify "));
}

TEST_CASE("the certificate is the same whatever the number of processes, not so of the seed") {
  const Workspace workspace;
  write_rotor(workspace);
  const auto verified = [&](const std::string& options) {
    return shell("elgen verify -v one.scene.toml --samples 40 " + options, workspace.path());
  };
  const Outcome alone = verified("--jobs 1");
  INFO(alone.output + alone.errors);
  CHECK(alone.status == 0);
  CHECK(mentions(alone.output, "as users compile"));
  CHECK(verified("--jobs 3").output == alone.output);
  CHECK(verified("").output == alone.output);
  CHECK(verified("--seed 2").output != alone.output);
}

TEST_CASE("all samples are visited, however many") {
  const Workspace workspace;
  write_rotor(workspace);
  const Outcome outcome =
      shell("elgen verify --quick --format json --samples 2500 --limit seconds=600 one.scene.toml",
            workspace.path());
  INFO(outcome.errors);
  REQUIRE(outcome.status == 0);
  std::size_t compared = 0;
  const auto certificate = nlohmann::json::parse(outcome.output);
  for (const auto& row : certificate.at("checks")) {
    if (row.at("check") != "program vs oracle") continue;
    ++compared;
    std::size_t visited = row.at("samples");
    for (const auto& skipped : row.at("skipped_states")) visited += skipped.get<std::size_t>();
    CHECK(visited >= 2500);
  }
  CHECK(compared == 2);
}

TEST_CASE("processor time is that of each process, and ends all of them") {
  const Workspace workspace;
  write_rotor(workspace);
  const Outcome outcome =
      shell("elgen verify --quick --samples 200000 --jobs 2 --limit seconds=1 one.scene.toml",
            workspace.path());
  CHECK(outcome.status == 3);
  CHECK(outcome.errors ==
        "elgen: error[E909]: 1 s of processor time are over\n      raised by --limit seconds=N\n");
}

TEST_CASE("an interrupt ends the processes that share states, and leaves no files") {
  const Workspace workspace;
  write_rotor(workspace);
  const Outcome outcome = shell(
      "mkdir t; export TMPDIR=$PWD/t\n"
      "elgen verify one.scene.toml --limit seconds=600 --samples 200000 --jobs 2 & id=$!\n"
      "until test \"$(wc -w < /proc/$id/task/$id/children)\" = 2; do sleep 0.1; done\n"
      "children=$(cat /proc/$id/task/$id/children)\n"
      "kill -TERM $id; wait $id; echo $?\n"
      "for child in $children; do kill -0 $child 2>/dev/null && echo runs; done\n"
      "ls t",
      workspace.path());
  INFO(outcome.errors);
  CHECK(outcome.output == "130\n");
}

}  // namespace elgen::test
