// Helpers of the tests of parse: answers as one line of text, so that tables of cases stay
// readable.
#pragma once

#include <string>
#include <string_view>

#include "elgen/syntax.hpp"

namespace elgen::testing {

/// "E303 17:9", one line each, in the order given.
[[nodiscard]] std::string places(const Diagnostics& diagnostics);

/// The tree of an expression, or "E303 1:9".
[[nodiscard]] std::string expression_answer(std::string_view text, const Limits& limits = {});

/// dump() of a model or scene, or the places of its errors.
[[nodiscard]] std::string model_answer(std::string_view text, const Limits& limits = {});
[[nodiscard]] std::string scene_answer(std::string_view text);

/// The first diagnostic of a model file, which must have one.
[[nodiscard]] Diagnostic first_error(std::string_view model_text);

/// The first diagnostic of an expression, which must have one.
[[nodiscard]] Diagnostic expression_error(std::string_view text);

/// `text` as [energy] V of the smallest model, in the quotes it brings; the value stands in line 6.
[[nodiscard]] std::string with_potential(std::string_view quoted_text);

/// `text` repeated `count` times.
[[nodiscard]] std::string repeated(std::string_view text, std::size_t count);

}  // namespace elgen::testing
