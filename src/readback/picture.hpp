// Picture: a template of templates/, read as what stands in a file: the tokens that are the same in
// every file, with holes between them that the reader of a language fills.
//
//     struct {{name}} {                 tokens `struct`, hole `name`, token `{`,
//     {{#members}} {{line}} {{/members}}   section `members` with the hole `line`, token `}`
//     }
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "readback/token_reader.hpp"

namespace elgen {

struct PictureElement {
  CodeToken token = {};                    ///< where it is one of its own
  std::string name = {};                   ///< of a hole or section
  std::vector<PictureElement> parts = {};  ///< of a section
  bool is_section = false;
};

class Picture {
 public:
  /// `known` are the holes whose text is the same everywhere: "scalar" -> "double". Holes that
  /// begin with `> ` are other templates.
  Picture(std::string_view path, const std::map<std::string, std::string>& known);

  [[nodiscard]] const std::vector<PictureElement>& elements() const { return elements_; }

 private:
  std::string text_;
  std::vector<PictureElement> elements_;
};

/// What reads the holes; a section is read once more as long as its question says yes.
struct HoleReaders {
  std::map<std::string, std::function<void()>> holes = {};
  std::map<std::string, std::function<bool()>> sections = {};
};

/// The question of a section that stands there once wherever the picture has it, or nowhere.
[[nodiscard]] std::function<bool()> once(bool is_there);

/// Reads what the picture shows, token by token. Comments are no tokens.
void read_picture(const Picture& picture, const HoleReaders& readers, TokenReader& tokens);

}  // namespace elgen
