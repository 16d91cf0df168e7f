// plain_text: the words of another program, made fit for a message.
#pragma once

#include <string>
#include <string_view>

namespace elgen {

/// Without escape sequences and control characters other than line ends; what is longer than 4000
/// bytes is cut, and so is what is not UTF-8.
[[nodiscard]] std::string plain_text(std::string_view text);

}  // namespace elgen
