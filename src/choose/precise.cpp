// precise: all ways in the order of their lengths.
#include "choose/precise.hpp"

#include <algorithm>

#include "choose/ways.hpp"
#include "lower/network/linearise.hpp"

namespace elgen {
namespace {

void append(std::vector<Expressions>& ways, std::vector<Collected> more) {
  for (Collected& way : more) ways.push_back(std::move(way.expressions));
}

std::vector<Expressions> all_ways(const Algebra& algebra, const Fraction& form,
                                  const DerivedEntry* derived) {
  std::vector<Expressions> ways;
  append(ways, collected_ways(algebra, form));
  append(ways, precise_ways(algebra, form));
  if (derived != nullptr) {
    ways.push_back(derived_way(derived->written_out).expressions);
    ways.push_back(derived->as_it_stands);
  }
  for (std::size_t i = ways.size(); i-- > 0;) {
    if (auto conjugate = with_conjugates(ways[i])) ways.push_back(std::move(*conjugate));
  }
  std::ranges::stable_sort(ways, {}, [](const Expressions& way) { return written_length(way); });
  return ways;
}

double loss_of(const Expressions& way, const ComparisonPoints& points,
               const std::vector<double>& beside = {}) {
  Program program;
  Function function;
  function.fields = {Field{"", 1, 1, {0}}};
  linearise(make_network(way), program, function);
  return possible_loss(program, function, points, beside);
}

}  // namespace

std::optional<Expressions> harmless_way(const Algebra& algebra, const Fraction& form,
                                        const DerivedEntry* derived, const TextErrors& text,
                                        std::size_t entry) {
  for (Expressions& way : all_ways(algebra, form, derived)) {
    if (!text.are_passed_by(way, entry)) return std::move(way);
  }
  return std::nullopt;
}

std::optional<Expressions> more_precise(const Algebra& algebra, const Fraction& form,
                                        const DerivedEntry* derived, const LossyEntry& entry,
                                        const ComparisonPoints& points) {
  std::optional<Expressions> best;
  double least = entry.loss;
  for (Expressions& way : all_ways(algebra, form, derived)) {
    if (written_length(way) > entry.longest) break;
    const double own = loss_of(way, points, entry.beside);
    if (own >= least) continue;
    least = own;
    best = std::move(way);
    if (least <= entry.tolerated) return best;
  }
  if (!loses_more(entry.loss, least, entry.tolerated)) return std::nullopt;
  return best;
}

std::optional<Expressions> shorter_precise(const Algebra& algebra, const Fraction& form,
                                           const Expressions& known,
                                           const ComparisonPoints& points) {
  for (Collected& way : precise_ways(algebra, form)) {
    const bool is_shorter = way.length < written_length(known);
    if (is_shorter && loss_of(way.expressions, points) <= tolerated_loss) {
      return std::move(way.expressions);
    }
  }
  return std::nullopt;
}

}  // namespace elgen
