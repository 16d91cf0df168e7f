// page_data: a Sheet -> the values of the holes of templates/pages/, in the words of one language.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "elgen/render.hpp"
#include "render/display.hpp"
#include "render/fill_template.hpp"

namespace elgen {

/// How a language of pages writes what a sheet has.
struct PageWords {
  std::string (*plain)(const std::string& text);     ///< prose, its markup escaped
  std::string (*name)(const std::string& name);      ///< what models and programs call it
  std::string (*formula)(const std::string& latex);  ///< in a line, without what encloses it
  std::string (*equation)(const Display& display);   ///< on lines of its own
};

/// What is empty is a section that is absent; a text of one line or more is its `line`.
[[nodiscard]] TemplateData page_data(const Sheet& sheet, const PageWords& words);

/// What a language writes for characters that are its markup.
using Escapes = std::map<char, std::string_view>;
[[nodiscard]] std::string escaped(const std::string& text, const Escapes& escapes);

/// A text that a language writes as it is.
[[nodiscard]] std::string unchanged(const std::string& text);

}  // namespace elgen
