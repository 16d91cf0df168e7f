// latex_document: a Sheet as a complete document; amsmath and longtable are all it needs.
#include <fmt/format.h>

#include "elgen/render.hpp"
#include "render/display.hpp"

namespace elgen {
namespace {

/// Text with what LaTeX would read as commands escaped; Unicode is left to inputenc.
std::string plain(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '\\':
        result += "\\textbackslash{}";
        break;
      case '^':
        result += "\\textasciicircum{}";
        break;
      case '~':
        result += "\\textasciitilde{}";
        break;
      case '#':
      case '$':
      case '%':
      case '&':
      case '_':
      case '{':
      case '}':
        result += '\\';
        [[fallthrough]];
      default:
        result += c;
    }
  }
  return result;
}

std::string block(const std::string& latex) { return fmt::format("\\[\n{}\n\\]\n", latex); }

/// Lines that may break across pages; `aligned` may not.
constexpr std::size_t longest_block = 10;

std::string block(const Display& display) {
  const std::string latex = latex_block(display);
  if (display.columns > 0 || display.texts.size() <= longest_block) return block(latex);
  const std::string body = latex.substr(latex.find('\n'), latex.rfind('\n') - latex.find('\n'));
  return fmt::format("\\begin{{align*}}{}\n\\end{{align*}}\n", body);
}

std::string table(const std::string& title, const std::vector<SheetVariable>& variables,
                  bool have_values) {
  if (variables.empty()) return {};
  std::string text =
      fmt::format("\\paragraph{{{}}}\n\\begin{{longtable}}[l]{{@{{}}lll{}p{{7cm}}@{{}}}}\n", title,
                  have_values ? "l" : "");
  for (const SheetVariable& v : variables) {
    const std::string value = have_values ? plain(v.value) + " & " : "";
    text += fmt::format("${}$ & \\texttt{{{}}} & {}{} & {} \\\\\n", v.symbol, plain(v.name), value,
                        plain(v.unit), plain(v.doc));
  }
  return text + "\\end{longtable}\n\n";
}

std::string section(const SheetOutput& output) {
  std::string text = fmt::format("\n\\section*{{{}}}\n", plain(output.name));
  if (!output.doc.empty()) text += plain(output.doc) + "\n";
  if (!output.definition.empty()) text += block(output.definition);
  for (const SheetEquation& equation : output.equations) {
    for (const Display& display : displays(equation)) {
      text += block(display);
    }
  }
  return text;
}

}  // namespace

std::string latex_document(const Sheet& sheet) {
  std::string text =
      "\\documentclass[a4paper]{article}\n"
      "\\usepackage[T1]{fontenc}\n"
      "\\usepackage[margin=2cm]{geometry}\n"
      "\\usepackage{amsmath}\n"
      "\\usepackage{longtable}\n"
      "\\allowdisplaybreaks\n"
      "\\setlength{\\parindent}{0pt}\n"
      "\\begin{document}\n";
  text += fmt::format("{{\\Large\\bfseries {}}}\n\n", plain(sheet.title));
  if (!sheet.description.empty()) text += plain(sheet.description) + "\n\n";
  if (!sheet.reference.empty()) text += plain(sheet.reference) + "\n\n";
  for (const std::string& note : sheet.notes) text += plain(note) + "\n\n";
  text += block(sheet.equation_of_motion);
  text += table("Coordinates", sheet.coordinates, false);
  text += table("Inputs", sheet.inputs, false);
  text += table("Parameters", sheet.parameters, true);
  for (const SheetOutput& output : sheet.outputs) text += section(output);
  return text + "\\end{document}\n";
}

}  // namespace elgen
