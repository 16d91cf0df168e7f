// Pages are true: every command runs and prints the output shown, every file shown is read by a
// command, and every link and path exists. ELGEN_UPDATE=1 writes the pictures.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <regex>

#include "pages/page.hpp"
#include "pages/replay.hpp"
#include "support/installed.hpp"
#include "support/shell.hpp"

namespace elgen::test {

namespace {

namespace fs = std::filesystem;

/// Copies the project's files to `folder`, so that commands cannot change the originals.
void copy_project(const fs::path& folder) {
  for (const char* part :
       {"models", "generated", "include", "src", "templates", "tests", "recipes"}) {
    fs::copy(source / part, folder / part, fs::copy_options::recursive);
  }
}

/// Runs a command of a page as if the package were installed. The package is installed when a
/// command first needs it.
Outcome run_installed(const std::string& command, const fs::path& folder) {
  const std::string package = "/usr/share/elgen";
  if (!mentions(command, package) && !mentions(command, "cmake ")) return shell(command, folder);
  const std::string prefix = "'" + installed().string() + "'";
  std::string line = command;
  for (std::size_t at = line.find(package); at != std::string::npos; at = line.find(package)) {
    line.replace(at, package.size(), prefix + "/share/elgen");
  }
  return shell("export CMAKE_PREFIX_PATH=" + prefix + "\n" + line, folder);
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

void replay_page(const Page& page) {
  const Workspace workspace;
  copy_project(workspace.path());
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

/// True if a heading of the page at `path` has this anchor.
bool has_anchor(const fs::path& path, const std::string& anchor) {
  const std::vector<std::string> known = anchors(read_page("", read_text(path)).prose);
  return std::find(known.begin(), known.end(), anchor) != known.end();
}

bool leads_somewhere(const Page& page, const std::string& link) {
  if (starts_with(link, "https://")) return true;
  const std::size_t hash = std::min(link.find('#'), link.size());
  const fs::path own = source / page.path;
  const fs::path target = hash == 0 ? own : own.parent_path() / link.substr(0, hash);
  return fs::exists(target) && (hash == link.size() || has_anchor(target, link.substr(hash + 1)));
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
  for (const Page& page : pages()) replay_page(page);
}

TEST_CASE("commands are in fences, so that they are run") {
  const std::regex indented(R"((^|\n)    (\$ |elgen |\./bootstrap|cmake ))");
  for (const Page& page : pages()) {
    INFO(page.path);
    CHECK_FALSE(std::regex_search(page.prose, indented));
  }
}

TEST_CASE("every link of a page has a target") {
  for (const Page& page : pages()) {
    for (const std::string& link : links(page.prose)) {
      INFO(page.path << ": " << link);
      CHECK(leads_somewhere(page, link));
    }
  }
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
