// ClosedForms: every entry of the wanted outputs as one canonical sum over one canonical
// denominator, free of GiNaC and of the program's sharing.
//
//     numerator / product of denominator factors, each a sum of   (x + i y) * atoms^exponents
//
// Atoms are the leaves, roots (atom^2 = radicand), opaque calls, and e^(i angle) for every angle
// that sines and cosines are taken of: cos(x) = (e^ix + e^-ix)/2, sin(x) = (e^ix - e^-ix)/(2i). In
// these exponentials sums of angles, products of sines and sin^2 + cos^2 = 1 need no rule of their
// own, so that two forms of one function of leaves, sines and cosines are the same sum. A form is
// given up, never approximated, where it outgrows its budget.
#pragma once

#include <cln/rational.h>

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "elgen/polynomial.hpp"
#include "elgen/program.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// numerator / product of factors[i]^exponent, exponents positive; no factor divides the numerator.
struct Fraction {
  Polynomial numerator = {};
  std::map<std::uint32_t, std::int32_t> denominator = {};
  friend bool operator==(const Fraction&, const Fraction&) = default;
};

enum class AtomKind : std::uint8_t {
  leaf,
  circular,  ///< e^(i angle), angle = argument / divisor
  root,      ///< sqrt(argument), argument positive
  call,      ///< function(arguments)
  pi,
  sum,  ///< a typed sum that stays whole: its argument is its canonical form
};

struct Atom {
  AtomKind kind = AtomKind::leaf;
  Opcode leaf = Opcode::constant;
  std::uint32_t index = 0;  ///< of the leaf, or of the sum in Algebra::sums
  FunctionId function = FunctionId::sin;
  cln::cl_RA divisor = 1;
  std::vector<Fraction> arguments = {};
  friend bool operator==(const Atom&, const Atom&) = default;
};

/// The atoms and denominator factors that fractions refer to.
struct Algebra {
  std::vector<Atom> atoms = {};
  std::unordered_multimap<std::size_t, AtomId> known = {};  ///< of each atom, by its hash
  /// As first met, and normalised: without common monomial, leading coefficient 1.
  struct Factor {
    Polynomial shown = {};
    Polynomial normal = {};
  };
  std::vector<Factor> factors = {};
  /// Sums that stay whole, each as a function of one entry: as it is typed, since a canonical form
  /// forgets a^2 sin^2 + b^2 cos^2. Null where there are none.
  std::shared_ptr<const Program> sums = {};
  /// stumpff(x, k > 0) is no atom but its quotient over powers of x, which has no value at 0.
  bool has_quotients = false;
  /// exp, sinh, cosh and tanh are written by atoms exp(u/12), u a monomial over a denominator.
  bool has_exponentials = false;
};

struct ClosedField {
  std::string name = {};
  std::vector<std::optional<Fraction>> entries = {};  ///< none: beyond the budget
};

/// Parallel to Program::functions; `dynamics` has no fields, since it repeats the others.
struct ClosedFunction {
  std::vector<ClosedField> fields = {};
};

struct ClosedForms {
  Algebra algebra = {};
  std::vector<ClosedFunction> functions = {};
};

/// Terms multiplied with terms: what a form may cost before it is given up.
struct PresentBudget {
  std::size_t products_per_function = 30'000;
  std::size_t products = 150'000;
  std::size_t terms = 4'000;  ///< of any one sum on the way
};

/// The closed forms of a program's functions. Cost: at most `budget`, about 0.4 us a product.
[[nodiscard]] ClosedForms present(const Program& program, const PresentBudget& budget = {});

/// Closed forms in which stumpff(x, k) of k > 0 is the quotient that it is at x != 0, so that its
/// relations to sines and cosines are seen: sin(x)/x, (1 - cos(x))/x^2, and so on.
[[nodiscard]] ClosedForms present_quotients(const Program& program,
                                            const PresentBudget& budget = {});

/// Closed forms for proofs alone: with these quotients, and with exp, sinh, cosh and tanh written
/// by powers of few exponentials, so that these relations are seen:
///
///     exp(a + b) = exp(a) exp(b),  1/exp(-a) = exp(a),  tanh(a) = (exp(2 a) - 1)/(exp(2 a) + 1)
[[nodiscard]] ClosedForms present_for_proofs(const Program& program,
                                             const PresentBudget& budget = {});

