// Lowering a Graph to a Function: the network, shared operations, signs, instructions, and the
// cheapest form.
#include "program/network/network.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "elgen/evaluate.hpp"
#include "program/expression_leaves.hpp"
#include "program/network/cheapest.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

Network network_of(const Texts& texts) { return make_network(expressions_of(texts)); }

std::size_t cheapest_cost(const Texts& texts) {
  Function unfilled;
  Field field;
  for (std::uint32_t i = 0; i < texts.size(); ++i) field.entries.push_back(i);
  unfilled.fields = {field};
  return cost(counts_of(cheapest_network(expressions_of(texts), unfilled)));
}

}  // namespace

TEST_CASE("powers are repeated factors, and denominators form one division") {
  const Network network = network_of({"a^2*b*c^(-1)*d^(-2)"});
  CHECK(texts_of(network) == Texts{"a^2*b/(c*d^2)"});
  CHECK(counts_of(network) == OperationCounts{.mul = 4, .div = 1});
  // A divisor that two products share becomes a reciprocal.
  CHECK(counts_of(network_of({"a*c^(-1)", "b*c^(-1)"})) == OperationCounts{.mul = 2, .div = 1});
  // High powers use repeated squaring: a * ((a^2)^2)^3.
  CHECK(counts_of(network_of({"a^13"})).mul == 5);
  CHECK(texts_of(network_of({"a^13"})) == Texts{"a^13"});
}

TEST_CASE("the constants of a sum or product are folded into one number") {
  const Network network = network_of({"2*pi*cos(1)*a", "2 - pi + a", "-(1 - exp(2))"});
  CHECK(counts_of(network) == OperationCounts{.add = 1, .mul = 1});
  CHECK(texts_of(network) == Texts{"2*pi*cos(1)*a", "a - (-2 + pi)", "-1 + exp(2)"});
  // A constant without a value remains an operation.
  CHECK(texts_of(network_of({"2*log(-1)*a"})) == Texts{"2*log(-1)*a"});
}

TEST_CASE("a function of a number stays a call beside the same function of a sum with it") {
  struct LiteralRow {
    const char* what;
    Texts texts;
    bool stays;
  };
  const LiteralRow row = GENERATE(values<LiteralRow>({
      {"a difference", {"cos(a - 7/10)*cos(b) - cos(7/10)"}, true},
      {"factors of the call", {"3*exp(a + 3/10)*b - 3*exp(3/10)"}, true},
      {"the sign of the number, without parity", {"exp(-3/10) - exp(a - 3/10)"}, true},
      {"a root", {"sqrt(a + 3/10)*b - sqrt(3/10)"}, true},
      {"two arguments", {"atan2(a + 3/10, b + 1/2) - atan2(3/10, 1/2)"}, true},
      {"one argument is the number", {"atan2(a + 3/10, 1/2) - atan2(3/10, 1/2)"}, true},
      {"a multiple of pi", {"log(a + b + pi/7) - log(pi/7)"}, true},
      {"a number of two terms", {"log(a + pi + 1/7) - log(pi + 1/7)"}, true},
      {"calls in functions", {"sqrt(2 - 2*cos(a - 7/10)) - sqrt(2 - 2*cos(7/10))"}, true},
      {"calls in brackets", {"(cos(a - 7/10) + b)*c - cos(7/10)"}, true},
      {"another function", {"sin(a - 7/10)*cos(b) - cos(7/10)"}, false},
      {"another number", {"cos(a - 3/10)*cos(b) - cos(7/10)"}, false},
      {"another sign", {"exp(a + 3/10) - exp(-3/10)"}, false},
      {"a further number", {"exp(a + 3/10 + pi) - exp(3/10)"}, false},
      {"another sum", {"cos(a - 7/10)*cos(b)", "cos(7/10)*c + d"}, false},
      {"the same term", {"cos(a - 7/10)*cos(7/10) + c"}, false},
  }));
  INFO(row.what);
  const auto has_function = [](const Constant& constant) {
    return text_of(constant.form).find('(') != std::string::npos;
  };
  const Expressions expressions = expressions_of(row.texts);
  for (const NumberJoining numbers : {NumberJoining::unjoined, NumberJoining::joined}) {
    const Network network = make_network(expressions, numbers);
    CHECK(std::ranges::none_of(network.constants, has_function) == row.stays);
    CHECK(find_invariant_violation(program_of(network)) == "");
  }
}

TEST_CASE("a call of a number is written and counted as the number") {
  const Network network = network_of({"exp(3/10) - exp(a + 3/10)"});
  CHECK(texts_of(network) == Texts{"exp(3/10) - exp(3/10 + a)"});
  CHECK(counts_of(network) == OperationCounts{.add = 2, .other = 1});
}

