// elgen verify: certificates and exit codes.
#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/cli_testing.hpp"

namespace elgen::test {
TEST_CASE("verify: all closed forms of the models hold, and a wrong one exits with 1") {
  const Workspace workspace;
  CHECK(failure_of(workspace.run("elgen verify --quick " + models + "/*.toml")) == "");
  workspace.prepare("sed 's/\"m\\*g\\*l\\*sin(theta)\"/\"m*g*l*cos(theta)\"/' " + models +
                    "/simple_pendulum.toml > wrong.toml");
  const Outcome wrong = workspace.run("elgen verify --quick wrong.toml");
  CHECK(wrong.status == 1);
  CHECK(mentions(wrong.errors, "[E510]"));
}

TEST_CASE("forward dynamics without pivots is verified, and its model runs") {
  const Workspace workspace;
  for (const std::string name : {"pendulum_xy", "cart_pole"}) {
    workspace.prepare("cp " + models + "/" + name +
                      ".toml . && printf '\\n[outputs]\\n"
                      "forward_dynamics = { pivots = false }\\n' >> " +
                      name + ".toml");
    const std::string scene = "format = 1\nmodel = \"" + name + ".toml\"\nname = \"";
    const std::string outputs = "\"\n[outputs]\nforward_dynamics = true\n[emit]\n";
    workspace.write("c.scene.toml", scene + "c" + outputs + "language = \"c99\"\n");
    workspace.write("packs.scene.toml", scene + "packs" + outputs + "batch = true\neigen = true\n");
    for (const std::string& file :
         {name + ".toml", std::string("c.scene.toml"), std::string("packs.scene.toml")}) {
      const Outcome judged = workspace.run("elgen verify --quick " + file);
      INFO(file + judged.output + judged.errors);
      CHECK(judged.status == 0);
    }
    const Outcome emitted = workspace.run("elgen generate -q -o out " + name + ".toml && cat out/" +
                                          name + "/" + name + ".hpp");
    CHECK_FALSE(mentions(emitted.output, "pivots"));
    CHECK(mentions(emitted.output, "Accelerations<Scalar> forward_dynamics(") ==
          (name == "cart_pole"));
    CHECK(workspace.run("elgen simulate --time 0.1 " + name + ".toml").status == 0);
  }
}

TEST_CASE("the Jacobian of a frame is compared with its twist") {
  const Workspace workspace;
  workspace.write("arm.toml", R"toml(format = 1
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
  const Outcome judged = workspace.run("elgen verify --build written -v --samples 16 arm.toml");
  INFO(judged.output + judged.errors);
  CHECK(judged.status == 0);
  CHECK(mentions(judged.output, "J = d(omega; dp/dt)/dv, [omega]x = dR/dt R^T"));
}

TEST_CASE("a rounding error of the oracle in terms without q is no failure, even in slow motion") {
  const Workspace workspace;
  workspace.write("turn.toml", R"toml(format = 1
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
  CHECK(failure_of(workspace.run("elgen verify -q --quick turn.toml")) == "");
}

TEST_CASE("every emitted file is compiled and run, in every storage order") {
  const Workspace workspace;
  const auto judged = [&](const std::string& emission) {
    workspace.write(
        "one.scene.toml",
        "format = 1\nmodel = \"" + models + "/cart_pole.toml\"\nname = \"one\"\n" +
            "[outputs]\ninput_matrix = true\nmass_matrix = true\nlinearization = true\n" +
            "[numeric]\nscalar = [\"double\"]\n[emit]\n" + emission);
    const Outcome outcome = workspace.run("elgen verify -v --samples 16 one.scene.toml");
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
    CHECK(mentions(on_eigen, "linearization (float, Eigen, -O3 -march=native) "));
    const std::string in_c = judged(line + "language = \"c99\"\n");
    CHECK(mentions(in_c, "input_matrix (double) "));
    CHECK(mentions(in_c, "input_matrix (double, -O3 -march=native) "));
  }
  const std::string in_packs = judged("batch = true\n");
  CHECK(mentions(in_packs, "linearization (double, batch, -O3 -march=native) "));
  CHECK(mentions(in_packs, "sine and cosine (double, batch, -O3 -march=native, contraction on) "));
}

TEST_CASE("a rounding error beyond its bound is a note, and the exit code is 0") {
  const Workspace workspace;
  // A square root of a sum of squares. Code that multiplies out the squares loses digits.
  workspace.write("egg.toml", R"toml(format = 1
[model]
name = "egg"
[[coordinate]]
name = "q2"
unit = "rad"
range = [-0.6, 0.6]
[[coordinate]]
name = "q3"
unit = "rad"
range = [-0.6, 0.6]
[parameters]
m = { value = 1, unit = "kg", assume = "positive" }
J = { value = 1e-3, unit = "kg*m^2", assume = "positive" }
a = { value = 0.2, unit = "m", assume = "positive" }
b = { value = 0.03, unit = "m", assume = "positive" }
c = { value = 0.02, unit = "m", assume = "positive" }
h = { value = 0.01, unit = "m" }
g = { value = 9.80665, unit = "m/s^2" }
[define]
n1 = "-cos(q2)*sin(q3)"
n2 = "sin(q2)"
n3 = "cos(q2)*cos(q3)"
[energy]
T = "1/2*J*(dot(q2)^2 + dot(q3)^2)"
V = "m*g*(sqrt(a^2*n1^2 + b^2*n2^2 + c^2*n3^2) - h*n3)"
)toml");
  for (const std::string seed : {"3", "4", "6"}) {
    CHECK(failure_of(workspace.run("elgen verify --quick --seed " + seed + " egg.toml")) == "");
  }
}

TEST_CASE("option --build compiles in one way only") {
  const Workspace workspace;
  write_rotor(workspace);
  const std::string verify = "elgen verify -v --samples 2 one.scene.toml --build ";
  const std::string rows_of_bits = " entries differ\n";  // one row for double, one for float
  const std::string written = workspace.run(verify + "written").output;
  CHECK(count(written, rows_of_bits) == 2);
  CHECK_FALSE(mentions(written, "-O3 -march=native"));
  const std::string native = workspace.run(verify + "native").output;
  CHECK(count(native, rows_of_bits) == 2);
  CHECK(count(native, ", -O3 -march=native) ") == 2);
  CHECK_FALSE(mentions(native, "as users compile"));
  const std::string users = workspace.run(verify + "users").output;
  CHECK(count(users, rows_of_bits) == 0);
  CHECK(mentions(users, "as users compile"));
  for (const std::string refused : {"all", "written --quick", "users --foreign ./mine.so"}) {
    INFO(refused);
    CHECK(workspace.run(verify + refused).status == 2);
  }
}

TEST_CASE("a slow compiler is no failure of the model") {
  const Workspace workspace;
  write_rotor(workspace);
  workspace.write("slow",
                  "#!/bin/sh\ncase \"$*\" in *--version*) exec c++ --version ;; esac\n"
                  "exec sleep 100\n");
  workspace.prepare("chmod +x slow");
  const Outcome outcome =
      workspace.run("CXX=$PWD/slow elgen verify --samples 2 --limit seconds=4 one.scene.toml");
  INFO(outcome.output + outcome.errors);
  CHECK(outcome.status == 0);
  CHECK(mentions(outcome.output, "skipped: compiled code vs program, all outputs\n"));
  CHECK(mentions(outcome.output,
                 "slow` has not ended within 4 s; `--limit seconds=N` raises the limit\n"));
}

TEST_CASE("a model whose numbers do not fit into float is verified in double only") {
  const Workspace workspace;
  workspace.write(
      "star.toml",
      "format = 1\n[model]\nname = \"star\"\n[[coordinate]]\nname = \"x\"\nunit = \"m\"\n"
      "[parameters]\nm = { value = 1e39, unit = \"kg\" }\nk = { value = 1e39, unit = "
      "\"N/m\" }\n[energy]\nT = \"1/2*m*dot(x)^2\"\nV = \"1/2*k*x^2\"\n");
  const Outcome outcome = workspace.run("elgen verify --build written -v star.toml");
  INFO(outcome.output + outcome.errors);
  CHECK(outcome.status == 0);
  CHECK(mentions(outcome.output, "mass_matrix (double)"));
  CHECK_FALSE(mentions(outcome.output, "(float)"));
}

TEST_CASE("option -o writes the certificates, and replaces a file only with --force") {
  const Workspace workspace;
  workspace.prepare("cp " + models + "/simple_pendulum.toml a.toml");
  const std::string model = workspace.read("a.toml");
  const Outcome refused = workspace.run("elgen verify --quick a.toml -o a.toml");
  CHECK(refused.status == 4);
  CHECK(mentions(refused.errors, "error[E703]: `a.toml` exists\n      --force overwrites it"));
  CHECK(workspace.read("a.toml") == model);

  const std::string command = "elgen verify --quick a.toml -o new/c.txt";
  CHECK(failure_of(workspace.run(command)) == "");
  const std::string full = workspace.run("elgen verify --quick -v a.toml").output;
  CHECK(workspace.read("new/c.txt") == full);
  CHECK(workspace.run(command).status == 4);
  workspace.write("new/c.txt", "old\n");
  CHECK(workspace.run(command + " --force").status == 0);
  CHECK(workspace.read("new/c.txt") == full);
}

TEST_CASE("if a certificate is missing, no file is written") {
  const Workspace workspace;
  workspace.prepare("cp " + models + "/simple_pendulum.toml a.toml && echo old > c.txt");
  const std::string command = "elgen verify --quick --force -o c.txt a.toml ";
  CHECK(workspace.run(command + "missing.toml").status == 2);
  CHECK(workspace.run(command + "--stop-after check").status == 0);
  CHECK(workspace.read("c.txt") == "old\n");
}

TEST_CASE("option --samples is a positive number of states, -v prints the equations") {
  const Workspace workspace;
  const std::string model = models + "/simple_pendulum.toml";
  CHECK(workspace.run("elgen verify --samples 0 " + model).status == 2);
  CHECK(workspace.run("elgen verify --jobs 0 " + model).status == 2);
  const Outcome few = workspace.run("elgen verify --build written --samples 4 -v " + model);
  CHECK(few.status == 0);
  CHECK(few.output != workspace.run("elgen verify --build written --samples 8 -v " + model).output);
  for (const std::string number : {"18446744073709551616", "-1", "1.5", "''"}) {
    for (const std::string option : {"--seed ", "--samples "}) {
      INFO(option + number);
      CHECK(workspace.run("elgen verify --quick " + option + number + " " + model).status == 2);
    }
  }
  const std::string largest = "elgen verify --quick --seed 18446744073709551615 ";
  CHECK(mentions(workspace.run(largest + model).output, "seed 18446744073709551615\n"));
  CHECK(mentions(few.errors, "\n  M = m l^2\n"));
}

TEST_CASE(
    "one line for each output, all details with -v, the verdict with -q, everything with json") {
  const Workspace workspace;
  const std::string verify = "elgen verify --quick " + models + "/simple_pendulum.toml ";
  const Outcome lines = workspace.run(verify);
  CHECK(mentions(lines.output, "\n  holds    mass_matrix "));
  CHECK(mentions(lines.output, "\n  holds    [[expect]] gravity            1 check, proved\n"));
  CHECK(mentions(lines.output, " checks hold, 0 fail, 0 skipped\n"));
  CHECK_FALSE(mentions(lines.output, "tolerance"));
  const Outcome full = workspace.run(verify + "-v");
  CHECK(mentions(full.output, "           tolerance  1e-50 (E + |x*|)"));
  CHECK(mentions(full.output, "           decided    for every state, by proof"));
  const Outcome verdict = workspace.run(verify + "-q");
  CHECK(starts_with(verdict.output, "simple_pendulum: "));
  CHECK(std::count(verdict.output.begin(), verdict.output.end(), '\n') == 1);
  const Outcome as_json = workspace.run(verify + "--format json");
  const auto json = nlohmann::json::parse(as_json.output);
  CHECK(json.at("model") == "simple_pendulum");
  CHECK(json.at("fails") == 0);
  CHECK(json.at("checks").size() == json.at("holds"));
}

TEST_CASE("skipped checks are counted with their reason, and fail with --strict") {
  const Workspace workspace;
  // M = [[m, m], [m, m + d]] is regular, but det M = m d is only 1e-18 m^2.
  workspace.write(
      "light.toml",
      "format = 1\n[model]\nname = \"light\"\n[[coordinate]]\nname = \"x\"\nunit = \"m\"\n"
      "[[coordinate]]\nname = \"y\"\nunit = \"m\"\n[parameters]\n"
      "m = { value = 1, unit = \"kg\" }\nd = { value = 1e-18, unit = \"kg\" }\n"
      "[energy]\nT = \"1/2*m*(dot(x) + dot(y))^2 + 1/2*d*dot(y)^2\"\nV = \"0\"\n");
  const std::string verify = "elgen verify --quick light.toml";
  const Outcome lenient = workspace.run(verify);
  INFO(lenient.output + lenient.errors);
  CHECK(lenient.status == 0);
  CHECK(mentions(lenient.output,
                 "           skipped: mass matrix positive definite, mass_matrix\n"
                 "           because    "));
  CHECK(mentions(lenient.output, " singular\n"));
  CHECK_FALSE(mentions(lenient.output, ", 0 skipped"));
  CHECK(workspace.run(verify + " --strict").status == 1);
  CHECK(workspace.run("elgen verify --quick --strict " + models + "/simple_pendulum.toml").status ==
        0);
}

TEST_CASE("the forward dynamics of arms is compared at most states") {
  const Workspace workspace;
  for (const std::string name : {"panda7", "ur5", "chain"}) {
    const Outcome outcome =
        workspace.run("elgen verify --quick --format json " + models + "/" + name + ".toml");
    INFO(name << outcome.errors);
    REQUIRE(outcome.status == 0);
    const auto json = nlohmann::json::parse(outcome.output);
    CHECK(json.at("skipped") == 0);
    for (const auto& row : json.at("checks")) {
      if (row.at("check") != "program vs oracle" || row.at("output") != "forward_dynamics")
        continue;
      INFO(row.dump(2));
      CHECK(row.at("samples") >= 7);
    }
  }
}

TEST_CASE("option --timings includes verify") {
  const std::string model = models + "/simple_pendulum.toml";
  const Outcome outcome = run("elgen verify --build written --samples 2 --timings " + model);
  CHECK(outcome.status == 0);
  CHECK(mentions(outcome.errors, "     compile "));
  CHECK(mentions(outcome.errors, "      verify "));
}

}  // namespace elgen::test
