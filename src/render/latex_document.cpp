// latex_document: a Sheet as a complete document; amsmath and longtable are all it needs. Its fonts
// are outlines: those of OT1 where lmodern is not installed, which have no <, > and |.
#include <fmt/format.h>

#include "render/page_data.hpp"

namespace elgen {
namespace {

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

}  // namespace

std::string latex_document(const Sheet& sheet) {
  const PageWords words{latex_text, latex_text, unchanged, latex_equation};
  return fill_template("pages/latex.tex.mustache", page_data(sheet, words));
}

}  // namespace elgen
