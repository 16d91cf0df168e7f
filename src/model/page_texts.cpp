// Titles, symbols and units in the characters of pages.
#include <algorithm>

#include "base/ascii.hpp"
#include "formula/drawing.hpp"
#include "model/symbols.hpp"

namespace elgen {

std::string format_unit(std::string unit, std::string_view times,
                        std::string (*exponent_text)(const std::string& exponent)) {
  std::erase(unit, ' ');
  std::string text;
  for (std::size_t i = 0; i < unit.size(); ++i) {
    const std::size_t begin = i + 1;
    if (unit[i] == '*') {
      text += times;
    } else if (unit[i] == '^' && unit[std::min(begin, unit.size() - 1)] == '(') {
      i = std::min(unit.find(')', begin), unit.size());
      text += exponent_text(unit.substr(begin + 1, i - begin - 1));
    } else if (unit[i] == '^') {
      i = std::min(unit.find_first_not_of("-0123456789", begin), unit.size());
      text += exponent_text(unit.substr(begin, i - begin));
      --i;
    } else {
      text += unit[i];
    }
  }
  return text;
}

std::string unicode_text(const Glyphs& glyphs) {
  const TextBlock block = draw_glyphs(glyphs, Alphabet::unicode, FractionStyle::in_line);
  return block.lines[block.base];
}

std::string unicode_text(const Formula& formula) { return unicode_text(glyphs_of(formula)); }

std::string unicode_unit(const std::string& unit) {
  return unit == "1" ? "" : format_unit(unit, " ", small_exponent);
}

std::string title_from_name(std::string name) {
  std::ranges::replace(name, '_', ' ');
  if (!name.empty()) name[0] = to_upper_case(name[0]);
  return name;
}

std::string page_title(const Model& model) {
  return model.title.empty() ? title_from_name(model.name) : model.title;
}

}  // namespace elgen
