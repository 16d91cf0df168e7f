// elgen tradeoff: the printed table, the designs in the table, runs by all methods, files and exit
// codes. No test depends on measured times.
#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/cli_testing.hpp"

namespace elgen::test {
namespace {

nlohmann::json table_in(const Outcome& outcome) {
  INFO(outcome.errors);
  REQUIRE(outcome.status == 0);
  return nlohmann::json::parse(outcome.output);
}

/// Writes a compiler that adds a line to the file `made` for each library, and that fails if the
/// source contains `refused`.
void write_compiler(const Workspace& workspace, const std::string& refused) {
  workspace.write("compiler.sh",
                  "for word; do case $word in */timing_driver.cpp)\n"
                  "  echo made >> " +
                      (workspace.path() / "made").string() + "\n" + "  grep -q '" + refused +
                      "' \"$word\" && exit 1 ;; esac; done\nexec c++ \"$@\"\n");
}

/// A model, a scene, and a compiler that only answers --version.
class RotorWorkspace : public Workspace {
 public:
  RotorWorkspace() {
    write("rotor.toml",
          "format = 1\n[model]\nname = \"rotor\"\n[[coordinate]]\nname = \"q\"\n"
          "unit = \"rad\"\n[parameters]\nJ = { value = 2, unit = \"kg*m^2\" }\n"
          "k = { value = 3, unit = \"J\" }\n"
          "[energy]\nT = \"1/2*J*dot(q)^2\"\nV = \"k*(1 - cos(q))\"\n");
    write("two.scene.toml",
          "format = 1\nmodel = \"rotor.toml\"\nname = \"two\"\n[outputs]\n"
          "potential_energy = true\ngravity = true\n");
    write("idle.sh", "test \"$1\" = --version\n");
  }

