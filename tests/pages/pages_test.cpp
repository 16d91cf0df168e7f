// Pages are true: every command runs with nothing but the installed package and prints the output
// shown, every file shown is read by a command, and every link and path exists. ELGEN_UPDATE=1
// writes the pictures.
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <regex>

#include "pages/page.hpp"
#include "pages/replay.hpp"
#include "support/installed.hpp"
#include "support/shell.hpp"

namespace elgen::test {

namespace {

namespace fs = std::filesystem;

/// The pages have about a hundred such fences; a reader that finds fewer overlooks some.
constexpr std::size_t fewest_replayed = 90;

/// Runs a command of a page as a user of the installed package.
Outcome run_installed(const std::string& command, const fs::path& folder) {
  const std::string prefix = "'" + installed().string() + "'";
  return shell("export CMAKE_PREFIX_PATH=" + prefix + "\nPATH=" + prefix + "/bin:$PATH\n" +
                   replaced_all(command, "/usr/share/elgen", prefix + "/share/elgen"),
               folder);
}

/// True if a later command reads the file. `cmake -S FOLDER` reads the CMakeLists.txt of a folder.
bool is_read(const Page& page, const Fence& file) {
  const fs::path path = file.file;
  const std::string name = path.filename() == "CMakeLists.txt" && path.has_parent_path()
                               ? "cmake -S " + path.parent_path().string()
                               : file.file;
  return std::any_of(page.fences.begin(), page.fences.end(), [&](const Fence& fence) {
    const bool runs = fence.kind == FenceKind::commands || fence.kind == FenceKind::console;
    return runs && fence.line > file.line && mentions(fence.text, name);
  });
}

bool is_replayed(const Fence& fence) {
  return fence.kind != FenceKind::not_run && fence.kind != FenceKind::picture;
}

/// Compares the pictures of a page with the files of the same names that its commands wrote.
void check_pictures(const Page& page, const fs::path& folder) {
  for (const std::string& link : links(page.prose)) {
    const fs::path picture = source / fs::path(page.path).parent_path() / link;
    if (picture.extension() != ".svg") continue;
    INFO(page.path << ": " << link);
    const std::string drawn = read_text(folder / picture.filename());
    if (std::getenv("ELGEN_UPDATE") != nullptr) write_text(picture, drawn);
    const bool is_current = read_text(picture) == drawn;
    CHECK(is_current);
  }
}

/// Replays the fences of a page in an empty folder.
void replay_page(const Page& page) {
  const Workspace workspace;
  const auto run = [&](const std::string& command) {
    return run_installed(command, workspace.path());
  };
  for (const Fence& fence : page.fences) {
    INFO(page.path << ":" << fence.line << ": " << fence.info);
    CHECK(fence.kind != FenceKind::unknown);
    replay(fence, workspace.path(), run);
    if (fence.kind == FenceKind::file) CHECK(is_read(page, fence));
  }
  check_pictures(page, workspace.path());
}

/// True for a page that is not installed: only a clone has the files that it explains.
bool is_only_in_clone(const Page& page) {
  return starts_with(page.path, "tests/") || starts_with(page.path, "generated/");
}

/// True if a heading of the page at `path` has this anchor.
bool has_anchor(const fs::path& path, const std::string& anchor) {
  const std::vector<std::string> known = anchors(read_page("", read_text(path)).prose);
  return std::find(known.begin(), known.end(), anchor) != known.end();
}

/// True if the link of a page, whose path is relative to `root`, has a target.
bool leads_somewhere(const fs::path& root, const Page& page, const std::string& link) {
  if (starts_with(link, "https://")) return true;
  const std::size_t hash = std::min(link.find('#'), link.size());
  const fs::path own = root / page.path;
  const fs::path target = hash == 0 ? own : own.parent_path() / link.substr(0, hash);
  return fs::exists(target) && (hash == link.size() || has_anchor(target, link.substr(hash + 1)));
}

void check_links(const fs::path& root, const Page& page) {
  for (const std::string& link : links(page.prose)) {
    INFO(page.path << ": " << link);
    CHECK(leads_somewhere(root, page, link));
  }
}

/// True for a path such as "src/check/", false for a path with a placeholder: "models/NAME.toml".
bool is_path(const std::string& code) {
  static const std::regex path(
      R"((src|include|tests|models|templates|recipes|examples|packaging|cmake|\.ci)/[\w./-]*)");
  static const std::regex placeholder(R"(.*\b(NAME|CODE_\w+|ID)\b.*)");
  return std::regex_match(code, path) && !std::regex_match(code, placeholder);
}

}  // namespace

TEST_CASE("every command of a page prints the output that the page shows") {
  std::size_t replayed = 0;
  std::size_t fences = 0;
  for (const Page& page : pages()) {
    replay_page(page);
    fences += page.fences.size();
    replayed += static_cast<std::size_t>(
        std::count_if(page.fences.begin(), page.fences.end(), is_replayed));
  }
  std::cout << fmt::format("replayed: {} of {} blocks of {} pages, with the package alone\n",
                           replayed, fences, pages().size());
  CHECK(replayed >= fewest_replayed);
}

TEST_CASE("commands are in fences, so that they are run") {
  const std::regex indented(R"((^|\n)    (\$ |elgen |\./bootstrap|cmake ))");
  for (const Page& page : pages()) {
    INFO(page.path);
    CHECK_FALSE(std::regex_search(page.prose, indented));
  }
}

TEST_CASE("every link of a page has a target") {
  for (const Page& page : pages()) check_links(source, page);
}

TEST_CASE("every page is installed, and its links have targets there") {
  const fs::path folder = installed() / "share/doc/elgen";
  for (const Page& page : pages()) {
    if (is_only_in_clone(page)) continue;
    const Page there = read_page(page.path, read_text(folder / page.path));
    CHECK(there.fences.size() == page.fences.size());
    check_links(folder, there);
  }
  check_links(folder, read_page("CHANGELOG.md", read_text(folder / "CHANGELOG.md")));
  const std::string first = fs::canonical(folder / "README.md").string();
  CHECK(mentions(run_installed("elgen help", "/").output, "\nPages to read: " + first + "\n"));
  CHECK(mentions(run_installed("elgen", "/").output, "\nPages to read: " + first + "\n"));
  CHECK_FALSE(mentions(run_installed("elgen help show", "/").output, first));
}

TEST_CASE("installed scripts can be run") {
  std::size_t scripts = 0;
  for (const auto& entry : fs::recursive_directory_iterator(installed() / "share/elgen")) {
    if (!entry.is_regular_file() || !starts_with(read_text(entry.path()), "#!")) continue;
    INFO(entry.path());
    ++scripts;
    CHECK((entry.status().permissions() & fs::perms::others_exec) != fs::perms::none);
  }
  CHECK(scripts >= 3);
}

TEST_CASE("every path that a page names exists") {
  for (const Page& page : pages()) {
    for (const std::string& code : code_spans(page.prose)) {
      if (!is_path(code)) continue;
      INFO(page.path << ": " << code);
      CHECK(fs::exists(source / code));
    }
  }
}

}  // namespace elgen::test
