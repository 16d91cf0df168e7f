// Every row of bad_expressions.tsv: the code and column it promises, within 1 s and 256 MiB.
#include <sys/resource.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <fstream>
#include <sstream>

#include "parse_testing.hpp"

namespace {

using namespace elgen;

struct TableRow {
  std::string input;
  std::string stage;
  std::string answer;
  std::string column;
};

/// `\xHH` and `\<N*text>` with # for the number of the repeat.
std::string expanded(const std::string& input) {
  std::string result;
  for (std::size_t i = 0; i < input.size();) {
    if (input.compare(i, 2, "\\x") == 0) {
      result += static_cast<char>(std::stoi(input.substr(i + 2, 2), nullptr, 16));
      i += 4;
    } else if (input.compare(i, 2, "\\<") == 0) {
      const std::size_t star = input.find('*', i);
      const std::size_t end = input.find('>', i);
      const std::string text = input.substr(star + 1, end - star - 1);
      const std::size_t hash = text.find('#');
      for (int n = 0; n < std::stoi(input.substr(i + 2)); ++n) {
        result += hash == std::string::npos
                      ? text
                      : text.substr(0, hash) + std::to_string(n) + text.substr(hash + 1);
      }
      i = end + 1;
    } else {
      result += input[i++];
    }
  }
  return result;
}

std::vector<TableRow> read_rows() {
  std::ifstream file(ELGEN_SOURCE_DIR "/tests/parse/bad_expressions.tsv");
  REQUIRE(file);
  std::vector<TableRow> rows;
  bool past_heading = false;
  for (std::string line; std::getline(file, line);) {
    if (line[0] == '#') continue;
    std::istringstream fields(line);
    std::string category;
    TableRow row;
    std::getline(fields, category, '\t');
    std::getline(fields, row.input, '\t');
    std::getline(fields, row.stage, '\t');
    std::getline(fields, row.answer, '\t');
    std::getline(fields, row.column, '\t');
    if (past_heading) rows.push_back(row);
    past_heading = true;
  }
  return rows;
}

}  // namespace

TEST_CASE("hostile expressions are answered as the table says", "[parse]") {
  const std::vector<TableRow> rows = read_rows();
  REQUIRE(rows.size() == 144);
  for (const TableRow& row : rows) {
    INFO(row.input);
    const SourcePointer source = make_source("test", expanded(row.input));
    const auto begin = std::chrono::steady_clock::now();
    const auto result = parse_expression(source, {});
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    CHECK(seconds.count() < 1.0);
    if (row.stage == "parse") {
      CHECK(testing::places(result.diagnostics) == row.answer + " 1:" + row.column);
    } else {
      CHECK(result);
    }
  }
}

#ifndef __SANITIZE_ADDRESS__  // its shadow memory counts too
TEST_CASE("hostile expressions take little memory", "[parse]") {
  const std::string digits = testing::repeated("7", 10'000'000);
  CHECK(testing::expression_answer(digits) == "E903 1:1");
  CHECK(testing::expression_answer(testing::repeated("x+", 500'000) + "x").size() > 500'000);
  rusage usage{};
  REQUIRE(getrusage(RUSAGE_SELF, &usage) == 0);
  CHECK(usage.ru_maxrss < 256 * 1024);  // KiB, peak of the whole process
}
#endif
