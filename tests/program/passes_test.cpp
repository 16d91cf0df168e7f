// Passes from Graph to Graph (rebuild, factor, flatten, angle_sums), and pruning of a Program.
#include <catch2/catch.hpp>

#include "program/expression_leaves.hpp"
#include "program/graph/angle_sums.hpp"
#include "program/graph/factor.hpp"
#include "program/read_program.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

struct PassRow {
  const char* what;
  Texts before;
  Texts after;
};

template <class Pass>
void check_rows(const std::vector<PassRow>& rows, const Pass& pass) {
  for (const PassRow& row : rows) {
    INFO(row.what);
    CHECK(texts_of(pass(expressions_of(row.before))) == row.after);
  }
}

Program program_of(const std::string& function) {
  return read_program("parameters m l\nfunction gravity\n" + function);
}

}  // namespace

TEST_CASE("an identity rule copies values, names and births, and omits unused nodes") {
  ExpressionLeaves l;
  l.graph.set_creation_rank(3);
  const SignedNode root = l.graph.square_root(l.graph.sum({l.a, -l.b}));
  l.graph.set_name(root, "distance");
  const SignedNode pi = l.graph.pi();
  const SignedNode call = l.graph.call(FunctionId::atan2, {-l.c, root});
  l.expressions.values = {-l.graph.product({{call, 2}, {pi}, {l.d, -1}})};
  const Expressions copied = rebuild(l.expressions, copy_node);
  CHECK(texts_of(copied) == texts_of(l.expressions));
  CHECK(copied.graph.size() < l.graph.size());  // e is unused
  std::size_t named = 0;
  for (NodeId id = 0; id < copied.graph.size(); ++id) {
    const Node& node = copied.graph.node(id);
    if (node.name != "distance") continue;
    ++named;
    CHECK(node.creation_rank == 3);
  }
  CHECK(named == 1);
}

TEST_CASE("a rule may change signs: users see the changed operand") {
  const auto turn_b = [](Graph& graph, const RebuildStep& step) {
    const SignedNode same = copy_node(graph, step);
    return same == graph.leaf(Opcode::coordinate, 1) ? -same : same;
  };
  CHECK(texts_of(rebuild(expressions_of({"a + b", "a*b"}), turn_b)) == Texts{"a - b", "-a*b"});
}

TEST_CASE("copying into another graph reuses its equal nodes") {
  const Expressions one = expressions_of({"-(a + b)"});
  Expressions other;
  const SignedNode first = copy_value(other.graph, one);
  const std::size_t size = other.graph.size();
  CHECK(copy_value(other.graph, one) == first);
  CHECK(other.graph.size() == size);
  other.values = {first};
  CHECK(texts_of(other) == texts_of(one));
}

TEST_CASE("factor: common factors are multiplied once") {
  check_rows(
      {{"the factor of most terms goes first",
        {"a*b*c + a*c*d - e", "a^2*b + a*c"},
        {"-(e - a*c*(b + d))", "a*(c + a*b)"}},
       {"a product that something else needs too is left alone",
        {"a*b + a*c", "a*b + d"},
        {"a*b + a*c", "d + a*b"}},
       {"a term that is the factor leaves 1", {"a - a*b"}, {"a*(1 - b)"}},
       {"a common factor that is left alone meets itself",
        {"a^2*sin(b)^2*c + a^2*cos(b)^2*c + c*d", "a^2*b^2 + a^2*d"},
        {"c*(d + a^2)", "a^2*(d + b^2)"}},
       {"a coefficient does not hide common factors", {"2*a*b*c + a*b*d"}, {"a*b*(d + 2*c)"}},
       {"a coefficient that the scaled product has too is one base with its power",
        {"sqrt(2)*(sqrt(2)*a*b) + sqrt(2)*c"},
        {"sqrt(2)*(c + sqrt(2)*a*b)"}},
       {"a common factor keeps its power", {"a*b^2*c^2 + a*b^2*d^2"}, {"a*b^2*(c^2 + d^2)"}}},
      factor);
  // Sums inside and outside a factored term are factored too: a*(e + b*(c + d)) + c*(d + e).
  CHECK(counts_of(factor(expressions_of({"a*b*c + a*b*d + a*e + c*d + c*e"}))) ==
        OperationCounts{.add = 4, .mul = 3});
}

TEST_CASE("flatten: a value used once is merged into its user") {
  const auto used_once = [](const Expressions& before) { return flatten(before); };
  check_rows({{"sums in sums and products in products",
               {"(b + d) - c", "(b*e)*c"},
               {"b - c + d", "b*c*e"}},
              {"signs go with the terms, and terms that meet merge",
               {"c - (a - b)", "a + (a + d)"},
               {"-(a - b - c)", "d + 2*a"}}},
             used_once);
  // A node used twice stays, and powers of a product are not expanded.
  CHECK(counts_of(flatten(expressions_of({"(a + b) + c", "(a + b) + d"}))).add == 3);
  CHECK(counts_of(flatten(expressions_of({"(a*b)^2*c"}))).mul == 3);
}

TEST_CASE("flatten, all products: every product is merged into its users, so that factors meet") {
  const auto all = [](const Expressions& x) { return flatten(x, FlattenedProducts::all_products); };
  check_rows(
      {{"two products that are used again",
        {"(a*sin(b))*sin(b) + (a*cos(b))*cos(b)", "(a*sin(b))^(-2)*c", "a*sin(b)", "a*cos(b)"},
        {"a", "c/(a^2*sin(b)^2)", "a*sin(b)", "a*cos(b)"}}},
      all);
}

