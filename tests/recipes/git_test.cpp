// The effects of recipes/git in a real repository: differences as equations, merges without
// markers.
#include <catch2/catch.hpp>

#include "recipes/repository.hpp"

namespace elgen::test {

namespace {

constexpr const char* include = "git config --local include.path ../recipes/git/config";

/// Two edits of different lines of the model. Both edits change the same generated lines.
constexpr const char* heavier = "s/mass = \"M\"/mass = \"M + m\"/";
constexpr const char* longer = "s/l\\*sin(theta)\"/2*l*sin(theta)\"/;s/\"l\\*cos/\"2*l*cos/";

class Merging : public Repository {
 public:
  Merging() {
    branch("heavier", heavier);
    branch("longer", longer);
  }
  [[nodiscard]] Outcome merge() const { return outcome("git merge -q --no-commit heavier"); }
  [[nodiscard]] bool has_markers() const { return outcome("grep -rq '^<<<<<<<' .").status == 0; }
};

}  // namespace

TEST_CASE("git diff shows changed equations, and changed values that equations do not contain") {
  const Repository repository;
  repository.run(include);
  repository.run("sed -i 's/\"-g\"/\"g\"/;s/value = 9.81/value = 9.8/' models/cart_pole.toml");
  const Outcome outcome = repository.outcome("git diff");
  CHECK(outcome.status == 0);
  CHECK(mentions(outcome.output, "\n-  gravity[2] = -m*g*l*sin(theta)\n"));
  CHECK(mentions(outcome.output, "\n+  gravity[2] = m*g*l*sin(theta)\n"));
  CHECK(mentions(outcome.output, "\n-g = { value = 9.81, unit"));
  CHECK_FALSE(mentions(outcome.output, "vector"));
  CHECK_FALSE(mentions(outcome.output, "\n-M = "));
  CHECK(
      mentions(repository.outcome("git diff --no-textconv").output, "\n+vector = [\"0\", \"g\"]"));
  repository.run("git commit -q -a -m edited");
  CHECK(mentions(repository.outcome("git log -p -1").output, "+  gravity[2] = m*g*l*sin(theta)\n"));
}

TEST_CASE("git diff shows the text of a model with an error, and the error") {
  const Repository repository;
  repository.run(include);
  repository.run("sed -i 's/cos(theta)\"/cos(thet)\"/' models/cart_pole.toml");
  const Outcome outcome = repository.outcome("git diff");
  CHECK(outcome.status == 0);
  CHECK(mentions(outcome.output, "\n+at   = [\"x + l*sin(theta)\", \"l*cos(thet)\"]\n"));
  CHECK(mentions(outcome.errors, "error[E201]: unknown name `thet`"));
}

TEST_CASE("git diff shows the text if elgen is not installed") {
  const Repository repository;
  repository.run(include);
  repository.run("sed -i 's/\"-g\"/\"g\"/' models/cart_pole.toml");
  const Outcome outcome = repository.outcome("PATH=/usr/bin:/bin\ngit diff");
  CHECK(outcome.status == 0);
  CHECK(mentions(outcome.output, "\n+vector = [\"0\", \"g\"]"));
}

TEST_CASE("a scene without its model is shown as text, with a message") {
  const Repository repository;
  repository.run(include);
  repository.run(
      "echo '*.scene.toml diff=elgen' >> .gitattributes && "
      "sed -i 's/1\\/2/1\\/3/' models/scenes/balance.scene.toml");
  const Outcome outcome = repository.outcome("git diff models");
  CHECK(outcome.status == 0);
  CHECK(mentions(outcome.output, "fixed = { g = 9.81, l = \"1/2\" }\n"));
  CHECK(mentions(outcome.errors, "cart_pole.toml` does not exist"));
  CHECK(mentions(outcome.errors,
                 "git passes the scene without its model; `elgen diff --against REV` reads both"));
}

TEST_CASE("without the driver, generated files of two branches conflict") {
  const Merging repository;
  CHECK(repository.merge().status == 1);
  CHECK(repository.has_markers());
}

TEST_CASE(
    "with the driver generated files merge, and elgen generate updates them to the merged model") {
  const Merging repository;
  repository.run(include);
  CHECK(repository.merge().status == 0);
  CHECK_FALSE(repository.has_markers());
  const std::string& generate = Repository::generate;
  CHECK(repository.outcome(generate + " --check").status == 1);
  repository.run(generate + " && git add models generated && git commit -q --no-edit");
  CHECK(repository.outcome(generate + " --check").status == 0);
  const std::string page = repository.read("generated/cart_pole/cart_pole.hpp");
  CHECK(mentions(page, "[ M + 2*m,          2*m*l*cos(theta) ]"));
  repository.run("git checkout -q main && sed -i '" + std::string(heavier) + ";" + longer +
                 "' models/cart_pole.toml");
  CHECK(repository.outcome("git diff --exit-code longer -- models").status == 0);
  CHECK(repository.outcome("elgen diff --against longer").status == 0);
}

TEST_CASE("a model changed on both branches keeps its markers, its generated files have none") {
  const Merging repository;
  repository.run(include);
  repository.run(
      "git checkout -q heavier && sed -i 's/\"-g\"/\"g\"/' models/cart_pole.toml && "
      "git commit -q -a -m g && git checkout -q longer && "
      "sed -i 's/\"-g\"/\"-2*g\"/' models/cart_pole.toml && git commit -q -a -m 2g");
  CHECK(repository.merge().status == 1);
  CHECK(mentions(repository.read("models/cart_pole.toml"), "\n<<<<<<< "));
  CHECK(repository.outcome("grep -rq '^<<<<<<<' generated").status == 1);
  CHECK(repository.outcome("git diff --name-only --diff-filter=U").output ==
        "models/cart_pole.toml\n");
}

TEST_CASE("a generated file added on both branches is merged without markers") {
  const Repository repository;
  repository.run(include);
  for (const std::string name : {"one", "two"}) {
    repository.run("git checkout -q -b " + name +
                   " main && sed 's/\"cart_pole\"/\"cart\"/;s/\"-g\"/\"-" +
                   (name == "one" ? "g" : "2*g") + "\"/' models/cart_pole.toml > models/" + name +
                   ".toml && elgen generate -q models/" + name +
                   ".toml && git add . && git commit -q -m " + name);
  }
  CHECK(repository.outcome("git merge -q -m merged one").status == 0);
  CHECK_FALSE(mentions(repository.read("generated/cart/cart.hpp"), "<<<<<<<"));
}

TEST_CASE("an installed elgen includes its recipes") {
  const Repository repository;
  repository.run(
      "cmake --install \"$(dirname \"$ELGEN\")\" --prefix \"$PWD/home/usr\" && "
      "rm -r recipes && git config --local include.path "
      "\"$PWD/home/usr/share/elgen/recipes/git/config\" && "
      "sed -i 's/\"-g\"/\"g\"/' models/cart_pole.toml");
  const Outcome outcome =
      repository.outcome("PATH=\"$PWD/home/usr/bin:/usr/bin:/bin\"\ngit diff models");
  CHECK(mentions(outcome.output, "+  gravity[2] = m*g*l*sin(theta)\n"));
}

TEST_CASE("this project has the attributes of its recipe") {
  const std::string source = ELGEN_SOURCE_DIR;
  CHECK(read_text(source + "/.gitattributes") == read_text(source + "/recipes/git/attributes"));
}

}  // namespace elgen::test
