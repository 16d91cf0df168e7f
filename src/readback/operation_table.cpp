// operation_table: the words of each row, one row per function.
#include "readback/operation_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <sstream>

namespace elgen {
namespace {

constexpr std::string_view heading = "function ";

using Words = std::vector<std::string>;

Words words_of(std::string_view line) {
  std::istringstream stream{std::string(line)};
  return {std::istream_iterator<std::string>(stream), {}};
}

Words expected_words(const Program& program, const Function& function) {
  const OperationCounts n = count_operations(function);
  const std::vector<std::string> names = temporary_names(program, function);
  const auto unnamed = std::count(names.begin(), names.end(), std::string());
  Words words{function.name};
  for (const std::size_t count : {n.add, n.mul, n.div, n.sqrt, n.sincos, n.other,
                                  names.size() - static_cast<std::size_t>(unnamed)}) {
    words.push_back(std::to_string(count));
  }
  words.emplace_back(name_of(function.form));
  return words;
}

}  // namespace

WrongLine wrong_operations(const Program& program, const std::vector<std::string_view>& lines) {
  const Words columns{"function", "add",   "mul",         "div", "sqrt",
                      "sincos",   "other", "definitions", "form"};
  auto line = std::find_if(lines.begin(), lines.end(), [&](std::string_view text) {
    const std::size_t start = text.find_first_not_of("/ ");
    return start != std::string_view::npos && words_of(text.substr(start)) == columns;
  });
  if (line == lines.end()) return {lines.empty() ? "" : lines.front(), "no table of operations"};
  const std::size_t margin = line->find(heading);
  for (const Function& function : program.functions) {
    if (++line == lines.end()) return {lines.back(), "no row of `" + function.name + "`"};
    const Words expected = expected_words(program, function);
    const bool is_right = line->size() > margin && words_of(line->substr(margin)) == expected;
    if (!is_right) return {*line, fmt::format("the row should be `{}`", fmt::join(expected, " "))};
  }
  return {};
}

}  // namespace elgen
