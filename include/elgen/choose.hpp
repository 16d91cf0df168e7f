// choose: which of its two forms each function is emitted in, and how its entries are written for a
// reader.
//
// The recursive form keeps the definitions of the derivation: linear cost along a chain. The closed
// form is the cancelled, collected equation: for small models fewer operations, and more accurate,
// since what cancels on paper is gone. Both are lowered and counted after sharing, and the cheaper
// is kept, the closed one on a tie, unless the scene asks for one. A closed form that loses digits
// which the recursive one keeps is not taken, whatever it costs. Where sums cancel entries are
// rewritten, and the other form is taken, if digits are lost (choose/text_errors.hpp): many, and
// for a little more, where the scene wants balance; any where it prefers accuracy; never for speed.
// Guards that make either hold at states that algebra passes over come last, and then the order in
// which all is evaluated (choose/finish.hpp).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "elgen/closed_forms.hpp"
#include "elgen/domain.hpp"
#include "elgen/program.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// The cost of one call of a function in either form.
struct FormCosts {
  std::string function = {};
  OperationCounts recursive = {};
  std::optional<OperationCounts> closed = {};  ///< none: given up, or far beyond the recursive form
  /// The largest error of either form at points where sums cancel, as a multiple of |x| and of the
  /// least error of all known rewritings (choose/text_errors.hpp): x is the entry where the scene
  /// prefers accuracy, else the largest one of its field. None where it did not matter.
  std::optional<double> recursive_loss = {};
  std::optional<double> closed_loss = {};
  /// The first entry, by its number among all, that is inaccurate in every closed form tried, while
  /// the recursive form keeps its digits (choose/text_errors.hpp).
  std::optional<std::size_t> inaccurate = {};
  Form chosen = Form::recursive;
  bool is_asked_for = false;  ///< by the scene, whatever it costs
};

struct Choice {
  Program program = {};               ///< with `readable` filled
  std::vector<FormCosts> costs = {};  ///< parallel to program.functions
};

/// Coordinates of states, one list each, where typed sums vanish.
using SumZeros = std::vector<std::vector<double>>;

/// `recursive` is the program the closed forms were made of. A loss of a quarter of the digits is
/// worth a quarter of the cost; with `zeros`, near which forms are judged too, a loss of any digits
/// is worth four times the cost. E608: a closed form is asked for that was given up.
[[nodiscard]] Result<Choice> choose(const Program& recursive, const ClosedForms& forms,
                                    const Domain& domain, const Scene& scene,
                                    const SumZeros* zeros = nullptr);

/// The reader of a closed form.
enum class Reader : std::uint8_t {
  code,    ///< all entries together, the cheapest form
  people,  ///< each entry by itself, the shortest form
};

/// A program with those functions in their closed forms that have one which can be read: for code
/// among its functions, for people among the readable ones. Unlike choose(), it takes no notice of
/// costs and digits of the recursive form.
[[nodiscard]] Program written(Program program, Reader reader, const PresentBudget& budget = {});

/// V and its derivatives (PotentialEquations) in one form each.
struct RewrittenPotential {
  Program program = {};
  bool has_slopes = true;  ///< a derivative differs from its text and its closed form, not V alone
};

/// For all functions that have V: with the typed sums whole that keep digits at the zeros of sums,
/// else that cost less. None where neither V nor a derivative differs from the text and from the
/// closed form, or the scene wants speed alone.
/// Cost: that of choose() up to eighteen times where typed sums lose digits.
[[nodiscard]] std::optional<RewrittenPotential> rewritten_potential(const Program& potential,
                                                                    const Domain& domain,
                                                                    const Scene& scene);

/// The domain of functions that take V and its derivatives as open values behind those of the
/// model.
[[nodiscard]] Domain with_open_potential(Domain domain, const Program& potential);

/// Puts V and its derivatives in the place of the open values behind those of `choice`: the
/// functions of `open` that take any of these replace those of `choice`, which are read as they
/// were. All stay where one would lose digits that it has now, as where V cancels the weight of
/// bodies.
void put_potential(const RewrittenPotential& potential, const Choice& open, const Domain& domain,
                   Choice& choice);

}  // namespace elgen
