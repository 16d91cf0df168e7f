// elgen generate: the effect of options on the written files, and the sources named in the files.
#include <catch2/catch.hpp>

#include "cli/cli_testing.hpp"

namespace elgen::test {
namespace {

/// The first line of the file `header` after `command`, in a folder with the cart and its scene in
/// a/.
std::string first_line(const std::string& command, const std::string& header) {
  const Workspace workspace;
  workspace.prepare("mkdir -p a/scenes b/deep && cp " + models + "/cart_pole.toml a && cp " +
                    models + "/scenes/balance.scene.toml a/scenes && " + command);
  const std::string text = workspace.read(header);
  return text.substr(0, text.find('\n'));
}

}  // namespace

TEST_CASE("the base name of a scene is the model's name and its own") {
  const Workspace workspace;
  CHECK(failure_of(workspace.run("elgen generate -q -o out " + models +
                                 "/scenes/balance.scene.toml")) == "");
  CHECK(workspace.files() ==
        "./out/cart_pole_balance/cart_pole_balance.equations.json\n"
        "./out/cart_pole_balance/cart_pole_balance.hpp\n"
        "./out/cart_pole_balance/cart_pole_balance.md\n");
}

TEST_CASE("`files` of a scene omits the sidecar and the page") {
  const Project project;
  project.write(
      "bare.scene.toml",
      "format = 1\nmodel = \"cart_pole.toml\"\nname = \"bare\"\n[outputs]\nmass_matrix = true\n"
      "[emit]\nfiles = [\"header\"]\n");
  CHECK(project.run("elgen generate -q bare.scene.toml").status == 0);
  CHECK(project.run("ls generated/cart_pole_bare").output == "cart_pole_bare.hpp\n");
  CHECK(project.run("elgen generate --check -q bare.scene.toml").status == 0);
  project.prepare("sed -i 's/mass_matrix/bias/' bare.scene.toml");
  CHECK(project.run("elgen generate --check -q bare.scene.toml").status == 1);
}

TEST_CASE("option --stdout prints the header and writes nothing") {
  const Workspace workspace;
  const Outcome outcome = workspace.run("elgen generate --stdout " + models + "/cart_pole.toml");
  CHECK(outcome.status == 0);
  CHECK(starts_with(outcome.output, marker));
  CHECK(workspace.files().empty());
}

TEST_CASE("option --list-outputs prints the paths and writes nothing") {
  const Workspace workspace;
  const Outcome outcome =
      workspace.run("elgen generate --list-outputs -o out " + models + "/cart_pole.toml");
  CHECK(outcome.status == 0);
  CHECK(outcome.output ==
        "out/cart_pole/cart_pole.equations.json\nout/cart_pole/cart_pole.hpp\n"
        "out/cart_pole/cart_pole.md\n");
  CHECK(workspace.files().empty());
}

TEST_CASE("option --depfile writes the dependencies of each output as rules of make") {
  const Workspace workspace;
  workspace.prepare("cp -r " + models + " models");
  REQUIRE(failure_of(workspace.run(
              "elgen generate -q -o out --depfile out.d models/scenes/balance.scene.toml")) == "");
  const std::string stem = "out/cart_pole_balance/cart_pole_balance";
  const std::string sources = ": models/cart_pole.toml models/scenes/balance.scene.toml\n";
  CHECK(workspace.read("out.d") ==
        stem + ".hpp" + sources + stem + ".equations.json" + sources + stem + ".md" + sources);
}

TEST_CASE("with a Ninja rule that declares every file, elgen runs if a source changed") {
  const Workspace workspace;
  workspace.prepare("cp -r " + models + " models");
  const std::string stem = "out/cart_pole_balance/cart_pole_balance";
  workspace.write("build.ninja",
                  "rule elgen\n  command = elgen generate -q -o out --depfile out.d $in\n"
                  "  depfile = out.d\n  deps = gcc\n  restat = 1\n"
                  "build " +
                      stem + ".hpp " + stem + ".equations.json " + stem +
                      ".md: elgen models/scenes/balance.scene.toml\n");
  const auto builds = [&](const std::string& edit) {
    return mentions(workspace.run(edit + " && ninja").output, "elgen generate");
  };
  CHECK(builds("true"));
  CHECK_FALSE(builds("true"));
  CHECK(builds("sed -i 's/0.1, /0.2, /' models/cart_pole.toml"));
  CHECK_FALSE(builds("true"));
}

TEST_CASE("the JSON of generate names the sources that are files") {
  const Workspace workspace;
  workspace.prepare("cp -r " + models + " models");
  const std::string list = "elgen generate --list-outputs --format json ";
  CHECK(mentions(workspace.run(list + "models/scenes/../scenes/balance.scene.toml").output,
                 "\"sources\": [\n        \"models/cart_pole.toml\",\n"
                 "        \"models/scenes/../scenes/balance.scene.toml\"\n      ]"));
  CHECK(mentions(workspace.run(list + "- < models/cart_pole.toml").output, "\"sources\": []"));
}

TEST_CASE("options that change the model's default output are refused without -o") {
  const Workspace workspace;
  const std::string generate = "elgen generate -q " + models + "/chain.toml ";
  for (const std::string option : {"--outputs mass_matrix", "--fix g", "--size n=2"}) {
    INFO(option);
    CHECK(workspace.run("rm -rf generated && " + generate + option).status == 0);
    REQUIRE(workspace.run("rm -rf generated && " + generate).status == 0);
    const Outcome outcome = workspace.run(generate + option);
    CHECK(outcome.status == 2);
    CHECK(mentions(outcome.errors, "[E607]"));
    CHECK(workspace.run(generate + option + " -o other").status == 0);
  }
}

TEST_CASE(
    "code of a model is not replaced by another model of the same name while its source exists") {
  const Workspace workspace;
  workspace.prepare("mkdir a b && cp " + models +
                    "/simple_pendulum.toml a/pend.toml && sed 's/\"-g\"/\"-2*g\"/' a/pend.toml > "
                    "b/pend.toml && elgen generate -q a/pend.toml");
  const std::string header = "generated/simple_pendulum/simple_pendulum.hpp";
  const std::string before = workspace.read(header);
  const std::string command = "elgen generate -q b/pend.toml";
  const Outcome refused = workspace.run(command);
  CHECK(refused.status == 2);
  CHECK(mentions(refused.errors,
                 "error[E604]: `generated/simple_pendulum/simple_pendulum.equations.json` was "
                 "generated from `a/pend.toml`, and `b/pend.toml` has the same name"));
  CHECK(workspace.read(header) == before);
  CHECK(workspace.run("elgen generate -q ./a/../a/pend.toml").status == 0);
  CHECK(workspace.run(command + " -o other").status == 0);
  CHECK(workspace.run("elgen generate -q - < b/pend.toml").status == 2);
  CHECK(workspace.run(command + " --force").status == 0);
  CHECK(workspace.run("elgen generate -q a/pend.toml").status == 2);
  CHECK(workspace
            .run("sed -i 's/\"simple_pendulum\"/\"pend\"/' b/pend.toml && elgen generate -q "
                 "a/pend.toml")
            .status == 0);
  CHECK(workspace.run("mv a/pend.toml b/moved.toml && elgen generate -q b/moved.toml").status == 0);
}

TEST_CASE("a scene does not replace files of another model or scene of the same name") {
  const Workspace workspace;
  workspace.prepare("cp " + models + "/simple_pendulum.toml swing.toml");
  const auto scene = [&](const std::string& file) {
    workspace.write(file,
                    "format = 1\nmodel = \"swing.toml\"\nname = \"fast\"\n"
                    "[outputs]\ngravity = true\n[emit]\nfiles = [\"header\"]\n");
  };
  scene("one.scene.toml");
  scene("two.scene.toml");
  CHECK(workspace.run("elgen generate -q one.scene.toml").status == 0);
  const Outcome refused = workspace.run("elgen generate -q two.scene.toml");
  CHECK(refused.status == 2);
  CHECK(mentions(refused.errors,
                 "was generated from `one.scene.toml`, and `two.scene.toml` has the"));
  workspace.prepare("sed 's/\"simple_pendulum\"/\"simple_pendulum_fast\"/' swing.toml > fast.toml");
  CHECK(workspace.run("elgen generate -q fast.toml").status == 2);
  CHECK(workspace.run("rm one.scene.toml && elgen generate -q two.scene.toml").status == 0);
  CHECK(workspace.run("elgen generate -q fast.toml").status == 2);
}

TEST_CASE("a line reports the comparison, and that [[expect]] was not checked") {
  const Outcome outcome = run("elgen generate -o out " + models + "/simple_pendulum.toml");
  CHECK(outcome.status == 0);
  CHECK(mentions(outcome.errors, "simple_pendulum: compared with 60-digit arithmetic at "));
  CHECK(mentions(outcome.errors, " lost; `elgen verify` checks [[expect]]\n"));
}

TEST_CASE("paths in files are relative to the output root, in whatever form it is given") {
  const std::string line = "// Code generated by elgen from ../a/cart_pole.toml. DO NOT EDIT.";
  const std::string header = "b/cart_pole/cart_pole.hpp";
  CHECK(first_line("elgen generate -q -o b a/cart_pole.toml", header) == line);
  CHECK(first_line("cd b/deep && elgen generate -q -o .. $PWD/../../a/cart_pole.toml", header) ==
        line);
  CHECK(first_line("elgen generate -q -o b a/scenes/balance.scene.toml",
                   "b/cart_pole_balance/cart_pole_balance.hpp") ==
        "// Code generated by elgen from ../a/scenes/balance.scene.toml of ../a/cart_pole.toml. DO "
        "NOT EDIT.");
}

TEST_CASE("a path that would reveal the machine is replaced by the file name") {
  const std::string named = "// Code generated by elgen from cart_pole.toml. DO NOT EDIT.";
  const std::string header = "b/cart_pole/cart_pole.hpp";
  CHECK(first_line("elgen generate --stdout a/cart_pole.toml > b/cart.hpp", "b/cart.hpp") == named);
  CHECK(first_line("HOME=$PWD elgen generate -q -o b a/cart_pole.toml", header) == named);
  CHECK(first_line("HOME=$PWD/a elgen generate -q -o b a/cart_pole.toml", header) == named);
  CHECK(first_line("TMPDIR=$PWD elgen generate -q -o b a/cart_pole.toml", header) == named);
  CHECK(first_line("git init -q && HOME=$PWD elgen generate -q -o b a/cart_pole.toml", header) !=
        named);
}

TEST_CASE("a clone below the folder for temporary files has no paths to other folders there") {
  const Workspace clone;
  const Workspace other;
  clone.prepare("cp " + models + "/cart_pole.toml . && git init -q");
  other.prepare("elgen generate -q " + (clone.path() / "cart_pole.toml").string());
  CHECK(starts_with(other.read("generated/cart_pole/cart_pole.hpp"), marker));
  CHECK(mentions(other.read("generated/cart_pole/cart_pole.hpp"),
                 "elgen from cart_pole.toml. DO NOT EDIT."));
}

}  // namespace elgen::test
