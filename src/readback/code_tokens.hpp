// code_tokens: text of C or C++ -> its tokens by the rules of these languages, and its comments.
//
//     x = a - -b;  // sum     ->   x  =  a  -  -  b  ;     and the comment "// sum"
//
// A line that starts with # ends with a token of its own. In a picture `{{name}}` is one token.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace elgen {

enum class CodeTokenKind : std::uint8_t {
  name,
  number,
  string,  ///< with its quotes
  sign,    ///< the longest operator or bracket that stands there
  hole,    ///< of a picture
  end_of_directive,
  end,
  invalid,  ///< what starts no token
};

struct CodeToken {
  CodeTokenKind kind = CodeTokenKind::end;
  std::string_view text = {};
  std::uint32_t begin = 0;     ///< offset in the text
  std::uint32_t comments = 0;  ///< so many stand before it
};

struct CodeText {
  std::vector<CodeToken> tokens = {};           ///< the last one is the end
  std::vector<std::string_view> comments = {};  ///< with their `//`
};

enum class CodeKind : std::uint8_t { file, picture };

/// The text must outlive what is returned.
[[nodiscard]] CodeText code_tokens(std::string_view text, CodeKind kind = CodeKind::file);

}  // namespace elgen
