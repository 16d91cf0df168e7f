// choose: selects the form in which each function is emitted, and how its entries are written for
// readers.
//
// The recursive form keeps the definitions of the derivation: its cost is linear along a chain. The
// closed form is the cancelled, collected equation. For small models it is cheaper and more
// accurate, because cancelling terms are gone. Both forms are lowered and their operations counted
// after sharing. The cheaper form wins, the closed form on a tie, unless the scene demands a form.
// A closed form that loses digits which the recursive form keeps is never chosen. If sums cancel
// many digits (any digits in a scene for float alone), entries are rewritten and the other form is
// reconsidered (choose/text_errors.hpp). It is chosen if it costs little more. If the scene prefers
// speed, nothing is rewritten. Guards against states that algebra ignores, and the order of
// evaluation, come last (choose/finish.hpp).
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
  /// None: over budget, or far more expensive than recursive.
  std::optional<OperationCounts> closed = {};
  /// The largest relative error of a form at points at which sums cancel (choose/text_errors.hpp).
  /// It is relative to |x| or, if larger, to the least error of all known rewritings. x is the
  /// largest entry of the field; for V and its derivatives x is the entry. None if it was not
  /// computed.
  std::optional<double> recursive_loss = {};
  std::optional<double> closed_loss = {};
  /// The number of the first entry that every closed form computes inaccurately although the
  /// recursive form keeps its digits (choose/text_errors.hpp).
  std::optional<std::size_t> inaccurate = {};
  Form chosen = Form::recursive;
  bool is_demanded = false;  ///< the scene demands this form at any cost
};

struct Choice {
  Program program = {};               ///< with `readable` filled in
  std::vector<FormCosts> costs = {};  ///< parallel to program.functions
};

/// States, as lists of coordinates, at which typed sums are 0.
using SumZeros = std::vector<std::vector<double>>;

/// `recursive` is the program of the closed forms. A loss of a quarter of the digits outweighs a
/// quarter of the cost. If `zeros` is given, forms are also compared near these states, and any
/// loss outweighs four times the cost. E608: the demanded closed form is over budget.
[[nodiscard]] Result<Choice> choose(const Program& recursive, const ClosedForms& forms,
                                    const Domain& domain, const Scene& scene,
                                    const SumZeros* zeros = nullptr);

/// The reader for whom a closed form is written.
enum class Reader : std::uint8_t {
  code,    ///< one function for all entries, the cheapest form
  people,  ///< every entry alone, the shortest form
};

/// Replaces functions by their closed forms if these are short enough: for code in `functions`, for
/// people in `readable`. Unlike choose() it ignores costs and lost digits of the recursive form.
[[nodiscard]] Program with_closed_forms(Program program, Reader reader,
                                        const PresentBudget& budget = {});

/// V and its derivatives (PotentialEquations), each in one form.
struct RewrittenPotential {
  Program program = {};
  bool has_slopes = true;  ///< a derivative, not only V, differs from its text and its closed form
};

/// Rewrites V for all functions that contain it. Typed sums stay intact if this keeps digits near
/// the zeros of sums or costs less. None if V and its derivatives equal their text or their closed
/// form, or if the scene prefers speed. Cost: choose() up to eighteen times if typed sums lose
/// digits.
[[nodiscard]] std::optional<RewrittenPotential> rewrite_potential(const Program& potential,
                                                                  const Domain& domain,
                                                                  const Scene& scene);

/// The domain of functions that read V and its derivatives as open values after the model's own
/// ones.
[[nodiscard]] Domain with_open_potential(Domain domain, const Program& potential);

/// Replaces the open values of V in `open` by V and its derivatives. Functions of `open` that read
/// such a value then replace their counterparts in `choice`; readable forms stay. Nothing changes
/// if a function would lose digits that it keeps now, for example if V cancels the weight of
/// bodies.
void insert_potential(const RewrittenPotential& potential, const Choice& open, const Domain& domain,
                      Choice& choice);

}  // namespace elgen
