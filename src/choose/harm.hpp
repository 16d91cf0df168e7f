// harm: whether a way to write an entry loses digits that the text keeps.
//
//     E(way) > 64 max(E(text), |x|)     at one of the points, E the running error in u
//                                       (evaluate/running_errors.hpp), x the entry
//
// The text is the recursive form: the energies as they were typed, differentiated. In double first;
// where that is not sure in 64 digits, so that every machine decides alike.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "choose/points.hpp"
#include "evaluate/rough_errors.hpp"
#include "evaluate/running_errors.hpp"
#include "lower/graph/rebuild.hpp"

namespace elgen {

/// The errors of the text of one function.
class TextErrors {
 public:
  /// `program` and `text` outlive it. Cost: one operation of double per instruction and point.
  TextErrors(const Program& program, const Function& text, ComparisonPoints points);

  [[nodiscard]] const ComparisonPoints& points() const { return points_; }

  /// Of one entry of the text, by its number among all.
  [[nodiscard]] bool are_passed_by(const Expressions& way, std::size_t entry) const;

  /// The first entry of another form that is harmed; none where no entry is.
  [[nodiscard]] std::optional<std::size_t> harmed_entry(const Program& program,
                                                        const Function& form) const;

 private:
  using Entries = std::vector<std::uint32_t>;

  /// The first of `entries` that harms the entry of the text with the number beside it.
  [[nodiscard]] std::optional<std::size_t> harmed(const Program& program, const Function& form,
                                                  std::size_t first, std::size_t point) const;
  [[nodiscard]] const std::vector<Running>& exact_text(std::size_t point) const;

  const Program& program_;
  const Function& text_;
  ComparisonPoints points_;
  std::vector<std::vector<RoughError>> rough_ = {};  ///< of the text, by point and entry
  mutable std::map<std::size_t, std::vector<Running>> exact_ = {};  ///< once it is asked for
};

}  // namespace elgen
