// Searches and replacements in texts, and files of the project as texts.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace elgen::test {

[[nodiscard]] bool mentions(std::string_view text, std::string_view part);
[[nodiscard]] std::size_t count(std::string_view text, std::string_view part);
[[nodiscard]] bool starts_with(std::string_view text, std::string_view start);

/// The text with the first occurrence of `part` replaced; throws if there is none.
[[nodiscard]] std::string replaced(std::string text, std::string_view part, std::string_view other);
/// The text with every occurrence of `part` replaced.
[[nodiscard]] std::string replaced_all(std::string text, std::string_view part,
                                       std::string_view other);

/// The lines without their line feeds.
[[nodiscard]] std::vector<std::string> split_lines(std::string_view text);

/// The text of a file; throws if it cannot be read.
[[nodiscard]] std::string read_text(const std::filesystem::path& path);
/// Writes a file and creates its folders.
void write_text(const std::filesystem::path& path, const std::string& text);

/// The files whose names end in `ending`, sorted.
[[nodiscard]] std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder,
                                                          std::string_view ending);

/// The files models/*.toml, sorted.
[[nodiscard]] std::vector<std::filesystem::path> model_paths();

/// The path of a model of this project, models/NAME.toml, and its text.
[[nodiscard]] std::string model_path(const std::string& name);
[[nodiscard]] std::string model_file(const std::string& name);

/// The text of tests/models/NAME.toml; throws if it cannot be read.
[[nodiscard]] std::string read_model(const std::string& name);

}  // namespace elgen::test
