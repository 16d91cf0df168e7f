// pages: one walk over a Sheet for every language, and the words of each.
#include <fmt/format.h>

#include <algorithm>

#include "elgen/render.hpp"
#include "render/display.hpp"
#include "render/fill_template.hpp"
#include "render/latex_tree.hpp"

namespace elgen {
namespace {

/// How a language of pages writes what a sheet has.
struct PageWords {
  std::string (*plain)(const std::string& text);     ///< prose, its markup escaped
  std::string (*name)(const std::string& name);      ///< what models and programs call it
  std::string (*formula)(const std::string& latex);  ///< in a line, without what encloses it
  std::string (*equation)(const Display& display);   ///< on lines of its own
};

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

/// Rows of cells, heads first; absent where there are no heads.
TemplateData cells_data(const SheetTable& table, const PageWords& words) {
  const auto row_of = [&](auto first, std::size_t count) {
    TemplateData cells(List::list);
    for (std::size_t i = 0; i < count; ++i, ++first) {
      TemplateData cell;
      cell.set("cell", section_of(first->empty() ? "" : words.formula(*first)));
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

TemplateData output_data(const SheetOutput& output, const PageWords& words) {
  std::vector<std::string> equations;
  for (const SheetEquation& equation : output.equations) {
    for (const Display& display : displays(equation)) equations.push_back(words.equation(display));
  }
  const bool leaves_out = std::ranges::any_of(
      output.equations, [](const SheetEquation& equation) { return leaves_out_zeros(equation); });
  TemplateData data;
  std::vector<std::string> lines;
  for (const std::string& line : output.lines) lines.push_back(words.formula(line));
  TemplateData heading;
  heading.set("title", words.plain(output.title));
  heading.set("function", section_of(words.name(output.function)));
  data.set("heading", section_if(!output.title.empty(), heading));
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

std::string latex_equation(const Display& display) {
  const std::string latex = latex_block(display);
  if (display.columns > 0 || display.texts.size() <= longest_block) {
    return fmt::format("\\[\n{}\n\\]", latex);
  }
  const std::string body = latex.substr(latex.find('\n'), latex.rfind('\n') - latex.find('\n'));
  return fmt::format("\\begin{{align*}}{}\n\\end{{align*}}", body);
}

std::string formula(const std::string& latex) {
  return fmt::format("<mrow>{}</mrow>", mathml(read_latex(latex)));
}

std::string cell(const std::string& content) { return fmt::format("<mtd>{}</mtd>", content); }

/// Rows of `columns` entries in tall brackets.
std::string matrix(const Display& display) {
  std::string rows;
  for (std::size_t i = 0; i < display.texts.size(); ++i) {
    if (i % display.columns == 0) rows += "<mtr>";
    rows += cell(formula(display.texts[i]));
    if ((i + 1) % display.columns == 0) rows += "</mtr>\n";
  }
  return fmt::format("<mrow>{}<mo>=</mo><mo>(</mo><mtable>\n{}</mtable><mo>)</mo></mrow>",
                     formula(display.left), rows);
}

/// One line, or lines that continue each other to the right of the sign.
std::string lines(const Display& display) {
  const std::string start = formula(display.left) + "<mo>=</mo>";
  if (display.texts.size() == 1) {
    return fmt::format("<mrow>{}{}</mrow>", start, formula(display.texts.front()));
  }
  std::string rows;
  for (std::size_t i = 0; i < display.texts.size(); ++i) {
    const std::string left = i == 0 ? fmt::format("<mrow>{}</mrow>", start) : "";
    rows += fmt::format("<mtr>{}{}</mtr>\n", cell(left), cell(formula(display.texts[i])));
  }
  return fmt::format("<mtable class=\"lines\">\n{}</mtable>", rows);
}

std::string html_equation(const Display& display) {
  return display.columns > 0 ? matrix(display) : lines(display);
}

}  // namespace

/// GitHub Markdown, formulas in blocks of $$.
std::string markdown_page(const Sheet& sheet) {
  const PageWords words{markdown_text, unchanged, unchanged, latex_block};
  std::string text = fill_template("pages/markdown.md.mustache", page_data(sheet, words));
  while (text.ends_with("\n\n")) text.pop_back();
  return text;
}

/// A complete document; amsmath and longtable are all it needs. Its fonts are outlines: those of
/// OT1 where lmodern is not installed, which have no <, > and |.
std::string latex_document(const Sheet& sheet) {
  const PageWords words{latex_text, latex_text, unchanged, latex_equation};
  return fill_template("pages/latex.tex.mustache", page_data(sheet, words));
}

/// One page of HTML with MathML Core, translated from the LaTeX.
std::string html_page(const Sheet& sheet) {
  const PageWords words{xml_text, xml_text, formula, html_equation};
  return fill_template("pages/mathml.html.mustache", page_data(sheet, words));
}

}  // namespace elgen
