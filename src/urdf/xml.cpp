// read_xml: parses by tinyxml2, and finds the spans of names and values. In tinyxml2, names and
// values are pointers into a copy of the text. Once start_of_copy() has found the start of the
// copy, the offset of a pointer is a difference of two pointers.
#include "urdf/xml.hpp"

#include <fmt/format.h>
#include <tinyxml2.h>

#include <algorithm>
#include <array>
#include <optional>

#include "base/utf8.hpp"

namespace elgen::urdf {

namespace {

struct XmlErrorRow {
  tinyxml2::XMLError error;
  std::string_view words;
};

constexpr std::array mistakes{
    XmlErrorRow{tinyxml2::XML_ERROR_PARSING_ATTRIBUTE,
                "an attribute is not written `name=\"value\"`"},
    XmlErrorRow{tinyxml2::XML_ERROR_PARSING_TEXT, "a text has no end"},
    XmlErrorRow{tinyxml2::XML_ERROR_PARSING_CDATA, "a CDATA section has no end"},
    XmlErrorRow{tinyxml2::XML_ERROR_PARSING_COMMENT, "a comment has no end"},
    XmlErrorRow{tinyxml2::XML_ERROR_PARSING_DECLARATION, "`<?xml` is not at the start of the file"},
    XmlErrorRow{tinyxml2::XML_ERROR_PARSING_UNKNOWN, "a `<!` has no end"},
    XmlErrorRow{tinyxml2::XML_ERROR_EMPTY_DOCUMENT, "the file has no element"},
    XmlErrorRow{tinyxml2::XML_ERROR_MISMATCHED_ELEMENT, "an element is not closed by its own name"},
    XmlErrorRow{tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED, "elements are nested more than 100 deep"},
};

std::string_view error_words(tinyxml2::XMLError error) {
  const auto row = std::ranges::find(mistakes, error, &XmlErrorRow::error);
  return row == mistakes.end() ? "an element is malformed" : row->words;
}

Span span_at(const SourceText& source, std::size_t begin, std::size_t length) {
  return {&source, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(begin + length)};
}

/// The span of a line without leading blanks.
Span span_of_line(const SourceText& source, int line) {
  const auto last = static_cast<int>(source.line_starts.size());
  const std::string_view text =
      line_text(source, static_cast<std::uint32_t>(std::clamp(line, 1, last)));
  const std::size_t blanks = std::min(text.find_first_not_of(" \t"), text.size());
  const auto begin = static_cast<std::size_t>(text.data() - source.text.data()) + blanks;
  return span_at(source, begin, text.size() - blanks);
}

Diagnostic malformed_error(const SourceText& source, int line, std::string_view words) {
  return {Code::E801, span_of_line(source, line), fmt::format("not XML: {}", words)};
}

std::size_t skip_blanks(std::string_view text, std::size_t position) {
  return std::min(text.find_first_not_of(" \t\r\n", position), text.size());
}

/// tinyxml2 compares every attribute with all previous attributes, at quadratic cost.
constexpr std::size_t most_attributes = 1000;

/// The position just behind the next `closing` after `position`; the end of the text if there is
/// none.
std::size_t skip_piece(std::string_view text, std::size_t position, std::string_view closing) {
  const std::size_t end = text.find(closing, position + 1);
  return end == std::string_view::npos ? text.size() : end + closing.size();
}

/// The position of the first attribute beyond most_attributes in an element, if there is one.
std::optional<std::size_t> find_excess_attribute(std::string_view text) {
  std::size_t attributes = 0;
  bool is_inside = false;
  for (std::size_t i = 0; i < text.size();) {
    if (text.substr(i, 4) == "<!--") {
      i = skip_piece(text, i, "-->");
      continue;
    }
    if (is_inside && (text[i] == '"' || text[i] == '\'')) {
      i = skip_piece(text, i, text.substr(i, 1));
      continue;
    }
    if (text[i] == '<') attributes = 0;
    if (text[i] == '<' || text[i] == '>') is_inside = text[i] == '<';
    attributes += is_inside && text[i] == '=' ? 1 : 0;
    if (attributes > most_attributes) return i;
    ++i;
  }
  return std::nullopt;
}

/// The start of tinyxml2's copy of the text. It is found from the pointer to the first node's text
/// and the offset of this text in the source.
const char* start_of_copy(const tinyxml2::XMLDocument& document, std::string_view text) {
  std::size_t first = skip_blanks(text, 0);
  if (text.substr(first, 3) == "\xEF\xBB\xBF") first = skip_blanks(text, first + 3);
  const tinyxml2::XMLNode* node = document.FirstChild();
  const std::size_t opening = node->ToComment() != nullptr   ? std::string_view("<!--").size()
                              : node->ToElement() != nullptr ? std::string_view("<").size()
                                                             : std::string_view("<?").size();
  return node->Value() - (first + opening);
}

/// Copies tinyxml2's nodes; they are at most 100 deep.
class ElementCopier {
 public:
  ElementCopier(const SourceText& source, const char* start) : source_(source), start_(start) {}

  Element copy(const tinyxml2::XMLElement& from) const {
    Element element{from.Name(), name_span(from.Name())};
    for (const auto* next = from.FirstAttribute(); next != nullptr; next = next->Next()) {
      element.attributes.push_back(
          {next->Name(), next->Value(), name_span(next->Name()), value_span(next->Value())});
    }
    for (const auto* next = from.FirstChildElement(); next != nullptr;
         next = next->NextSiblingElement()) {
      element.children.push_back(copy(*next));
    }
    return element;
  }

 private:
  [[nodiscard]] Span name_span(const char* name) const {
    return span_at(source_, static_cast<std::size_t>(name - start_), std::string_view(name).size());
  }

  /// The span of an attribute's value, up to the closing quote: entities and line ends may be
  /// longer in the source than in the value.
  [[nodiscard]] Span value_span(const char* value) const {
    const auto begin = static_cast<std::size_t>(value - start_);
    const std::size_t end = source_.text.find(source_.text[begin - 1], begin);
    return span_at(source_, begin, end - begin);
  }

  const SourceText& source_;
  const char* start_;
};

}  // namespace

Result<Element> read_xml(const SourceText& source) {
  if (const auto invalid = find_invalid_utf8(source.text)) {
    return Diagnostic{Code::E110, span_at(source, *invalid, 1), "the file is not UTF-8 text"};
  }
  if (const std::size_t zero = source.text.find('\0'); zero != std::string::npos) {
    return Diagnostic{Code::E801, span_at(source, zero, 1), "not XML: a byte is zero"};
  }
  if (const auto endless = find_excess_attribute(source.text)) {
    return Diagnostic{Code::E801, span_at(source, *endless, 1),
                      fmt::format("an element has more than {} attributes", most_attributes)};
  }
  tinyxml2::XMLDocument document;
  document.Parse(source.text.data(), source.text.size());
  if (document.Error()) {
    return malformed_error(source, document.ErrorLineNum(), error_words(document.ErrorID()));
  }
  const tinyxml2::XMLElement* root = document.RootElement();
  for (const auto* node = document.FirstChild(); node != nullptr; node = node->NextSibling()) {
    if (node->ToText() == nullptr && (node->ToElement() == nullptr || node == root)) continue;
    return malformed_error(source, node->GetLineNum(),
                           "something follows or precedes the root element");
  }
  if (root == nullptr)
    return malformed_error(source, 1, error_words(tinyxml2::XML_ERROR_EMPTY_DOCUMENT));
  return ElementCopier(source, start_of_copy(document, source.text)).copy(*root);
}

}  // namespace elgen::urdf
