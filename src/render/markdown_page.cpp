// markdown_page: a Sheet as GitHub Markdown, formulas in blocks of $$.
#include "render/page_data.hpp"

namespace elgen {
namespace {

/// One line, without what Markdown would read as markup.
std::string markdown_text(const std::string& text) {
  static const Escapes escapes{{'|', "\\|"}, {'<', "\\<"},   {'*', "\\*"}, {'_', "\\_"},
                               {'$', "\\$"}, {'\\', "\\\\"}, {'`', "\\`"}, {'\n', " "},
                               {'\r', " "},  {'\t', " "},    {'[', "\\["}, {']', "\\]"},
                               {'&', "\\&"}, {'~', "\\~"}};
  return escaped(text, escapes);
}

}  // namespace

std::string markdown_page(const Sheet& sheet) {
  const PageWords words{markdown_text, unchanged, unchanged, latex_block};
  std::string text = fill_template("pages/markdown.md.mustache", page_data(sheet, words));
  while (text.ends_with("\n\n")) text.pop_back();
  return text;
}

}  // namespace elgen
