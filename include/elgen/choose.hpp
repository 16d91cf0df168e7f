// choose: selects the form in which each function is emitted, and how its entries are written for
// readers.
//
// The recursive form keeps the definitions of the derivation: its cost is linear along a chain. The
// closed form is the cancelled, collected equation: for small models it is cheaper and more
// accurate, since cancelling terms are gone. Both are lowered and counted after sharing. The
// cheaper one is kept, the closed one on a tie, unless the scene asks for one. A closed form that
// loses digits which the recursive one keeps is never taken. If many digits are lost where sums
// cancel, or any in a scene for float alone, entries are rewritten and the other form is considered
// (choose/text_errors.hpp): it is taken if it costs little more. Nothing of this happens if the
// scene prefers speed. Guards against states that algebra ignores, and the order of evaluation,
// come last (choose/finish.hpp).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "elgen/closed_forms.hpp"
#include "elgen/domain.hpp"
#include "elgen/program.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// The cost of one call of a function in both forms.
struct FormCosts {
  std::string function = {};
  OperationCounts recursive = {};
  std::optional<OperationCounts> closed = {};  ///< none: given up, or far beyond the recursive form
  /// The largest error of a form at points where sums cancel, relative to |x| and to the least
  /// error of all known rewritings (choose/text_errors.hpp). x is the largest entry of the field;
  /// of V and its derivatives it is the entry itself. None if it was not needed.
  std::optional<double> recursive_loss = {};
  std::optional<double> closed_loss = {};
  /// The number of the first entry that is inaccurate in every closed form tried, while the
  /// recursive form keeps its digits (choose/text_errors.hpp).
  std::optional<std::size_t> inaccurate = {};
  Form chosen = Form::recursive;
  bool is_asked_for = false;  ///< the scene asks for this form at any cost
};

struct Choice {
  Program program = {};               ///< with `readable` filled
  std::vector<FormCosts> costs = {};  ///< parallel to program.functions
};

/// States, as lists of coordinates, where typed sums vanish.
using SumZeros = std::vector<std::vector<double>>;

/// `recursive` is the program of the closed forms. A loss of a quarter of the digits is worth a
/// quarter of the cost. With `zeros`, near which forms are compared too, any loss is worth four
/// times the cost. E608: the requested closed form was given up.
[[nodiscard]] Result<Choice> choose(const Program& recursive, const ClosedForms& forms,
                                    const Domain& domain, const Scene& scene,
                                    const SumZeros* zeros = nullptr);

/// The reader of a closed form.
enum class Reader : std::uint8_t {
  code,    ///< all entries together, the cheapest form
  people,  ///< each entry by itself, the shortest form
};

/// A program with closed forms in place of the functions that have a readable one: for code among
/// its functions, for people among the readable ones. Unlike choose(), it ignores costs and digits
/// of the recursive form.
[[nodiscard]] Program written(Program program, Reader reader, const PresentBudget& budget = {});

/// V and its derivatives (PotentialEquations) in one form each.
struct RewrittenPotential {
  Program program = {};
  bool has_slopes = true;  ///< a derivative, not V alone, differs from its text and its closed form
};

/// Rewrites V for all functions that contain it: typed sums stay whole if that keeps digits at the
/// zeros of sums, or costs less. None if neither V nor a derivative differs from the text and the
/// closed form, or the scene prefers speed.
/// Cost: that of choose() up to eighteen times if typed sums lose digits.
[[nodiscard]] std::optional<RewrittenPotential> rewritten_potential(const Program& potential,
                                                                    const Domain& domain,
                                                                    const Scene& scene);

/// The domain of functions that take V and its derivatives as open values after those of the model.
[[nodiscard]] Domain with_open_potential(Domain domain, const Program& potential);

/// Replaces the open values after those of `choice` by V and its derivatives: functions of `open`
/// that take any of these replace those of `choice`, whose readable forms stay. Nothing changes if
/// one would lose digits that it has now, for example where V cancels the weight of bodies.
void put_potential(const RewrittenPotential& potential, const Choice& open, const Domain& domain,
                   Choice& choice);

}  // namespace elgen
