// elgen diff: inputs, exit codes and refusals.
#include <catch2/catch.hpp>

#include "cli/cli_testing.hpp"

namespace elgen::test {
namespace {

/// Folder `old` with the cart, its scene and a pendulum, and a copy `new` with the cart's gravity
/// reversed.
class TwoFolders : public Workspace {
 public:
  TwoFolders() {
    prepare("mkdir -p old/scenes && cp " + models + "/cart_pole.toml " + models +
            "/simple_pendulum.toml old && cp " + models +
            "/scenes/balance.scene.toml old/scenes "
            "&& cp -r old new && sed -i 's/\"-g\"/\"g\"/' new/cart_pole.toml");
  }
  [[nodiscard]] Outcome diff(const std::string& words) const { return run("elgen diff " + words); }
};

/// Two versions of the cart; gravity is reversed in the second.
class TwoCarts : public Workspace {
 public:
  TwoCarts() {
    prepare("mkdir old new && cp " + models +
            "/cart_pole.toml old && sed 's/\"-g\"/\"g\"/' old/cart_pole.toml > "
            "new/cart_pole.toml");
  }
  [[nodiscard]] Outcome diff(const std::string& words) const { return run("elgen diff " + words); }
};

}  // namespace

TEST_CASE("two files are compared, a difference exits with 1") {
  const TwoFolders folders;
  const Outcome outcome = folders.diff("old/cart_pole.toml new/cart_pole.toml");
  CHECK(outcome.status == 1);
  CHECK(starts_with(outcome.output,
                    "changed      new/cart_pole.toml:56:17  [gravity] vector[2]: -g -> g\n"));
  CHECK(outcome.errors.empty());
  CHECK(folders.diff("old/cart_pole.toml old/cart_pole.toml").status == 0);
}

TEST_CASE("a scene is compared together with its model") {
  const TwoFolders folders;
  const Outcome outcome =
      folders.diff("old/scenes/balance.scene.toml new/scenes/balance.scene.toml");
  CHECK(outcome.status == 1);
  CHECK(mentions(outcome.output, "new/cart_pole.toml:56:17"));
}

TEST_CASE("files of folders match by their paths") {
  const TwoFolders folders;
  const Outcome outcome = folders.diff("old new");
  CHECK(mentions(outcome.output, "follows      cart_pole: 14 of 74 entries differ"));
  CHECK(mentions(outcome.output, "             cart_pole_balance: 3 of "));
  CHECK_FALSE(mentions(outcome.output, "simple_pendulum"));
}

TEST_CASE("a removed model breaks, a moved model does not") {
  const TwoFolders folders;
  folders.prepare(
      "cp old/cart_pole.toml new && mv new/simple_pendulum.toml new/scenes/pendulum.toml");
  const Outcome same = folders.diff("old new");
  CHECK(same.status == 0);
  CHECK(same.output == "equal        the equations are the same\n");
  folders.prepare("sed -i 's/value = 9.81/value = 9.8/' new/scenes/pendulum.toml");
  const Outcome moved = folders.diff("old new --allow values");
  CHECK(moved.status == 0);
  CHECK(mentions(moved.output, "new/scenes/pendulum.toml:"));
  CHECK_FALSE(mentions(moved.output, "removed"));
  folders.prepare("sed -i 's/\"simple_pendulum\"/\"pendulum\"/' new/scenes/pendulum.toml");
  const Outcome gone = folders.diff("old new --allow different");
  CHECK(gone.status == 1);
  CHECK(mentions(gone.output, "added        new/scenes/pendulum.toml\n"));
  CHECK(mentions(gone.output, "removed      simple_pendulum.toml\n"));
  CHECK(mentions(gone.output, "breaks       calling code breaks\n"));
}

TEST_CASE("a file of a revision that was moved or removed is reported if named") {
  const TwoFolders folders;
  folders.prepare(
      "git init -q && git add old && git -c user.name=a -c user.email=a@b commit -q -m first && "
      "git mv old/simple_pendulum.toml old/pendulum.toml");
  CHECK(folders.diff("--against HEAD old").status == 0);
  CHECK(folders.diff("--against HEAD old/simple_pendulum.toml old/pendulum.toml").status == 0);
  const Outcome gone = folders.diff("--against HEAD --allow different old/simple_pendulum.toml");
  CHECK(gone.status == 1);
  CHECK(starts_with(gone.output, "removed      old/simple_pendulum.toml\n"));
  CHECK(folders.diff("--against HEAD nothing.toml").status == 2);
}

TEST_CASE("option --allow sets the differences that exit with 0") {
  const TwoFolders folders;
  const std::string pair = "old/cart_pole.toml new/cart_pole.toml ";
  CHECK(folders.diff(pair + "--allow extended").status == 1);
  CHECK(folders.diff(pair + "--allow different").status == 0);
  CHECK(folders.diff(pair + "--allow breaks").status == 0);
  CHECK(folders.diff(pair + "--allow all").status == 2);
}

TEST_CASE("a revision of git is compared with the working tree") {
  const TwoFolders folders;
  folders.prepare(
      "mv old/* . && rmdir old && rm -r new && git init -q && git add . && "
      "git -c user.name=a -c user.email=a@b commit -q -m first && "
      "sed -i 's/\"-g\"/\"g\"/' cart_pole.toml");
  const Outcome outcome = folders.diff("--against HEAD");
  CHECK(outcome.status == 1);
  CHECK(mentions(outcome.output, "cart_pole.toml:56:17  [gravity] vector[2]: -g -> g\n"));
  CHECK(folders.diff("--against HEAD simple_pendulum.toml").status == 0);
  const Outcome inside = folders.run("cd scenes && elgen diff --against HEAD balance.scene.toml");
  CHECK(mentions(inside.output, "[gravity] vector[2]"));
  const Outcome unknown = folders.diff("--against nothing");
  CHECK(unknown.status == 4);
  CHECK(mentions(unknown.errors, "error[E713]: `nothing` is no revision"));
}

TEST_CASE("a model with errors in one version is reported as unreadable") {
  const TwoFolders folders;
  folders.prepare("sed -i 's/cos(theta)/cos(thet)/' new/cart_pole.toml");
  const Outcome outcome = folders.diff("old new");
  CHECK(outcome.status == 2);
  CHECK(starts_with(outcome.output, "unreadable   new/cart_pole.toml: E201: unknown name `thet`"));
  CHECK_FALSE(mentions(outcome.output, "equal  "));
  CHECK(mentions(outcome.errors, "new/cart_pole.toml:51:36: error[E201]: unknown name `thet`"));
}

TEST_CASE("an unreadable model does not stop the report of the others, in every format") {
  const TwoFolders folders;
  folders.prepare("echo x >> new/simple_pendulum.toml");
  const Outcome text = folders.diff("old new");
  CHECK(text.status == 2);
  CHECK(starts_with(text.output, "unreadable   new/simple_pendulum.toml: E101: "));
  CHECK(mentions(text.output, "follows      cart_pole: 14 of 74 entries differ"));
  CHECK(mentions(text.errors, "error[E101]"));
  const Outcome markdown = folders.diff("--format markdown --allow breaks old new");
  CHECK(markdown.status == 2);
  CHECK(starts_with(markdown.output, "### elgen diff: different (of the readable systems: "));
  CHECK(mentions(markdown.output, "<details><summary>Entries of cart_pole</summary>"));
  const Outcome json = folders.diff("--format json old new");
  CHECK(json.status == 2);
  CHECK(mentions(json.output, "\"impact\": \"different\""));
  CHECK(mentions(json.output, "\"path\": \"new/simple_pendulum.toml\""));
}

TEST_CASE("equal roots in another form are equal, except with --strict") {
  const Workspace workspace;
  workspace.write("a.toml",
                  "format = 1\n[model]\nname = \"pushed\"\n[[coordinate]]\nname = \"x\"\n"
                  "[energy]\nT = \"1/2*dot(x)^2\"\n"
                  "[[force]]\non = \"x\"\nvalue = \"abs(x)^3\"\n");
  workspace.prepare("sed 's/abs(x)^3/x^2*abs(x)/' a.toml > b.toml");
  CHECK(workspace.run("elgen diff a.toml b.toml").status == 0);
  CHECK(workspace.run("elgen diff --strict a.toml b.toml").status == 1);
}

TEST_CASE("an unreadable model is an error in every mode, not a removed model") {
  const std::string merge = "1i <<<<<<< HEAD";
  const std::string misnamed = "s/^.model./[modell]/";
  const std::string empty = "d";
  for (const std::string& edit : {merge, misnamed, empty}) {
    INFO(edit);
    const TwoFolders folders;
    folders.prepare("sed -i '" + edit + "' new/simple_pendulum.toml");
    for (const std::string words :
         {"old new", "--format github old new", "old/simple_pendulum.toml new/simple_pendulum.toml",
          "new/simple_pendulum.toml new/simple_pendulum.toml", "new old"}) {
      INFO(words);
      const Outcome outcome = folders.diff(words);
      CHECK(outcome.status == 2);
      CHECK_FALSE(mentions(outcome.output, "removed"));
      CHECK(mentions(outcome.output + outcome.errors, "new/simple_pendulum.toml"));
    }
    folders.prepare(
        "cp old/*.toml . && git init -q && git add *.toml && "
        "git -c user.name=a -c user.email=a@b commit -q -m first && "
        "cp new/simple_pendulum.toml .");
    CHECK(folders.diff("--against HEAD").status == 2);
    CHECK(folders.diff("--against HEAD simple_pendulum.toml").status == 2);
  }
}

TEST_CASE("a model that is unreadable in both versions is an error, changed or not") {
  const std::string merge = "1i <<<<<<< HEAD";
  const std::string misnamed = "s/^.model./[modell]/";
  const std::string unknown = "s/^.parameters./&\\nZ = \"2*zeta\"/";
  const std::string massless = "/^mass/d";
  for (const std::string& edit : {merge, misnamed, unknown, massless}) {
    INFO(edit);
    const TwoFolders folders;
    folders.prepare("sed -i '" + edit + "' old/simple_pendulum.toml && cp old/*.toml new");
    const auto expect_error = [&folders](const std::string& words) {
      INFO(words);
      const Outcome outcome = folders.diff(words);
      CHECK(outcome.status == 2);
      CHECK(mentions(outcome.output + outcome.errors, "simple_pendulum.toml:"));
    };
    expect_error("old new");
    expect_error("old/simple_pendulum.toml new/simple_pendulum.toml");
    folders.prepare("echo '# more' >> new/simple_pendulum.toml");
    expect_error("old new");
    folders.prepare("rm old/simple_pendulum.toml");
    expect_error("old new");
    folders.prepare(
        "git init -q && git add new && git -c user.name=a -c user.email=a@b commit -q -m first");
    expect_error("--against HEAD");
    expect_error("--against HEAD new");
    folders.prepare("echo '# and more' >> new/simple_pendulum.toml");
    expect_error("--against HEAD");
  }
}

TEST_CASE("annotations report differences and unreadable models") {
  const TwoFolders folders;
  folders.prepare(
      "sed -i 's/^name *= \"u\"/name = \"F\"/' new/cart_pole.toml && echo x >> "
      "new/simple_pendulum.toml");
  const Outcome outcome = folders.diff("--format github old new");
  CHECK(outcome.status == 2);
  CHECK(outcome.errors.empty());
  CHECK(count(outcome.output, "::error ") == 3);
  CHECK(mentions(outcome.output, "title=elgen diff%3A breaks::cart_pole: "));
  CHECK(mentions(outcome.output, "title=elgen diff%3A breaks::cart_pole_balance: "));
  CHECK(
      mentions(outcome.output, "title=elgen diff%3A unreadable::new/simple_pendulum.toml: E101: "));
}

TEST_CASE("dangling links and long paths are no internal errors") {
  const TwoFolders folders;
  folders.prepare(
      "ln -s nothing old/dangling.toml && ln -s round new/round && ln -s loop.toml new/loop.toml "
      "&& mkdir -p out && ln -s round out/round");
  CHECK(folders.diff("old new").status == 1);
  const std::string name(300, 'a');
  CHECK(folders.diff("old/cart_pole.toml " + name).status == 4);
  CHECK(folders.diff("old " + name).status == 4);
  CHECK(folders.run("elgen generate --check -o out new/cart_pole.toml").status == 1);
  folders.prepare("ln -s circle circle");
  const Outcome circle = folders.run("elgen generate -o circle new/cart_pole.toml");
  CHECK(circle.status == 4);
  CHECK(mentions(circle.errors, "cannot be reached: Too many levels of symbolic links"));
}

TEST_CASE("a rename is OLD=NEW, and two inputs are compared") {
  const TwoFolders folders;
  CHECK(folders.diff("--rename l=len old/cart_pole.toml new/cart_pole.toml").status == 1);
  const Outcome rename = folders.diff("--rename l old/cart_pole.toml old/cart_pole.toml");
  CHECK(rename.status == 2);
  CHECK(mentions(rename.errors, "`l` is no rename"));
  const Outcome one = folders.diff("old/cart_pole.toml");
  CHECK(one.status == 2);
  CHECK(mentions(one.errors, "`diff` compares two, not 1"));
}

TEST_CASE("with --format json results and errors are JSON") {
  const TwoFolders folders;
  const Outcome outcome = folders.diff("old new --format json");
  CHECK(starts_with(outcome.output, "{\n  \"format\": \"elgen diff 1\",\n"));
  CHECK(starts_with(folders.diff("old nowhere.toml --format json").errors, "{"));
}

TEST_CASE("a report has the format of messages, unless diff has its own --format") {
  const TwoFolders folders;
  const std::string pair = " old/cart_pole.toml new/cart_pole.toml";
  const auto output = [&](const std::string& words) {
    return folders.run("elgen " + words + pair).output;
  };
  CHECK(starts_with(output("--format json diff"), "{"));
  CHECK(output("--format json diff") == output("diff --format json"));
  CHECK(starts_with(output("--format github diff"), "::warning file=new/cart_pole.toml,"));
  CHECK(starts_with(output("diff --format markdown"), "### elgen diff: different"));
}

TEST_CASE("option --only hides other outputs, but they count for the verdict") {
  const TwoFolders folders;
  const Outcome mass = folders.diff("--only mass_matrix old/cart_pole.toml new/cart_pole.toml");
  CHECK(mentions(mass.output, "follows      0 of 4 entries differ, 0 rewritten\n"));
  CHECK(mentions(mass.output, "different    the equations differ\n"));
  const Outcome two = folders.diff("--only gravity,bias old/cart_pole.toml new/cart_pole.toml");
  CHECK(mentions(two.output, "follows      2 of 4 entries differ, 0 rewritten\n"));
  const Outcome unknown = folders.diff("--only biass old/cart_pole.toml new/cart_pole.toml");
  CHECK(unknown.status == 2);
  CHECK(mentions(unknown.errors, "no version has an output `biass`"));
}

TEST_CASE("other TOML files, hidden folders and equal files are skipped") {
  const Workspace workspace;
  workspace.prepare(
      "mkdir -p old/.cache && cp " + models +
      "/simple_pendulum.toml old && "
      "cp old/simple_pendulum.toml old/.cache && echo '[tool]' > old/pyproject.toml && "
      "cp -r old new && echo 'x = 1' >> new/pyproject.toml && rm -r new/.cache");
  const Outcome outcome = workspace.run("elgen diff old new");
  CHECK(outcome.status == 0);
  CHECK(outcome.output == "equal        the equations are the same\n");
}

TEST_CASE("a folder is not compared with a file") {
  const Outcome outcome = run("elgen diff " + models + " " + models + "/simple_pendulum.toml");
  CHECK(outcome.status == 4);
  CHECK(mentions(outcome.errors, "is a folder"));
}

TEST_CASE("steps are compared in their emitted form") {
  const Workspace workspace;
  workspace.prepare("cp -r " + models +
                    " old && cp -r old new && "
                    "sed -i 's/\"-g\"/\"g\"/' new/cart_pole.toml");
  const std::string scene = "scenes/cart_pole_prediction.scene.toml";
  const Outcome outcome = workspace.run("elgen diff --list old/" + scene + " new/" + scene);
  CHECK(mentions(outcome.output, "step.rates[2] "));
}

TEST_CASE("a model may come from standard input") {
  const TwoCarts carts;
  CHECK(carts.diff("- new/cart_pole.toml < old/cart_pole.toml").status == 1);
  CHECK(carts.diff("- - < old/cart_pole.toml").status == 4);
}

TEST_CASE("operations of emitted code are reported, but not counted for large systems") {
  const TwoCarts carts;
  carts.prepare("sed 's/l\\*sin(theta)/2*l*sin(theta)/' old/cart_pole.toml > new/cart_pole.toml");
  CHECK(mentions(carts.diff("old/cart_pole.toml new/cart_pole.toml").output, "\noperations   "));
  carts.prepare("cp " + models +
                "/panda7.toml old && sed 's/value = 9.81/value = 9.8/' old/panda7.toml > "
                "new/panda7.toml");
  CHECK_FALSE(mentions(carts.diff("old/panda7.toml new/panda7.toml").output, "operations"));
}

}  // namespace elgen::test
