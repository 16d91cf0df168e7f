// The files that `generate` writes or leaves unchanged. Processes that write to the same folder
// take turns. Failures in the middle of writing are tested in tests/faults.
#include <catch2/catch.hpp>

#include "cli/cli_testing.hpp"

namespace elgen::test {

TEST_CASE("generate writes header, sidecar and page below generated/") {
  const Workspace workspace;
  CHECK(workspace.run("elgen generate -q " + models + "/cart_pole.toml").status == 0);
  CHECK(workspace.files() ==
        "./generated/cart_pole/cart_pole.equations.json\n./generated/cart_pole/cart_pole.hpp\n"
        "./generated/cart_pole/cart_pole.md\n");
  CHECK(starts_with(workspace.read("generated/cart_pole/cart_pole.hpp"), marker));
}

TEST_CASE("if one of several models is faulty, nothing is written") {
  const Workspace workspace;
  workspace.write("faulty.toml", "format = 2\n");
  const Outcome outcome = workspace.run("elgen generate " + models + "/cart_pole.toml faulty.toml");
  CHECK(outcome.status == 2);
  CHECK(workspace.files() == "./faulty.toml\n");
}

TEST_CASE("a failed write keeps the old files and leaves no temporary file") {
  const Workspace workspace;
  workspace.prepare("cp " + models + "/cart_pole.toml . && elgen generate -q cart_pole.toml");
  const std::string before = workspace.read("generated/cart_pole/cart_pole.hpp");
  workspace.prepare(
      "sed -i 's/\"-g\"/\"-2*g\"/' cart_pole.toml && "
      "rm generated/cart_pole/cart_pole.equations.json && "
      "mkdir -p generated/cart_pole/cart_pole.equations.json/occupied");
  CHECK(workspace.run("elgen generate -q --force cart_pole.toml").status == 4);
  CHECK(workspace.read("generated/cart_pole/cart_pole.hpp") == before);
  CHECK(workspace.files() ==
        "./cart_pole.toml\n./generated/cart_pole/cart_pole.hpp\n"
        "./generated/cart_pole/cart_pole.md\n");
}

TEST_CASE("a file without our marker is overwritten with --force only") {
  const Workspace workspace;
  const auto header = workspace.path() / "generated/cart_pole/cart_pole.hpp";
  write_text(header, "// mine\n");
  const std::string command = "elgen generate -q " + models + "/cart_pole.toml";
  CHECK(workspace.run(command).status == 4);
  CHECK(read_text(header) == "// mine\n");
  CHECK(workspace.files() == "./generated/cart_pole/cart_pole.hpp\n");
  CHECK(workspace.run(command + " --force").status == 0);
  CHECK(starts_with(read_text(header), marker));
}

TEST_CASE("if a dependency file cannot be written, all files stay unchanged") {
  const Workspace workspace;
  workspace.write("file", "mine\n");
  const Outcome outcome =
      workspace.run("elgen generate -q --depfile file/d " + models + "/cart_pole.toml");
  CHECK(outcome.status == 4);
  CHECK(mentions(outcome.errors, "error[E706]: `file/d` could not be written: Not a directory"));
  CHECK(workspace.files() == "./file\n");
}

TEST_CASE(
    "option --depfile replaces only rules for files of elgen, and other files only with --force") {
  const Workspace workspace;
  workspace.prepare("cp " + models + "/cart_pole.toml .");
  const auto depfile = workspace.path() / "cart_pole.d";
  const std::string command = "elgen generate -q --depfile cart_pole.d cart_pole.toml";
  REQUIRE(workspace.run(command).status == 0);
  const std::string rules = read_text(depfile);
  write_text(depfile, "generated/cart_pole/cart_pole.hpp: something.toml\n");
  CHECK(workspace.run(command + " -o elsewhere").status == 0);
  CHECK(workspace.run(command).status == 0);
  CHECK(read_text(depfile) == rules);
  write_text(depfile, "main.o: main.c\n");
  const Outcome refused = workspace.run(command);
  CHECK(refused.status == 4);
  CHECK(mentions(refused.errors,
                 "error[E703]: `cart_pole.d` exists and its rules are for other files"));
  CHECK(read_text(depfile) == "main.o: main.c\n");
  CHECK(workspace.run(command + " --force").status == 0);
  CHECK(read_text(depfile) == rules);
}

TEST_CASE("an input is never overwritten, whatever its name and even with --force") {
  const Workspace workspace;
  workspace.prepare("cp " + models + "/cart_pole.toml . && ln cart_pole.toml other.toml");
  const std::string before = workspace.read("cart_pole.toml");
  for (const std::string place : {"cart_pole.toml", "./cart_pole.toml", "other.toml"}) {
    INFO(place);
    for (const std::string& command :
         {"elgen generate -q --force cart_pole.toml --depfile " + place,
          "elgen verify -q --quick --force cart_pole.toml -o " + place,
          "elgen verify -q --quick --force -o " + place + " - < cart_pole.toml"}) {
      const Outcome outcome = workspace.run(command);
      CHECK(outcome.status == 4);
      CHECK(mentions(outcome.errors, "error[E708]: `" + place + "` is an input"));
    }
  }
  CHECK(workspace.read("cart_pole.toml") == before);
  CHECK(workspace.files() == "./cart_pole.toml\n./other.toml\n");
}

TEST_CASE("two outputs with the same path are refused") {
  const Workspace workspace;
  const Outcome outcome =
      workspace.run("elgen generate -q --depfile ./generated/cart_pole/cart_pole.hpp " + models +
                    "/cart_pole.toml");
  CHECK(outcome.status == 4);
  CHECK(mentions(outcome.errors, "cart_pole.hpp` would be written twice"));
  CHECK(workspace.files().empty());
}

TEST_CASE("only regular files are replaced") {
  const Workspace workspace;
  workspace.prepare(
      "mkdir folder && mkfifo fifo && echo mine > file && ln -s file link && ln -s nowhere loose");
  const std::string model = models + "/cart_pole.toml";
  for (const auto& [place, kind] :
       {std::pair{"folder", "a folder"}, std::pair{"fifo", "a FIFO"},
        std::pair{"link", "a symbolic link"}, std::pair{"loose", "a symbolic link"},
        std::pair{"/dev/null", "a device"}}) {
    INFO(place);
    const Outcome outcome =
        workspace.run("elgen generate -q --force " + model + " --depfile " + place);
    CHECK(outcome.status == 4);
    CHECK(mentions(outcome.errors, std::string("`") + place + "` is " + kind + ", not a file\n"));
  }
  CHECK(workspace.run("test -c /dev/null && test -p fifo && test -L link && cat file").output ==
        "mine\n");
  CHECK_FALSE(workspace.run("test -e generated").status == 0);
}

TEST_CASE("a file whose content does not change is not touched") {
  const Workspace workspace;
  workspace.prepare("cp " + models +
                    "/cart_pole.toml . && elgen generate -q cart_pole.toml && cd generated/"
                    "cart_pole && touch -d 2001-01-01 * && sed -i s/M/N/ cart_pole.md");
  const Outcome outcome = workspace.run("elgen generate cart_pole.toml");
  CHECK(outcome.status == 0);
  CHECK(mentions(outcome.errors, "unchanged generated/cart_pole/cart_pole.hpp\n"));
  CHECK(mentions(outcome.errors, "wrote generated/cart_pole/cart_pole.md\n"));
  CHECK(workspace.run("find generated -type f -newermt 2002-01-01").output ==
        "generated/cart_pole/cart_pole.md\n");
}

TEST_CASE("temporary files of a killed process are removed by the next one") {
  const Workspace workspace;
  workspace.write("generated/cart_pole/.elgen-stage-abcdef/new0", "half");
  CHECK(workspace.run("elgen generate -q " + models + "/cart_pole.toml").status == 0);
  CHECK(workspace.run("ls -A generated/cart_pole").output ==
        "cart_pole.equations.json\ncart_pole.hpp\ncart_pole.md\n");
}

TEST_CASE("waiting for a lock ends at the limit") {
  const Workspace workspace;
  workspace.prepare("mkdir -p generated/cart_pole");
  const Outcome outcome =
      workspace.run("flock generated/cart_pole elgen generate -q --limit seconds=1 " + models +
                    "/cart_pole.toml");
  CHECK(outcome.status == 4);
  CHECK(mentions(outcome.errors, "could not be written: another process keeps writing there"));
  CHECK(workspace.files().empty());
}

TEST_CASE("two concurrent writers leave one complete version and may create a folder together") {
  const Workspace workspace;
  workspace.prepare("cp " + models +
                    "/cart_pole.toml a.toml && sed 's/\"-g\"/\"-2*g\"/' a.toml > b.toml");
  for (int round = 0; round < 10; ++round) {
    CHECK(failure_of(workspace.run("rm -rf generated; elgen generate -q --force a.toml & elgen "
                                   "generate -q --force b.toml; "
                                   "b=$?; wait $! && test $b = 0 && { elgen generate -q --check "
                                   "a.toml || elgen generate -q "
                                   "--check b.toml; }")) == "");
  }
}

}  // namespace elgen::test
