// comment_reader: heading, equation, listing, with blank lines between them. Of a listing the lines
// that continue others are joined to them, and each line is a row, an entry or a definition.
#include "readback/comment_reader.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "elgen/wording.hpp"

namespace elgen {
namespace {

constexpr std::string_view mark = "///";
constexpr std::string_view margin = "     ";
constexpr std::string_view continuation = "    ";

/// One line of a listing, put together again, and where it begins.
struct Line {
  std::string text = {};
  std::string_view place = {};
};

class CommentReader {
 public:
  CommentReader(const TokenReader& tokens, EquationReader& equations)
      : tokens_(tokens), equations_(equations), function_(equations.function()) {}

  void read(const std::vector<Line>& listing) {
    if (gives_struct(function_)) field_ = function_.fields.size();
    for (const Line& line : listing) read_line(line);
    if (!listing.empty()) expect_all_entries(listing.back());
    if (gives_struct(function_) && next_field_ < function_.fields.size()) {
      fail(listing.back(), in_backticks(function_.fields[next_field_].name) + " is missing");
    }
  }

 private:
  [[noreturn]] void fail(const Line& line, const std::string& problem) const {
    tokens_.fail(tokens_.span(line.place), problem);
  }

  void read_line(const Line& line) {
    const std::string& text = line.text;
    const std::size_t equal = text.find(" = ");
    if (text.empty()) return;
    if (text.back() == ':') return start_field(line);
    if (text.starts_with("= ")) return entry(line, text.substr(2));
    if (text.starts_with("[ ") && text.ends_with(" ]")) return row(line);
    if (equal == std::string::npos) fail(line, "no equation");
    if (text.front() == '[') return indexed(line, text.substr(0, equal), text.substr(equal + 3));
    const std::string problem =
        equations_.definition(text.substr(0, equal), text.substr(equal + 3));
    if (!problem.empty()) fail(line, problem);
  }

  void start_field(const Line& line) {
    if (field_ < function_.fields.size()) expect_all_entries(line);
    const bool is_next = gives_struct(function_) && next_field_ < function_.fields.size() &&
                         line.text == function_.fields[next_field_].name + ":";
    if (!is_next) fail(line, "another field should follow here");
    field_ = next_field_++;
    entry_ = 0;
  }

  void row(const Line& line) {
    std::vector<std::string> entries =
        split_row(std::string_view(line.text).substr(2, line.text.size() - 4));
    if (entries.size() == 1 && entries.front().empty()) entries.clear();  // a row of no columns
    for (const std::string& text : entries) entry(line, text);
    const bool is_known = field_ < function_.fields.size();
    if (!is_known || entries.size() != function_.fields[field_].columns) {
      fail(line, "a row of another length");
    }
  }

  void indexed(const Line& line, const std::string& index, const std::string& text) {
    const bool has_field = field_ < function_.fields.size();
    const std::size_t columns = has_field ? function_.fields[field_].columns : 1;
    const std::string expected = columns > 1
                                     ? fmt::format("[{}, {}]", entry_ / columns, entry_ % columns)
                                     : fmt::format("[{}]", entry_);
    if (index != expected) fail(line, fmt::format("{} instead of {}", index, expected));
    entry(line, text);
  }

  void entry(const Line& line, const std::string& text) {
    const bool is_expected =
        field_ < function_.fields.size() && entry_ < function_.fields[field_].entries.size();
    if (!is_expected) fail(line, "one entry too many");
    const std::string problem = equations_.entry(function_.fields[field_].entries[entry_], text);
    if (!problem.empty()) fail(line, problem);
    ++entry_;
  }

  void expect_all_entries(const Line& line) const {
    const bool has_field = field_ < function_.fields.size();
    if (has_field && entry_ < function_.fields[field_].entries.size()) {
      fail(line, fmt::format("entry {} is missing", entry_));
    }
  }

  const TokenReader& tokens_;
  EquationReader& equations_;
  const Function& function_;
  std::size_t field_ = 0;
  std::size_t next_field_ = 0;
  std::size_t entry_ = 0;
};

/// The comment without its marks.
std::vector<std::string_view> unmarked(const std::vector<std::string_view>& comments) {
  std::vector<std::string_view> lines;
  for (std::string_view line : comments) {
    if (line.starts_with(mark)) lines.push_back(line.substr(mark.size()));
  }
  return lines;
}

std::vector<Line> joined(const std::vector<std::string_view>& lines, std::size_t first) {
  std::vector<Line> result;
  for (std::size_t i = first; i < lines.size(); ++i) {
    std::string_view text = lines[i].substr(std::min(margin.size(), lines[i].size()));
    if (text.starts_with(continuation) && !result.empty()) {
      text.remove_prefix(text.find_first_not_of(' '));
      result.back().text += " " + std::string(text);
    } else {
      result.push_back({std::string(text), lines[i]});
    }
  }
  return result;
}

/// "1231 definitions and 294 entries: see panda7.equations.json."
bool is_reference(const std::string& text, const Function& function, const Scene& scene) {
  return text.ends_with(fmt::format(" definitions and {} entries: see {}.equations.json.",
                                    entry_count(function), scene.base_name));
}

/// The shape is a part of the heading where there is one field.
bool names_shape(const std::string& heading, const Function& function, const Scene& scene) {
  const Field& field = function.fields.front();
  if (gives_struct(function) || field.columns == 1) return true;
  const std::string shape =
      fmt::format(" {} x {}, {}", field.rows, field.columns, name_of(scene.emission.storage));
  return heading.find(shape) != std::string::npos;
}

}  // namespace

std::vector<std::string> split_row(std::string_view row) {
  std::vector<std::string> entries(1);
  int brackets = 0;
  for (const char c : row) {
    if (c == '(' || c == '[') ++brackets;
    if (c == ')' || c == ']') --brackets;
    if (c == ',' && brackets == 0) {
      entries.emplace_back();
    } else {
      entries.back() += c;
    }
  }
  for (std::string& entry : entries) {
    entry.erase(0, entry.find_first_not_of(' '));
    entry.erase(entry.find_last_not_of(' ') + 1);
  }
  return entries;
}

void read_comment(const std::vector<std::string_view>& comments, const TokenReader& tokens,
                  EquationReader& equations, const Origin& origin) {
  const Function& function = equations.function();
  const std::vector<std::string_view> lines = unmarked(comments);
  const auto heading_end = std::find(lines.begin(), lines.end(), "");
  std::string heading;
  for (auto line = lines.begin(); line != heading_end; ++line) heading += *line;
  if (lines.empty() || !names_shape(heading, function, origin.scene)) {
    const Span span = lines.empty() ? tokens.span(tokens.current()) : tokens.span(lines.front());
    tokens.fail(span, "the heading should say the shape of the result");
  }
  if (!has_equations(output_row(function.kind))) return;
  const auto equation_end =
      heading_end == lines.end() ? lines.end() : std::find(heading_end + 1, lines.end(), "");
  if (equation_end == lines.end()) tokens.fail(tokens.span(lines.back()), "no equations follow");
  const std::size_t first = static_cast<std::size_t>(equation_end - lines.begin()) + 1;
  const std::vector<Line> listing = joined(lines, first);
  if (listing.empty()) tokens.fail(tokens.span(lines.back()), "no equations follow");
  if (is_reference(listing.front().text, function, origin.scene)) return;
  CommentReader(tokens, equations).read(listing);
}

}  // namespace elgen
