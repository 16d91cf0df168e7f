// fill_template: inserts values into the holes of a template.
//
// Templates are in Mustache: holes `{{name}}`, sections for parts that repeat or may be absent,
// partials from the same folder (`{{> kinked}}`), no logic. A hole without a value is a mistake in
// elgen and throws std::logic_error.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

// Packages install mustache.hpp in the folder kainjow; its author publishes the file alone.
#if __has_include(<kainjow/mustache.hpp>)
#include <kainjow/mustache.hpp>
#else
#include <mustache.hpp>
#endif

namespace elgen {

using TemplateData = kainjow::mustache::data;
/// The values of holes, by their names.
using TemplateRow = kainjow::mustache::object;

/// The list for a repeated section: row_of(element) has the values of one repetition.
template <class Elements, class RowOf>
[[nodiscard]] TemplateData repeated_section(const Elements& elements, const RowOf& row_of) {
  TemplateData list(TemplateData::type::list);
  for (const auto& element : elements) list.push_back(row_of(element));
  return list;
}

/// The list for an optional section: one element with the values if `present`, else no element.
[[nodiscard]] TemplateData optional_section(bool present, const TemplateData& values = {});

/// The list for a section that repeats for each line, such as a comment block. The section has the
/// hole `line`.
[[nodiscard]] TemplateData lines_section(const std::vector<std::string>& lines);

/// Fills the embedded template at `path` ("cpp/header.hpp.mustache"). Values are inserted
/// unescaped.
[[nodiscard]] std::string fill_template(std::string_view path, const TemplateData& data);

/// Characters that are markup in a language, and their escapes.
using Escapes = std::map<char, std::string_view>;
[[nodiscard]] std::string escape_markup(const std::string& text, const Escapes& escapes);

}  // namespace elgen