/// Whether forms for proofs take a function apart that present() has as an atom.
[[nodiscard]] bool is_taken_apart(FunctionId function);

/// The sums of a program that may stay whole, each a function of one entry, none twice: the bases
/// of powers and the arguments of roots, quotients and functions other than sines, cosines and
/// tangents, and the factors of these, where they hold a coordinate or t.
///
///     before    F*sqrt((x - 1)^2 + (y - 3/10)^2)
///     after     (x - 1)^2 + (y - 3/10)^2,   x - 1,   y - 3/10
[[nodiscard]] Program typed_sums(const Program& program);

/// Closed forms in which these sums stay whole: they are not multiplied out, wherever they stand. A
/// sum of several that is shorter multiplied out is written so: (x + r) + (x - r) is 2 x.
[[nodiscard]] ClosedForms present(const Program& program, Program whole_sums,
                                  const PresentBudget& budget = {});

/// Whether x = y is proved: x - y is the empty sum. False says nothing where roots or calls occur.
[[nodiscard]] bool proved_equal(ClosedForms& forms, const Fraction& x, const Fraction& y);

/// Whether no algebraic relation joins atoms of this sort: leaves, pi, and e^(i m/12) of monomials
/// m of these. e^(i m/24), roots, and e^(ix) of fractions x have relations that forms do not know.
[[nodiscard]] bool is_independent(const Algebra& algebra, AtomId id);

/// The verdict of a closed form.
enum class ZeroProof : std::uint8_t {
  open,
  zero,      ///< the empty sum
  not_zero,  ///< another sum of leaves, numbers, pi, sines and cosines, which has one form
};

/// Proofs by the closed form of each entry, in the order of the fields, or else by its form for
/// proofs. A form that is given up is no proof. Cost: that of the forms, within the budget.
[[nodiscard]] std::vector<ZeroProof> proved_zeros(const Program& program, Function function,
                                                  const PresentBudget& budget = {});

/// dq/dt of every coordinate; empty where nothing rotates, and dq/dt is v.
[[nodiscard]] std::vector<Fraction> coordinate_rates(ClosedForms& forms, const Model& model);

/// One term of the rate of an open value: its derivative by an argument times the argument's rate.
struct OpenTerm {
  std::uint32_t derivative = 0;  ///< the number of the leaf
  Fraction argument = {};
};

/// df/dt = sum_i f_i dx_i/dt of every open value of a model; empty where it is not known, as that
/// of second derivatives is not.
using OpenTerms = std::vector<std::vector<OpenTerm>>;
[[nodiscard]] OpenTerms open_terms(ClosedForms& forms, const Model& model,
                                   const FixedParameters& fixed);

/// How fast the leaves of a form change; parameters stand still. The rate of a leaf beyond the end
/// of its list, and of inputs, is not known.
struct LeafRates {
  std::vector<Fraction> coordinates = {};  ///< empty: they change at their velocities
  std::vector<Fraction> velocities = {};
  std::vector<Fraction> accelerations = {};
  OpenTerms open_values = {};
  Fraction time = {};
};

/// dx/ds where the leaves change at these rates: sum dx/dleaf dleaf/ds. None beyond the budget, and
/// of functions with kinks.
[[nodiscard]] std::optional<Fraction> rate_along(ClosedForms& forms, const Fraction& x,
                                                 const LeafRates& rates);

/// dx/dq_k, k the number of one of so many coordinates, of an x that holds no velocities.
[[nodiscard]] std::optional<Fraction> partial_derivative(ClosedForms& forms, const Fraction& x,
                                                         std::uint32_t coordinate,
                                                         std::size_t coordinates);

/// dx/dt along the motion at u = 0; `accelerations` are those of the forward dynamics, one per
/// velocity. The empty sum proves that x is conserved. None beyond the budget, and of functions
/// with kinks.
[[nodiscard]] std::optional<Fraction> free_rate(ClosedForms& forms, const Fraction& x,
                                                const std::vector<Fraction>& accelerations,
                                                const std::vector<Fraction>& coordinate_rates = {},
                                                const OpenTerms& open_values = {});

/// One expression of the model over the same atoms; `fixed` parameters are numbers. None where it
/// outgrows the budget.
[[nodiscard]] std::optional<Fraction> closed_form(ClosedForms& forms, const Model& model,
                                                  const FixedParameters& fixed,
                                                  ExpressionId expression);

}  // namespace elgen
