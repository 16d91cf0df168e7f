// choose: selects the form in which each function is emitted, and how its entries are written for
// readers.
//
// The recursive form keeps the definitions of the derivation; its cost is linear in the length of a
// chain. The closed form is the cancelled, collected equation. For small models it is cheaper and
// more accurate, because terms that cancel are absent. The costs of both forms are counted after
// common subexpressions are shared. The rules are, in this order:
//
//     the scene demands a form      this form
//     the scene prefers speed       the cheaper form; nothing is rewritten
//     otherwise                     the cheaper form, on a tie the closed form; but never a closed
//                                   form that loses digits which the recursive form keeps
//
// If sums in the chosen form cancel many digits (for float only: any digits), its entries are
// rewritten, and the other form is reconsidered: it is chosen if it loses fewer digits and costs
// little more (choose/text_errors.hpp). Forward dynamics of two or three velocities must lose no
// digits of float; it may be solved by determinants of M (choose/solution.cpp). The last pass adds
// guards against states that algebra ignores, and sets the order of evaluation (choose/finish.hpp).
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
  /// None: the closed form is over budget, or far more expensive than the recursive form.
  std::optional<OperationCounts> closed = {};
  /// The largest loss E / max(E0, |x|) of the recursive form at points at which sums cancel. E is
  /// the error of an entry, E0 the least error of its known rewritings, both in units of the unit
  /// roundoff (choose/text_errors.hpp). x is the largest entry of the field; for V and its
  /// derivatives x is the entry. None if the loss was not computed.
  std::optional<double> recursive_loss = {};
  /// The largest loss of the closed form, defined as `recursive_loss`.
  std::optional<double> closed_loss = {};
  /// The index, over all fields, of the first entry that every closed form computes inaccurately
  /// although the recursive form keeps the digits of the entry (choose/text_errors.hpp).
  std::optional<std::size_t> inaccurate_entry = {};
  /// The index, over all fields, of the first entry for which the limit of rewritings was reached,
  /// so that a form with more digits may exist. None: all rewritings were tried.
  std::optional<std::size_t> limited_entry = {};
  Form chosen_form = Form::recursive;
  bool is_demanded = false;  ///< true: the scene demands `chosen_form` at any cost
};

struct FormChoice {
  Program program = {};  ///< each function in its chosen form; forms for readers in `readable`
  std::vector<FormCosts> costs = {};  ///< parallel to program.functions
};

/// Each element: the coordinates q of a state at which sums of unexpanded_sums() are 0.
using SumZeros = std::vector<std::vector<double>>;

/// Chooses the form of every function of `recursive`; `forms` are the closed forms of `recursive`.
/// A form that avoids the loss of a quarter of the digits may cost a quarter more than the cheapest
/// form. Forms are also compared at rest at domain.minima and near them. If `zeros` is not null,
/// forms are also compared near the states `zeros`, and a form that keeps more digits may cost four
/// times as much. E608: the demanded closed form is over budget.
[[nodiscard]] Result<FormChoice> choose(const Program& recursive, const ClosedForms& forms,
                                        const Domain& domain, const Scene& scene,
                                        const SumZeros* zeros = nullptr);

/// True if solve_by_minors() may give function `index` a form that keeps more digits: it is forward
/// dynamics of two or three velocities, and its chosen form loses digits or has an unknown loss.
[[nodiscard]] bool may_solve_by_minors(const Scene& scene, const FormChoice& choice,
                                       std::size_t index);

/// Replaces forward dynamics, function `index`, by a solution with closed determinants of M
/// (choose/solution.cpp) if this keeps far more digits and costs at most a quarter more than the
/// cheapest form. `parts` has the mass matrix, the bias and, if there are inputs, the input matrix;
/// `recursive` is the program from which the forms of `choice` were chosen.
void solve_by_minors(const Program& parts, const Program& recursive, const Domain& domain,
                     std::size_t index, FormChoice& choice);

/// The minima of V by find_minima() (sample/minima.hpp), for Domain::minima. `potential` has V and
/// its first derivatives (PotentialEquations). None if the scene prefers speed, if V contains open
/// values or no coordinate, or if V or its derivatives have more than 400 instructions.
[[nodiscard]] std::vector<std::vector<double>> find_potential_minima(const Program& potential,
                                                                     const Domain& domain,
                                                                     const Scene& scene);

/// The reader for whom a closed form is written.
enum class Audience : std::uint8_t {
  code,    ///< one function for all entries, the cheapest form
  people,  ///< each entry separately, in its shortest form
};

/// `program` with the closed forms that are short enough: in `functions` if `reader` is code, in
/// `readable` if `reader` is people. Unlike choose(), this function does not compare the costs and
/// lost digits of the forms.
[[nodiscard]] Program with_closed_forms(Program program, Audience reader,
                                        const ClosedFormBudget& budget = {});

/// V and its derivatives (PotentialEquations) as rewritten for accuracy.
struct RewrittenPotential {
  Program program = {};
  bool has_derivatives = true;  ///< true: derivatives of V are rewritten, not only V
};

/// V and its derivatives, rewritten once for all functions that contain V. Typed sums are not
/// expanded if this keeps digits near the zeros of sums or costs less. None if no rewriting differs
/// from the recursive and the closed form, if the scene prefers speed, or if V is too long. Cost:
/// up to nineteen calls of choose() if typed sums lose digits.
[[nodiscard]] std::optional<RewrittenPotential> rewrite_potential(const Program& potential,
                                                                  const Domain& domain,
                                                                  const Scene& scene);

/// `domain` for functions in which V is open (with_open_potential() of equations_of_motion.hpp). In
/// each state, the values of V and its derivatives follow the open values of the model. The result
/// has no minima, because no sum of V is left.
[[nodiscard]] Domain with_open_potential(Domain domain, const Program& potential);

/// Inserts V and its derivatives into copies of the functions of `open_choice`, in which V is open.
/// The copies replace the functions of the same names in `choice`, but not the readable forms.
/// `choice` does not change if a new function would lose digits that the old function keeps, for
/// example if V cancels the weight of bodies.
void insert_potential(const RewrittenPotential& potential, const FormChoice& open_choice,
                      const Domain& domain, FormChoice& choice);

}  // namespace elgen
