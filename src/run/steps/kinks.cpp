// KinkWatch: evaluates the arguments of calls with kinks.
#include "run/steps/kinks.hpp"

#include "elgen/wording.hpp"

namespace elgen {

KinkWatch::KinkWatch(SimulatedSystem& system) : system_(system) {
  const Model& model = system.model();
  std::vector<ExpressionId> laws;
  for (const InputLaw& law : system.laws()) {
    if (law.expression) laws.push_back(*law.expression);
  }
  for (const KinkedCall& found : kinked_calls(model, laws)) {
    Kink& kink = kinks_.emplace_back(Kink{found, {}});
    for (const ExpressionId argument : model.expressions[found.call].operands) {
      kink.arguments.push_back(system.state_function(argument));
    }
  }
}

std::vector<int> KinkWatch::sides(const Numbers& state, double t) {
  const double* const v = system_.v_of(state);
  std::vector<int> all;
  for (Kink& kink : kinks_) {
    const bool is_still = kink.is_of_law && system_.holds_inputs();
    const double* const q =
        kink.is_of_law ? system_.displayed_position(state.data()).data() : state.data();
    double side = is_still ? 0 : kink.arguments.front()(q, v, t);
    if (!is_still && kink.arguments.size() > 1) side -= kink.arguments.back()(q, v, t);
    all.push_back(side > 0 ? 1 : side < 0 ? -1 : 0);
  }
  return all;
}

std::string KinkWatch::kink_text(std::size_t kink) const {
  return in_backticks(system_.model().expressions[kinks_[kink].call].span);
}

}  // namespace elgen
