// --check: compares the generated files with the files on disk, which may be missing, stale or
// edited.
#include <fmt/format.h>

#include <array>
#include <dtl/dtl.hpp>
#include <sstream>

#include "cli/files/output_files.hpp"

namespace elgen::cli {

namespace {

constexpr std::size_t diff_lines = 20;  // printed lines per file; further lines are only counted

std::vector<std::string> split_lines(const std::string& text) {
  std::vector<std::string> result;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) result.push_back(line);
  return result;
}

/// The first `diff_lines` lines of a unified diff, and the number of further lines.
std::string unified_diff(const std::string& before, const std::string& after) {
  dtl::Diff<std::string> diff(split_lines(before), split_lines(after));
  diff.onHuge();
  diff.compose();
  diff.composeUnifiedHunks();
  std::ostringstream text;
  diff.printUnifiedFormat(text);
  const std::vector<std::string> all = split_lines(text.str());
  std::string shown;
  for (std::size_t i = 0; i < all.size() && i < diff_lines; ++i) shown += "  " + all[i] + "\n";
  if (all.size() > diff_lines) shown += fmt::format("  … {} more lines\n", all.size() - diff_lines);
  return shown;
}

std::optional<FileDifference> compare_file(const OutputFile& file) {
  const std::optional<std::string> found = read_existing_file(file.path);
  if (!found) return FileDifference{FileState::missing, file.path};
  if (*found == file.text) return std::nullopt;
  const BodyHash hash = body_hash(*found);
  const bool is_edited = !hash.stated.empty() && hash.stated != hash.actual;
  return FileDifference{is_edited ? FileState::edited : FileState::stale, file.path,
                        unified_diff(*found, file.text)};
}

}  // namespace

std::string_view name_of(FileState state) {
  constexpr std::array names{"stale", "edited", "missing", "orphaned"};
  return names[static_cast<std::size_t>(state)];
}

std::vector<FileDifference> compare_files(const std::string& directory, const EmittedFiles& files) {
  std::vector<FileDifference> differences;
  for (const OutputFile& file : to_output_files(directory, files)) {
    if (auto difference = compare_file(file)) differences.push_back(*std::move(difference));
  }
  return differences;
}

}  // namespace elgen::cli
