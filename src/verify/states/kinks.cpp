// KinkCoverage: finds the side of each kink on which a state lies: the sign of the function's
// argument; for min and max, the sign of the first argument minus the second.
#include "verify/states/kinks.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "elgen/wording.hpp"
#include "sample/states.hpp"

namespace elgen {

KinkCoverage::KinkCoverage(const Model& model) : model_(model) {
  for (ExpressionId id = 0; id < model.expressions.size(); ++id) {
    const Expression& e = model.expressions[id];
    if (e.kind == ExpressionKind::function && is_kinked(e.function))
      one_sided_kinks_.push_back({id});
  }
}

bool KinkCoverage::add_state(const State& state) {
  bool is_new = false;
  for (Kink& kink : one_sided_kinks_) {
    const std::vector<ExpressionId>& arguments = model_.expressions[kink.call].operands;
    auto side = oracle_expression_value(model_, arguments.front(), state);
    if (side && arguments.size() > 1) {
      const auto other = oracle_expression_value(model_, arguments.back(), state);
      side = other ? std::optional(*side - *other) : std::nullopt;
    }
    if (!side || cln::zerop(*side)) continue;
    bool& seen = cln::minusp(*side) ? kink.has_state_below : kink.has_state_above;
    is_new = is_new || !seen;
    seen = true;
  }
  std::erase_if(one_sided_kinks_,
                [](const Kink& kink) { return kink.has_state_below && kink.has_state_above; });
  return is_new;
}

std::string KinkCoverage::one_sided_kinks_text() const {
  std::vector<std::string> texts;
  for (const Kink& kink : one_sided_kinks_) {
    const std::string text = in_backticks(model_.expressions[kink.call].span);
    if (std::ranges::count(texts, text) == 0) texts.push_back(text);
  }
  return fmt::format("{}", fmt::join(texts, ", "));
}

CoveringStates draw_covering_states(const Model& model, const Scene& scene, std::size_t count,
                                    std::uint64_t seed) {
  Sampler draw(seed);
  KinkCoverage kinks(model);
  CoveringStates drawn;
  for (std::size_t turn = 0; turn < most_draws_for_kinks; ++turn) {
    if (turn >= count && kinks.is_complete()) break;
    State state = draw_state(model, scene, draw, turn);
    const bool is_new = kinks.add_state(state);
    if (turn < count || is_new) drawn.states.push_back(std::move(state));
  }
  drawn.one_sided_kinks = kinks.one_sided_kinks_text();
  return drawn;
}

}  // namespace elgen
