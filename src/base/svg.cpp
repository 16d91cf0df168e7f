// Elements of pictures as text.
#include "base/svg.hpp"

#include <fmt/format.h>

namespace elgen {
namespace {

std::string escaped_for_xml(const std::string& text) {
  std::string result;
  for (const char letter : text) {
    result += letter == '&' ? "&amp;" : letter == '<' ? "&lt;" : std::string(1, letter);
  }
  return result;
}

}  // namespace

std::string svg_start(double width, double height, const std::string& title) {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
      "viewBox=\"0 0 {0} {1}\" font-family=\"sans-serif\" font-size=\"12\">\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
      "<text x=\"14\" y=\"22\" font-size=\"14\" font-weight=\"bold\">{2}</text>\n",
      width, height, escaped_for_xml(title));
}

std::string svg_grid_line(double x1, double y1, double x2, double y2) {
  return fmt::format(
      "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"#ddd\"/>\n", x1, y1,
      x2, y2);
}

std::string svg_label(double x, double y, const char* anchor, const std::string& text) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor,
                     escaped_for_xml(text));
}

std::string svg_title(double x, double y, const std::string& text) {
  return fmt::format("<text x=\"{}\" y=\"{}\" font-weight=\"bold\">{}</text>\n", x, y,
                     escaped_for_xml(text));
}

}  // namespace elgen
