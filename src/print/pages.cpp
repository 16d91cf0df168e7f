// pages: one traversal of a Page for all languages, and the syntax of each language.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "base/fill_template.hpp"
#include "elgen/page.hpp"
#include "formula/drawing.hpp"
#include "model/symbols.hpp"
#include "print/display.hpp"

namespace elgen {
namespace {

/// The syntax of a page language: functions from content to its text.
struct PageSyntax {
  std::string (*plain)(const std::string& text);  ///< prose, with markup escaped
  std::string (*name)(const std::string& name);   ///< a name in models and programs
  std::string (*unit)(const std::string& unit);   ///< a unit such as "m/s^2"
  std::string (*formula)(const Glyphs& glyphs);   ///< without delimiters
  std::string (*in_line)(const Glyphs& glyphs);   ///< with the delimiters of a formula inside prose
  std::string (*equations)(const DisplayBlock& all);  ///< displayed equations
};

using List = TemplateData::type;

TemplateData section_of(const std::string& text) {
  return section_if(!text.empty(), {"line", text});
}

TemplateData formula_section(const Formula& formula, const PageSyntax& words) {
  return section_of(formula.is_empty() ? "" : words.formula(glyphs_of(formula)));
}

/// A row of prose and formulas.
std::string prose_with_formulas(const Glyphs& row, const PageSyntax& words) {
  std::string text;
  for (const auto& [is_prose, prose, formula] : pieces(row)) {
    text += is_prose ? words.plain(prose) : words.in_line(formula);
  }
  return text;
}

std::string prose_with_formulas(const Formula& formula, const PageSyntax& words) {
  return prose_with_formulas(glyphs_of(formula), words);
}

/// A table for each kind of variable on the page; only parameters have values.
TemplateData variables_data(const Page& page, const PageSyntax& words) {
  TemplateData tables(List::list);
  const auto add = [&](const std::vector<PageVariable>& variables, const std::string& word) {
    if (variables.empty()) return;
    const TemplateData rows = rows_data(variables, [&words](const PageVariable& variable) {
      return TemplateRow{{"symbol", words.in_line(glyphs_of(variable.symbol))},
                         {"name", words.name(variable.name)},
                         {"value", words.plain(variable.value)},
                         {"unit", words.unit(variable.unit)},
                         {"doc", words.plain(variable.doc)}};
    });
    tables << TemplateRow{{"title", as_title(word) + "s"},
                          {"word", word},
                          {"has_value", section_if(word == "parameter")},
                          {"rows", rows}};
  };
  add(page.coordinates, "coordinate");
  add(page.inputs, "input");
  add(page.functions, "function");
  add(page.parameters, "parameter");
  return tables;
}

/// The data of a table: the list `heads` with the row of heads, and the list `rows`. Both are empty
/// for a table without heads.
TemplateData cells_data(const PageTable& table, const PageSyntax& words) {
  const auto row_of = [&](auto first, std::size_t count) {
    TemplateData cells(List::list);
    for (std::size_t i = 0; i < count; ++i, ++first) {
      TemplateData cell;
      cell.set("cell", section_of(prose_with_formulas(*first, words)));
      cell.set("separator", i + 1 < count ? " & " : "");
      cells << cell;
    }
    TemplateData row("cells", cells);
    row.set("columns", std::to_string(count));
    return row;
  };
  const std::size_t columns = table.heads.size();
  TemplateData data;
  TemplateData heads(List::list);
  TemplateData rows(List::list);
  if (columns > 0) heads << row_of(table.heads.begin(), columns);
  for (std::size_t i = 0; columns > 0 && i < table.cells.size(); i += columns) {
    rows << row_of(table.cells.begin() + static_cast<std::ptrdiff_t>(i), columns);
  }
  data.set("heads", heads);
  data.set("rows", rows);
  return section_if(columns > 0, data);
}

std::vector<DisplayBlock> blocks_of(const std::vector<SetEquation>& equations, bool are_aligned) {
  if (are_aligned) return aligned_blocks(equations);
  std::vector<DisplayBlock> blocks;
  for (const SetEquation& equation : equations) {
    for (Display& display : displays(equation)) blocks.push_back(DisplayBlock{std::move(display)});
  }
  return blocks;
}

/// The heading of a section. A title equal to the name in code is printed as code.
TemplateData heading_data(const PageSection& section, const PageSyntax& words) {
  const bool is_name = text_of(section.title) == section.function;
  TemplateData heading;
  heading.set("title", is_name ? "" : prose_with_formulas(section.title, words));
  heading.set("function", section_of(is_name ? words.name(section.function) : ""));
  return section_if(!section.title.is_empty(), heading);
}

TemplateData section_data(const PageSection& section, const PageSyntax& words) {
  const SetSection set = set_section(section);
  std::vector<std::string> equations;
  for (const DisplayBlock& block : blocks_of(set.equations, section.is_aligned)) {
    equations.push_back(words.equations(block));
  }
  const bool leaves_out = std::ranges::any_of(
      set.equations, [](const SetEquation& equation) { return omits_zeros(equation); });
  TemplateData data;
  std::vector<std::string> lines;
  for (const Glyphs& line : set.lines) lines.push_back(prose_with_formulas(line, words));
  data.set("heading", heading_data(section, words));
  data.set("lines", lines_data(lines));
  data.set("table", cells_data(section.table, words));
  data.set("zeros", section_of(leaves_out ? words.plain("All other entries are 0.") : ""));
  data.set("doc", section_of(words.plain(section.doc)));
  data.set("definition", formula_section(section.definition, words));
  data.set("equations", lines_data(equations));
  return data;
}

TemplateData sections_data(const std::vector<PageSection>& sections, const PageSyntax& words) {
  TemplateData list(List::list);
  for (const PageSection& section : sections) list << section_data(section, words);
  return list;
}

/// The data of templates/pages/. A section with an empty value is absent; `line` is a text of one
/// or more lines.
TemplateData page_data(const Page& page, const PageSyntax& words) {
  TemplateData notes(List::list);
  for (const std::string& note : page.notes) notes << TemplateData("line", words.plain(note));
  TemplateData data;
  data.set("title", words.plain(text_of(page.title)));
  data.set("headline", prose_with_formulas(page.title, words));
  data.set("description", section_of(words.plain(page.description)));
  data.set("reference", section_of(words.plain(page.reference)));
  data.set("notes", notes);
  data.set("equation_of_motion", formula_section(page.equation_of_motion, words));
  data.set("variables", variables_data(page, words));
  data.set("outputs", sections_data(page.sections, words));
  return data;
}

/// The identity, for languages without escapes.
std::string identity(const std::string& text) { return text; }

/// Escapes Markdown syntax in one line.
std::string markdown_text(const std::string& text) {
  static const Escapes escapes{{'|', "\\|"}, {'<', "\\<"},   {'*', "\\*"}, {'_', "\\_"},
                               {'$', "\\$"}, {'\\', "\\\\"}, {'`', "\\`"}, {'\n', " "},
                               {'\r', " "},  {'\t', " "},    {'[', "\\["}, {']', "\\]"},
                               {'&', "\\&"}, {'~', "\\~"}};
  return escaped(text, escapes);
}

/// Escapes LaTeX syntax; inputenc handles Unicode.
std::string latex_text(const std::string& text) {
  static const Escapes escapes{{'\\', "\\textbackslash{}"},
                               {'^', "\\textasciicircum{}"},
                               {'~', "\\textasciitilde{}"},
                               {'<', "\\textless{}"},
                               {'>', "\\textgreater{}"},
                               {'|', "\\textbar{}"},
                               {'#', "\\#"},
                               {'$', "\\$"},
                               {'%', "\\%"},
                               {'&', "\\&"},
                               {'_', "\\_"},
                               {'{', "\\{"},
                               {'}', "\\}"}};
  return escaped(text, escapes);
}

/// Longer blocks may break across pages, which `aligned` cannot.
constexpr std::size_t longest_block = 10;

std::string latex_equations(const DisplayBlock& block) {
  const std::string text = latex_block(block);
  if (line_count(block) <= longest_block) return fmt::format("\\[\n{}\n\\]", text);
  const std::string body = text.substr(text.find('\n'), text.rfind('\n') - text.find('\n'));
  return fmt::format("\\begin{{align*}}{}\n\\end{{align*}}", body);
}

std::string in_dollars(const Glyphs& glyphs) { return fmt::format("${}$", latex(glyphs)); }

std::string markdown_unit(const std::string& unit) {
  return markdown_text(unit_text(unit, " ", small_exponent));
}

std::string latex_unit(const std::string& unit) {
  if (unit.empty()) return {};
  const auto exponent_text = [](const std::string& exponent) { return "^{" + exponent + "}"; };
  return fmt::format("$\\mathrm{{{}}}$", unit_text(unit, "\\,", exponent_text));
}

std::string html_unit(const std::string& unit) {
  return unit_text(unit, " ", [](const std::string& exponent) {
    return fmt::format("<sup>{}</sup>", exponent);
  });
}

std::string html_formula(const Glyphs& glyphs) {
  return fmt::format("<mrow>{}</mrow>", mathml(glyphs));
}

std::string mathml_element(const Glyphs& glyphs) {
  return fmt::format("<math>{}</math>", html_formula(glyphs));
}

std::string cell(const std::string& content) { return fmt::format("<mtd>{}</mtd>", content); }

/// A matrix of `columns` columns in tall brackets.
std::string html_matrix(const Display& display) {
  std::string rows;
  for (std::size_t i = 0; i < display.rows.size(); ++i) {
    if (i % display.columns == 0) rows += "<mtr>";
    rows += cell(html_formula(display.rows[i]));
    if ((i + 1) % display.columns == 0) rows += "</mtr>\n";
  }
  return fmt::format("<mo>(</mo><mtable>\n{}</mtable><mo>)</mo>", rows);
}

std::vector<std::string> html_right_sides(const Display& display) {
  if (display.columns > 0) return {html_matrix(display)};
  std::vector<std::string> sides;
  for (const Glyphs& row : display.rows) sides.push_back(html_formula(row));
  return sides;
}

/// One line, or lines with aligned equals signs. Continuation lines are to the right of the sign.
std::string html_equations(const DisplayBlock& block) {
  std::string rows;
  for (const Display& display : block) {
    const bool has_left = !display.left.parts.empty();
    std::string left = has_left ? html_formula(display.left) + "<mo>=</mo>" : "";
    for (const std::string& right : html_right_sides(display)) {
      if (line_count(block) == 1) return fmt::format("<mrow>{}{}</mrow>", left, right);
      rows += fmt::format("<mtr>{}{}</mtr>\n", cell(fmt::format("<mrow>{}</mrow>", left)),
                          cell(fmt::format("<mrow>{}</mrow>", right)));
      left.clear();
    }
  }
  return fmt::format("<mtable class=\"lines\" displaystyle=\"true\">\n{}</mtable>", rows);
}

constexpr PageSyntax html_words{xml_text,     xml_text,       html_unit,
                                html_formula, mathml_element, html_equations};

}  // namespace

/// GitHub Markdown with $$ blocks.
std::string markdown_page(const Page& page) {
  const PageSyntax words{markdown_text, identity, markdown_unit, latex, in_dollars, latex_block};
  std::string text = fill_template("pages/markdown.md.mustache", page_data(page, words));
  while (text.ends_with("\n\n")) text.pop_back();
  return text;
}

/// A complete document with amsmath and longtable. It needs outline fonts: without lmodern, LaTeX
/// uses OT1 fonts, which lack <, > and |.
std::string latex_document(const Page& page) {
  const PageSyntax words{latex_text, latex_text, latex_unit, latex, in_dollars, latex_equations};
  return fill_template("pages/latex.tex.mustache", page_data(page, words));
}

std::string html_parts(const std::vector<PageSection>& sections) {
  return fill_template("pages/sections.html.mustache",
                       TemplateRow{{"outputs", sections_data(sections, html_words)}});
}

std::string html_page(const Page& page) {
  return fill_template("pages/mathml.html.mustache", page_data(page, html_words));
}

}  // namespace elgen
