// Limits of the prose of pages: columns of a line, columns of a cell, mean words of a sentence.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cctype>
#include <sstream>

#include "formula/drawing.hpp"
#include "pages/page.hpp"
#include "support/text.hpp"

namespace elgen::test {

namespace {

// Two pages stand side by side on a screen of 240 columns.
constexpr std::size_t most_columns = 120;
// Readers expect one line in a cell; GitHub wraps longer cells to paragraphs.
constexpr std::size_t most_of_a_cell = 160;
// Sentences of more words on average are difficult to read (Plain English Campaign: 15 to 20).
constexpr double most_words = 25;

bool is_row(const std::string& line) { return starts_with(line, "|"); }

/// The cells of a row, without the blanks around them.
std::vector<std::string> cells(const std::string& row) {
  static const std::regex around(R"(^\s+|\s+$)");
  std::vector<std::string> all;
  std::istringstream stream(std::regex_replace(row, std::regex(R"(\\\|)"), "/"));
  for (std::string cell; std::getline(stream, cell, '|');) {
    all.push_back(std::regex_replace(cell, around, ""));
  }
  return all;
}

/// Paragraphs and items of lists, each on one line: no headings, no tables.
std::vector<std::string> paragraphs(const std::string& prose) {
  static const std::regex item(R"(^\s*([-*]|\d+\.) )");
  std::vector<std::string> all(1);
  for (const std::string& line : split_lines(prose)) {
    const bool is_text = !line.empty() && line[0] != '#' && !is_row(line);
    if (!is_text || std::regex_search(line, item)) all.emplace_back();
    if (is_text) all.back() += std::regex_replace(line, item, "") + " ";
  }
  return all;
}

/// The sentences of the paragraphs. A sentence ends at ".", "?" or "!" if a blank follows, never at
/// a colon. A code span `a b.c` becomes the word "code"; the target of a link is removed.
std::vector<std::string> sentences(const std::string& prose) {
  static const std::regex code("`[^`]*`");
  static const std::regex target(R"(\]\([^)]*\))");
  static const std::regex end(R"([.?!]\)?\s+)");
  std::vector<std::string> all;
  for (const std::string& paragraph : paragraphs(prose)) {
    const std::string text =
        std::regex_replace(std::regex_replace(paragraph, code, "code"), target, "]");
    for (std::sregex_token_iterator i(text.begin(), text.end(), end, -1), last; i != last; ++i) {
      if (i->length() > 0) all.push_back(*i);
    }
  }
  return all;
}

std::size_t column_words(const std::string& sentence) {
  std::istringstream stream(sentence);
  std::size_t words = 0;
  for (std::string word; stream >> word;) words += std::isalnum(word.front()) != 0 ? 1 : 0;
  return words;
}

double mean_words(const std::string& prose) {
  const std::vector<std::string> all = sentences(prose);
  double words = 0;
  for (const std::string& sentence : all) words += static_cast<double>(column_words(sentence));
  return all.empty() ? 0 : words / static_cast<double>(all.size());
}

}  // namespace

TEST_CASE("sentences of a page are counted as a reader counts them") {
  CHECK(sentences("One two. Three `a. b` four:\nfive.\n\n- six [seven](x.md)\n").size() == 3);
  CHECK(sentences("# heading\n| cell. cell |\n").empty());
  CHECK(column_words("x^2 is `code` of 3 words - here") == 6);
  CHECK(mean_words("One two three. One.") == 2);
}

TEST_CASE("lines of pages have at most 120 columns, and cells 160 characters") {
  for (const Page& page : pages()) {
    INFO(page.path);
    for (const std::string& line : split_lines(page.prose)) {
      INFO(line);
      if (!is_row(line)) CHECK(terminal_width(line) <= most_columns);
      if (!is_row(line)) continue;
      for (const std::string& cell : cells(line)) CHECK(terminal_width(cell) <= most_of_a_cell);
    }
  }
}

TEST_CASE("sentences of a page have at most 25 words on average") {
  for (const Page& page : pages()) {
    INFO(page.path);
    CHECK(mean_words(page.prose) <= most_words);
  }
}

}  // namespace elgen::test
