// What equations are made of, and the order below it.
#include "inspect/roots.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "elgen/references.hpp"
#include "support/frame_systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

std::string texts(const Model& model, const std::vector<ExpressionId>& ids) {
  std::string text;
  for (const ExpressionId id : ids) text += (text.empty() ? "" : ", ") + to_string(model, id);
  return text;
}

}  // namespace

TEST_CASE("energies are roots of equations, values are those of outputs") {
  const Model model = checked_model(
                          "format = 1\n[model]\nname = \"a\"\n[[coordinate]]\nname = \"x\"\n"
                          "[define]\na = \"2*x\"\nunused = \"3*x\"\n[energy]\nT = \"dot(x)^2\"\n"
                          "V = \"sin(a) + a\"\n[[output]]\nname = \"o\"\nvalue = \"cos(x)\"\n")
                          .model;
  CHECK(texts(model, equation_roots(model)) == "dot(x)^2, sin(a) + a");
  CHECK(texts(model, output_roots(model.outputs.front())) == "cos(x)");
}

TEST_CASE("everything that carries energy or force is a root", "[frames]") {
  for (const auto& [name, text] : frame_systems()) {
    INFO(name);
    const Model model = checked_model(text).model;
    const auto all = reached(model, equation_roots(model));
    for (const Body& body : model.bodies) {
      if (body.mass) CHECK(std::find(all.begin(), all.end(), *body.mass) != all.end());
    }
    auto sorted = all;
    std::sort(sorted.begin(), sorted.end());
    CHECK(std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end());
  }
}
