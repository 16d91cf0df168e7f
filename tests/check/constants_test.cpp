// Numbers known when a model is checked: constants, and integer expressions of sizes and indices.
#include "check/names/constants.hpp"

#include <catch2/catch.hpp>
#include <ctime>

#include "check/names/integers.hpp"
#include "check_testing.hpp"
#include "numbers/exact_number.hpp"

namespace elgen::test {

namespace {

/// The value of the parameter c = `text`, printed as a number.
std::string parameter_value(const std::string& text) {
  const Model model = checked(block("[define]\none = \"1\"\n[parameters.c]\nvalue = \"" + text +
                                    "\"\nunit = \"1\"\n"))
                          .model;
  return number_text(model.parameters.back().value);
}

const Sizes sizes{{"n", 4}};

ExpressionSyntax parsed(const std::string& text) {
  static std::vector<SourcePointer> alive;
  alive.push_back(make_source("m.toml", text));
  auto result = parse_expression(alive.back(), {});
  REQUIRE(result);
  return *result;
}

std::string evaluated(const std::string& text) {
  IndexScope scope(sizes);
  scope.push("i", 2);
  Report report;
  const auto value = evaluate_integer(parsed(text), scope, report);
  if (value) {
    CHECK(report.error_count() == 0);
    return std::to_string(*value);
  }
  REQUIRE(report.error_count() == 1);
  const Diagnostic error = report.sorted_diagnostics().front();
  return std::string(code_row(error.code).name) + " " + std::to_string(error.span.begin + 1) + " " +
         error.message + (error.hint.empty() ? "" : " | " + error.hint);
}

RangeSyntax range(const std::string& index, const std::string& low, const std::string& high) {
  return {index, parsed(low), parsed(high), {}, {}};
}

}  // namespace

TEST_CASE("rational constants stay exact") {
  const Rows rows{
      {"0.1", "1/10"},      {"1/3 + 1/6", "1/2"},      {"2^-3", "1/8"},
      {"sqrt(4/9)", "2/3"}, {"8^(2/3)", "4"},          {"(-2)^3", "-8"},
      {"1e16+1-1e16", "1"}, {"abs(-3)", "3"},          {"min(2, 1/3)", "1/3"},
      {"sign(-7)", "-1"},   {"exp(0)", "1"},           {"log(1)", "0"},
      {"sin(0)", "0"},      {"cos(0)", "1"},           {"atan2(0, 2)", "0"},
      {"tanh(0)", "0"},     {"asin(0)", "0"},          {"log1p(0)", "0"},
      {"expm1(0)", "0"},    {"hypot(3, -4)", "5"},     {"sinc(0)", "1"},
      {"cosc(0)", "1/2"},   {"stumpff(0, 4)", "1/24"}, {"stumpff(0, -4)", "1/24"},
  };
  check_rows(rows, [&](const std::string& text) { return parameter_value(text); });
}

TEST_CASE("functions of constants are accurate to 100 digits") {
  // Expected values: 30 digits from tables.
  const Rows rows{
      {"pi", "3.14159265358979323846264338328e0"},
      {"exp(1)", "2.71828182845904523536028747135e0"},
      {"sqrt(2)", "1.41421356237309504880168872421e0"},
      {"log(2)", "6.93147180559945309417232121458e-1"},
      {"4*atan(1)", "3.14159265358979323846264338328e0"},
      {"2*asin(1)", "3.14159265358979323846264338328e0"},
      {"acos(-1)", "3.14159265358979323846264338328e0"},
      {"atan2(1, -1)", "2.35619449019234492884698253746e0"},
      {"sinh(1)", "1.17520119364380145688238185060e0"},
      {"cosh(1)", "1.54308063481524377847790562076e0"},
      {"tanh(1)", "7.61594155955764888119458282605e-1"},
      {"tan(1)", "1.55740772465490223050697480746e0"},
      {"log1p(1)", "6.93147180559945309417232121458e-1"},
      {"log1p(1e-20)", "9.99999999999999999995000000000e-21"},
      {"expm1(1e-20)", "1.00000000000000000000500000000e-20"},
      {"sinc(1)", "8.41470984807896506652502321630e-1"},
      {"cosc(1)", "4.59697694131860282599063392557e-1"},
      {"stumpff(1, 3)", "1.58529015192103493347497678370e-1"},
      {"stumpff(1, -3)", "1.75201193643801456882381850596e-1"},
      {"exp(1e-20)-1", "1.00000000000000000000500000000e-20"},
  };
  check_rows(rows, [&](const std::string& text) { return parameter_value(text); });
}

TEST_CASE("the precision of trigonometry follows the magnitude of the angle") {
  CHECK(parameter_value("sin(1e15)").substr(0, 20) == "8.582727931702358355");
  CHECK(parameter_value("sin(10^30)").substr(0, 21) == "-9.011690191213805803");
  CHECK(parameter_value("sin(1e300)").substr(0, 21) == "-9.857504251603769966");
  // sin(2 pi k + 1/2): the precision of the angle grows with its magnitude.
  CHECK(parameter_value("sin(2e30*pi + 1/2) - sin(1/2)") == "0");
}

TEST_CASE("cancellation gives an exact zero, so that a division by it is found") {
  for (const char* zero : {"sin(pi)", "cos(pi/2)", "sqrt(2)^2 - 2", "4*atan(1) - pi"}) {
    INFO(zero);
    CHECK(messages(block("V = \"x/(" + std::string(zero) + ")\"\n")).substr(0, 4) == "E312");
  }
}

TEST_CASE("an undefined constant is reported at its position") {
  const Rows rows{
      {"1/0", "E312 12:8 `0` is zero"},
      {"m/0", "E312 12:8 `0` is zero"},
      {"0^(-1)", "E312 12:6 `0` is zero"},
      {"0^0", "E313 12:6 `0^0` has no value"},
      {"log(0)", "E313 12:6 `log(0)` has no value"},
      {"m*tan(pi/2)", "E313 12:8 `tan(pi/2)` has no value"},
      {"atan2(0, 0)", "E313 12:6 `atan2(0, 0)` has no value"},
      {"log(-1)", "E314 12:6 `log(-1)` is not a real number"},
      {"sqrt(-2)", "E314 12:6 `sqrt(-2)` is not a real number"},
      {"(-8)^(1/3)", "E314 12:6 `(-8)^(1/3)` is not a real number"},
      {"asin(2)", "E314 12:6 `asin(2)` is not a real number"},
      {"acos(1.0000000001)", "E314 12:6 `acos(1.0000000001)` is not a real number"},
      {"exp(1e30)", "E914 12:6 `exp(1e30)` is beyond 10^±10000"},
      {"exp(exp(exp(10)))", "E914 12:6 `exp(exp(exp(10)))` is beyond 10^±10000"},
      {"cosh(1e9)", "E914 12:6 `cosh(1e9)` is beyond 10^±10000"},
      {"((1e300+1)^16)", "E914 12:6 `((1e300+1)^16)` has more than 4096 digits"},
      {"((10^64)^64)^64", "E914 12:6 `((10^64)^64)` has more than 4096 digits"},
  };
  for (const auto& [text, error] : rows) {
    INFO(text);
    CHECK(messages(block("V = \"" + text + "\"\n")) == error + "\n");
  }
}

TEST_CASE("values at the end of a domain belong to it") {
  CHECK(parameter_value("asin(sqrt(2)/2*sqrt(2))").substr(0, 20) == "1.570796326794896619");
  CHECK(parameter_value("acos(1)") == "0");
}

TEST_CASE("expressions in one arena are evaluated one after another") {
  Expression sum;
  sum.kind = ExpressionKind::add;
  sum.operands = {0, 1};
  std::vector<Expression> arena(2);
  arena[0].number = cln::cl_RA(1) / 2;
  arena[1].number = 3;
  arena.push_back(sum);
  ConstantValues constants;
  for (std::size_t i = 0; i < arena.size(); ++i) CHECK_FALSE(constants.evaluate_next(arena));
  REQUIRE(constants.size() == 3);
  for (ExpressionId id = 0; id < 3; ++id) REQUIRE(constants[id].has_value());
  CHECK(*constants[0] == arena[0].number);
  CHECK(*constants[1] == arena[1].number);
  CHECK(*constants[2] == cln::cl_RA(7) / 2);
}

TEST_CASE("the cost of nested angles is linear in the depth") {
  std::string text = "1";
  for (int i = 0; i < 60; ++i) text = "sin(1e9*" + text + ")";
  const std::clock_t begin = std::clock();
  CHECK(messages(block("V = \"k*x^2*" + text + "\"\n")).empty());
  // Evaluating every level twice would take 2^60 steps.
  CHECK(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC < 5.0);
}

TEST_CASE("index expressions are integer arithmetic") {
  const Rows rows{
      {"3", "3"},
      {"i", "2"},
      {"n-i", "2"},
      {"2*n+1", "9"},
      {"-i", "-2"},
      {"max(i, n)", "4"},
      {"min(i, n)", "2"},
      {"i*i*n - 1", "15"},
      {"n/2", "E318 1 `n/2` is not integer arithmetic over sizes and indices"},
      {"1/2", "E318 1 `1/2` is not integer arithmetic over sizes and indices"},
      {"0.5", "E318 1 `0.5` is not integer arithmetic over sizes and indices"},
      {"i^2", "E318 1 `i^2` is not integer arithmetic over sizes and indices"},
      {"sin(i)", "E318 1 `sin(i)` is not integer arithmetic over sizes and indices"},
      {"1 + i[2]", "E318 5 `i[2]` is not integer arithmetic over sizes and indices"},
      {"i + j", "E201 5 unknown index `j`"},
      {"1e9*1e9*1e9", "E318 1 `1e9*1e9*1e9` is not integer arithmetic over sizes and indices"},
      {"1e10", "E318 1 `1e10` is not integer arithmetic over sizes and indices"},
  };
  check_rows(rows, [&](const std::string& text) { return evaluated(text); });
}

TEST_CASE("an inner index hides an outer index only until it is popped") {
  IndexScope scope(sizes);
  scope.push("i", 1);
  scope.push("i", 7);
  CHECK(scope.find("i") == 7);
  scope.pop();
  CHECK(scope.find("i") == 1);
  CHECK_FALSE(scope.find("k"));
}

TEST_CASE("the last index runs fastest, and bounds may use earlier indices") {
  IndexScope scope(sizes);
  Report report;
  std::string order;
  const std::vector ranges{range("a", "1", "n-1"), range("b", "a", "2")};
  const bool complete = for_each_index_tuple(ranges, scope, report, [&] {
    order += std::to_string(*scope.find("a")) + std::to_string(*scope.find("b")) + " ";
    return true;
  });
  // a = 3 leaves the empty range 3..2 for b.
  CHECK_FALSE(complete);
  CHECK(order == "11 12 22 ");
  REQUIRE(report.error_count() == 1);
  CHECK(report.sorted_diagnostics().front().code == Code::E209);
  CHECK(report.sorted_diagnostics().front().message == "from 3 to 2 there is no element");
  CHECK_FALSE(scope.find("a"));
}

TEST_CASE("a repetition ends early if its body returns false") {
  IndexScope scope(sizes);
  Report report;
  int count = 0;
  const std::vector ranges{range("a", "0", "1000000000")};
  CHECK_FALSE(for_each_index_tuple(ranges, scope, report, [&] { return ++count < 3; }));
  CHECK(count == 3);
}

}  // namespace elgen::test
