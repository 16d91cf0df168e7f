// What --check reports: missing, stale, edited by hand, orphaned.
#include <fmt/format.h>

#include <dtl/dtl.hpp>
#include <filesystem>
#include <set>
#include <sstream>

#include "cli/files/output_files.hpp"

namespace elgen::cli {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t diff_lines = 20;  // of each file; the rest is counted

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> result;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) result.push_back(line);
  return result;
}

/// A unified diff of at most `diff_lines` lines.
std::string unified_diff(const std::string& before, const std::string& after) {
  dtl::Diff<std::string> diff(lines(before), lines(after));
  diff.onHuge();
  diff.compose();
  diff.composeUnifiedHunks();
  std::ostringstream text;
  diff.printUnifiedFormat(text);
  const std::vector<std::string> all = lines(text.str());
  std::string shown;
  for (std::size_t i = 0; i < all.size() && i < diff_lines; ++i) shown += "  " + all[i] + "\n";
  if (all.size() > diff_lines) shown += fmt::format("  … {} more lines\n", all.size() - diff_lines);
  return shown;
}

std::string compare(const OutputFile& file) {
  const std::optional<std::string> found = existing_text(file.path);
  if (!found) return fmt::format("{}: missing\n", file.path);
  if (*found == file.text) return {};
  const BodyHash hash = body_hash(*found);
  const bool edited = !hash.stated.empty() && hash.stated != hash.actual;
  return fmt::format("{}: {}\n{}", file.path, edited ? "edited by hand" : "stale",
                     unified_diff(*found, file.text));
}

/// Files of ours, in the folders of `files`, that nothing generates any more.
std::set<std::string> orphans(const fs::path& directory, const EmittedFiles& files) {
  std::set<fs::path> folders;
  for (const auto& [name, text] : files.files) folders.insert((directory / name).parent_path());
  std::set<std::string> found;
  std::error_code error;
  for (const fs::path& folder : folders) {
    for (const auto& entry : fs::directory_iterator(folder, error)) {
      const std::string name = fs::relative(entry.path(), directory, error).generic_string();
      if (!entry.is_regular_file() || files.files.count(name) != 0) continue;
      if (bears_marker(entry.path().string())) found.insert(entry.path().string());
    }
  }
  return found;
}

}  // namespace

Differences compare_files(const std::string& directory, const EmittedFiles& files) {
  Differences differences;
  for (const OutputFile& file : files_in(directory, files)) differences.text += compare(file);
  differences.is_stale = !differences.text.empty();
  for (const std::string& path : orphans(directory, files)) {
    differences.text += path + ": orphan, nothing generates it\n";
    differences.orphans.push_back(path);
  }
  return differences;
}

}  // namespace elgen::cli
