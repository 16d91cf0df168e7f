// page_reader: one row of the table for each parameter of the model, fixed ones too.
#include <fmt/format.h>

#include <algorithm>

#include "elgen/wording.hpp"
#include "readback/comment_reader.hpp"
#include "readback/operation_table.hpp"
#include "readback/page_readers.hpp"
#include "readback/token_reader.hpp"

namespace elgen {
namespace {

constexpr std::string_view operations_title = "## Operations";
constexpr std::string_view parameters_title = "| parameter |";

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

bool drop_end(std::string& text, std::string_view end) {
  const bool is_there = text.ends_with(end);
  if (is_there) text.resize(text.size() - end.size());
  return is_there;
}

class PageReader {
 public:
  PageReader(const SourceText& source, const Origin& origin, EquationReader& equations)
      : source_(source), origin_(origin), equations_(equations), lines_(lines_of(source.text)) {}

  void read() {
    const std::vector<ParameterArray>& arrays = origin_.model.parameter_arrays;
    auto line = std::find_if(lines_.begin(), lines_.end(), [](std::string_view text) {
      return text.starts_with(parameters_title);
    });
    if (line == lines_.end() && !arrays.empty()) fail("", "no table of parameters");
    if (!arrays.empty()) ++line;  // what aligns the columns
    for (const ParameterArray& array : arrays) {
      if (++line == lines_.end()) fail(lines_.back(), "no row of " + in_backticks(array.name));
      parameter(*line, array);
    }
    operations();
  }

 private:
  [[noreturn]] void fail(std::string_view line, const std::string& problem) const {
    const auto begin =
        line.empty() ? 0U : static_cast<std::uint32_t>(line.data() - source_.text.data());
    throw Mistake{
        {Code::E915, {&source_, begin, begin + static_cast<std::uint32_t>(line.size())}, problem}};
  }

  /// | $l_{i}$ | `l[1..2]` | 0.3, 0.4 (fixed) | m | length |
  void parameter(std::string_view line, const ParameterArray& array) {
    const std::string name =
        array.is_array ? fmt::format("{}[1..{}]", array.name, array.count) : array.name;
    const std::string before = fmt::format(" | `{}` | ", name);
    const std::size_t start = line.find(before);
    const std::size_t value = start + before.size();
    const std::size_t end = line.find(" |", start == std::string_view::npos ? 0 : value);
    if (start == std::string_view::npos || end == std::string_view::npos) {
      fail(line, "the row should be that of " + in_backticks(name));
    }
    std::string text(line.substr(value, end - value));
    const std::string problem = wrong_values(array, text);
    if (!problem.empty()) fail(line, problem);
  }

  std::string wrong_values(const ParameterArray& array, std::string text) {
    bool is_fixed = true;
    std::vector<cln::cl_R> values;
    for (std::uint32_t i = array.first; i < array.first + array.count; ++i) {
      const auto fixed = origin_.scene.specialisation.fixed.find(i);
      const bool has_value = fixed == origin_.scene.specialisation.fixed.end();
      values.push_back(has_value ? origin_.model.parameters[i].value : fixed->second.number);
      is_fixed = is_fixed && !has_value;
    }
    if (drop_end(text, " (fixed)") != is_fixed) return "whether it is fixed";
    const bool is_uniform = drop_end(text, " each");
    std::vector<std::string> parts = split_row(text);
    if (is_uniform || parts.size() == 1) parts.resize(values.size(), parts.front());
    if (parts.size() != values.size()) return "another number of values";
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::string problem = equations_.number(values[i], parts[i]);
      if (!problem.empty()) return problem;
    }
    return {};
  }

  void operations() const {
    const auto title = std::find(lines_.rbegin(), lines_.rend(), operations_title).base();
    const auto [line, problem] = wrong_operations(
        origin_.program, {title == lines_.begin() ? lines_.end() : title, lines_.end()});
    if (!problem.empty()) fail(line, problem);
  }

  const SourceText& source_;
  const Origin& origin_;
  EquationReader& equations_;
  std::vector<std::string_view> lines_;
};

}  // namespace

void read_page(const SourceText& source, const Origin& origin, EquationReader& equations) {
  PageReader(source, origin, equations).read();
}

}  // namespace elgen