TEST_CASE("angle_sums: an angle is expanded into other angles that occur") {
  check_rows(
      {{"sums",
        {"cos(a + b)", "sin(a + b)", "cos(a)", "sin(b)"},
        {"-(sin(a)*sin(b) - cos(a)*cos(b))", "sin(a)*cos(b) + sin(b)*cos(a)", "cos(a)", "sin(b)"}},
       {"differences and multiples are sums too, but for exact multiples of a leaf",
        {"sin(a - b)", "cos(2*a)", "sin(a)", "sin(b)", "cos(3*a)"},
        {"sin(a)*cos(b) - sin(b)*cos(a)", "cos(2*a)", "sin(a)", "sin(b)",
         "-(sin(a)*sin(2*a) - cos(a)*cos(2*a))"}},
       {"a number is a part whose sine is a number",
        {"sin(a + 1)", "sin(a)", "cos(1/6*pi + 1/10)"},
        {"sin(1)*cos(a) + cos(1)*sin(a)", "sin(a)", "cos(1/10 + 1/6*pi)"}}},
      [](const Expressions& before) { return expand_angle_sums(before).value(); });
}

TEST_CASE("angle_sums: some angles are not expanded") {
  // No call has the angle b; b cancels in (a - b) + (b + 5 c); the angle a - b may be small.
  CHECK_FALSE(expand_angle_sums(expressions_of({"cos(a + b)", "sin(a)"})));
  CHECK_FALSE(expand_angle_sums(expressions_of({"cos(a + 5*c)", "sin(a - b)", "cos(b + 5*c)"})));
  const Expressions difference = expressions_of({"sin(a - b)", "sin(a)", "sin(b)"});
  CHECK(expand_angle_sums(difference, ExpandedAngles::sums_and_differences));
  CHECK_FALSE(expand_angle_sums(difference, ExpandedAngles::sums));
}

TEST_CASE("angle_sums: a chain of splits grows with its length, not with its number of paths") {
  ExpressionLeaves l;
  const auto cosine = [&l](SignedNode x) { return l.graph.call(FunctionId::cos, {x}); };
  // S_k = S_(k-1) + b^k. sin S_k and cos S_k both use sin and cos of S_(k-1): 2^19 paths.
  constexpr int length = 20;
  SignedNode sum = l.a;
  l.expressions.values = {cosine(l.a)};
  for (int k = 1; k < length; ++k) {
    const SignedNode joint = l.graph.product({{l.b, k}});
    sum = l.graph.sum({sum, joint});
    l.expressions.values.push_back(cosine(joint));
    l.expressions.values.push_back(cosine(sum));
  }
  const auto expanded = expand_angle_sums(l.expressions);
  REQUIRE(expanded);
  // For each k there are two sums of two products, and four calls.
  CHECK(expanded->graph.size() < 12 * length);
}

TEST_CASE("the needed instructions of an entry are found") {
  const Program program = program_of(
      "  0 = parameter m\n  1 = parameter l\n  2 = multiply 0 0\n  3 = add 2 1\n"
      "  result 1 1 = 3\n");
  CHECK(needed_instructions(program.functions[0], {2}) ==
        std::vector<bool>{true, false, true, false});
  CHECK(needed_instructions(program.functions[0], {3}) ==
        std::vector<bool>{true, true, true, true});
  CHECK(dependency_cone(program.functions[0], {2}) == std::vector<std::uint32_t>{0, 2});
  CHECK(dependency_cone(program.functions[0], {2, 3, 2}) == std::vector<std::uint32_t>{0, 1, 2, 3});
  CHECK(dependency_cone(program.functions[0], {3}, 2).size() == 3);
}

TEST_CASE("unused instructions are removed, and the others renumbered") {
  Program program = program_of(
      "  0 = parameter m\n  1 = parameter l\n  2 = multiply 0 0  ; square\n  3 = add 2 1\n"
      "  result 1 1 = 3\n");
  program.functions[0].fields[0].entries = {2};
  program.functions[0] = eliminate_dead_code(program.functions[0]);
  CHECK(find_invariant_violation(program).empty());
  CHECK(dump(program) ==
        dump(program_of("  0 = parameter m\n  1 = multiply 0 0  ; square\n  result 1 1 = 1\n")));
}

TEST_CASE("selected instructions become the entries of one field") {
  const Program program = program_of(
      "  0 = parameter m\n  1 = parameter l\n  2 = multiply 0 0\n  3 = add 2 1\n"
      "  result 1 1 = 3\n");
  CHECK(dump(Program{program.leaves, {}, {with_entries(program.functions[0], {2, 0})}}) ==
        dump(program_of("  0 = parameter m\n  1 = multiply 0 0\n  result 2 1 = 1 0\n")));
}

TEST_CASE("names stay with their instructions") {
  Program program = program_of(
      "  0 = parameter m\n  1 = multiply 0 0  ; square\n  2 = parameter l\n"
      "  3 = multiply 1 0  ; cube\n  result 1 1 = 3\n");
  program.functions[0] = eliminate_dead_code(program.functions[0]);
  CHECK(program.functions[0].names == std::vector<std::string>{"", "square", "cube"});
}

TEST_CASE("reordered instructions compute the same values") {
  Program program = program_of(
      "  0 = parameter m\n  1 = multiply 0 0  ; square\n  2 = parameter l\n  3 = add 1 2\n"
      "  result 1 1 = 3\n");
  program.functions[0] = reorder_instructions(program.functions[0], {2, 0, 1, 3});
  CHECK(find_invariant_violation(program).empty());
  CHECK(dump(program) == dump(program_of("  0 = parameter l\n  1 = parameter m\n"
                                         "  2 = multiply 1 1  ; square\n  3 = add 2 0\n"
                                         "  result 1 1 = 3\n")));
}
