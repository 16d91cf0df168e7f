// Which files a command reads: models, scenes with their model, and paths that are neither.
#include <catch2/catch.hpp>

#include "cli/cli_testing.hpp"

namespace elgen::test {

TEST_CASE("a scene finds its model relative to itself, not to the working folder") {
  const Workspace workspace;
  prepare("mkdir -p project/scenes elsewhere && cp " + models + "/cart_pole.toml project && cp " +
              models + "/scenes/balance.scene.toml project/scenes",
          workspace.path());
  CHECK(shell("cd elsewhere && elgen generate -q ../project/scenes/balance.scene.toml",
              workspace.path())
            .status == 0);
  CHECK(shell("ls elsewhere/generated", workspace.path()).output == "cart_pole_balance\n");
}

TEST_CASE("every input is read, and the worst exit code counts") {
  const Workspace workspace;
  prepare("mkdir folder.toml", workspace.path());
  const std::string good = models + "/cart_pole.toml";
  CHECK(shell("elgen generate -q " + good + " nowhere.toml", workspace.path()).status == 2);
  CHECK(shell("elgen generate -q nowhere.toml folder.toml", workspace.path()).status == 4);
  const Outcome both = shell("elgen generate -q nowhere.toml folder.toml", workspace.path());
  CHECK(mentions(both.errors, "`nowhere.toml`"));
  CHECK(mentions(both.errors, "`folder.toml`"));
}

TEST_CASE("a path with spaces and quotes is a path") {
  const Workspace workspace;
  prepare("mkdir \"it's mine\" && cp " + models + "/cart_pole.toml \"it's mine\"",
          workspace.path());
  CHECK(shell("elgen generate -q -o \"out 1\" \"it's mine/cart_pole.toml\"", workspace.path())
            .status == 0);
  CHECK(shell("ls 'out 1'", workspace.path()).output == "cart_pole\n");
}

TEST_CASE("`-` is standard input, for models, scenes and robots") {
  const Workspace workspace;
  prepare("cp " + models + "/cart_pole.toml . && cp " + models +
              "/scenes/balance.scene.toml . && "
              "sed -i 's:[.][.]/::' balance.scene.toml",
          workspace.path());
  CHECK(shell("elgen show - < cart_pole.toml", workspace.path()).output ==
        shell("elgen show cart_pole.toml", workspace.path()).output);
  CHECK(shell("cat balance.scene.toml | elgen show -", workspace.path()).output ==
        shell("elgen show balance.scene.toml", workspace.path()).output);
  CHECK(shell("elgen import - < " ELGEN_SOURCE_DIR "/tests/urdf/robots/gripper.urdf",
              workspace.path())
            .status == 0);
  CHECK(shell("elgen generate -q --depfile d - < cart_pole.toml", workspace.path()).status == 0);
  CHECK(starts_with(read_text(workspace.path() / "d"),
                    "generated/cart_pole/cart_pole.equations.json:\n"));
  const Outcome faulty = shell("echo 'format = 2' | elgen show -", workspace.path());
  CHECK(starts_with(faulty.errors, "<stdin>:1:10: error[E102]"));
  const Outcome twice = shell("elgen generate - - < cart_pole.toml", workspace.path());
  CHECK(twice.status == 4);
  CHECK(mentions(twice.errors, "error[E707]: `<stdin>` can be read only once"));
}

TEST_CASE("a FIFO is read as far as the limit, and waited for as long as the limit") {
  const Workspace workspace;
  prepare("mkfifo pipe.toml silent.toml", workspace.path());
  const Outcome read = shell("cat " + models + "/cart_pole.toml > pipe.toml & elgen show pipe.toml",
                             workspace.path());
  CHECK(read.status == 0);
  CHECK(read.output == shell("elgen show " + models + "/cart_pole.toml", workspace.path()).output);
  const Outcome endless = shell("yes > pipe.toml & elgen show pipe.toml", workspace.path());
  CHECK(endless.status == 2);
  CHECK(mentions(endless.errors, "error[E901]: `pipe.toml` has more than 1048576 bytes"));
  for (const std::string command :
       {"elgen show silent.toml --limit seconds=1", "sleep 9 | elgen show - --limit seconds=1"}) {
    const Outcome late = shell(command, workspace.path());
    CHECK(late.status == 3);
    CHECK(mentions(late.errors, "could not be read within 1 s\n"));
  }
}

TEST_CASE("folders and devices are no inputs, not even of a scene") {
  const Workspace workspace;
  prepare("mkdir folder.toml && ln -s /dev/zero zero.toml", workspace.path());
  for (const std::string& path : {std::string("zero.toml"), std::string("folder.toml")}) {
    INFO(path);
    write_text(workspace.path() / "a.scene.toml",
               "format = 1\nmodel = \"" + path + "\"\nname = \"a\"\n");
    for (const std::string& input : {path, std::string("a.scene.toml")}) {
      const Outcome outcome = shell("elgen show " + input, workspace.path());
      CHECK(outcome.status == 4);
      CHECK(mentions(outcome.errors, "error[E707]: `" + path + "` is a "));
    }
    CHECK(shell("elgen import " + path, workspace.path()).status == 4);
  }
}

TEST_CASE("line ends in names of inputs reach no message and no report") {
  const Workspace workspace;
  prepare("mkdir old new && cp " + models + "/simple_pendulum.toml old/a.toml && cp old/a.toml new",
          workspace.path());
  prepare("sed 's/^title/titel/' old/a.toml > \"$(printf 'new/a\\n::error::b.toml')\"",
          workspace.path());
  const std::string name = "a\\x0a::error::b.toml";
  for (const std::string command :
       {"elgen show new/*::*", "elgen diff old new", "elgen generate new/*::*",
        "elgen show \"$(printf 'no\\n::error::such.toml')\"",
        "elgen show \"$(printf 'no\\n::error::such.xml')\"",
        "elgen import \"$(printf 'no\\n::error::such.xml')\""}) {
    INFO(command);
    const Outcome outcome = shell(command, workspace.path());
    CHECK(outcome.status > 0);
    CHECK_FALSE(mentions(outcome.output + outcome.errors, "\n::error"));
    CHECK_FALSE(starts_with(outcome.output + outcome.errors, "::error"));
  }
  CHECK(mentions(shell("elgen show new/*::*", workspace.path()).errors, name));
}

}  // namespace elgen::test
