// README.md on a bare Debian 12. The first screen and the commands of `Use` need the package and a
// compiler; the controller also needs the packages named in its section.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <iostream>

#include "consumer/projects.hpp"
#include "pages/page.hpp"
#include "pages/replay.hpp"

namespace elgen::test {

namespace {

class BareDebian : public Workspace {
 public:
  BareDebian() : Workspace("elgen_root_") {
    prepare(
        "mmdebstrap --quiet --variant=apt bookworm root && mkdir root/work && "
        "cp /etc/resolv.conf root/etc && chroot root apt-get update -qq");
  }

  /// Runs `command` in the folder /work of the bare Debian.
  [[nodiscard]] Outcome run_inside(const std::string& command) const {
    write("root/command", "cd /work\n" + command + "\n");
    return run("env -i PATH=/usr/bin:/usr/sbin:/bin HOME=/root chroot root sh /command");
  }

  /// Installs `packages`; prints the time in s and the size in MB. Throws runtime_error on failure.
  void install(const std::string& packages) const {
    const auto start = std::chrono::steady_clock::now();
    const long before = megabytes();
    const Outcome outcome = run_inside(
        "DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends " +
        packages);
    if (outcome.status != 0) throw std::runtime_error(outcome.errors);
    static_cast<void>(run("rm -f root/var/cache/apt/archives/*.deb"));
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    std::cout << fmt::format("bare Debian 12: {} took {:.0f} s and {} MB\n", packages,
                             seconds.count(), megabytes() - before);
  }

 private:
  [[nodiscard]] long megabytes() const { return std::stol(run("du -sm root").output); }
};

/// Runs the fences of README.md in the lines [begin, end).
void replay_in(const BareDebian& debian, std::size_t begin, std::size_t end) {
  const auto run = [&](const std::string& command) { return debian.run_inside(command); };
  for (const Fence& fence : page("README.md").fences) {
    if (fence.line < begin || fence.line >= end) continue;
    INFO("README.md:" << fence.line);
    replay(fence, debian.path() / "root/work", run);
  }
}

/// The line number of a heading in the page's text.
std::size_t line_of(const std::string& text, const std::string& heading) {
  const std::size_t at = text.find("\n" + heading + "\n");
  REQUIRE(at != std::string::npos);
  return count(text.substr(0, at + 1), "\n") + 1;
}

}  // namespace

TEST_CASE("the first page needs Debian 12, the package and g++, its controller CMake and Eigen",
          "[.all]") {
  const Workspace workspace;
  if (!is_installed("mmdebstrap on Debian 12, or a root to run it,",
                    "command -v mmdebstrap && test \"$(id -u)\" = 0 && "
                    "grep -q bookworm /etc/os-release")) {
    return;
  }
  const BareDebian debian;
  if (write_package(workspace).empty()) return;
  workspace.prepare("cp elgen.deb '" + debian.path().string() + "/root/work'");
  debian.install("./elgen.deb");
  debian.install("g++");
  const std::string text = read_text(source / "README.md");
  const std::size_t controller = line_of(text, "## Into a controller");
  replay_in(debian, 0, controller);
  replay_in(debian, line_of(text, "## Use"), line_of(text, "## Python"));
  debian.install("cmake g++ make libeigen3-dev");
  replay_in(debian, controller, line_of(text, "## Install"));
}

}  // namespace elgen::test
