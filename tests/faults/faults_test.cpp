// Failures and signals at every system call: afterwards all files are old or all are new, there are
// no other files, and there is a message and a documented exit code. ELGEN_FAULTS=all visits every
// call, and every 97th allocation; the daily tests visit only some.
#include <catch2/catch.hpp>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>

#include "support/shell.hpp"

namespace elgen::test {

namespace {

using Files = std::map<std::string, std::string>;

constexpr const char* model = R"toml(format = 1
[model]
name = "rotor"
[[coordinate]]
name = "q"
unit = "rad"
[parameters]
J = { value = 2, unit = "kg*m^2" }
k = { value = 5, unit = "N*m" }
[energy]
T = "1/2*J*dot(q)^2"
V = "-k*cos(q)"
)toml";

const std::set<int> documented_codes{0, 1, 2, 3, 4, 70, 130};
constexpr int killed = 128 + SIGKILL;

/// The stride n: every n-th call of `kind` is visited; n is `usual` without ELGEN_FAULTS.
long stride(const std::string& kind, long usual) {
  if (std::getenv("ELGEN_FAULTS") == nullptr) return usual;
  return kind == "memory" ? 97 : 1;
}

/// Files and folders below `folder`, including files of the compiler.
Files contents(const std::filesystem::path& folder) {
  Files files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::string name = entry.path().lexically_relative(folder).string();
    files[name] = entry.is_regular_file() ? read_text(entry.path()) : "a folder";
  }
  return files;
}

struct Fault {
  std::string kind;
  long number = 0;
  int action = 0;  ///< an errno if positive, a signal if negative
};

/// A command, and the contents of its folder before and after a successful run.
class FaultScenario {
 public:
  FaultScenario(std::string preparation, std::string command)
      : preparation_(std::move(preparation)), command_(std::move(command)) {
    const Workspace workspace;
    prepare_in(workspace);
    before_ = contents(workspace.path());
    const Workspace counted;
    const std::string counts = (counted.path() / "counts").string();
    workspace.prepare(preload("ELGEN_FAULT_COUNTS='" + counts + "' ") + command_);
    after_ = contents(workspace.path());
    std::istringstream lines(read_text(counts));
    for (std::string kind; lines >> kind;) lines >> counts_[kind];
  }

  [[nodiscard]] long calls(const std::string& kind) const { return counts_.at(kind); }

  /// Runs the command with the fault and checks the files, the exit code and the message.
  void run_with_fault(const Fault& fault) const {
    const Workspace workspace;
    prepare_in(workspace);
    const std::string text =
        fault.kind + " " + std::to_string(fault.number) + " " + std::to_string(fault.action);
    const Outcome outcome = workspace.run(preload("ELGEN_FAULT='" + text + "' ") + command_);
    const Files found = contents(workspace.path());
    INFO(command_ << ", " << text << ": " << outcome.status << "\n" << outcome.errors);
    if (outcome.status == killed && fault.action == -SIGKILL) {
      check_killed(workspace, found);
      return;
    }
    CHECK(documented_codes.count(outcome.status) == 1);
    CHECK((found == before_ || found == after_));
    if (outcome.status == 0) CHECK(found == after_);
    if (outcome.status != 0 && outcome.status != 130) CHECK(mentions(outcome.errors, "error[E"));
  }

 private:
  /// The program may be linked with jemalloc, whose `free` and `operator new` do not fit the malloc
  /// of the preloaded library. The standard libraries are preloaded to take their place.
  static std::string preload(const std::string& variables) {
    return variables + "LD_PRELOAD='" ELGEN_PRELOAD " libstdc++.so.6 libc.so.6' ";
  }

  void prepare_in(const Workspace& workspace) const {
    workspace.write("rotor.toml", model);
    workspace.prepare("mkdir tmp && " + preparation_);
  }

  /// Checks the files after SIGKILL, which prevents any cleaning up: every file is complete, old or
  /// new, and the next run cleans up.
  void check_killed(const Workspace& workspace, const Files& found) const {
    for (const auto& [name, text] : before_) {
      CHECK(found.count(name) == 1);
      const auto fresh = after_.find(name);
      CHECK((found.at(name) == text || (fresh != after_.end() && found.at(name) == fresh->second)));
    }
    workspace.prepare(command_);
    CHECK(contents(workspace.path()) == after_);
  }

  std::string preparation_;
  std::string command_;
  Files before_;
  Files after_;
  std::map<std::string, long> counts_;
};

/// A scenario that replaces files of an older model and writes some files for the first time.
FaultScenario generation() {
  return FaultScenario(
      "sed 's/-k/-2*k/' rotor.toml > old.toml && elgen generate -q old.toml && rm old.toml"
      " && rm generated/rotor/rotor.md",
      "elgen generate -q --depfile made/rotor.d rotor.toml");
}

FaultScenario import() {
  return FaultScenario("cp " ELGEN_SOURCE_DIR
                       "/tests/urdf/robots/gripper.urdf . && echo old > gripper.toml",
                       "elgen import -q --force gripper.urdf -o gripper.toml");
}

void run_with_all_faults(const FaultScenario& scene, const std::string& kind, int action,
                         long usual) {
  for (long number = 1; number <= scene.calls(kind); number += stride(kind, usual)) {
    scene.run_with_fault({kind, number, action});
  }
}

}  // namespace

TEST_CASE("if a system call fails, files are all unchanged or all new") {
  for (const FaultScenario& scene : {generation(), import()}) {
    run_with_all_faults(scene, "open", EMFILE, 3);
    run_with_all_faults(scene, "write", ENOSPC, 1);
    run_with_all_faults(scene, "rename", EIO, 1);
    run_with_all_faults(scene, "mkdir", EDQUOT, 1);
  }
}

TEST_CASE("one failed allocation leads to an orderly exit") {
  run_with_all_faults(generation(), "memory", ENOMEM, 4999);
  run_with_all_faults(import(), "memory", ENOMEM, 4999);
}

TEST_CASE("after a signal at any call, files are all unchanged or all new") {
  const FaultScenario scene = generation();
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGKILL})
    run_with_all_faults(scene, "any", -signal, 4);
}

TEST_CASE("if the compiler or its folder cannot be started or created, no files remain") {
  const FaultScenario scene("true",
                            "TMPDIR=$PWD/tmp elgen verify -q --samples 2 rotor.toml -o c.txt");
  run_with_all_faults(scene, "mkdir", ENOSPC, 1);
  run_with_all_faults(scene, "spawn", EAGAIN, 1);
  run_with_all_faults(scene, "write", ENOSPC, 2);
  run_with_all_faults(scene, "any", -SIGTERM, 5);
}

}  // namespace elgen::test
