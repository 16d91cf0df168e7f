// References: names are followed, whatever they stand for, and everything comes once.
#include "elgen/references.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "check/check_testing.hpp"

namespace elgen::test {
namespace {

std::string texts(const Model& model, const std::vector<ExpressionId>& expressions) {
  std::string text;
  for (const ExpressionId id : expressions) {
    text += (text.empty() ? "" : ", ") + to_string(model, id);
  }
  return text;
}

TEST_CASE("operands come before their users, through definitions, each once") {
  const Model model =
      checked(
          "format = 1\n[model]\nname = \"a\"\n[[coordinate]]\nname = \"x\"\n[define]\n"
          "a = \"2*x\"\nunused = \"3*x\"\n[energy]\nT = \"dot(x)^2\"\nV = \"sin(a) + a\"\n")
          .model;
  CHECK(texts(model, reached(model, {*model.energies.V})) == "2, x, 2*x, a, sin(a), a, sin(a) + a");
  CHECK(texts(model, references(model, *model.energies.V)) == "sin(a), a");
}

TEST_CASE("points, frames and prescribed functions are followed to what they are made of") {
  const Model model =
      checked(
          "format = 1\n[model]\nname = \"a\"\n[[coordinate]]\nname = \"x\"\n[parameters]\nm = 1\n"
          "[[prescribed]]\nname = \"s\"\nvalue = \"sin(3*t)\"\n"
          "[[frame]]\nname = \"F\"\nparent = \"world\"\ntranslate = [\"s\", \"0\", \"0\"]\n"
          "[[point]]\nname = \"P\"\nframe = \"F\"\nat = [\"x\", \"0\", \"0\"]\nmass = \"m\"\n"
          "[[output]]\nname = \"o\"\nvalue = \"x(P)\"\n")
          .model;
  const auto all = reached(model, {model.outputs.front().values.front()});
  const auto has = [&](ExpressionKind kind) {
    return std::any_of(all.begin(), all.end(),
                       [&](ExpressionId id) { return model.expressions[id].kind == kind; });
  };
  CHECK(has(ExpressionKind::time));
  CHECK(has(ExpressionKind::coordinate));
}

TEST_CASE("everything comes once, after what it refers to") {
  const Model model = checked(file_text("models/chain.toml")).model;
  CHECK(find_cycle(model).empty());
  const std::vector<ExpressionId> order = in_order(model);
  REQUIRE(order.size() == model.expressions.size());
  std::vector<bool> is_known(order.size(), false);
  for (const ExpressionId id : order) {
    REQUIRE_FALSE(is_known[id]);
    is_known[id] = true;
    for (const ExpressionId other : references(model, id)) REQUIRE(is_known[other]);
  }
}

TEST_CASE("a cycle is one through names, link by link") {
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

TEST_CASE("what is reached twice is there once") {
  const Model model = checked(file_text("models/chain.toml")).model;
  auto all = reached(model, {*model.expectations.front().entries.begin(),
                             *model.expectations.front().entries.begin()});
  std::sort(all.begin(), all.end());
  CHECK(std::adjacent_find(all.begin(), all.end()) == all.end());
}

}  // namespace
}  // namespace elgen::test
