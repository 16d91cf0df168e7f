// Loss: the digits that a formula loses and another may keep, of one function at one state.
//
//     loss = max(0, |x - x*| - N eta) / (u R),     R = |x*| + K
//
// K = sum |z dx/dz| (evaluate/conditioning.hpp) is what one rounding of every input would cost, so
// that an angle of 1e15 rad, which is known to a tenth, excuses what is made of it. In solutions of
// M x = b the norm |D^1/2 x| is taken of errors and of R alike. It is looked at only where |x - x*|
// > 64 u |x*|; elsewhere it is less.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "elgen/choose.hpp"
#include "evaluate/conditioning.hpp"
#include "evaluate/running_errors.hpp"
#include "verify/bounds/field_place.hpp"
#include "verify/bounds/solution_bound.hpp"

namespace elgen {

/// A way to write a field: where its entries are.
struct FieldWay {
  std::string_view name = {};
  const Program* program = nullptr;
  const Function* function = nullptr;
  std::size_t first = 0;  ///< of the field's entries among the function's
};

/// As emitted, as its closed form is read, and in all of `ways` that have the function.
[[nodiscard]] std::vector<FieldWay> field_ways(const Subject& subject, const FieldPlace& place,
                                               const std::vector<Way>& ways);

/// What is lost where it is most.
struct Loss {
  double figure = 0;
  std::size_t entry = 0;  ///< of the field
};

class Losses {
 public:
  /// All arguments outlive it.
  Losses(const Subject& subject, const State& state, const Rounding& rounding)
      : subject_(subject), state_(state), rounding_(rounding) {}

  /// Whether angles are known well enough for K, which is of first order: to 1/1000 rad.
  [[nodiscard]] bool knows_angles() const;

  /// What an entry that is off by `errors` (without N eta) from `exact` loses, or its column of
  /// `columns`, which are judged by their norms. 0 where K has no value.
  [[nodiscard]] double of_entry(const FieldPlace& place, std::size_t entry,
                                const std::vector<Real>& errors, const std::vector<Real>& exact,
                                const std::vector<SolvedColumn>& columns);

  /// The largest of all entries.
  [[nodiscard]] Loss of_field(const FieldPlace& place, const std::vector<Real>& errors,
                              const std::vector<Real>& exact,
                              const std::vector<SolvedColumn>& columns);

  /// Of the code of the entry, the instruction at which errors grow most.
  [[nodiscard]] std::uint32_t culprit(const FieldPlace& place, std::size_t entry);

 private:
  const std::vector<Running>& errors(const Function& function);
  Real reference(const FieldPlace& place, std::size_t entry);
  Real norm_of_references(const FieldPlace& place, const SolvedColumn& column);

  const Subject& subject_;
  const State& state_;
  const Rounding& rounding_;
  std::map<const Function*, std::vector<Running>> errors_ = {};  ///< of all instructions
  std::map<const Function*, std::unique_ptr<Conditioning>> conditioning_ = {};
};

}  // namespace elgen