  [[nodiscard]] Outcome measure(const std::string& words) const {
    return run("CXX='sh idle.sh' elgen tradeoff --format json " + words);
  }
  [[nodiscard]] std::string subject(const std::string& words) const {
    const Outcome outcome = measure(words);
    INFO(outcome.errors);
    REQUIRE(outcome.status == 4);
    return nlohmann::json::parse(outcome.output).at("subject");
  }
};

}  // namespace

TEST_CASE("a wider inner scalar has all digits, whatever the condition of M") {
  const Workspace workspace;
  workspace.write("far.scene.toml",
                  "format = 1\nmodel = \"" + models +
                      "/two_link_arm.toml\"\nname = \"far\"\n[outputs]\nforward_dynamics = true\n"
                      "[parameters]\nfixed = { c2 = 3.5e5 }\n");
  const nlohmann::json table = table_in(workspace.run(
      "elgen tradeoff --as json --scalar double --batch one --parameters arguments --form chosen "
      "--dimensions inner --max-error 1e-15 --write-scene wide.scene.toml far.scene.toml"));
  REQUIRE(table["designs"].size() == 3);
  for (const auto& design : table["designs"]) {
    const bool is_right = design["error"]["worst"] < 1e-15;
    const std::string inner = design["design"]["inner"];
    if (inner != "long double") CHECK(is_right == (inner == "double-double"));
  }
  const std::string wide = workspace.read("wide.scene.toml");
  CHECK((mentions(wide, "inner = \"double-double\"\n") ||
         mentions(wide, "inner = \"long double\"\n")));
  CHECK(workspace.run("elgen verify --build written --samples 8 wide.scene.toml").status == 0);
}

TEST_CASE("a model has nine designs, and verify confirms the error of the chosen scene") {
  const Workspace workspace;
  const Outcome outcome = workspace.run(
      "elgen tradeoff --as json --max-error 1e-6 --write-scene "
      "fast.scene.toml -o front.svg " +
      models + "/cart_pole.toml");
  const nlohmann::json table = table_in(outcome);
  CHECK(table["subject"] == "inverse_dynamics");
  REQUIRE(table["designs"].size() == 9);
  for (const auto& design : table["designs"]) {
    const bool is_double = design["design"]["scalar"] == "double";
    CHECK(design["error"]["worst"] < (is_double ? 1e-15 : 1e-6));
    CHECK(design["error"]["worst"] > (is_double ? 1e-17 : 1e-11));
  }
  CHECK(table["designs"][0]["front"] == true);
  CHECK(table["designs"][0]["rank"] == 1);
  CHECK(table["pick"]["error"]["worst"] <= 1e-6);
  CHECK(starts_with(workspace.read("front.svg"), "<svg "));
  CHECK(mentions(workspace.read("fast.scene.toml"), "max_error = \"1e-06\"\n"));
  const auto verified = [&workspace](const std::string& words) {
    const Outcome verdict = workspace.run("elgen verify --build written --samples 16 " + words);
    INFO(verdict.output + verdict.errors);
    CHECK(mentions(verdict.output, "max_error, inverse_dynamics") == (verdict.status == 1));
    return verdict.status;
  };
  CHECK(verified("fast.scene.toml") == 0);
  workspace.prepare("sed -i 's/max_error = \"1e-06\"/max_error = 1e-17/' fast.scene.toml");
  CHECK(verified("fast.scene.toml") == 1);
}

TEST_CASE("the error of an expansion is measured against the exact model if the scene says so") {
  const Workspace workspace;
  const auto status = [&workspace](const std::string& ranges) {
    workspace.write("upright.scene.toml",
                    "format = 1\nmodel = \"" + models +
                        "/cart_pole.toml\"\nname = \"upright\"\n[outputs]\ngravity = true\n"
                        "[approximate]\norder = 1\nabout = { x = 0, theta = 0 }\n"
                        "[numeric]\nmax_error = 1e-4\n" +
                        ranges);
    return workspace.run("elgen verify --build written --samples 16 upright.scene.toml").status;
  };
  CHECK(status("ranges = { theta = [-0.01, 0.01] }\n") == 0);
  CHECK(status("") == 1);
}

TEST_CASE("polynomials of 1e-7 are tried if the command or the scene asks for them") {
  const Workspace workspace;
  workspace.write("rough.scene.toml",
                  "format = 1\nmodel = \"" + models +
                      "/simple_pendulum.toml\"\nname = \"rough\"\n[outputs]\ngravity = true\n"
                      "[emit]\nbatch = true\n[numeric]\ntrigonometry = { max_error = 1e-7 }\n");
  const auto tried = [&workspace](const std::string& words) {
    const nlohmann::json table = table_in(workspace.run(
        "elgen tradeoff --as json --scalar double --form chosen --parameters fixed " + words));
    std::size_t count = 0;
    for (const auto& design : table["designs"]) {
      if (design["design"].value("trigonometry", "") != "1e-7") continue;
      ++count;
      CHECK(design["error"]["worst"] > 1e-10);
    }
    return count;
  };
  const std::string pendulum = "--of gravity " + models + "/simple_pendulum.toml";
  CHECK(tried(pendulum) == 0);
  CHECK(tried("--dimensions trigonometry " + pendulum) == 1);
  CHECK(tried("--trigonometry 1e-7 " + pendulum) == 1);
  CHECK(tried("rough.scene.toml") == 1);
}

TEST_CASE("requested dimensions are tried, expansions about the point of the scene") {
  const Workspace workspace;
  workspace.write("upright.scene.toml",
                  "format = 1\nmodel = \"" + models +
                      "/cart_pole.toml\"\nname = \"upright\"\n[outputs]\ngravity = true\n"
                      "[approximate]\norder = 3\nabout = { x = 0, theta = 0 }\n");
  const nlohmann::json table = table_in(
      workspace.run("elgen tradeoff -q --format json --dimensions order --range theta=-0.01..0.01 "
                    "upright.scene.toml"));
  std::size_t expanded = 0;
  for (const auto& design : table["designs"]) {
    CHECK_FALSE(design.contains("failure"));
    if (design["design"]["order"] != "1") continue;
    ++expanded;
    // search_margin (1.5) times theta^2/6 at 0.01 rad, the relative error of sin(theta) = theta.
    CHECK(design["error"]["worst"] == Approx(2.5e-5).epsilon(0.01));
  }
  CHECK(expanded > 0);
}

TEST_CASE("a design has a cost per state and a cost per call, and only packs differ in them") {
  const Workspace workspace;
  const std::string command = "elgen tradeoff -q --of gravity " + models + "/simple_pendulum.toml";
  const nlohmann::json both = table_in(workspace.run(command + " --as json"));
  CHECK(both["cost"] == "ns per state");
  CHECK(both["call_cost"] == "ns per call");
  for (const auto& design : both["designs"]) {
    if (design["design"]["batch"] == "one") CHECK(design["call_cost"] == design["cost"]);
    if (design["design"]["batch"] == "packs") CHECK(design["call_cost"]["least"] > 0);
  }
  const nlohmann::json one = table_in(workspace.run(command + " --as json --batch one"));
  CHECK(one["cost"] == "ns per call");
  CHECK_FALSE(one.contains("call_cost"));
  REQUIRE(one["designs"].size() == 5);
  for (const auto& design : one["designs"]) CHECK(design["design"]["batch"] == "one");
}

TEST_CASE("the chosen row is printed, also with -q, and its scene has the pinned values") {
  const Workspace workspace;
  const Outcome outcome = workspace.run(
      "elgen tradeoff -q --scalar float --batch one --parameters arguments --form chosen "
      "--max-error 1e-3 --write-scene x.scene.toml --of gravity " +
      models + "/simple_pendulum.toml");
  INFO(outcome.errors);
  CHECK(outcome.status == 0);
  CHECK(outcome.errors.empty());
  CHECK(mentions(outcome.output, "\ncheapest within 0.001: float, one, arguments, chosen; "));
  const std::string scene = workspace.read("x.scene.toml");
  CHECK(mentions(scene, "scalar = [\"float\"]"));
  CHECK_FALSE(mentions(scene, "batch"));
  CHECK_FALSE(mentions(scene, "fixed"));
}

TEST_CASE("a scene keeps its locked and fixed values, and existing files need --force") {
  const Workspace workspace;
  const std::string command =
      "elgen tradeoff -q --as csv -o x.csv " + models + "/scenes/balance.scene.toml";
  const Outcome outcome = workspace.run(command);
  INFO(outcome.errors);
  CHECK(outcome.status == 0);
  CHECK(starts_with(outcome.output, "scalar,batch,"));
  CHECK(outcome.output == workspace.read("x.csv"));
  CHECK(workspace.run(command).status == 4);
  CHECK(workspace.run("elgen tradeoff -o x.pdf " + models + "/cart_pole.toml").status == 2);
}

TEST_CASE("if no design is accurate enough, the table is written and no scene") {
  const Workspace workspace;
  const Outcome outcome = workspace.run(
      "elgen tradeoff --of gravity --max-error 1e-30 --write-scene x.scene.toml -o x.csv " +
      models + "/simple_pendulum.toml");
  CHECK(outcome.status == 1);
  CHECK(mentions(outcome.errors, "error[E632]: no design has a worst error of at most 1e-30\n"));
  CHECK(starts_with(workspace.read("x.csv"), "scalar,"));
  CHECK_FALSE(std::filesystem::exists(workspace.path() / "x.scene.toml"));
}

TEST_CASE("runs have a row for each emitted step, and shorter steps have smaller errors") {
  const Workspace workspace;
  const Outcome outcome = workspace.run(
      "elgen tradeoff --trajectory 2 --as json --max-error 1e-12 --write-scene x.scene.toml "
      "-o x.svg " +
      models + "/double_pendulum.toml");
  INFO(outcome.errors);
  REQUIRE(outcome.status == 0);
  const auto table = nlohmann::json::parse(outcome.output);
  const auto row = [&table](const std::string& method, const std::string& order,
                            const std::string& step, const std::string& inner = "double") {
    for (const auto& design : table["designs"]) {
      const auto& values = design["design"];
      if (values["method"] == method && values["order"] == order && values["step"] == step &&
          values["batch"] == "one" && values["inner"] == inner) {
        return design;
      }
    }
    return nlohmann::json();
  };
  const auto error = [&row](const std::string& order, const std::string& step) {
    return row(order == "4" ? "rk4" : "midpoint", order, step)["error"]["worst"].get<double>();
  };
  CHECK(error("4", "0.002 s") > 0);
  CHECK(error("4", "0.02 s") > 100 * error("4", "0.002 s"));
  CHECK(error("2", "0.002 s") > 100 * error("8", "0.002 s"));
  CHECK(row("verlet", "2", "0.002 s").is_null());
  const auto in_float = row("rk4", "4", "0.0002 s", "float")["error"]["worst"].get<double>();
  CHECK(in_float > error("4", "0.0002 s"));
  CHECK(in_float < 1e-4);  // 2 s, in which errors of the accelerations grow by a factor of 100
  // Ten times as many steps cost ten times as much.
  const auto cost = [&row](const std::string& step) {
    return row("rk4", "4", step)["cost"]["least"].get<double>();
  };
  CHECK(cost("0.0002 s") == Approx(10 * cost("0.002 s")));
  // The reference is more accurate than every method.
  CHECK(error("4", "0.0002 s") < 1e-12);
  CHECK_FALSE(row("rk4", "4", "0.0002 s")["error"].contains("below_reference"));
  CHECK(mentions(table["sentences"].front().get<std::string>(),
                 "reference: Fehlberg's method of order 8 in long double, with tolerance 1e-18; a "
                 "run with 1e-17 differs by "));
  CHECK(table["sentences"].back() ==
        "`verlet` does not apply to this system: M depends on `theta1`");
  CHECK(table["pick"]["error"]["worst"] <= 1e-12);
  CHECK(starts_with(workspace.read("x.svg"), "<svg "));
  CHECK(mentions(workspace.read("x.scene.toml"), "step = { method = "));
  CHECK(workspace.run("elgen generate x.scene.toml").status == 0);
}

TEST_CASE("runs with requested steps, projected if the model has constraints") {
  const Workspace workspace;
  const auto measured = [&workspace](const std::string& options) {
    const Outcome outcome = workspace.run("elgen tradeoff --as json " + options);
    INFO(outcome.errors);
    REQUIRE(outcome.status == 0);
    return nlohmann::json::parse(outcome.output);
  };
  const auto bar = measured("--trajectory 1 --steps 1e-2,2e-3 --max-error 1e-6 --write-scene " +
                            std::string("bar.scene.toml ") + models + "/four_bar.toml");
  CHECK(bar["designs"].size() == 8);
  for (const auto& design : bar["designs"]) {
    CHECK((design["design"]["step"] == "0.01 s" || design["design"]["step"] == "0.002 s"));
    // Without `projected` the error with steps of 0.01 s is 7e-7, because the state leaves the
    // constraints.
    if (design["design"]["inner"] == "double") {
      CHECK(design["error"]["worst"].get<double>() < 2e-7);
    }
  }
  CHECK(mentions(bar["sentences"].dump(), "the cost includes a call of `projected`"));
  CHECK(mentions(workspace.read("bar.scene.toml"), "projected = true"));
  CHECK(workspace.run("elgen generate -q bar.scene.toml").status == 0);
  const auto free = measured("--trajectory 1 --steps 0.5 " + models + "/simple_pendulum.toml");
  CHECK_FALSE(mentions(free["sentences"].dump(), "projected"));
  CHECK(workspace.run("elgen tradeoff --steps 0.1 " + models + "/simple_pendulum.toml").status ==
        2);
}

TEST_CASE("options for outputs are refused for runs") {
  const Workspace workspace;
  for (const char* option :
       {"--of gravity", "--dimensions order", "--batch one", "--range q1=0..1", "--over m1=1:2"}) {
    INFO(option);
    CHECK(workspace
              .run(std::string("elgen tradeoff --trajectory 2 ") + option + " " + models +
                   "/double_pendulum.toml")
              .status == 2);
  }
}

TEST_CASE("nine designs are compiled as three libraries") {
  const Workspace workspace;
  write_compiler(workspace, "no such word");
  const Outcome outcome =
      workspace.run("CXX=\"sh $PWD/compiler.sh\" elgen tradeoff -q --format json " + models +
                    "/simple_pendulum.toml");
  INFO(outcome.errors);
  REQUIRE(outcome.status == 0);
  CHECK(nlohmann::json::parse(outcome.output)["designs"].size() == 9);
  CHECK(workspace.read("made") == "made\nmade\nmade\n");
}

TEST_CASE(
    "designs that do not compile are reported, the others are measured, and the exit code is 4") {
  const Workspace workspace;
  write_compiler(workspace, "fixed");
  const Outcome outcome =
      workspace.run("CXX=\"sh $PWD/compiler.sh\" elgen tradeoff -q --format json " + models +
                    "/simple_pendulum.toml");
  CHECK(outcome.status == 4);
  CHECK(mentions(outcome.errors, "E705"));
  const auto table = nlohmann::json::parse(outcome.output);
  const auto& designs = table["designs"];
  CHECK(std::count_if(designs.begin(), designs.end(), [](const auto& design) {
          return design.contains("failure") && design["design"]["parameters"] == "fixed";
        }) == 4);
  CHECK(std::count_if(designs.begin(), designs.end(),
                      [](const auto& design) { return design.contains("cost"); }) == 5);
}

TEST_CASE_METHOD(
    RotorWorkspace,
    "the subject is inverse_dynamics, the first output of a scene, or the named output") {
  CHECK(subject("rotor.toml") == "inverse_dynamics");
  CHECK(subject("two.scene.toml") == "gravity");
  CHECK(subject("--of potential_energy two.scene.toml") == "potential_energy");
}

TEST_CASE_METHOD(RotorWorkspace, "several outputs and unknown outputs are refused as subject") {
  const Outcome outcome = measure("--of gravity,bias rotor.toml");
  CHECK(outcome.status == 2);
  CHECK(mentions(outcome.errors, "`gravity,bias` is not one output"));
}

TEST_CASE_METHOD(RotorWorkspace,
                 "E644: a pinned value is refused where a key of the scene says another one") {
  struct PinRow {
    std::string keys;
    std::string option;
    bool contradicts;
  };
  const std::string polynomials =
      "[emit]\nbatch = true\n[numeric]\ntrigonometry = { max_error = 1e-7 }\n";
  const std::string expanded = "[approximate]\norder = 1\nabout = { q = 0 }\n";
  const std::vector<PinRow> rows{
      {"", "--scalar float --batch packs --parameters arguments", false},
      {"[numeric]\nscalar = [\"float\"]\n", "--scalar double", true},
      {"[numeric]\nscalar = [\"float\"]\n", "--scalar float", false},
      {"[numeric]\nscalar = [\"float\", \"double\"]\n", "--scalar double", false},
      {"[emit]\nbatch = false\n", "--batch packs", true},
      {"[emit]\nbatch = true\n", "--batch one", true},
      {polynomials, "--trigonometry full", true},
      {polynomials, "--trigonometry 1e-7", false},
      {polynomials, "--trigonometry library", true},
      {"[numeric]\ntrigonometry = { scalar = \"library\" }\n", "--trigonometry full", true},
      {"[numeric]\ntrigonometry = { scalar = \"library\" }\n", "--trigonometry library", false},
      {"[parameters]\nfixed = \"all\"\n", "--parameters arguments", true},
      {"[parameters]\nfixed = { J = 2 }\n", "--parameters arguments", false},
      {"[parameters]\nfixed = { J = 2 }\n", "--parameters fixed", false},
      {expanded, "--order 3", true},
      {expanded, "--order exact", true},
      {expanded, "--order 1", false},
      {"[numeric]\nform = \"closed\"\n", "--form typed", true},
      {"[numeric]\nform = \"closed\"\n", "--form chosen", false},
      {"[numeric]\nform = \"recursive\"\n", "--form typed", false},
  };
  for (const PinRow& row : rows) {
    INFO(row.keys + row.option);
    write("pinned.scene.toml",
          "format = 1\nmodel = \"rotor.toml\"\nname = \"pinned\"\n[outputs]\ngravity = true\n" +
              row.keys);
    const Outcome outcome = measure(row.option + " pinned.scene.toml");
    INFO(outcome.errors);
    CHECK(outcome.status == (row.contradicts ? 2 : 4));
    CHECK(mentions(outcome.errors, "E644") == row.contradicts);
  }
}

}  // namespace elgen::test
