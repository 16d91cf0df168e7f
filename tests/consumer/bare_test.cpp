// SPDX-License-Identifier: GPL-3.0-or-later
// README.md on a machine that has nothing but Debian 12, the package and a compiler: the first
// screen, then, with what its section names, the controller.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <iostream>
#include <sstream>

#include "consumer/projects.hpp"
#include "pages/page.hpp"

namespace elgen::test {

namespace {

class BareDebian : public Workspace {
 public:
  BareDebian() : Workspace("elgen_root_") {
    prepare(
        "mmdebstrap --quiet --variant=apt bookworm root && mkdir root/work && "
        "cp /etc/resolv.conf root/etc && chroot root apt-get update -qq");
  }

  /// Runs a command in the folder /work of the root.
  [[nodiscard]] Outcome inside(const std::string& command) const {
    write("root/command", "cd /work\n" + command + "\n");
    return run("env -i PATH=/usr/bin:/usr/sbin:/bin HOME=/root chroot root sh /command");
  }

  /// Throws where it fails; prints what it took.
  void install(const std::string& packages) const {
    const auto start = std::chrono::steady_clock::now();
    const long before = megabytes();
    const Outcome outcome =
        inside("DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends " +
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

/// The commands of the fences between two lines of a page, in the root.
void replay(const BareDebian& debian, const Page& page, std::size_t begin, std::size_t end) {
  for (const Fence& fence : page.fences) {
    if (fence.line < begin || fence.line >= end) continue;
    INFO(page.path << ":" << fence.line);
    if (fence.kind == FenceKind::file) debian.write("root/work/" + fence.file, fence.text);
    if (fence.kind == FenceKind::commands)
      CHECK(debian.inside("set -e\n" + fence.text).status == 0);
    if (fence.kind != FenceKind::console) continue;
    for (const Exchange& exchange : exchanges(fence.text)) {
      const Outcome outcome = debian.inside("{ " + exchange.command + "\n} 2>&1");
      INFO("$ " << exchange.command << "\n" << outcome.output);
      CHECK(agrees(exchange.output, outcome.output));
    }
  }
}

/// The line of the page's file that begins so.
std::size_t line_of(const std::string& text, const std::string& heading) {
  const std::size_t at = text.find("\n" + heading + "\n");
  REQUIRE(at != std::string::npos);
  return count(text.substr(0, at + 1), "\n") + 1;
}

}  // namespace

TEST_CASE("the first page needs Debian 12, the package and g++, then CMake and Eigen", "[.all]") {
  const Workspace workspace;
  if (!is_there(
          "command -v mmdebstrap && test \"$(id -u)\" = 0 && grep -q bookworm /etc/os-release",
          "mmdebstrap, or Debian 12, or a root's right to change root,")) {
    return;
  }
  const BareDebian debian;
  if (packed(workspace).empty()) return;
  workspace.prepare("cp elgen.deb '" + debian.path().string() + "/root/work'");
  debian.install("./elgen.deb");
  debian.install("g++");
  const std::string text = read_text(source / "README.md");
  const std::size_t controller = line_of(text, "## Into a controller");
  replay(debian, page("README.md"), 0, controller);
  debian.install("cmake g++ make libeigen3-dev");
  replay(debian, page("README.md"), controller, line_of(text, "## Install"));
}

}  // namespace elgen::test
