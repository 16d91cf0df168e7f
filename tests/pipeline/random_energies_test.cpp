// Random energies of 2 to 12 nodes over 1 to 3 coordinates, with functions of one argument,
// irrational constants, and the parameter values 0, 0.7, 1 and 1.3. Each energy gives code and a
// page, or an error with a place. $ELGEN_SEEDS sets the number of energies, $ELGEN_FIRST_SEED the
// first seed. $ELGEN_ALL_OUTPUTS requests all outputs.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <iterator>
#include <string>
#include <vector>

#include "numbers/random.hpp"
#include "pipeline/pipeline_testing.hpp"

namespace elgen::test {
namespace {

constexpr std::uint64_t usual_count = 1000;
constexpr std::uint64_t largest = 12;

/// The least share of accepted energies. A lower share means that the generator draws nonsense.
constexpr double least_accepted = 0.6;

std::uint64_t number_of(const char* variable, std::uint64_t otherwise) {
  const char* const text = std::getenv(variable);
  return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

/// Functions of one argument without kinks. The order of the first six must stay, because it
/// determines the energies of all seeds.
std::vector<std::string> functions_of_energies() {
  std::vector<std::string> names{"sin", "cos", "sqrt", "tan", "exp", "log"};
  for (const FunctionRow& row : function_table()) {
    const bool is_listed = std::ranges::count(names, row.name) > 0;
    if (row.arity == 1 && !is_kinked(row.id) && !is_listed) names.emplace_back(row.name);
  }
  names.insert(names.end(), {"sinc", "cosc"});
  return names;
}

class EnergyText {
 public:
  explicit EnergyText(std::uint64_t seed) : random_(seed), coordinate_count_(1 + below(3)) {}

  [[nodiscard]] std::string model() {
    static constexpr std::array names{"x", "y", "z"};
    std::string text = "format = 1\n[model]\nname = \"drawn\"\n";
    std::string T;
    for (std::size_t i = 0; i < coordinate_count_; ++i) {
      const std::string name = names.at(i);
      text += "[[coordinate]]\nname = \"" + name + "\"\n";
      T += (i == 0 ? "" : " + ") + std::string(i == 1 ? "pi*" : "") + "dot(" + name + ")^2/2";
    }
    text += "[parameters]\none = 1\nnone = 0\nratio = 1.3\nlength = { value = 0.7, assume = ";
    text += "\"positive\" }\n[energy]\nT = \"" + T + "\"\nV = \"";
    return text + tree(2 + below(largest - 1)) + "\"\n";
  }

 private:
  [[nodiscard]] std::uint64_t below(std::uint64_t end) { return random_.next() % end; }

  [[nodiscard]] std::string leaf() {
    static constexpr std::array coordinates{"x", "y", "z"};
    static constexpr std::array others{"one",     "none", "ratio",  "length",   "2",   "0.5",
                                       "1/3",     "pi",   "exp(1)", "sqrt(2)",  "1",   "sin(0.5)",
                                       "sqrt(3)", "1e-3", "cos(1)", "(pi - 1)", "1.09"};
    if (below(5) < 3) return coordinates.at(below(coordinate_count_));
    return others.at(below(std::size(others)));
  }

  [[nodiscard]] std::string call(std::uint64_t nodes) {
    static const std::vector<std::string> functions = functions_of_energies();
    const std::uint64_t drawn = below(functions.size() + 4);
    // The modulus makes the first functions more frequent: roots, sines and cosines are in most
    // energies.
    return functions.at(drawn % functions.size()) + ("(" + tree(nodes - 1) + ")");
  }

  [[nodiscard]] std::string tree(std::uint64_t nodes) {
    static constexpr std::array operators{" + ", " - ", "*", "/"};
    static constexpr std::array powers{"2", "3", "(1/2)", "(-1)", "(3/2)"};
    if (nodes < 2) return leaf();
    if (nodes == 2 || below(3) == 0) return call(nodes);
    if (below(6) == 0) {
      const std::string base = tree(nodes - 2);
      return "(" + base + ")^" + powers.at(below(std::size(powers)));
    }
    const std::uint64_t left = 1 + below(nodes - 2);
    const std::string first = tree(left);
    const std::string second = tree(nodes - 1 - left);
    return "(" + first + operators.at(below(std::size(operators))) + second + ")";
  }

  Random random_;
  std::uint64_t coordinate_count_;
};

/// The message of an error without a place, or "no files and no error"; empty for right products.
std::string fault_of(const Products& products) {
  for (const Diagnostic& diagnostic : products.diagnostics) {
    if (code_row(diagnostic.code).severity != Severity::error) continue;
    return diagnostic.span.source ? "" : format(products.diagnostics);
  }
  return products.files ? "" : "no files and no error";
}

TEST_CASE("random energies give code and pages, or an error with a place") {
  PipelineOptions options;
  options.goals = {Goal::emit};
  if (std::getenv("ELGEN_ALL_OUTPUTS") == nullptr) {
    options.scene.outputs = {make_source("--outputs", "potential_energy,gravity")};
  }
  const std::uint64_t first = number_of("ELGEN_FIRST_SEED", 1);
  const std::uint64_t count = number_of("ELGEN_SEEDS", usual_count);
  std::uint64_t accepted = 0;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    const std::string text = EnergyText(seed).model();
    INFO("seed " << seed << "\n" << text);
    const Products products = run_pipeline(inputs_of(text), options);
    CHECK(fault_of(products).empty());
    accepted += products.files ? 1 : 0;
  }
  CHECK(static_cast<double>(accepted) >= least_accepted * static_cast<double>(count));
}

TEST_CASE("parameters of value 1 times roots, calls and inverses give code") {
  for (const char* const V :
       {"sin(x) - one*sin(y)", "sqrt(1 + x^2) - one*sqrt(1 + y^2)", "one*sin(x) + sin(x + y)",
        "one/x - 1/y", "1/x - one/(1 + y)", "(sin(x) - one*sin(y))^2",
        "sqrt(2 + x^2) + one*sqrt(1 + y^2)", "exp(x)*one - one*exp(y)"}) {
    const std::string text =
        "format = 1\n[model]\nname = \"ones\"\n[[coordinate]]\nname = \"x\"\n[[coordinate]]\n"
        "name = \"y\"\n[parameters]\none = 1\n[energy]\nT = \"dot(x)^2 + dot(y)^2\"\nV = \"" +
        std::string(V) + "\"\n";
    INFO(V);
    CHECK(derived(inputs_of(text)).program);
  }
}

}  // namespace
}  // namespace elgen::test
