// fill_template: a template and the values of its holes -> text.
//
// Templates look like the output (Mustache): holes `{{name}}`, sections for what repeats or may be
// absent, other templates of the folder by their names (`{{> kinked}}`), no logic. A hole without a
// value is a mistake in elgen and throws std::logic_error.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

// As packages install it, or the header alone, as it is published.
#if __has_include(<kainjow/mustache.hpp>)
#include <kainjow/mustache.hpp>
#else
#include <mustache.hpp>
#endif

namespace elgen {

using TemplateData = kainjow::mustache::data;
/// The values of holes, by their names.
using TemplateRow = kainjow::mustache::object;

/// The list that a section repeats over: `row_of` every element.
template <class Elements, class RowOf>
[[nodiscard]] TemplateData rows_data(const Elements& elements, const RowOf& row_of) {
  TemplateData list(TemplateData::type::list);
  for (const auto& element : elements) list.push_back(row_of(element));
  return list;
}

/// The list an optional section stands on: one element with the values, or none.
[[nodiscard]] TemplateData section_if(bool present, const TemplateData& values = {});

/// One element per line, each with the hole `line`; what a comment block repeats over.
[[nodiscard]] TemplateData lines_data(const std::vector<std::string>& lines);

/// Fills the embedded template at `path` ("cpp/header.hpp.mustache"). Text is put in unescaped.
[[nodiscard]] std::string fill_template(std::string_view path, const TemplateData& data);

/// The characters that are markup of a language, and how it writes them.
using Escapes = std::map<char, std::string_view>;
[[nodiscard]] std::string escaped(const std::string& text, const Escapes& escapes);

}  // namespace elgen
