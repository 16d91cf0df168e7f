// page_data: one walk over a Sheet for every language.
#include "render/page_data.hpp"

#include <algorithm>

namespace elgen {
namespace {

using List = TemplateData::type;

TemplateData section_of(const std::string& text) {
  return section_if(!text.empty(), {"line", text});
}

TemplateData table(const std::vector<SheetVariable>& variables, const PageWords& words) {
  TemplateData rows(List::list);
  for (const SheetVariable& variable : variables) {
    TemplateData row;
    row.set("symbol", words.formula(variable.symbol));
    row.set("name", words.name(variable.name));
    row.set("value", words.plain(variable.value));
    row.set("unit", words.plain(variable.unit));
    row.set("doc", words.plain(variable.doc));
    rows << row;
  }
  return section_if(!variables.empty(), {"rows", rows});
}

TemplateData output_data(const SheetOutput& output, const PageWords& words) {
  std::vector<std::string> equations;
  for (const SheetEquation& equation : output.equations) {
    for (const Display& display : displays(equation)) equations.push_back(words.equation(display));
  }
  const bool leaves_out = std::ranges::any_of(
      output.equations, [](const SheetEquation& equation) { return leaves_out_zeros(equation); });
  TemplateData data;
  data.set("title", words.plain(output.title));
  data.set("function", section_of(words.name(output.function)));
  data.set("zeros", section_of(leaves_out ? words.plain("All other entries are 0.") : ""));
  data.set("doc", section_of(words.plain(output.doc)));
  const std::string& definition = output.definition;
  data.set("definition", section_of(definition.empty() ? "" : words.formula(definition)));
  data.set("equations", lines_data(equations));
  return data;
}

}  // namespace

TemplateData page_data(const Sheet& sheet, const PageWords& words) {
  TemplateData notes(List::list);
  for (const std::string& note : sheet.notes) notes << TemplateData("line", words.plain(note));
  TemplateData outputs(List::list);
  for (const SheetOutput& output : sheet.outputs) outputs << output_data(output, words);
  TemplateData data;
  data.set("title", words.plain(sheet.title));
  data.set("description", section_of(words.plain(sheet.description)));
  data.set("reference", section_of(words.plain(sheet.reference)));
  data.set("notes", notes);
  data.set("equation_of_motion", words.formula(sheet.equation_of_motion));
  data.set("coordinates", table(sheet.coordinates, words));
  data.set("inputs", table(sheet.inputs, words));
  data.set("parameters", table(sheet.parameters, words));
  data.set("outputs", outputs);
  return data;
}

std::string escaped(const std::string& text, const Escapes& escapes) {
  std::string result;
  for (const char c : text) {
    const auto found = escapes.find(c);
    result += found == escapes.end() ? std::string_view(&c, 1) : found->second;
  }
  return result;
}

std::string unchanged(const std::string& text) { return text; }

}  // namespace elgen
