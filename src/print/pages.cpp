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

using DataType = TemplateData::type;

TemplateData line_section(const std::string& text) {
  return optional_section(!text.empty(), {"line", text});
}

TemplateData formula_section(const Formula& formula, const PageSyntax& syntax) {
  return line_section(formula.is_empty() ? "" : syntax.formula(glyphs_of(formula)));
}

/// The text of `row` on the page: its prose is escaped, its formulas have delimiters.
std::string prose_with_formulas(const Glyphs& row, const PageSyntax& words) {
  std::string text;
  for (const auto& [is_prose, prose, formula] : split_at_prose(row)) {
    text += is_prose ? words.plain(prose) : words.in_line(formula);
  }
  return text;
}

std::string prose_with_formulas(const Formula& formula, const PageSyntax& words) {
  return prose_with_formulas(glyphs_of(formula), words);
}

/// A table for each kind of variable on the page; only parameters have values.
TemplateData variables_data(const Page& page, const PageSyntax& words) {
  TemplateData tables(DataType::list);
  const auto add = [&](const std::vector<PageVariable>& variables, const std::string& word) {
    if (variables.empty()) return;
    const TemplateData rows = repeated_section(variables, [&words](const PageVariable& variable) {
      return TemplateRow{{"symbol", words.in_line(glyphs_of(variable.symbol))},
                         {"name", words.name(variable.name)},
                         {"value", words.plain(variable.value)},
                         {"unit", words.unit(variable.unit)},
                         {"doc", words.plain(variable.doc)}};
    });
    tables << TemplateRow{{"title", title_from_name(word) + "s"},
                          {"word", word},
                          {"has_value", optional_section(word == "parameter")},
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
TemplateData table_data(const PageTable& table, const PageSyntax& words) {
  const auto row_of = [&](auto first, std::size_t count) {
    TemplateData cells(DataType::list);
    for (std::size_t i = 0; i < count; ++i, ++first) {
      TemplateData cell;
      cell.set("cell", line_section(prose_with_formulas(*first, words)));
      cell.set("separator", i + 1 < count ? " & " : "");
      cells << cell;
    }
    TemplateData row("cells", cells);
    row.set("columns", std::to_string(count));
    return row;
  };
  const std::size_t columns = table.heads.size();
  TemplateData data;
  TemplateData heads(DataType::list);
  TemplateData rows(DataType::list);
  if (columns > 0) heads << row_of(table.heads.begin(), columns);
  for (std::size_t i = 0; columns > 0 && i < table.cells.size(); i += columns) {
    rows << row_of(table.cells.begin() + static_cast<std::ptrdiff_t>(i), columns);
  }
  data.set("heads", heads);
  data.set("rows", rows);
  return optional_section(columns > 0, data);
}

std::vector<DisplayBlock> blocks_of(const std::vector<TypesetEquation>& equations,
                                    bool are_aligned) {
  if (are_aligned) return aligned_blocks(equations);
  std::vector<DisplayBlock> blocks;
  for (const TypesetEquation& equation : equations) {
    for (DisplayedEquation& display : lay_out_equation(equation))
      blocks.push_back(DisplayBlock{std::move(display)});
  }
  return blocks;
}

/// The heading of a section. A title equal to the name in code is printed as code.
TemplateData heading_data(const PageSection& section, const PageSyntax& words) {
  const bool is_name = text_of(section.title) == section.function;
  TemplateData heading;
  heading.set("title", is_name ? "" : prose_with_formulas(section.title, words));
  heading.set("function", line_section(is_name ? words.name(section.function) : ""));
  return optional_section(!section.title.is_empty(), heading);
}

TemplateData section_data(const PageSection& section, const PageSyntax& words) {
  const TypesetSection set = typeset_section(section);
  std::vector<std::string> equations;
  for (const DisplayBlock& block : blocks_of(set.equations, section.is_aligned)) {
    equations.push_back(words.equations(block));
  }
  const bool leaves_out = std::ranges::any_of(
      set.equations, [](const TypesetEquation& equation) { return omits_zeros(equation); });
  TemplateData data;
  std::vector<std::string> lines;
  for (const Glyphs& line : set.lines) lines.push_back(prose_with_formulas(line, words));
  data.set("heading", heading_data(section, words));
  data.set("lines", lines_section(lines));
  data.set("table", table_data(section.table, words));
  data.set("zeros", line_section(leaves_out ? words.plain("All other entries are 0.") : ""));
  data.set("doc", line_section(words.plain(section.doc)));
  data.set("definition", formula_section(section.definition, words));
  data.set("equations", lines_section(equations));
  return data;
}

TemplateData sections_data(const std::vector<PageSection>& sections, const PageSyntax& words) {
  TemplateData list(DataType::list);
  for (const PageSection& section : sections) list << section_data(section, words);
  return list;
}

/// The data of templates/pages/. A section with an empty value is absent; `line` is a text of one
/// or more lines.
TemplateData page_data(const Page& page, const PageSyntax& words) {
  TemplateData notes(DataType::list);
  for (const std::string& note : page.notes) notes << TemplateData("line", words.plain(note));
  TemplateData data;
  data.set("title", words.plain(text_of(page.title)));
  data.set("headline", prose_with_formulas(page.title, words));
  data.set("description", line_section(words.plain(page.description)));
  data.set("reference", line_section(words.plain(page.reference)));
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
  return escape_markup(text, escapes);
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
  return escape_markup(text, escapes);
}

/// The most lines of a block in `aligned`, which cannot break across pages. Longer blocks can.
constexpr std::size_t longest_block = 10;

std::string latex_equations(const DisplayBlock& block) {
  const std::string text = latex_block(block);
  if (line_count(block) <= longest_block) return fmt::format("\\[\n{}\n\\]", text);
  const std::string body = text.substr(text.find('\n'), text.rfind('\n') - text.find('\n'));
  return fmt::format("\\begin{{align*}}{}\n\\end{{align*}}", body);
}

std::string dollar_formula(const Glyphs& glyphs) { return fmt::format("${}$", to_latex(glyphs)); }

std::string markdown_unit(const std::string& unit) {
  return markdown_text(format_unit(unit, " ", small_exponent));
}

std::string latex_unit(const std::string& unit) {
  if (unit.empty()) return {};
  const auto exponent_text = [](const std::string& exponent) { return "^{" + exponent + "}"; };
  return fmt::format("$\\mathrm{{{}}}$", format_unit(unit, "\\,", exponent_text));
}

std::string html_unit(const std::string& unit) {
  return format_unit(unit, " ", [](const std::string& exponent) {
    return fmt::format("<sup>{}</sup>", exponent);
  });
}

std::string html_formula(const Glyphs& glyphs) {
  return fmt::format("<mrow>{}</mrow>", to_mathml(glyphs));
}

std::string mathml_element(const Glyphs& glyphs) {
  return fmt::format("<math>{}</math>", html_formula(glyphs));
}

std::string mathml_cell(const std::string& content) {
  return fmt::format("<mtd>{}</mtd>", content);
}

/// A matrix of `columns` columns in tall brackets.
std::string html_matrix(const DisplayedEquation& display) {
  std::string rows;
  for (std::size_t i = 0; i < display.rows.size(); ++i) {
    if (i % display.columns == 0) rows += "<mtr>";
    rows += mathml_cell(html_formula(display.rows[i]));
    if ((i + 1) % display.columns == 0) rows += "</mtr>\n";
  }
  return fmt::format("<mo>(</mo><mtable>\n{}</mtable><mo>)</mo>", rows);
}

std::vector<std::string> html_right_sides(const DisplayedEquation& display) {
  if (display.columns > 0) return {html_matrix(display)};
  std::vector<std::string> sides;
  for (const Glyphs& row : display.rows) sides.push_back(html_formula(row));
  return sides;
}

/// One line, or lines with aligned equals signs. Continuation lines are to the right of the sign.
std::string html_equations(const DisplayBlock& block) {
  std::string rows;
  for (const DisplayedEquation& display : block) {
    const bool has_left = !display.left.parts.empty();
    std::string left = has_left ? html_formula(display.left) + "<mo>=</mo>" : "";
    for (const std::string& right : html_right_sides(display)) {
      if (line_count(block) == 1) return fmt::format("<mrow>{}{}</mrow>", left, right);
      rows += fmt::format("<mtr>{}{}</mtr>\n", mathml_cell(fmt::format("<mrow>{}</mrow>", left)),
                          mathml_cell(fmt::format("<mrow>{}</mrow>", right)));
      left.clear();
    }
  }
  return fmt::format("<mtable class=\"lines\" displaystyle=\"true\">\n{}</mtable>", rows);
}

constexpr PageSyntax html_syntax{escape_xml,   escape_xml,     html_unit,
                                 html_formula, mathml_element, html_equations};

}  // namespace

/// GitHub Markdown with $$ blocks.
std::string markdown_page(const Page& page) {
  const PageSyntax words{markdown_text, identity,       markdown_unit,
                         to_latex,      dollar_formula, latex_block};
  std::string text = fill_template("pages/markdown.md.mustache", page_data(page, words));
  while (text.ends_with("\n\n")) text.pop_back();
  return text;
}

/// A complete document with amsmath and longtable. It needs outline fonts: without lmodern, LaTeX
/// uses OT1 fonts, which lack <, > and |.
std::string latex_document(const Page& page) {
  const PageSyntax words{latex_text, latex_text,     latex_unit,
                         to_latex,   dollar_formula, latex_equations};
  return fill_template("pages/latex.tex.mustache", page_data(page, words));
}

std::string html_sections(const std::vector<PageSection>& sections) {
  return fill_template("pages/sections.html.mustache",
                       TemplateRow{{"outputs", sections_data(sections, html_syntax)}});
}

std::string html_page(const Page& page) {
  return fill_template("pages/mathml.html.mustache", page_data(page, html_syntax));
}

}  // namespace elgen
