// The search for the state with a design's largest error. Designs are the evaluator plus a known
// error.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "elgen/evaluate.hpp"
#include "run/tradeoff/derived.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// An output with one entry, at 1000 states.
class Searched {
 public:
  Searched(const std::string& text, const std::string& output)
      : products_(derived(text, output)),
        states_(*sample_tradeoff_states(*products_.checked, *products_.program, {})) {
    for (const std::vector<TwoDoubleNumber>& exact : states_.exact) {
      scale_ = std::max(scale_, std::abs(exact.front().high));
    }
  }

  [[nodiscard]] const TradeoffStates& states() const { return states_; }

  /// A design with the values of the evaluator plus mistake(q) times the largest exact |value|.
  template <class Scalar = double, class Mistake>
  [[nodiscard]] DesignEvaluator with(const Mistake& mistake) const {
    return [this, mistake](const std::vector<Arguments<double>>& states) {
      const Program& program = *products_.program;
      std::vector<double> values;
      for (const Arguments<double>& state : states) {
        const auto rounded = map_leaves([](double x) { return static_cast<Scalar>(x); }, state);
        const auto value = evaluate(program, program.functions.front(), rounded).front();
        values.push_back(static_cast<double>(value) + scale_ * mistake(state.q[0]));
      }
      return values;
    };
  }

  [[nodiscard]] FoundErrors found(const DesignEvaluator& design) const {
    return find_errors(*products_.checked, *products_.program, states_, design);
  }

  [[nodiscard]] double worst_of_states(const DesignEvaluator& design) const {
    const std::vector<double> errors = state_errors(design(states_.states), states_);
    return *std::max_element(errors.begin(), errors.end());
  }

 private:
  Products products_;
  TradeoffStates states_;
  double scale_ = 0;
};

/// The interval between two adjacent samples of q.
struct Gap {
  double middle = 0;
  double width = 0;
};

Gap widest_gap(const TradeoffStates& states) {
  std::vector<double> q;
  for (const Arguments<double>& state : states.states) q.push_back(state.q[0]);
  std::sort(q.begin(), q.end());
  Gap widest;
  for (std::size_t i = 1; i < q.size(); ++i) {
    const double width = q[i] - q[i - 1];
    if (width > widest.width) widest = {(q[i] + q[i - 1]) / 2, width};
  }
  return widest;
}

}  // namespace

TEST_CASE("the search climbs a peak between the states, reproducibly") {
  const Searched searched(read_model("pushed_pendulum"), "gravity");
  const Gap gap = widest_gap(searched.states());
  const DesignEvaluator peak = searched.with([gap](double q) {
    const double x = 40 * (q - gap.middle) / gap.width;
    return 1e-3 / (1 + x * x);
  });
  CHECK(searched.worst_of_states(peak) < 1e-5);
  const FoundErrors found = searched.found(peak);
  CHECK(found.worst == Approx(1e-3).epsilon(0.01));
  CHECK(std::abs(found.worst_state.q[0] - gap.middle) < gap.width / 100);
  CHECK(found.median < 1e-5);
  const FoundErrors again = searched.found(peak);
  CHECK(again.worst == found.worst);
  CHECK(again.worst_state.q == found.worst_state.q);
}

TEST_CASE("the search reaches the ends of ranges but not further, and keeps parameters") {
  const Searched searched(replaced(read_model("pushed_pendulum"), "g = 9.81",
                                   "g = { value = 9.81, min = 1, max = 20 }"),
                          "gravity");
  const FoundErrors found =
      searched.found(searched.with([](double q) { return 1e-3 * std::abs(q); }));
  CHECK(std::abs(found.worst_state.q[0]) == searched.states().high.q[0]);
  CHECK(found.worst == Approx(1e-3 * searched.states().high.q[0]));
  CHECK(found.worst_state.parameters == searched.states().states.front().parameters);
}

TEST_CASE("the number of visited states is proportional to the sample") {
  const Products products = derived(read_model("pushed_pendulum"), "inverse_dynamics");
  const auto visited = [&products](std::size_t count) {
    const auto states =
        sample_tradeoff_states(*products.checked, *products.program, {.count = count});
    std::size_t all = 0;
    const DesignEvaluator design = [&all](const std::vector<Arguments<double>>& asked) {
      all += asked.size();
      return std::vector<double>(asked.size());
    };
    static_cast<void>(find_errors(*products.checked, *products.program, *states, design));
    return static_cast<double>(all);
  };
  CHECK(visited(300) == Approx(21 * 300).epsilon(0.05));
  CHECK(visited(1000) == Approx(21 * 1000).epsilon(0.05));
}

TEST_CASE("rounding of the state to float counts as error") {
  const Searched searched(read_model("pushed_pendulum"), "gravity");
  const auto right = [](double) { return 0.0; };
  const double in_float = searched.found(searched.with<float>(right)).worst;
  CHECK(in_float > 1e-8);
  CHECK(in_float < 1e-6);
  CHECK(searched.found(searched.with(right)).worst < 1e-15);
}

TEST_CASE("states outside the domain are ignored") {
  const Searched searched(model_text("root", R"toml([[coordinate]]
name = "x"
range = [-0.1, 1]
[energy]
T = "dot(x)^2"
V = "sqrt(x)"
)toml"),
                          "potential_energy");
  const FoundErrors found = searched.found(searched.with([](double) { return 1e-9; }));
  CHECK(found.worst == Approx(1e-9));
  CHECK(found.worst_state.q[0] >= 0);
}

TEST_CASE("an output that depends on no state has its constant error") {
  const Searched searched(read_model("pushed_pendulum"), "mass_matrix");
  CHECK(searched.found(searched.with([](double) { return 1e-5; })).worst == Approx(1e-5));
}
