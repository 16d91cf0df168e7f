// read_comments. A comment consists of a heading, an equation and a listing, separated by blank
// lines. Continuation lines of a listing are joined first; each line is then a row, an entry or a
// definition.
#include <fmt/format.h>

#include <algorithm>

#include "elgen/wording.hpp"
#include "emit/interface/code_interface.hpp"
#include "support/text.hpp"
#include "texts/readers.hpp"

namespace elgen::test {
namespace {

using Lines = std::vector<std::string>;

constexpr std::string_view mark = "///";
constexpr std::string_view margin = "     ";
constexpr std::string_view continuation = "    ";

/// Splits at commas outside brackets, and trims.
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

class CommentReader {
 public:
  explicit CommentReader(WrittenEquations& equations)
      : equations_(equations), function_(equations.function()) {}

  void read(const Lines& listing) {
    if (returns_struct(function_)) field_ = function_.fields.size();
    for (const std::string& line : listing) read_line(line);
    if (!listing.empty()) expect_all_entries(listing.back());
    if (returns_struct(function_) && next_field_ < function_.fields.size()) {
      fail(listing.back(), quote_text(function_.fields[next_field_].name) + " is missing");
    }
  }

 private:
  [[noreturn]] void fail(const std::string& line, const std::string& problem) const {
    throw Mistake(fmt::format("`{}`: {}: {}", function_.name, line, problem));
  }

  void read_line(const std::string& line) {
    const std::size_t equal = line.find(" = ");
    if (line.empty()) return;
    if (line.back() == ':') return start_field(line);
    if (line.starts_with("= ")) return entry(line, line.substr(2));
    if (line.starts_with("[ ") && line.ends_with(" ]")) return row(line);
    if (equal == std::string::npos) fail(line, "no equation");
    if (line.front() == '[') return indexed(line, line.substr(0, equal), line.substr(equal + 3));
    const std::string problem =
        equations_.definition(line.substr(0, equal), line.substr(equal + 3));
    if (!problem.empty()) fail(line, problem);
  }

  void start_field(const std::string& line) {
    if (field_ < function_.fields.size()) expect_all_entries(line);
    const bool is_next = returns_struct(function_) && next_field_ < function_.fields.size() &&
                         line == function_.fields[next_field_].name + ":";
    if (!is_next) fail(line, "another field should follow here");
    field_ = next_field_++;
    entry_ = 0;
  }

  void row(const std::string& line) {
    std::vector<std::string> entries = split_row(std::string_view(line).substr(2, line.size() - 4));
    if (entries.size() == 1 && entries.front().empty()) entries.clear();  // a row without columns
    for (const std::string& text : entries) entry(line, text);
    const bool is_known = field_ < function_.fields.size();
    if (!is_known || entries.size() != function_.fields[field_].columns) {
      fail(line, "a row of another length");
    }
  }

  void indexed(const std::string& line, const std::string& index, const std::string& text) {
    const bool has_field = field_ < function_.fields.size();
    const std::size_t columns = has_field ? function_.fields[field_].columns : 1;
    const std::string expected = columns > 1
                                     ? fmt::format("[{}, {}]", entry_ / columns, entry_ % columns)
                                     : fmt::format("[{}]", entry_);
    if (index != expected) fail(line, fmt::format("{} instead of {}", index, expected));
    entry(line, text);
  }

  void entry(const std::string& line, const std::string& text) {
    const bool is_expected =
        field_ < function_.fields.size() && entry_ < function_.fields[field_].entries.size();
    if (!is_expected) fail(line, "one entry too many");
    const std::string problem = equations_.entry(function_.fields[field_].entries[entry_], text);
    if (!problem.empty()) fail(line, problem);
    ++entry_;
  }

  void expect_all_entries(const std::string& line) const {
    const bool has_field = field_ < function_.fields.size();
    if (has_field && entry_ < function_.fields[field_].entries.size()) {
      fail(line, fmt::format("entry {} is missing", entry_));
    }
  }

  WrittenEquations& equations_;
  const Function& function_;
  std::size_t field_ = 0;
  std::size_t next_field_ = 0;
  std::size_t entry_ = 0;
};

/// The lines of the listing from `first` on, with continuation lines joined.
Lines join_continuations(const Lines& comment, std::size_t first) {
  Lines result;
  for (std::size_t i = first; i < comment.size(); ++i) {
    std::string text = comment[i].substr(std::min(margin.size(), comment[i].size()));
    if (text.starts_with(continuation) && !result.empty()) {
      result.back() += " " + text.substr(text.find_first_not_of(' '));
    } else {
      result.push_back(std::move(text));
    }
  }
  return result;
}

/// True for "1231 definitions and 294 entries: see panda7.equations.json."
bool is_reference(const std::string& text, const Function& function, const Scene& scene) {
  return text.ends_with(fmt::format(" definitions and {} entries: see {}.equations.json.",
                                    entry_count(function), scene.base_name));
}

/// True if the heading contains the shape. A struct or a single column needs no shape.
bool names_shape(const std::string& heading, const Function& function, const Scene& scene) {
  const Field& field = function.fields.front();
  if (returns_struct(function) || field.columns == 1) return true;
  const std::string shape =
      fmt::format(" {} x {}, {}", field.rows, field.columns, name_of(scene.emission.storage));
  return mentions(heading, shape);
}

/// The comment lines directly above the definition of a function, without the comment marks.
Lines comment_above(const std::string& header, const std::string& name) {
  Lines comment;
  std::string code;
  std::size_t start = 0;
  while (start < header.size()) {
    const std::size_t end = std::min(header.find('\n', start), header.size());
    const std::string line = header.substr(start, end - start);
    start = end + 1;
    if (line.starts_with(mark)) {
      if (!code.empty()) comment.clear();
      code.clear();
      comment.push_back(line.substr(mark.size()));
      continue;
    }
    code += line + "\n";
    if (comment.empty() || !mentions(line, "{")) continue;
    if (mentions(code, " " + name + "(")) return comment;
    comment.clear();
  }
  throw Mistake(quote_text(name) + " has no comment");
}

void read_comment(const Lines& comment, WrittenEquations& equations) {
  const Function& function = equations.function();
  const Scene& scene = equations.origin().scene;
  const auto heading_end = std::ranges::find(comment, "");
  std::string heading;
  for (auto line = comment.begin(); line != heading_end; ++line) heading += *line;
  if (!names_shape(heading, function, scene)) {
    throw Mistake(quote_text(function.name) + ": the heading says another shape");
  }
  if (!has_equations(output_row(function.kind))) return;
  const auto equation_end =
      heading_end == comment.end() ? comment.end() : std::find(heading_end + 1, comment.end(), "");
  if (equation_end == comment.end()) throw Mistake(function.name + ": no equations follow");
  const Lines listing =
      join_continuations(comment, static_cast<std::size_t>(equation_end - comment.begin()) + 1);
  if (listing.empty()) throw Mistake(function.name + ": no equations follow");
  if (is_reference(listing.front(), function, scene)) return;
  CommentReader(equations).read(listing);
}

}  // namespace

void read_comments(const std::string& header, WrittenEquations& equations) {
  const auto& [model, scene, program] = equations.origin();
  const bool is_c = scene.emission.language != LanguageId::cpp;
  const std::string prefix = is_c ? name_space(scene) + "_" : "";
  for (std::size_t i = 0; i < program.functions.size(); ++i) {
    equations.start(i);
    read_comment(comment_above(header, prefix + program.functions[i].name), equations);
  }
}

}  // namespace elgen::test
