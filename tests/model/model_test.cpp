// Queries of a Model that every stage uses: names and counts of leaves, printed expressions, and
// references between entries.
#include <rapidcheck.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>
#include <utility>

#include "check/check_testing.hpp"
#include "elgen/leaf_names.hpp"
#include "elgen/references.hpp"

namespace elgen::test {

namespace {

std::string printed(const std::string& text) {
  const std::string head =
      "format = 1\n[model]\nname = \"a\"\n[[coordinate]]\nname = \"x\"\n"
      "[[coordinate]]\nname = \"y\"\n[energy]\nT = \"dot(x)^2 + dot(y)^2\"\nV = \"";
  const Model model = checked(head + text + "\"\n").model;
  return to_string(model, *model.energies.V);
}

/// A random expression over x, y, t and small numbers.
std::string random_expression(int depth) {
  const std::vector<std::string> leaves{"x", "y", "t", "2", "0.5", "pi", "1/3"};
  if (depth == 0) {
    return *rc::gen::elementOf(leaves);
  }
  const std::string a = random_expression(depth - 1);
  const std::string b = random_expression(depth - 1);
  switch (*rc::gen::inRange(0, 8)) {
    case 0:
      return "(" + a + ") + (" + b + ")";
    case 1:
      return "(" + a + ") - (" + b + ")";
    case 2:
      return "(" + a + ")*(" + b + ")";
    case 3:
      return "(" + a + ")/(x + (" + b + ")^2)";
    case 4:
      return "-(" + a + ")";
    case 5:
      return "(2 + (" + a + ")^2)^(1/3)";
    case 6:
      return "sin(" + a + ")";
    default:
      return "sqrt(3 + (" + b + ")^2)";
  }
}

std::string texts(const Model& model, const std::vector<ExpressionId>& expressions) {
  std::string text;
  for (const ExpressionId id : expressions) {
    text += (text.empty() ? "" : ", ") + to_string(model, id);
  }
  return text;
}

}  // namespace

TEST_CASE("leaves have the names that the model gives them") {
  const Model model = checked(model_file("chain")).model;
  const LeafNames leaves = leaf_names(model);
  REQUIRE(leaves.q.size() == 5);
  CHECK(leaves.q[4] == "q[5]");
  CHECK(leaves.u[0] == "tau[1]");
  CHECK(leaves.parameters.front() == "m[1]");
  CHECK_FALSE(leaves.uses_time);
  CHECK(leaf_names(checked(model_file("rotating_hoop")).model).uses_time);
}

TEST_CASE("leaf kinds of few functions have names only if a function takes them") {
  const LeafNames unused = leaf_names(checked(model_file("chain")).model);
  const auto has_names = [](const LeafNames& leaves, Opcode kind) {
    return leaf_count(leaves, kind) > 0 && !leaf_of(leaves, kind, 0).empty();
  };
  for (const LeafRow& row : leaf_table()) {
    INFO(row.symbol);
    LeafNames leaves = unused;
    name_optional_leaves(row.id, leaves);
    if (row.argument_rule != ArgumentRule::if_used) {
      CHECK(has_names(leaves, row.id) == has_names(unused, row.id));
      continue;
    }
    // A kind of optional leaves has one leaf for each velocity, or one leaf for the system.
    CHECK((row.owner == LeafOwner::velocities || row.owner == LeafOwner::system));
    CHECK_FALSE(has_names(unused, row.id));
    CHECK(has_names(leaves, row.id));
  }
  LeafNames leaves = unused;
  name_optional_leaves(Opcode::momentum | Opcode::step, leaves);
  CHECK(leaf_text(leaves, Opcode::momentum, 4) == "p(q[5])");
  CHECK(leaves.reference.empty());
  CHECK(leaves.h == "h");
}

TEST_CASE("no two kinds of leaves have the same rank") {
  std::set<int> ranks;
  for (const LeafRow& row : leaf_table()) ranks.insert(row.rank);
  CHECK(ranks.size() == leaf_table().size());
}

TEST_CASE("leaves have a text in model syntax and an identifier in C++") {
  const LeafNames leaves = leaf_names(checked(model_file("chain")).model);
  CHECK(leaf_text(leaves, Opcode::coordinate, 0) == "q[1]");
  CHECK(leaf_text(leaves, Opcode::velocity, 0) == "dot(q[1])");
  CHECK(leaf_text(leaves, Opcode::acceleration, 4) == "dot(dot(q[5]))");
  CHECK(leaf_text(leaves, Opcode::time, 0) == "t");
  CHECK(leaves.h.empty());  // empty until a function takes the step size
  CHECK(leaves.momenta.empty());
  LeafNames taken = leaves;
  taken.momenta = leaves.v;
  CHECK(leaf_text(taken, Opcode::momentum, 4) == "p(q[5])");
  CHECK(identifier_of("q[5]") == "q_5");
  CHECK(identifier_of("x_cart") == "x_cart");
}

TEST_CASE("the number of leaves is the number of entries that own them") {
  const Model model = checked(model_file("chain")).model;
  CHECK(leaf_count(model, Opcode::parameter) == 11);
  CHECK(leaf_count(model, Opcode::coordinate) == 5);
  CHECK(leaf_count(model, Opcode::velocity) == 5);
  CHECK(leaf_count(model, Opcode::acceleration) == 5);
  CHECK(leaf_count(model, Opcode::momentum) == 5);
  CHECK(leaf_count(model, Opcode::input) == 5);
  CHECK(leaf_count(model, Opcode::time) == 1);
  const Model top = checked(model_file("free_body")).model;
  CHECK(leaf_count(top, Opcode::coordinate) == leaf_count(top, Opcode::velocity) + 1);
}

TEST_CASE("a leaf has the range that its entry declares") {
  Model model = checked(model_file("cart_pole")).model;
  model.coordinates[1].range = Interval{-2, 2};
  model.velocities[0].rate_range = Interval{-3, 3};
  model.inputs[0].limits = Interval{-4, 4};
  CHECK(declared_range(model, Opcode::coordinate, 1)->high == 2);
  CHECK(declared_range(model, Opcode::velocity, 0)->high == 3);
  CHECK(declared_range(model, Opcode::input, 0)->high == 4);
  CHECK_FALSE(declared_range(model, Opcode::acceleration, 0));
  CHECK_FALSE(declared_range(model, Opcode::time, 0));
}

TEST_CASE("brackets are printed only if they are needed") {
  const std::vector<std::pair<std::string, std::string>> rows{
      {"x + y*2", "x + y*2"},
      {"(x + y)*2", "(x + y)*2"},
      {"x - (y - 2)", "x - (y - 2)"},
      {"x - y - 2", "x - y - 2"},
      {"-x*y", "-x*y"},
      {"-(x + y)", "-(x + y)"},
      {"(-x)^2", "(-x)^2"},
      {"-x^2", "-x^2"},
      {"x/y/2", "x/y/2"},
      {"x/(y*2)", "x/(y*2)"},
      {"x*(y/2)", "x*(y/2)"},
      {"(x/y)*2", "x/y*2"},
      {"x^(1/3)", "x^(1/3)"},
      {"x^-1", "x^(-1)"},
      {"sqrt(x + y)", "sqrt(x + y)"},
      {"(x^2)^3", "(x^2)^3"},
      {"sin(x)^2*atan2(x, y)", "sin(x)^2*atan2(x, y)"},
      {"0.5*x", "1/2*x"},
      {"x*0.5", "x*(1/2)"},
      {"pi*t*x", "pi*t*x"},
      {"x*(-y)", "x*(-y)"},
  };
  for (const auto& [text, expected] : rows) {
    INFO(text);
    CHECK(printed(text) == expected);
    CHECK(printed(printed(text)) == expected);
  }
}

TEST_CASE("printed text parses back and prints the same") {
  CHECK(rc::check("print, parse, print", [] {
    const std::string once = printed("x + " + random_expression(3));
    RC_ASSERT(printed(once) == once);
  }));
}

TEST_CASE("operands precede their users, each once, even through definitions") {
  const Model model =
      checked(
          "format = 1\n[model]\nname = \"a\"\n[[coordinate]]\nname = \"x\"\n[define]\n"
          "a = \"2*x\"\nunused = \"3*x\"\n[energy]\nT = \"dot(x)^2\"\nV = \"sin(a) + a\"\n")
          .model;
  CHECK(texts(model, reachable_expressions(model, {*model.energies.V})) ==
        "2, x, 2*x, a, sin(a), a, sin(a) + a");
  CHECK(texts(model, references(model, *model.energies.V)) == "sin(a), a");
}

TEST_CASE("references through points, frames and prescribed functions are followed") {
  const Model model =
      checked(
          "format = 1\n[model]\nname = \"a\"\n[[coordinate]]\nname = \"x\"\n[parameters]\nm = 1\n"
          "[[prescribed]]\nname = \"s\"\nvalue = \"sin(3*t)\"\n"
          "[[frame]]\nname = \"F\"\nparent = \"world\"\ntranslate = [\"s\", \"0\", \"0\"]\n"
          "[[point]]\nname = \"P\"\nframe = \"F\"\nat = [\"x\", \"0\", \"0\"]\nmass = \"m\"\n"
          "[[output]]\nname = \"o\"\nvalue = \"x(P)\"\n")
          .model;
  const auto all = reachable_expressions(model, {model.outputs.front().values.front()});
  const auto has = [&](Opcode kind) {
    return std::any_of(all.begin(), all.end(),
                       [&](ExpressionId id) { return is_leaf(model.expressions[id], kind); });
  };
  CHECK(has(Opcode::time));
  CHECK(has(Opcode::coordinate));
}

TEST_CASE("every expression comes once, after its references") {
  const Model model = checked(model_file("chain")).model;
  CHECK(find_cycle(model).empty());
  const std::vector<ExpressionId> order = topological_order(model);
  REQUIRE(order.size() == model.expressions.size());
  std::vector<bool> is_known(order.size(), false);
  for (const ExpressionId id : order) {
    REQUIRE_FALSE(is_known[id]);
    is_known[id] = true;
    for (const ExpressionId other : references(model, id)) REQUIRE(is_known[other]);
  }
}

TEST_CASE("a cycle consists of references, link by link") {
  Model model = checked(
                    "format = 1\n[model]\nname = \"a\"\n[[coordinate]]\nname = \"x\"\n[define]\n"
                    "a = \"2*x\"\nb = \"3*a\"\n[energy]\nT = \"dot(x)^2\"\nV = \"b\"\n")
                    .model;
  const ExpressionId first = model.definitions[0].value;
  model.definitions[0].value = model.definitions[1].value;  // b = 3*a, a = b
  CHECK(first != model.definitions[0].value);
  const std::vector<ExpressionId> cycle = find_cycle(model);
  REQUIRE_FALSE(cycle.empty());
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    const std::vector<ExpressionId> next = references(model, cycle[i]);
    CHECK(std::count(next.begin(), next.end(), cycle[(i + 1) % cycle.size()]) == 1);
  }
}

TEST_CASE("an expression reached twice is listed once") {
  const Model model = checked(model_file("chain")).model;
  auto all = reachable_expressions(model, {*model.expectations.front().entries.begin(),
                                           *model.expectations.front().entries.begin()});
  std::sort(all.begin(), all.end());
  CHECK(std::adjacent_find(all.begin(), all.end()) == all.end());
}

}  // namespace elgen::test
