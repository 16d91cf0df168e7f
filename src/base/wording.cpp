// wording: user text for messages, counts, and suggestions.
#include "elgen/wording.hpp"

#include <algorithm>
#include <array>

#include "base/ascii.hpp"
#include "base/utf8.hpp"
#include "elgen/diagnostic.hpp"

namespace elgen {

namespace {

/// The number of insertions, deletions, substitutions and swaps of neighbours that turn `a` into
/// `b` (optimal string alignment).
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::array<std::vector<std::size_t>, 3> rows;
  for (auto& row : rows) row.assign(b.size() + 1, 0);
  for (std::size_t j = 0; j <= b.size(); ++j) rows[1][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    auto& [before, above, here] = rows;
    here[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substitution = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      here[j] = std::min({above[j] + 1, here[j - 1] + 1, substitution});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) here[j] = std::min(here[j], before[j - 2] + 1);
    }
    std::rotate(rows.begin(), rows.begin() + 1, rows.end());
  }
  return rows[1][b.size()];
}

}  // namespace

std::string quote_text(std::string_view text) {
  constexpr std::size_t longest = 60;
  std::string shown = "`";
  std::size_t position = 0;
  bool after_blank = false;
  for (std::size_t count = 0; position < text.size();) {
    const CodePoint point = code_point_at(text, position);
    if (count == longest || point.bytes == 0) return shown + "…`";
    const bool blank = is_space(text[position]);
    if (!blank || !after_blank) {
      shown += blank ? " " : visible_text(text.substr(position, point.bytes));
      ++count;
    }
    after_blank = blank;
    position += point.bytes;
  }
  return shown + "`";
}

std::string collapse_blanks(std::string_view text) {
  std::string line;
  for (const char c : text) {
    if (!is_space(c)) {
      line += c;
    } else if (!line.empty() && line.back() != ' ') {
      line += ' ';
    }
  }
  if (line.ends_with(' ')) line.pop_back();
  return line;
}

std::string break_lines(std::string_view text, std::size_t width, std::string_view indent) {
  std::string lines;
  std::size_t column = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::string_view word = text.substr(at, text.find(' ', at) - at);
    const bool fits = column + 1 + word.size() <= width;
    if (column > 0) lines += fits ? " " : "\n" + std::string(indent);
    column = (column > 0 && fits ? column + 1 : 0) + word.size();
    lines += word;
    at += word.size() + 1;
  }
  return lines;
}

std::string printable_path(std::string_view path) {
  std::string shown;
  for (std::size_t i = 0; i < path.size();) {
    const CodePoint point = code_point_at(path, i);
    const std::size_t bytes = std::max<std::size_t>(1, point.bytes);
    const bool is_seen = point.bytes != 0 && !is_hidden(point.value);
    for (const char c : path.substr(i, bytes)) {
      shown += is_seen ? std::string(1, c) : byte_name(c);
    }
    i += bytes;
  }
  return shown;
}

std::string in_backticks(const Span& span) { return quote_text(covered_text(span)); }

std::string count_text(std::size_t count, std::string_view noun) {
  return std::to_string(count) + " " + std::string(noun) + (count == 1 ? "" : "s");
}

std::string nearest_word(std::string_view word, const std::vector<std::string>& candidates) {
  constexpr std::size_t longest_word = 64;  // a longer word gets no suggestion
  if (word.empty() || word.size() > longest_word) return {};
  // The largest edit distance of a suggestion: a third of the length of the word, but at least 1.
  const std::size_t allowed = std::max<std::size_t>(1, word.size() / 3);
  std::size_t best = allowed + 1;
  std::string result;
  for (const std::string& candidate : candidates) {
    if (candidate.size() > longest_word) continue;
    const std::size_t steps = edit_distance(word, candidate);
    const bool replaces_all = steps >= std::max(word.size(), candidate.size());
    if (steps < best && !replaces_all) {
      best = steps;
      result = candidate;
    }
  }
  return result;
}

std::string suggestion(std::string_view word, const std::vector<std::string>& candidates,
                       const std::string& otherwise) {
  const std::string near = nearest_word(word, candidates);
  return near.empty() ? otherwise : "did you mean `" + near + "`?";
}

}  // namespace elgen
