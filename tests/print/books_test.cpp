// Textbook systems are printed as in books: every line in tests/print/books occurs in the
// derivation, symbol by symbol, except for the order of terms.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "elgen/page.hpp"
#include "elgen/pipeline.hpp"
#include "support/inputs.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// A line that is printed differently on purpose.
struct BookException {
  std::string system;
  std::string line;
  std::string reason;
};

constexpr std::size_t most_exceptions = 3;

std::vector<BookException> book_exceptions() { return {}; }

/// The position of the bracket that closes the bracket at `open`, or the end of the text.
std::size_t closing_bracket(std::string_view text, std::size_t open) {
  int depth = 0;
  for (std::size_t i = open; i < text.size(); ++i) {
    if (text[i] == '(') ++depth;
    if (text[i] == ')') --depth;
    if (depth == 0) return i;
  }
  return text.size();
}

/// A sum with sorted terms; sums in its brackets are sorted too.
std::string sum_in_order(std::string_view sum) {
  std::vector<std::string> terms{sum.starts_with('-') ? "-" : "+"};
  for (std::size_t i = sum.starts_with('-') ? 1 : 0; i < sum.size(); ++i) {
    const std::string_view next = sum.substr(i, 3);
    if (sum[i] == '(') {
      const std::size_t close = closing_bracket(sum, i);
      terms.back() += "(" + sum_in_order(sum.substr(i + 1, close - i - 1)) + ")";
      i = close;
    } else if (next == " + " || next == " - ") {
      terms.emplace_back(next.substr(1, 1));
      i += next.size() - 1;
    } else {
      terms.back() += sum[i];
    }
  }
  std::ranges::sort(terms);
  std::string text;
  for (const std::string& term : terms) text += " " + term;
  return text;
}

/// Sorts both sides of "LEFT = RIGHT". Other lines are returned unchanged.
std::string equation_in_order(const std::string& line) {
  const std::size_t equal = line.find(" = ");
  if (equal == std::string::npos) return line;
  const std::string_view text(line);
  return sum_in_order(text.substr(0, equal)) + " = " + sum_in_order(text.substr(equal + 3));
}

/// The lines of the sections "Energies" and "Equations of motion", without their indent.
std::vector<std::string> read_sections(const std::string& text) {
  std::vector<std::string> lines;
  bool is_wanted = false;
  for (const std::string& line : split_lines(text)) {
    if (!line.starts_with("  ")) is_wanted = line == "Energies" || line == "Equations of motion";
    if (is_wanted && line.starts_with("  ")) lines.push_back(line.substr(2));
  }
  return lines;
}

std::vector<std::string> book_lines(const std::filesystem::path& path) {
  std::vector<std::string> lines;
  for (const std::string& line : split_lines(read_text(path))) {
    if (!line.empty() && line[0] != '#') lines.push_back(line);
  }
  return lines;
}

std::vector<std::string> printed_lines(const std::filesystem::path& path) {
  const Products products =
      products_with(&Products::steps, {source_of(path), nullptr}, {.goals = {Goal::steps}});
  return read_sections(text_of(derivation_sections(products.checked->model, *products.steps)));
}

/// The lines of a book that the derivation does not contain.
std::vector<std::string> missing_lines(const std::vector<std::string>& book,
                                       const std::vector<std::string>& printed) {
  std::set<std::string> known;
  for (const std::string& line : printed) known.insert(equation_in_order(line));
  std::vector<std::string> missing;
  for (const std::string& line : book) {
    if (known.count(equation_in_order(line)) == 0) missing.push_back(line);
  }
  return missing;
}

/// Removes the intended exceptions. Fails if an exception has no reason or is not needed.
void drop_exceptions(const std::string& system, std::vector<std::string>& missing) {
  for (const BookException& exception : book_exceptions()) {
    if (exception.system != system) continue;
    INFO(exception.line);
    CHECK_FALSE(exception.reason.empty());
    CHECK(std::erase(missing, exception.line) == 1U);
  }
}

}  // namespace

TEST_CASE("textbook systems are printed as in books") {
  CHECK(book_exceptions().size() <= most_exceptions);
  std::string failures;
  for (const std::filesystem::path& path :
       files_in(std::filesystem::path(ELGEN_SOURCE_DIR) / "tests/print/books", ".txt")) {
    const std::vector<std::string> printed =
        printed_lines(std::filesystem::path(path).replace_extension(".toml"));
    std::vector<std::string> missing = missing_lines(book_lines(path), printed);
    drop_exceptions(path.stem().string(), missing);
    if (missing.empty()) continue;
    failures += path.stem().string() + ", the book:\n";
    for (const std::string& line : missing) failures += "  " + line + "\n";
    failures += "printed:\n";
    for (const std::string& line : printed) failures += "  " + line + "\n";
  }
  INFO(failures);
  CHECK(failures.empty());
}

TEST_CASE("terms may be in any order, factors may not") {
  CHECK(equation_in_order("a + b*c - d = 0") == equation_in_order("-d + b*c + a = 0"));
  CHECK(equation_in_order("a*(b - c)^2 = x") == equation_in_order("a*(-c + b)^2 = x"));
  CHECK(equation_in_order("a*b = 0") != equation_in_order("b*a = 0"));
  CHECK(equation_in_order("a - b = 0") != equation_in_order("a + b = 0"));
  CHECK(equation_in_order("-(a - b)*c = 0") != equation_in_order("(b - a)*c = 0"));
  CHECK(equation_in_order("a = b") != equation_in_order("b = a"));
}
