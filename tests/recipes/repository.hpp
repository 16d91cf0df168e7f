// A repository of git with a model, made for one test.
#pragma once

#include "support/shell.hpp"

namespace elgen::test {

/// The cart, its scene and what is generated of them, in one commit on `main`; neither the files of
/// the user nor those of the system configure git.
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

  /// Throws where the command fails.
  void run(const std::string& command) const { prepare(environment() + command); }
  [[nodiscard]] Outcome outcome(const std::string& command) const {
    return Workspace::run(environment() + command);
  }

  /// An edit of the model on a branch of its own, with what is generated of it.
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
