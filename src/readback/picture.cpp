// picture: sections that hold comments alone are left out, for comments are no tokens.
#include "readback/picture.hpp"

#include "elgen/templates.hpp"

namespace elgen {
namespace {

std::string filled(std::string_view path, const std::map<std::string, std::string>& known) {
  std::string_view rest = template_at(path);
  std::string text;
  for (std::size_t open = rest.find("{{"); open != std::string_view::npos; open = rest.find("{{")) {
    const std::size_t close = rest.find("}}", open);
    const std::string name(rest.substr(open + 2, close - open - 2));
    text += rest.substr(0, open);
    const auto found = known.find(name);
    if (name.front() == '>') {
      text += filled(template_beside(path, name.substr(2)), known);
    } else {
      text += found == known.end() ? "{{" + name + "}}" : found->second;
    }
    rest.remove_prefix(close + 2);
  }
  return text.append(rest);
}

/// Elements up to the end of the section that is open, or of the text.
std::vector<PictureElement> elements_of(const std::vector<CodeToken>& tokens, std::size_t& at) {
  std::vector<PictureElement> elements;
  for (; tokens[at].kind != CodeTokenKind::end; ++at) {
    if (tokens[at].kind != CodeTokenKind::hole) {
      elements.push_back({tokens[at]});
      continue;
    }
    std::string name(tokens[at].text.substr(2, tokens[at].text.size() - 4));
    if (name.front() == '/') return elements;
    PictureElement element{{}, name};
    if (name.front() == '#') {
      element.name = name.substr(1);
      element.is_section = true;
      element.parts = elements_of(tokens, ++at);
      if (element.parts.empty()) continue;
    }
    elements.push_back(std::move(element));
  }
  return elements;
}

/// The tokens of a section before its first hole tell whether it stands there.
bool begins(const PictureElement& section, const TokenReader& tokens) {
  std::vector<CodeToken> start;
  for (const PictureElement& part : section.parts) {
    if (!part.name.empty()) break;
    start.push_back(part.token);
  }
  return tokens.begins(start);
}

void read(const std::vector<PictureElement>& elements, const HoleReaders& readers,
          TokenReader& tokens) {
  for (const PictureElement& element : elements) {
    if (element.name.empty()) {
      tokens.expect(element.token);
    } else if (!element.is_section) {
      readers.holes.at(element.name)();
    } else {
      const auto question = readers.sections.find(element.name);
      const bool is_asked = question != readers.sections.end();
      while (is_asked ? question->second() : begins(element, tokens)) {
        read(element.parts, readers, tokens);
      }
    }
  }
}

}  // namespace

Picture::Picture(std::string_view path, const std::map<std::string, std::string>& known)
    : text_(filled(path, known)) {
  const CodeText code = code_tokens(text_, CodeKind::picture);
  std::size_t at = 0;
  elements_ = elements_of(code.tokens, at);
}

std::function<bool()> once(bool is_there) {
  return [is_there, is_read = false]() mutable {
    is_read = is_there && !is_read;
    return is_read;
  };
}

void read_picture(const Picture& picture, const HoleReaders& readers, TokenReader& tokens) {
  read(picture.elements(), readers, tokens);
  tokens.expect_end();
}

}  // namespace elgen
