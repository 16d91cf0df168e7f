// One error case: input files, a command, and what the command must print.
//
//     --- model.toml            any other title is a file to write
//     format = 2
//     --- command
//     elgen generate model.toml
//     --- exit 2
//     --- stderr                an absent stderr or stdout means: empty
//     model.toml:1:10: error[E102]: …
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "support/shell.hpp"

namespace elgen::test {

struct Section {
  std::string title;
  std::string body;
};

struct CaseFile {
  std::vector<Section> inputs = {};  ///< name and content
  std::string command = {};
  Outcome expected = {};
};

/// Throws std::invalid_argument where the text has no such form.
[[nodiscard]] CaseFile parse_case(std::string_view text);

[[nodiscard]] std::string to_text(const CaseFile& parsed);

/// Runs the command in a fresh folder that holds the inputs.
[[nodiscard]] Outcome run_case(const CaseFile& parsed);

}  // namespace elgen::test
