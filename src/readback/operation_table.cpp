// operation_table: the words of each row, one row per function.
#include "readback/operation_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <sstream>

namespace elgen {
namespace {

constexpr std::string_view heading = "function ";
constexpr std::string_view heading_of_rewritten =
    "entries that are computed otherwise than shown, to keep digits";

using Words = std::vector<std::string>;

Words words_of(std::string_view line) {
  std::istringstream stream{std::string(line)};
  return {std::istream_iterator<std::string>(stream), {}};
}

Words words_of_operations(const Program& program, const Function& function) {
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

Words words_of_rewritten(const Function& function) {
  Words words{function.name};
  for (const std::uint32_t entry : function.rewritten) words.push_back(std::to_string(entry));
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
  std::vector<Words> expected;
  std::vector<Words> rewritten;
  for (const Function& function : program.functions) {
    expected.push_back(words_of_operations(program, function));
    if (!function.rewritten.empty()) rewritten.push_back(words_of_rewritten(function));
  }
  if (!rewritten.empty()) {
    expected.push_back(words_of(heading_of_rewritten));
    expected.insert(expected.end(), rewritten.begin(), rewritten.end());
  }
  for (const Words& row : expected) {
    if (++line == lines.end()) return {lines.back(), "no row of `" + row.front() + "`"};
    const bool is_right = words_of(line->substr(std::min(margin, line->size()))) == row;
    if (!is_right) return {*line, fmt::format("the row should be `{}`", fmt::join(row, " "))};
  }
  return {};
}

}  // namespace elgen
