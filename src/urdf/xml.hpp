// XML: elements and attributes as values, each with its span in the source.
#pragma once

#include <string>
#include <vector>

#include "elgen/diagnostic.hpp"
#include "elgen/source_text.hpp"

namespace elgen::urdf {

struct Attribute {
  std::string name = {};
  std::string value = {};  ///< entities decoded
  Span name_span = {};
  Span span = {};  ///< the value without its quotes
};

struct Element {
  std::string name = {};
  Span span = {};  ///< the name in the opening tag
  std::vector<Attribute> attributes = {};
  std::vector<Element> children = {};
};

/// The root element. E110: not UTF-8; E801: not XML (only the first mistake).
[[nodiscard]] Result<Element> read_xml(const SourceText& source);

}  // namespace elgen::urdf
