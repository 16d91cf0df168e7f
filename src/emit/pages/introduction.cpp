// introduction: title, equation of motion and variables, at the top of a header.
#include "emit/pages/introduction.hpp"

#include <fmt/ranges.h>

#include <algorithm>

#include "elgen/page.hpp"
#include "emit/text/layout.hpp"

namespace elgen {
namespace {

using Lines = std::vector<std::string>;

void add_prose(Lines& lines, const std::string& text) {
  if (text.empty()) return;
  for (const std::string& line : wrap_words(text, {line_width - 3, ""}))
    lines.push_back(" " + line);
}

}  // namespace

std::vector<std::string> introduction(const Model& model, const Scene& scene,
                                      const Program& program) {
  Lines lines;
  add_prose(lines, comment_text(model.title));
  add_prose(lines, comment_text(model.description));
  add_prose(lines, comment_text(model.reference));
  if (!lines.empty()) lines.emplace_back();
  lines.push_back("   " + text_of(equation_of_motion(model, program)));
  lines.emplace_back();
  for (const std::string& line : variable_lines(model, program)) lines.push_back("   " + line);
  const Lines notes = scene_notes(model, scene);
  if (!notes.empty()) lines.emplace_back();
  for (const std::string& note : notes) add_prose(lines, comment_text(note));
  return lines;
}

std::vector<std::string> operation_table(const Program& program) {
  std::size_t width = std::string_view("function").size();
  for (const Function& function : program.functions) width = std::max(width, function.name.size());
  constexpr std::string_view row = "{:<{}}  {:>6} {:>6} {:>5} {:>5} {:>6} {:>5}  {:>11}  {}";
  Lines lines = {fmt::format(row, "function", width, "add", "mul", "div", "sqrt", "sincos", "other",
                             "definitions", "form")};
  Lines rewritten;
  for (const Function& function : program.functions) {
    const OperationCounts n = count_operations(function);
    const std::vector<std::string> names = temporary_names(program, function);
    const auto unnamed = std::count(names.begin(), names.end(), std::string());
    lines.push_back(fmt::format(row, function.name, width, n.add, n.mul, n.div, n.sqrt, n.sincos,
                                n.other, names.size() - static_cast<std::size_t>(unnamed),
                                name_of(function.form)));
    if (function.rewritten.empty()) continue;
    rewritten.push_back(
        fmt::format("{:<{}}  {}", function.name, width, fmt::join(function.rewritten, " ")));
  }
  if (rewritten.empty()) return lines;
  lines.emplace_back("entries with another formula than shown, which keeps digits");
  lines.insert(lines.end(), rewritten.begin(), rewritten.end());
  return lines;
}

}  // namespace elgen
