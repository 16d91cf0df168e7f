// Every expression of bad_expressions.tsv gives the code and the column in its row, or the value to
// 20 digits, within 1 s and 256 MiB.
#include <cln/cln.h>
#include <sys/resource.h>

#include <catch2/catch.hpp>
#include <ctime>
#include <map>
#include <sstream>

#include "check/names/constants.hpp"
#include "check_testing.hpp"
#include "numbers/exact_number.hpp"

namespace elgen::test {
namespace {

struct Row {
  std::string input;
  std::string stage;
  std::string answer;
  std::string column;
  std::string value;
};

/// `input` with `\xHH` replaced by a byte, and `\<N*text>` by N copies of the text, in which # is
/// replaced by the number of the copy, from 0.
std::string expand_escapes(const std::string& input) {
  std::string result;
  for (std::size_t i = 0; i < input.size();) {
    if (input.compare(i, 2, "\\x") == 0) {
      result += static_cast<char>(std::stoi(input.substr(i + 2, 2), nullptr, 16));
      i += 4;
      continue;
    }
    if (input.compare(i, 2, "\\<") != 0) {
      result += input[i++];
      continue;
    }
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
  }
  return result;
}

std::vector<Row> read_rows() {
  std::vector<Row> rows;
  for (const std::string& line :
       split_lines(read_text(ELGEN_SOURCE_DIR "/tests/check/bad_expressions.tsv"))) {
    std::istringstream fields(line);
    std::string category;
    Row row;
    std::getline(fields, category, '\t');
    std::getline(fields, row.input, '\t');
    std::getline(fields, row.stage, '\t');
    std::getline(fields, row.answer, '\t');
    std::getline(fields, row.column, '\t');
    std::getline(fields, row.value, '\t');
    if (row.stage == "parse" || row.stage == "check") rows.push_back(row);
  }
  return rows;
}

/// A model with one [[force]] on x, whose value is `value`.
FileSyntax model_with_force(const ExpressionSyntax& value) {
  std::string text = "format = 1\n[model]\nname = \"hostile\"\n";
  std::string energy;
  for (const char* name : {"x", "y", "z", "q", "a", "b", "c", "d"}) {
    text += "[[coordinate]]\nname = \"" + std::string(name) + "\"\n";
    energy += (energy.empty() ? "" : " + ") + ("dot(" + std::string(name) + ")^2");
  }
  text += "[[force]]\non = \"x\"\nvalue = \"0\"\n[energy]\nT = \"" + energy + "\"\n";
  static const SourcePointer source = make_source("hostile.toml", text);
  FileSyntax syntax = *parse_model(source, {});
  for (EntrySyntax& entry : syntax.entries) {
    for (KeySyntax& key : entry.keys) {
      if (entry.name == "force" && key.key == "value") key.value.expression = value;
    }
  }
  return syntax;
}

/// The value of `id` at the state that bad_expressions.tsv assumes; 700 digits suffice to reduce
/// the largest angle.
EnclosedNumber value_at_state(const Model& model, ExpressionId id) {
  static const std::map<std::string, cln::cl_RA> state{
      {"x", cln::cl_RA(3) / 4}, {"y", cln::cl_RA(5) / 4}, {"z", cln::cl_RA(-1) / 2},
      {"q", cln::cl_RA(3) / 8}, {"a", cln::cl_RA(3) / 2}, {"b", cln::cl_RA(-1) / 4},
      {"c", cln::cl_RA(5) / 8}, {"d", cln::cl_RA(9) / 4}};
  const Expression& node = model.expressions[id];
  if (is_leaf(node, Opcode::coordinate)) {
    return {state.at(model.coordinates[node.index].name), 0};
  }
  std::vector<EnclosedNumber> operands;
  for (const ExpressionId operand : node.operands) {
    operands.push_back(value_at_state(model, operand));
  }
  const auto outcome = evaluate_constant(node, operands, 700);
  REQUIRE(outcome.value);
  return *outcome.value;
}

void check_value(const CheckedModel& result, const std::string& expected) {
  const cln::cl_R value =
      value_at_state(result.model, result.model.forces.front().value.front()).value;
  std::string plain = expected;
  const std::size_t e = plain.find("e+");
  if (e != std::string::npos) plain.erase(e + 1, 1);
  Limits limits;
  limits.decimal_exponent = 500;
  const auto literal = parse_expression(make_source("value", plain), limits);
  REQUIRE(literal);
  const ExpressionSyntax& number =
      literal->kind == SyntaxKind::negate ? literal->operands.front() : *literal;
  const cln::cl_RA exact = literal->kind == SyntaxKind::negate ? -number.value : number.value;
  INFO(number_text(value));
  // The table rounds to 20 digits, so the error is at most half a unit of the last digit.
  CHECK(cln::abs(value - exact) <= cln::abs(exact) * cln::expt(cln::cl_RA(10), -19) / 2);
}

TEST_CASE("hostile expressions are answered as in the table") {
  const std::vector<Row> rows = read_rows();
  REQUIRE(rows.size() == 144);
  for (const Row& row : rows) {
    INFO(row.input);
    const SourcePointer source = make_source("force", expand_escapes(row.input));
    const std::clock_t begin = std::clock();
    const auto expression = parse_expression(source, {});
    CHECK(expression.value.has_value() == (row.stage == "check"));
    const auto result = expression ? check(model_with_force(*expression), nullptr, {}, {})
                                   : Result<CheckedModel>(expression.diagnostics);
    // Processor time excludes the time of other processes.
    CHECK(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC < 1.0);
    if (row.answer == "accepted") {
      REQUIRE(result);
      check_value(*result, row.value);
      continue;
    }
    REQUIRE_FALSE(result.diagnostics.empty());
    const Diagnostic& first = result.diagnostics.front();
    CHECK(code_row(first.code).name == row.answer);
    CHECK(std::to_string(line_column(*source, first.span.begin).column) == row.column);
  }
}

#ifndef __SANITIZE_ADDRESS__  // ASan's shadow memory would count
TEST_CASE("hostile expressions take little memory") {
  const auto digits = parse_expression(make_source("test", std::string(10'000'000, '7')), {});
  REQUIRE(digits.diagnostics.size() == 1);
  CHECK(digits.diagnostics.front().code == Code::E903);
  std::string terms;
  for (int i = 0; i < 500'000; ++i) terms += "x+";
  CHECK(parse_expression(make_source("test", terms + "x"), {}));
  rusage usage{};
  REQUIRE(getrusage(RUSAGE_SELF, &usage) == 0);
  CHECK(usage.ru_maxrss < 256 * 1024);  // KiB, peak of the whole process
}
#endif

}  // namespace
}  // namespace elgen::test
