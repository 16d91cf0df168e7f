// Input files of a command: models, scenes with their models, and invalid paths.
#include <catch2/catch.hpp>

#include "cli/cli_testing.hpp"

namespace elgen::test {

TEST_CASE("the path of a model is relative to its scene, not to the working directory") {
  const Workspace workspace;
  workspace.prepare("mkdir -p project/scenes elsewhere && cp " + models +
                    "/cart_pole.toml project && cp " + models +
                    "/scenes/balance.scene.toml project/scenes");
  CHECK(workspace.run("cd elsewhere && elgen generate -q ../project/scenes/balance.scene.toml")
            .status == 0);
  CHECK(workspace.run("ls elsewhere/generated").output == "cart_pole_balance\n");
}

TEST_CASE("every input is read, and the most severe exit code counts") {
  const Workspace workspace;
  workspace.prepare("mkdir folder.toml");
  const std::string good = models + "/cart_pole.toml";
  CHECK(workspace.run("elgen generate -q " + good + " nowhere.toml").status == 2);
  CHECK(workspace.run("elgen generate -q nowhere.toml folder.toml").status == 4);
  const Outcome both = workspace.run("elgen generate -q nowhere.toml folder.toml");
  CHECK(mentions(both.errors, "`nowhere.toml`"));
  CHECK(mentions(both.errors, "`folder.toml`"));
}

TEST_CASE("a path may contain spaces and quotes") {
  const Workspace workspace;
  workspace.prepare("mkdir \"it's mine\" && cp " + models + "/cart_pole.toml \"it's mine\"");
  CHECK(workspace.run("elgen generate -q -o \"out 1\" \"it's mine/cart_pole.toml\"").status == 0);
  CHECK(workspace.run("ls 'out 1'").output == "cart_pole\n");
}

TEST_CASE("`-` is standard input, for models, scenes and robots") {
  const Workspace workspace;
  workspace.prepare("cp " + models + "/cart_pole.toml . && cp " + models +
                    "/scenes/balance.scene.toml . && "
                    "sed -i 's:[.][.]/::' balance.scene.toml");
  CHECK(workspace.run("elgen show - < cart_pole.toml").output ==
        workspace.run("elgen show cart_pole.toml").output);
  CHECK(workspace.run("cat balance.scene.toml | elgen show -").output ==
        workspace.run("elgen show balance.scene.toml").output);
  CHECK(workspace.run("elgen import - < " ELGEN_SOURCE_DIR "/tests/urdf/robots/gripper.urdf")
            .status == 0);
  CHECK(workspace.run("elgen generate -q --depfile d - < cart_pole.toml").status == 0);
  CHECK(starts_with(workspace.read("d"), "generated/cart_pole/cart_pole.hpp:\n"));
  const Outcome faulty = workspace.run("echo 'format = 2' | elgen show -");
  CHECK(starts_with(faulty.errors, "<stdin>:1:10: error[E102]"));
  const Outcome twice = workspace.run("elgen generate - - < cart_pole.toml");
  CHECK(twice.status == 4);
  CHECK(mentions(twice.errors, "error[E707]: `<stdin>` can be read only once"));
}

TEST_CASE("a FIFO is read up to the limit of bytes, and waited for up to the limit of seconds") {
  const Workspace workspace;
  workspace.prepare("mkfifo pipe.toml silent.toml");
  const Outcome read =
      workspace.run("cat " + models + "/cart_pole.toml > pipe.toml & elgen show pipe.toml");
  CHECK(read.status == 0);
  CHECK(read.output == workspace.run("elgen show " + models + "/cart_pole.toml").output);
  const Outcome endless = workspace.run("yes > pipe.toml & elgen show pipe.toml");
  CHECK(endless.status == 2);
  CHECK(mentions(endless.errors, "error[E901]: `pipe.toml` has more than 1048576 bytes"));
  for (const std::string command :
       {"elgen show silent.toml --limit seconds=1", "sleep 9 | elgen show - --limit seconds=1"}) {
    const Outcome late = workspace.run(command);
    CHECK(late.status == 3);
    CHECK(mentions(late.errors, "could not be read within 1 s\n"));
  }
}

TEST_CASE("folders and devices are refused as inputs and as models of scenes") {
  const Workspace workspace;
  workspace.prepare("mkdir folder.toml && ln -s /dev/zero zero.toml");
  for (const std::string& path : {std::string("zero.toml"), std::string("folder.toml")}) {
    INFO(path);
    workspace.write("a.scene.toml", "format = 1\nmodel = \"" + path + "\"\nname = \"a\"\n");
    for (const std::string& input : {path, std::string("a.scene.toml")}) {
      const Outcome outcome = workspace.run("elgen show " + input);
      CHECK(outcome.status == 4);
      CHECK(mentions(outcome.errors, "error[E707]: `" + path + "` is a "));
    }
    CHECK(workspace.run("elgen import " + path).status == 4);
  }
}

TEST_CASE("line ends in names of inputs are escaped in messages and reports") {
  const Workspace workspace;
  workspace.prepare("mkdir old new && cp " + models +
                    "/simple_pendulum.toml old/a.toml && cp old/a.toml new");
  workspace.prepare("sed 's/^title/titel/' old/a.toml > \"$(printf 'new/a\\n::error::b.toml')\"");
  const std::string name = "a\\x0a::error::b.toml";
  for (const std::string command :
       {"elgen show new/*::*", "elgen diff old new", "elgen generate new/*::*",
        "elgen show \"$(printf 'no\\n::error::such.toml')\"",
        "elgen show \"$(printf 'no\\n::error::such.xml')\"",
        "elgen import \"$(printf 'no\\n::error::such.xml')\""}) {
    INFO(command);
    const Outcome outcome = workspace.run(command);
    CHECK(outcome.status > 0);
    CHECK_FALSE(mentions(outcome.output + outcome.errors, "\n::error"));
    CHECK_FALSE(starts_with(outcome.output + outcome.errors, "::error"));
  }
  CHECK(mentions(workspace.run("elgen show new/*::*").errors, name));
}

}  // namespace elgen::test
