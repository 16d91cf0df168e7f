// pages: one walk over a Sheet for every language, and the words of each.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "elgen/render.hpp"
#include "render/display.hpp"
#include "render/drawing.hpp"
#include "render/fill_template.hpp"
#include "render/symbols.hpp"

namespace elgen {
namespace {

/// How a language of pages writes what a sheet has.
struct PageWords {
  std::string (*plain)(const std::string& text);      ///< prose, its markup escaped
  std::string (*name)(const std::string& name);       ///< what models and programs call it
  std::string (*unit)(const std::string& unit);       ///< "m/s^2"
  std::string (*formula)(const std::string& latex);   ///< without what encloses it
  std::string (*in_line)(const std::string& latex);   ///< a formula within prose
  std::string (*equations)(const DisplayBlock& all);  ///< on lines of their own
};

using List = TemplateData::type;

TemplateData section_of(const std::string& text) {
  return section_if(!text.empty(), {"line", text});
}

/// Prose with formulas.
std::string mixed(const std::string& latex, const PageWords& words) {
  std::string text;
  for (const LatexPiece& piece : pieces(latex)) {
    text += piece.is_prose ? words.plain(piece.text) : words.in_line(piece.text);
  }
  return text;
}

std::string title_text(const std::string& title, const std::string& latex, const PageWords& words) {
  return latex.empty() ? words.plain(title) : mixed(latex, words);
}

TemplateData table(const std::vector<SheetVariable>& variables, const PageWords& words) {
  const TemplateData rows = rows_data(variables, [&words](const SheetVariable& variable) {
    return TemplateRow{{"symbol", words.in_line(variable.symbol)},
                       {"name", words.name(variable.name)},
                       {"value", words.plain(variable.value)},
                       {"unit", words.unit(variable.unit)},
                       {"doc", words.plain(variable.doc)}};
  });
  return section_if(!variables.empty(), {"rows", rows});
}

/// Rows of cells, heads first; absent where there are no heads.
TemplateData cells_data(const SheetTable& table, const PageWords& words) {
  const auto row_of = [&](auto first, std::size_t count) {
    TemplateData cells(List::list);
    for (std::size_t i = 0; i < count; ++i, ++first) {
      TemplateData cell;
      cell.set("cell", section_of(mixed(*first, words)));
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

/// "S = \int L dt", of which nothing in front of the sign is prose.
std::optional<SheetEquation> equation_in(const std::string& line) {
  const std::size_t sign = line.find(" = ");
  if (sign == std::string::npos || line.find("\\text") < sign) return std::nullopt;
  return SheetEquation{line.substr(0, sign), 1, 1, {line.substr(sign + 3)}};
}

/// Lines of aligned outputs that are equations are some of them.
SheetOutput with_equations_of_lines(const SheetOutput& given) {
  if (!given.is_aligned) return given;
  SheetOutput output = given;
  output.equations.clear();
  output.lines.clear();
  for (const std::string& line : given.lines) {
    std::optional<SheetEquation> equation = equation_in(line);
    if (equation) {
      output.equations.push_back(std::move(*equation));
    } else {
      output.lines.push_back(line);
    }
  }
  output.equations.insert(output.equations.end(), given.equations.begin(), given.equations.end());
  return output;
}

std::vector<DisplayBlock> blocks_of(const SheetOutput& output) {
  const std::vector<SheetEquation>& equations = output.equations;
  if (output.is_aligned) return aligned_blocks(equations);
  std::vector<DisplayBlock> blocks;
  for (const SheetEquation& equation : equations) {
    for (Display& display : displays(equation)) blocks.push_back(DisplayBlock{std::move(display)});
  }
  return blocks;
}

/// The name in code stands where the title is no other.
TemplateData heading_data(const SheetOutput& output, const PageWords& words) {
  const bool is_name = output.title == output.function;
  const std::string title = title_text(output.title, output.title_latex, words);
  TemplateData heading;
  heading.set("title", is_name ? "" : title);
  heading.set("function", section_of(is_name ? words.name(output.function) : ""));
  return section_if(!output.title.empty(), heading);
}

TemplateData output_data(const SheetOutput& given, const PageWords& words) {
  const SheetOutput output = with_equations_of_lines(given);
  std::vector<std::string> equations;
  for (const DisplayBlock& block : blocks_of(output)) equations.push_back(words.equations(block));
  const bool leaves_out = std::ranges::any_of(
      output.equations, [](const SheetEquation& equation) { return leaves_out_zeros(equation); });
  TemplateData data;
  std::vector<std::string> lines;
  for (const std::string& line : output.lines) lines.push_back(mixed(line, words));
  data.set("heading", heading_data(output, words));
  data.set("lines", lines_data(lines));
  data.set("table", cells_data(output.table, words));
  data.set("zeros", section_of(leaves_out ? words.plain("All other entries are 0.") : ""));
  data.set("doc", section_of(words.plain(output.doc)));
  const std::string& definition = output.definition;
  data.set("definition", section_of(definition.empty() ? "" : words.formula(definition)));
  data.set("equations", lines_data(equations));
  return data;
}

/// The values of the holes of templates/pages/. An empty value is a section that is absent; a text
/// of one line or more is its `line`.
TemplateData page_data(const Sheet& sheet, const PageWords& words) {
  TemplateData notes(List::list);
  for (const std::string& note : sheet.notes) notes << TemplateData("line", words.plain(note));
  TemplateData outputs(List::list);
  for (const SheetOutput& output : sheet.outputs) outputs << output_data(output, words);
  TemplateData data;
  data.set("title", words.plain(sheet.title));
  data.set("headline", title_text(sheet.title, sheet.title_latex, words));
  data.set("description", section_of(words.plain(sheet.description)));
  data.set("reference", section_of(words.plain(sheet.reference)));
  data.set("notes", notes);
  const std::string& equation = sheet.equation_of_motion;
  data.set("equation_of_motion", section_of(equation.empty() ? "" : words.formula(equation)));
  data.set("coordinates", table(sheet.coordinates, words));
  data.set("inputs", table(sheet.inputs, words));
  data.set("functions", table(sheet.functions, words));
  data.set("parameters", table(sheet.parameters, words));
  data.set("outputs", outputs);
  return data;
}

/// A text that a language writes as it is.
std::string unchanged(const std::string& text) { return text; }

/// One line, without what Markdown would read as markup.
std::string markdown_text(const std::string& text) {
  static const Escapes escapes{{'|', "\\|"}, {'<', "\\<"},   {'*', "\\*"}, {'_', "\\_"},
                               {'$', "\\$"}, {'\\', "\\\\"}, {'`', "\\`"}, {'\n', " "},
                               {'\r', " "},  {'\t', " "},    {'[', "\\["}, {']', "\\]"},
                               {'&', "\\&"}, {'~', "\\~"}};
  return escaped(text, escapes);
}

/// Text with what LaTeX would read as commands escaped; Unicode is left to inputenc.
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

/// Lines that may break across pages; `aligned` may not.
constexpr std::size_t longest_block = 10;

std::string latex_equations(const DisplayBlock& block) {
  const std::string latex = latex_block(block);
  if (line_count(block) <= longest_block) return fmt::format("\\[\n{}\n\\]", latex);
  const std::string body = latex.substr(latex.find('\n'), latex.rfind('\n') - latex.find('\n'));
  return fmt::format("\\begin{{align*}}{}\n\\end{{align*}}", body);
}

std::string in_dollars(const std::string& latex) { return fmt::format("${}$", latex); }

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

std::string html_formula(const std::string& latex) {
  return fmt::format("<mrow>{}</mrow>", mathml(read_latex(latex)));
}

std::string in_math(const std::string& latex) {
  return fmt::format("<math>{}</math>", html_formula(latex));
}

std::string cell(const std::string& content) { return fmt::format("<mtd>{}</mtd>", content); }

/// Rows of `columns` entries in tall brackets.
std::string html_matrix(const Display& display) {
  std::string rows;
  for (std::size_t i = 0; i < display.texts.size(); ++i) {
    if (i % display.columns == 0) rows += "<mtr>";
    rows += cell(html_formula(display.texts[i]));
    if ((i + 1) % display.columns == 0) rows += "</mtr>\n";
  }
  return fmt::format("<mo>(</mo><mtable>\n{}</mtable><mo>)</mo>", rows);
}

std::vector<std::string> html_right_sides(const Display& display) {
  if (display.columns > 0) return {html_matrix(display)};
  std::vector<std::string> sides;
  for (const std::string& text : display.texts) sides.push_back(html_formula(text));
  return sides;
}

/// One line, or lines of which the signs stand below each other, and what continues a line to the
/// right of its sign.
std::string html_equations(const DisplayBlock& block) {
  std::string rows;
  for (const Display& display : block) {
    const bool has_left = !display.left.empty();
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

}  // namespace

/// GitHub Markdown, formulas in blocks of $$.
std::string markdown_page(const Sheet& sheet) {
  const PageWords words{markdown_text, unchanged,  markdown_unit,
                        unchanged,     in_dollars, latex_block};
  std::string text = fill_template("pages/markdown.md.mustache", page_data(sheet, words));
  while (text.ends_with("\n\n")) text.pop_back();
  return text;
}

/// A complete document; amsmath and longtable are all it needs. Its fonts are outlines: those of
/// OT1 where lmodern is not installed, which have no <, > and |.
std::string latex_document(const Sheet& sheet) {
  const PageWords words{latex_text, latex_text, latex_unit, unchanged, in_dollars, latex_equations};
  return fill_template("pages/latex.tex.mustache", page_data(sheet, words));
}

/// One page of HTML with MathML Core, translated from the LaTeX.
std::string html_page(const Sheet& sheet) {
  const PageWords words{xml_text, xml_text, html_unit, html_formula, in_math, html_equations};
  return fill_template("pages/mathml.html.mustache", page_data(sheet, words));
}

}  // namespace elgen
