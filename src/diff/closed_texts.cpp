// closed_texts: each on its own, so that one that is given up takes no other with it.
#include "diff/closed_texts.hpp"

#include "choose/entries.hpp"
#include "choose/lowered_entries.hpp"
#include "elgen/closed_forms.hpp"
#include "elgen/render.hpp"
#include "lower/graph/prune.hpp"

namespace elgen {
namespace {

/// A form that needs more does not fit into a line.
constexpr PresentBudget texts_budget{
    .products_per_function = 2'000, .products = 60'000, .terms = 300};
/// Nor does what is made of so many.
constexpr std::size_t most_instructions = 400;

/// The entry alone; nothing where it is long.
Function alone(const Function& function, std::uint32_t at) {
  Function one = with_entries(function, {at});
  if (one.instructions.size() <= most_instructions) return one;
  return {.kind = function.kind, .name = function.name};
}

}  // namespace

std::vector<std::string> closed_texts(const Program& program, const Function& function,
                                      const std::vector<std::uint32_t>& instructions) {
  Program each{program.leaves, program.constants, {}};
  for (const std::uint32_t at : instructions) {
    each.functions.push_back(alone(function, at));
  }
  const ClosedForms forms = present(each, texts_budget);
  const MixedPoints points = mixed_points(each.leaves);
  std::vector<bool> is_known;
  for (std::size_t i = 0; i < each.functions.size(); ++i) {
    const ReadableEntries entries =
        read_entries({each, each.functions[i], forms, forms.functions[i]}, points);
    is_known.push_back(is_complete(entries));
    each.readable.push_back(is_known.back() ? lowered_one_by_one(entries, each.functions[i], each)
                                            : Function{});
  }
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < each.functions.size(); ++i) {
    std::string text = is_known[i] ? readable_equations(each, i).entries[0][0] : "";
    texts.push_back(text.size() <= longest_read ? std::move(text) : "");
  }
  return texts;
}

}  // namespace elgen
