// unit_text: one pass over the text of the model, which units are kept in as written.
#include "render/unit_text.hpp"

#include <algorithm>

namespace elgen {

std::string unit_text(std::string unit, std::string_view times,
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

}  // namespace elgen
