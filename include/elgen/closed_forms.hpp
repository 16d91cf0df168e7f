// ClosedForms: every entry of the outputs as one canonical sum over one canonical denominator,
// without GiNaC and without the shared instructions of the program.
//
//     numerator / product of denominator factors, each a sum of   (x + i y) * atoms^exponents
//
// Atoms are the leaves, roots (atom^2 = radicand), opaque calls, and e^(i angle) for every angle of
// a sine or cosine: cos(x) = (e^ix + e^-ix)/2, sin(x) = (e^ix - e^-ix)/(2i). In these exponentials
// sums of angles, products of sines and sin^2 + cos^2 = 1 need no extra rule. Two forms of one
// function of leaves, sines and cosines are therefore the same sum. A form over budget is dropped,
// never approximated.
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

/// numerator / product of factors[i]^exponent; exponents are positive, and no factor divides the
/// numerator.
struct Fraction {
  Polynomial numerator = {};
  std::map<std::uint32_t, std::int32_t> denominator = {};
  friend bool operator==(const Fraction&, const Fraction&) = default;
};

enum class AtomKind : std::uint8_t {
  leaf,
  circular,  ///< e^(i angle), angle = argument / divisor
  root,      ///< sqrt(argument), argument >= 0
  call,      ///< function(arguments)
  pi,
  sum,  ///< a typed sum that is not expanded; its argument is its canonical form
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

/// The atoms and denominator factors to which fractions refer by number.
struct Algebra {
  std::vector<Atom> atoms = {};
  std::unordered_multimap<std::size_t, AtomId> known = {};  ///< atoms by their hash
  /// `shown` as first found; `normal` without common monomial, with leading coefficient 1.
  struct Factor {
    Polynomial shown = {};
    Polynomial normal = {};
  };
  std::vector<Factor> factors = {};
  /// The typed sums that are not expanded, each a function of one entry, in their typed form: the
  /// canonical form hides a^2 sin^2 + b^2 cos^2. Null if there are none.
  std::shared_ptr<const Program> sums = {};
  /// stumpff(x, k) with k > 0 is written as its quotient over powers of x, which has no value at x
  /// = 0.
  bool has_quotients = false;
  /// exp, sinh, cosh and tanh are written by atoms exp(u/12), u a monomial over a denominator.
  bool has_exponentials = false;
};

struct ClosedField {
  std::string name = {};
  std::vector<std::optional<Fraction>> entries = {};  ///< none: over budget
};

/// Parallel to Program::functions; `dynamics` has no fields, since it repeats other outputs.
struct ClosedFunction {
  std::vector<ClosedField> fields = {};
};

struct ClosedForms {
  Algebra algebra = {};
  std::vector<ClosedFunction> functions = {};
};

/// Products of one term with another that may be computed before a form is dropped.
struct PresentBudget {
  std::size_t products_per_function = 30'000;
  std::size_t products = 150'000;
  std::size_t terms = 4'000;  ///< of any intermediate sum
};

/// The closed forms of the functions of a program. Cost: at most `budget`, about 0.4 us per
/// product.
[[nodiscard]] ClosedForms present(const Program& program, const PresentBudget& budget = {});

/// Closed forms that write stumpff(x, k), k > 0, as its quotient, valid for x != 0: sin(x)/x, (1 -
/// cos(x))/x^2, and so on. They reveal its relations to sines and cosines.
[[nodiscard]] ClosedForms present_quotients(const Program& program,
                                            const PresentBudget& budget = {});

/// Closed forms for proofs only. They have these quotients, and write exp, sinh, cosh and tanh by
/// powers of few exponentials. This reveals the relations
///
///     exp(a + b) = exp(a) exp(b),  1/exp(-a) = exp(a),  tanh(a) = (exp(2 a) - 1)/(exp(2 a) + 1)
[[nodiscard]] ClosedForms present_for_proofs(const Program& program,
                                             const PresentBudget& budget = {});

/// True if present_for_proofs() rewrites a function that is an opaque atom for present().
[[nodiscard]] bool is_rewritten_for_proofs(FunctionId function);

/// The sums of a program that may stay unexpanded, each a function of one entry, without
/// duplicates: bases of powers; arguments of roots, of quotients and of functions other than sin,
/// cos and tan; factors of these. Only sums with a coordinate or t count.
///
///     before    F*sqrt((x - 1)^2 + (y - 3/10)^2)
///     after     (x - 1)^2 + (y - 3/10)^2,   x - 1,   y - 3/10
[[nodiscard]] Program typed_sums(const Program& program);

/// Closed forms in which these sums are not expanded wherever they occur. A combination of several
/// sums is expanded if that is shorter: (x + r) + (x - r) becomes 2 x.
[[nodiscard]] ClosedForms present(const Program& program, Program whole_sums,
                                  const PresentBudget& budget = {});

/// True if x = y is proved: x - y is the empty sum. False proves nothing if roots or calls occur.
[[nodiscard]] bool is_proved_equal(ClosedForms& forms, const Fraction& x, const Fraction& y);

/// True if no algebraic relation joins atoms of this kind: leaves, pi, and e^(i m/12) of their
/// monomials m. Closed forms do not know the relations of e^(i m/24), roots, and e^(ix) of
/// fractions x.
[[nodiscard]] bool is_independent(const Algebra& algebra, AtomId id);

/// The verdict of a proof that an entry is 0.
enum class ZeroProof : std::uint8_t {
  open,
  zero,      ///< the empty sum
  not_zero,  ///< another sum of leaves, numbers, pi, sines and cosines, whose form is unique
};

/// Proves entries to be 0 by their closed forms, or else by their forms for proofs, in the order of
/// the fields. A form over budget proves nothing. Cost: one closed form per entry, at most two,
/// within `budget`.
[[nodiscard]] std::vector<ZeroProof> prove_zeros(const Program& program, Function function,
                                                 const PresentBudget& budget = {});

/// dq/dt of every coordinate; empty if the model has no rotation, since dq/dt = v then.
[[nodiscard]] std::vector<Fraction> coordinate_rates(ClosedForms& forms, const Model& model);

/// One term of the rate of an open value: its derivative by an argument times the rate of the
/// argument.
struct OpenTerm {
  std::uint32_t derivative = 0;  ///< number of the leaf
  Fraction argument = {};
};

/// df/dt = sum_i f_i dx_i/dt for every open value of a model. Empty if the rate is unknown, for
/// example for second derivatives.
using OpenTerms = std::vector<std::vector<OpenTerm>>;
[[nodiscard]] OpenTerms open_terms(ClosedForms& forms, const Model& model,
                                   const FixedParameters& fixed);

/// The rates of the leaves of a form. Parameters have rate 0. The rate of inputs, and of leaves
/// beyond the end of a list, is unknown.
struct LeafRates {
  std::vector<Fraction> coordinates = {};  ///< empty: they change at their velocities
  std::vector<Fraction> velocities = {};
  std::vector<Fraction> accelerations = {};
  OpenTerms open_values = {};
  Fraction time = {};
};

/// dx/ds if the leaves change at these rates: sum dx/dleaf dleaf/ds. None if it is over budget or x
/// contains a function with kinks.
[[nodiscard]] std::optional<Fraction> rate_along(ClosedForms& forms, const Fraction& x,
                                                 const LeafRates& rates);

/// dx/dq_k, k = `coordinate` of `coordinates`, for an x without velocities.
[[nodiscard]] std::optional<Fraction> partial_derivative(ClosedForms& forms, const Fraction& x,
                                                         std::uint32_t coordinate,
                                                         std::size_t coordinates);

/// dx/dt along the motion at u = 0. `accelerations` are the forward dynamics, one per velocity. The
/// empty sum proves that x is conserved. None if it is over budget or x contains a function with
/// kinks.
[[nodiscard]] std::optional<Fraction> free_rate(ClosedForms& forms, const Fraction& x,
                                                const std::vector<Fraction>& accelerations,
                                                const std::vector<Fraction>& coordinate_rates = {},
                                                const OpenTerms& open_values = {});

/// One expression of the model over the same atoms. `fixed` parameters are numbers. None if it is
/// over budget.
[[nodiscard]] std::optional<Fraction> closed_form(ClosedForms& forms, const Model& model,
                                                  const FixedParameters& fixed,
                                                  ExpressionId expression);

}  // namespace elgen
