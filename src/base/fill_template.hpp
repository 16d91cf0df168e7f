// fill_template: a template and the values of its holes -> text.
//
// Templates look like the output (Mustache): holes `{{name}}`, sections for parts that repeat or
// may be absent, partials from the same folder (`{{> kinked}}`), no logic. A hole without a value
// is a mistake in elgen and throws std::logic_error.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

// The header as packages install it, or the single header as it is published.
#if __has_include(<kainjow/mustache.hpp>)
#include <kainjow/mustache.hpp>
#else
#include <mustache.hpp>
#endif

namespace elgen {

using TemplateData = kainjow::mustache::data;
/// The values of holes, by their names.
using TemplateRow = kainjow::mustache::object;

/// The list over which a section repeats: `row_of` each element.
template <class Elements, class RowOf>
[[nodiscard]] TemplateData rows_data(const Elements& elements, const RowOf& row_of) {
  TemplateData list(TemplateData::type::list);
  for (const auto& element : elements) list.push_back(row_of(element));
  return list;
}

/// The list of an optional section: one element with the values if `present`, else empty.
[[nodiscard]] TemplateData section_if(bool present, const TemplateData& values = {});

/// A list with one element per line, whose hole is `line`. A comment block repeats over it.
[[nodiscard]] TemplateData lines_data(const std::vector<std::string>& lines);

/// Fills the embedded template at `path` ("cpp/header.hpp.mustache"). Values are inserted
/// unescaped.
[[nodiscard]] std::string fill_template(std::string_view path, const TemplateData& data);

/// Characters that are markup in a language, and their escapes.
using Escapes = std::map<char, std::string_view>;
[[nodiscard]] std::string escaped(const std::string& text, const Escapes& escapes);

}  // namespace elgen