TEST_CASE("a constant has one form, even if its parts are shared") {
  const Texts texts =
      texts_of(network_of({"(4 + pi) + (40 - cos(4 + pi)) + a", "(4 + pi)*b",
                           "(40 - cos(4 + pi))*c", "pi + (40 - cos(4 + pi)) + (4 + pi) + d"}));
  CHECK(texts[0] == "44 + pi - cos(4 + pi) + a");
  CHECK(texts[3] == "44 + 2*pi - cos(4 + pi) + d");
}

TEST_CASE("joined numbers: factors of a sum move into it and merge with its numbers") {
  struct JoinedRow {
    const char* what;
    const char* text;
    OperationCounts apart;
    OperationCounts joined;
  };
  const JoinedRow row = GENERATE(values<JoinedRow>({
      {"a number that meets another", "3*a - 2*(sin(1)*b - cos(1)*a)", {2, 4}, {1, 2}},
      {"a number of a product", "2/3*(sin(1)*b - cos(1)*a)*c", {1, 4}, {1, 3}},
      {"numbers of sums in sums", "5*(sqrt(2)*(sqrt(2)*a + pi*b) + pi*c) + a", {3, 5}, {2, 3}},
      {"one term may be without", "7/10*(a + sqrt(2)*b) + pi*b", {2, 3}, {1, 2}},
      {"a number in a sum", "3/7*(sqrt(2) + pi*a) + b", {2, 2}, {2, 1}},
      {"a difference that may cancel stays", "pi*(a - b)", {1, 1}, {1, 1}},
      {"so do exact multiples", "pi*(2*a - 3/4*b)", {1, 3}, {1, 3}},
  }));
  INFO(row.what);
  const Expressions expressions = expressions_of({row.text});
  const Network apart = make_network(expressions);
  const Network joined = make_network(expressions, NumberJoining::joined);
  CHECK(counts_of(apart) == row.apart);
  CHECK(counts_of(joined) == row.joined);
  const Program before = program_of(apart);
  const Program after = program_of(joined);
  CHECK(find_invariant_violation(after) == "");
  Arguments<double> arguments;
  arguments.q = {2, 3, 5, 7, 11};
  CHECK(evaluate(after, after.functions[0], arguments)[0] ==
        Approx(evaluate(before, before.functions[0], arguments)[0]).epsilon(1e-14));
}

TEST_CASE("joined numbers: a sum with other users stays, and so does its factor") {
  const Expressions shared =
      expressions_of({"3*a - 2*(sin(1)*b - cos(1)*a)", "c*(sin(1)*b - cos(1)*a)"});
  CHECK(counts_of(make_network(shared, NumberJoining::joined)) == counts_of(make_network(shared)));
}

TEST_CASE("operations follow their operands in canonical order") {
  const Network network = network_of({"e + d*c + a"});
  std::vector<std::uint32_t> leaves;
  for (NodeId id = 0; id < network.operations.size(); ++id) {
    const Operation& operation = network.operations[id];
    if (operation.kind == OperationKind::leaf) leaves.push_back(operation.index);
    for (const SignedNode operand : operation.operands) CHECK(operand.node < id);
  }
  CHECK(leaves == std::vector<std::uint32_t>{0, 4, 2, 3});
}

TEST_CASE("common sub-sums and sub-products are computed once without changing values") {
  struct SharedRow {
    Texts texts;
    std::size_t add;
    std::size_t mul;
  };
  const SharedRow row = GENERATE(values<SharedRow>({
      {{"a*b*c", "a*b*d", "a*b*e"}, 0, 4},
      // Sums 1 and 3 share b - c, sums 2 and 3 share c - d. Sum 3 has one c and uses one pair only.
      {{"a + b - c", "b + c - d", "-b - d + c + e"}, 6, 0},
      // If a whole operation equals the shared pair, the other operations use its value.
      {{"a*c", "a*b*c"}, 0, 2},
      {{"a^2", "a^2*b", "a^4"}, 0, 3},
      {{"a*b + c - d", "d - a*b + e", "c - d + a*b + e", "(a*b)*c*d"}, 4, 3},
  }));
  Network network = network_of(row.texts);
  const Program before = program_of(network);
  eliminate_common_subexpressions(network);
  const Program after = program_of(network);
  CHECK(find_invariant_violation(after) == "");
  CHECK(counts_of(network) == OperationCounts{.add = row.add, .mul = row.mul});
  Arguments<double> arguments;
  arguments.q = {2, 3, 5, 7, 11};  // with integers every order of evaluation is exact
  CHECK(evaluate(before, before.functions[0], arguments) ==
        evaluate(after, after.functions[0], arguments));
}

