#include "forms/write/closed_graph.hpp"

#include <catch2/catch.hpp>

#include "elgen/page.hpp"
#include "program/network/linearise.hpp"
#include "program/network/network.hpp"
#include "program/read_program.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// The only entry of `function`, written in `layout`, as text.
std::string written_text(const std::string& function, Layout layout) {
  const Program program = read_program("parameters m l\ncoordinates x y\n" + function);
  const ClosedForms forms = present(program);
  Expressions expressions;
  const auto value =
      build_closed_graph(expressions.graph, forms.algebra,
                         *forms.functions.at(0).fields.at(0).entries.at(0), layout, 100);
  REQUIRE(value);
  expressions.values.push_back(*value);
  Program result;
  result.leaves = program.leaves;
  Function filled = program.functions[0];
  filled.instructions.clear();
  filled.names.clear();
  filled.fields[0].entries = {0};
  linearise(make_network(expressions), result, filled);
  const std::vector<std::string> names = temporary_names(result, filled);
  return text_of(function_equations(result, filled, names).entries.at(0).at(0));
}

const std::string two_rates =
    "function bias\n  0 = parameter m\n  1 = velocity x\n  2 = multiply 0 1\n  3 = parameter l\n"
    "  4 = multiply 3 1\n  5 = velocity y\n  6 = add 4 5\n  7 = add 2 6\n  result 1 1 = 7\n";

}  // namespace

TEST_CASE("terms are grouped by their rates") {
  CHECK(written_text(two_rates, {std::nullopt, Grouping::none}) == "m*dot(x) + l*dot(x) + dot(y)");
  CHECK(written_text(two_rates, {std::nullopt, Grouping::by_rates}) == "(m + l)*dot(x) + dot(y)");
}

TEST_CASE("a common denominator divides the sum of its terms") {
  const std::string text =
      "function bias\n  0 = coordinate x\n  1 = coordinate y\n  2 = parameter l\n"
      "  3 = divide 0 2\n  4 = multiply 2 2\n  5 = divide 1 4\n  6 = add 3 5\n"
      "  result 1 1 = 6\n";
  CHECK(written_text(text, {}) == "(y + l*x)/l^2");
}

TEST_CASE("more terms than the limit give no graph") {
  const Program program = read_program("parameters m l\ncoordinates x y\n" + two_rates);
  const ClosedForms forms = present(program);
  Graph graph;
  CHECK_FALSE(
      build_closed_graph(graph, forms.algebra, *forms.functions[0].fields[0].entries[0], {}, 2));
}
