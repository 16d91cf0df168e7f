// A git repository with a model, created for one test.
#pragma once

#include "support/shell.hpp"

namespace elgen::test {

/// The cart-pole model, its scene and the generated files in one commit on `main`. The user's and
/// the system's git configuration are ignored.
class Repository : public Workspace {
 public:
  Repository() {
    prepare("mkdir -p models/scenes home && cp " + source + "/models/cart_pole.toml models && cp " +
            source + "/models/scenes/balance.scene.toml models/scenes && cp -r " + source +
            "/recipes . && cp recipes/git/attributes .gitattributes && echo home > .gitignore");
    write("home/.gitconfig",
          "[user]\nname = a\nemail = a@b\n[init]\ndefaultBranch = main\n"
          "[advice]\ndetachedHead = false\n");
    run("git init -q && " + generate + " && git add . && git commit -q -m first");
  }

  /// Runs a command; throws if it fails.
  void run(const std::string& command) const { prepare(environment() + command); }
  [[nodiscard]] Outcome outcome(const std::string& command) const {
    return Workspace::run(environment() + command);
  }

  /// Creates a branch with an edit of the model and the regenerated files.
  void branch(const std::string& name, const std::string& edit) const {
    run("git checkout -q -b " + name + " main && sed -i '" + edit + "' models/cart_pole.toml && " +
        generate + " && git commit -q -a -m " + name);
  }

  inline static const std::string generate = "elgen generate -q models/*.toml models/scenes/*.toml";

 private:
  [[nodiscard]] std::string environment() const {
    return "export HOME='" + (path() / "home").string() +
           "' GIT_CONFIG_NOSYSTEM=1\nunset GIT_DIR GIT_CONFIG_GLOBAL\n";
  }

  inline static const std::string source = ELGEN_SOURCE_DIR;
};

}  // namespace elgen::test
