// Helpers of the parser tests: results as short text, so that tables of cases stay readable.
#pragma once

#include <string>
#include <string_view>

#include "elgen/syntax.hpp"
#include "support/text.hpp"

namespace elgen::test {

/// One line per diagnostic, such as "E303 17:9", in the order given.
[[nodiscard]] std::string places(const Diagnostics& diagnostics);

/// The tree of an expression, or the places of its errors, such as "E303 1:9".
[[nodiscard]] std::string expression_answer(std::string_view text, const Limits& limits = {});

/// dump() of a model or scene, or the places of its errors.
[[nodiscard]] std::string model_answer(std::string_view text, const Limits& limits = {});
[[nodiscard]] std::string scene_answer(std::string_view text);

/// The first diagnostic of a model file; there must be one.
[[nodiscard]] Diagnostic first_error(std::string_view model_text);
[[nodiscard]] Diagnostic first_scene_error(std::string_view scene_text);

/// The first diagnostic of an expression; there must be one.
[[nodiscard]] Diagnostic expression_error(std::string_view text);

/// The smallest model, with `quoted_text` (including its quotes) as [energy] V in line 6.
[[nodiscard]] std::string with_potential(std::string_view quoted_text);

/// `text` repeated `count` times.
[[nodiscard]] std::string repeated(std::string_view text, std::size_t count);

}  // namespace elgen::test
