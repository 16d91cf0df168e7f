// Equations of random models in the model language and in LaTeX must have the values of their
// trees. For the comparison each symbol is replaced by a, b or c, and each function by the sine.
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>

#include "elgen/page.hpp"
#include "elgen/pipeline.hpp"
#include "formula/glyphs.hpp"
#include "formula/written_values.hpp"
#include "random/generator.hpp"

namespace elgen::test {
namespace {

/// The same tree with a, b and c as the only symbols, and the sine as the only function.
Formula simplified(Formula formula) {
  for (Formula& part : formula.parts) part = simplified(std::move(part));
  if (formula.kind == FormulaKind::symbol) {
    const std::string name = text_of(formula);
    const auto letter = static_cast<std::size_t>(std::accumulate(name.begin(), name.end(), 0) % 3);
    const std::string other(1, "abc"[letter]);
    return symbol_formula(other, read_latex(other));
  }
  if (formula.kind == FormulaKind::call) {
    Formula argument =
        formula.parts.size() == 1 ? std::move(formula.parts[0]) : sum_of(std::move(formula.parts));
    return call_of(FunctionId::sin, {std::move(argument)});
  }
  return formula;
}

bool is_near(const Value& x, const Value& y) {
  return std::abs(x - y) <= 1e-8 * std::max(1.0, std::abs(x));
}

/// The text or the LaTeX of the formula if its value differs from the value of the tree, otherwise
/// empty.
std::string mistake_in(const Formula& read) {
  const Formula formula = simplified(read);
  const Value value = value_of_tree(formula);
  if (!std::isfinite(value.real()) || !std::isfinite(value.imag())) return {};
  const std::string text = text_of(formula);
  if (!is_near(value, value_of_text(text))) return text;
  const std::string set = to_latex(glyphs_of(formula));
  return is_near(value, value_of_line(set)) ? "" : set;
}

}  // namespace

TEST_CASE("equations of random models have the same value in every notation") {
  std::size_t formulas = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const random::System system = random::Generator(seed).system();
    const Products products = run_pipeline(
        {make_source("model.toml", text_of(system.model)), nullptr}, {.goals = {Goal::emit}});
    if (!products.page_programs) continue;
    const Program& program = products.page_programs->program;
    for (std::size_t i = 0; i < program.functions.size(); ++i) {
      const FunctionEquations read = equations(products.checked->model, program, i);
      Formulas all;
      for (const auto& [name, value] : read.definitions) all.push_back(value);
      for (const Formulas& entries : read.entries) {
        all.insert(all.end(), entries.begin(), entries.end());
      }
      for (const Formula& formula : all) {
        INFO(seed);
        CHECK(mistake_in(formula).empty());
        ++formulas;
      }
    }
  }
  CHECK(formulas > 2'000);
}

}  // namespace elgen::test
