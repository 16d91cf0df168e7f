// Checks models given as text and prints the results as text.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "elgen/scene.hpp"
#include "support/text.hpp"

namespace elgen::test {

/// Options of a run, as on the command line; `scene` is the text of a scene file.
struct CheckOptions {
  std::string scene = {};
  std::vector<std::string> outputs = {};
  std::vector<std::string> fixed = {};
  std::vector<std::string> sizes = {};
  std::vector<std::string> ranges = {};
  std::vector<std::string> over = {};
  Limits limits = {};
  Purpose purpose = purpose::generate;
};

/// A scene named `fast` of the model `block`; the text `more` starts on line 4.
[[nodiscard]] std::string scene_of_block(const std::string& more);

/// The result of check() on the text `model`; fails the test on syntax errors.
[[nodiscard]] Result<CheckedModel> run_check(const std::string& model,
                                             const CheckOptions& wanted = {});

/// One line per diagnostic: "E201 12:6 unknown name `z` | did you mean `x`? (coordinate, line 5)".
[[nodiscard]] std::string messages(const std::string& model, const CheckOptions& wanted = {});

/// The checked model and scene; fails the test on errors.
[[nodiscard]] CheckedModel checked(const std::string& model, const CheckOptions& wanted = {});

/// A model in eleven lines: a mass m at x on a spring k. `more` starts on line 12, inside [energy].
[[nodiscard]] std::string block(const std::string& more = {});

/// The scene of `block` with the lines `more`; fails the test on errors.
[[nodiscard]] Scene block_scene(const std::string& more);
[[nodiscard]] std::string block_scene_messages(const std::string& more);

/// The messages about `block` with V = `potential`.
[[nodiscard]] std::string potential_messages(const std::string& potential,
                                             const CheckOptions& wanted = {});

/// The lines of dump(Model) that start with `word`.
[[nodiscard]] std::string dump_lines(const std::string& model, const std::string& word,
                                     const CheckOptions& wanted = {});

/// Pairs of an input and the expected answer.
using Rows = std::vector<std::pair<std::string, std::string>>;

void check_rows(const Rows& rows, const std::function<std::string(const std::string&)>& answer);

}  // namespace elgen::test