TEST_CASE("long sums are shared only with neighbouring sums") {
  Network network;
  std::vector<SignedNode> terms;
  for (std::uint32_t i = 0; i < 200; ++i) {
    network.operations.push_back(
        {.kind = OperationKind::leaf, .leaf = Opcode::coordinate, .index = i});
    terms.push_back({i});
  }
  network.operations.push_back({.kind = OperationKind::sum, .operands = terms});
  terms.back().is_negative = true;
  network.operations.push_back({.kind = OperationKind::sum, .operands = terms});
  network.values = {{200}, {201}};
  eliminate_common_subexpressions(network);
  CHECK(counts_of(network).add == 200);
}

TEST_CASE("turn_signs: a value needed only negated is computed negated") {
  struct TurnedRow {
    const char* what;
    Texts before;
    Texts after;
  };
  const TurnedRow row = GENERATE(values<TurnedRow>({
      {"a difference", {"-(a - b)", "-(a - b)"}, {"b - a", "b - a"}},
      {"a difference among factors",
       {"-(c*(a - b))", "-(d*(c - e)^(-1))"},
       {"c*(b - a)", "d/(e - c)"}},
      {"arguments; terms of a sum need not be",
       {"exp(b - a)", "a - b*(c - d)"},
       {"exp(b - a)", "a - b*(c - d)"}},
      {"nothing that something else needs positive, or that has no difference",
       {"-(a - b)", "a - b", "-(c*(a - b))", "-(a + d)", "-sin(a)"},
       {"-(a - b)", "a - b", "-c*(a - b)", "-(a + d)", "-sin(a)"}},
  }));
  INFO(row.what);
  Network network = network_of(row.before);
  flip_signs(network);
  CHECK(find_invariant_violation(program_of(network)) == "");
  CHECK(texts_of(network) == row.after);
}

TEST_CASE("linearise: operands precede their users, terms and factors from left to right") {
  CHECK(dump(program_of(network_of({"a - b + c*d"}))) ==
        "coordinates a b c d e\n"
        "function bias\n"
        "  0 = coordinate a\n"
        "  1 = coordinate b\n"
        "  2 = coordinate c\n"
        "  3 = coordinate d\n"
        "  4 = multiply 2 3\n"
        "  5 = subtract 0 1\n"
        "  6 = add 5 4\n"
        "  result 1 1 = 6\n");
}

TEST_CASE("linearise: signs become subtractions, or negations without a minuend") {
  CHECK(dump(program_of(network_of({"-(a*b)", "exp(-a)", "sqrt(-b)"}))) ==
        "coordinates a b c d e\n"
        "function bias\n"
        "  0 = coordinate a\n"
        "  1 = coordinate b\n"
        "  2 = multiply 0 1\n"
        "  3 = negate 2\n"
        "  4 = negate 0\n"
        "  5 = exp 4\n"
        "  6 = negate 1\n"
        "  7 = square_root 6\n"
        "  result 1 3 = 3 5 7\n");
}

TEST_CASE("linearise: a sum starts with its first positive term, if any") {
  Network network;
  network.operations = {{.kind = OperationKind::leaf, .leaf = Opcode::coordinate, .index = 0},
                        {.kind = OperationKind::leaf, .leaf = Opcode::coordinate, .index = 1},
                        {.kind = OperationKind::sum, .operands = {{0, true}, {1, false}}},
                        {.kind = OperationKind::sum, .operands = {{0, true}, {1, true}}}};
  network.values = {{2}, {3}};
  CHECK(texts_of(network) == Texts{"b - a", "-a - b"});
}

TEST_CASE("linearise: equal operations are computed once, and names are kept") {
  Network network;
  network.operations = {{.kind = OperationKind::leaf, .leaf = Opcode::coordinate, .index = 0},
                        {.kind = OperationKind::product, .operands = {{0}, {0}}},
                        {.kind = OperationKind::product, .operands = {{0}, {0}}, .name = "area"}};
  network.values = {{1}, {2, true}};
  const Program program = program_of(network);
  CHECK(find_invariant_violation(program) == "");
  CHECK(program.functions[0].instructions.size() == 3);
  CHECK(program.functions[0].names == Texts{"", "area", ""});
  CHECK(program_of(network_of({"3*a", "3 + b"})).constants.size() == 1);
}

TEST_CASE("the cheapest form collects factors, and expands sums of angles whose parts occur") {
  CHECK(cheapest_cost({"a*b*c + a*b*d"}) == 3);  // a*b*(c + d)
  CHECK(cheapest_cost({"cos(a + b)"}) == 1 + 20);
  CHECK(cheapest_cost({"cos(a + b)", "cos(a)", "cos(b)"}) == 3 + 2 * 20);
  // A part of an angle may be a number: cos(a + 7/10) = cos(7/10)*cos(a) - sin(7/10)*sin(a).
  CHECK(cheapest_cost({"cos(a + 7/10)", "cos(a)"}) == 3 + 20);
  CHECK(cheapest_cost({"5*cos(a) + 2*cos(a + 7/10)"}) == 3 + 20);
}
