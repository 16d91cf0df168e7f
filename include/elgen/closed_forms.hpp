// ClosedForms: every entry of the outputs as one canonical sum over one canonical denominator,
// without GiNaC and without the shared instructions of the program.
//
//     numerator / product of denominator factors, each a sum of   (x + i y) * atoms^exponents
//
// Atoms are the leaves, roots (atom^2 = radicand), opaque calls, and e^(i angle) for every angle of
// a sine or cosine: cos(x) = (e^ix + e^-ix)/2, sin(x) = (e^ix - e^-ix)/(2i). Written with these
// exponentials, sums of angles, products of sines and sin^2 + cos^2 = 1 need no extra rule. Two
// equal expressions of leaves, sines and cosines therefore have the same canonical sum. A form over
// budget is dropped, never approximated.
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

/// numerator / product of Algebra::factors[i]^exponent over the entries i -> exponent of
/// `denominator`. Exponents are positive, and no factor divides the numerator.
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
  unexpanded_sum,  ///< a typed sum that is not expanded; its argument is its canonical form
};

struct Atom {
  AtomKind kind = AtomKind::leaf;
  Opcode leaf = Opcode::constant;
  std::uint32_t index = 0;  ///< number of the leaf, or of the function in Algebra::unexpanded_sums
  FunctionId function = FunctionId::sin;
  cln::cl_RA divisor = 1;
  std::vector<Fraction> arguments = {};
  friend bool operator==(const Atom&, const Atom&) = default;
};

/// The atoms and denominator factors to which fractions refer by number.
struct Algebra {
  std::vector<Atom> atoms = {};
  std::unordered_multimap<std::size_t, AtomId> atoms_by_hash = {};  ///< hash -> index in `atoms`
  /// `shown`: the factor as first found. `normal`: the factor without its common monomial, scaled
  /// to the leading coefficient 1.
  struct Factor {
    Polynomial shown = {};
    Polynomial normal = {};
  };
  std::vector<Factor> factors = {};
  /// The typed sums that are not expanded, each as a function with one entry. Null if all sums are
  /// expanded. A sum such as a^2 sin^2 + b^2 cos^2 stays as typed, because its expansion is long.
  std::shared_ptr<const Program> unexpanded_sums = {};
  /// True: stumpff(x, k) with k > 0 is written as its quotient over powers of x, which has no value
  /// at x = 0.
  bool has_quotients = false;
  /// True: exp, sinh, cosh and tanh are written by atoms exp(u/12), u a monomial over a
  /// denominator.
  bool has_exponentials = false;
};

struct ClosedField {
  std::string name = {};
  std::vector<std::optional<Fraction>> entries = {};  ///< none: no closed form within the budget
};

/// The closed forms of one function. `dynamics` has no fields, because it repeats other outputs.
struct ClosedFunction {
  std::vector<ClosedField> fields = {};
};

struct ClosedForms {
  Algebra algebra = {};
  std::vector<ClosedFunction> functions = {};  ///< parallel to Program::functions
};

/// Limits beyond which a form is dropped. `products`: products of two terms.
struct ClosedFormBudget {
  std::size_t products_per_function = 30'000;
  std::size_t products = 150'000;
  std::size_t terms = 4'000;  ///< largest number of terms of an intermediate sum
};

/// The closed forms of the functions of a program. Cost: at most `budget`, about 0.4 us per
/// product.
[[nodiscard]] ClosedForms present(const Program& program, const ClosedFormBudget& budget = {});

/// Closed forms in which stumpff(x, k), k > 0, is written as a quotient, valid for x != 0:
/// sin(x)/x, (1 - cos(x))/x^2, and so on. The quotients reveal how stumpff depends on sines and
/// cosines.
[[nodiscard]] ClosedForms present_quotients(const Program& program,
                                            const ClosedFormBudget& budget = {});

/// Closed forms for proofs only: present_quotients() with exp, sinh, cosh and tanh written as
/// powers of a few exponentials. The exponentials reveal the relations
///
///     exp(a + b) = exp(a) exp(b),  1/exp(-a) = exp(a),  tanh(a) = (exp(2 a) - 1)/(exp(2 a) + 1)
[[nodiscard]] ClosedForms present_for_proofs(const Program& program,
                                             const ClosedFormBudget& budget = {});

/// True if calls of `function` are opaque atoms for present(), but not for present_for_proofs().
[[nodiscard]] bool is_rewritten_for_proofs(FunctionId function);

/// The sums of a program that may stay unexpanded, each a function of one entry, without
/// duplicates. These sums contain a coordinate or t. Each sum is, or is a factor of, the base of a
/// power, a radicand, a denominator, or an argument of a function other than sin, cos and tan.
///
///     before    F*sqrt((x - 1)^2 + (y - 3/10)^2)
///     after     (x - 1)^2 + (y - 3/10)^2,   x - 1,   y - 3/10
[[nodiscard]] Program unexpanded_sums(const Program& program);

/// Closed forms in which the sums of `unexpanded_sums`, the program that unexpanded_sums() returns,
/// stay unexpanded. A combination of several of these sums is expanded if the expanded form has
/// fewer terms: (x + r) + (x - r) becomes 2 x.
[[nodiscard]] ClosedForms present(const Program& program, Program unexpanded_sums,
                                  const ClosedFormBudget& budget = {});

/// True if x - y is the empty sum, which proves x = y. False proves nothing if x or y contains
/// roots or calls, or if x - y is over budget.
[[nodiscard]] bool is_proved_equal(ClosedForms& forms, const Fraction& x, const Fraction& y);

/// True if the atom `id` is a leaf, pi, or e^(i m/12) for a monomial m of leaves and pi: no
/// algebraic relation connects these atoms. False for e^(i m/24), roots, e^(ix) for fractions x,
/// and all other atoms, whose relations closed forms do not use.
[[nodiscard]] bool is_independent(const Algebra& algebra, AtomId id);

/// The result of an attempt to prove that an entry is 0.
enum class ZeroProof : std::uint8_t {
  undecided,  ///< the form is over budget, or neither empty nor known to be unique
  zero,       ///< the canonical form is the empty sum
  not_zero,   ///< the form is not empty, and unique: it has only leaves, numbers, pi, sin and cos
};

/// One result per entry of `function`, field by field. Entries that present() leaves undecided are
/// tried again with present_for_proofs(). A form over budget proves nothing. Cost: one or two
/// closed forms per entry, within `budget`.
[[nodiscard]] std::vector<ZeroProof> prove_zeros(const Program& program, Function function,
                                                 const ClosedFormBudget& budget = {});

/// dq_i/dt = (N(q) v)_i, one entry per coordinate; empty if the model has no rotation (N = 1).
[[nodiscard]] std::vector<Fraction> coordinate_rates(ClosedForms& forms, const Model& model);

/// The term f_i dx_i/dt of df/dt: f is an open value, and f_i is df/dx_i for the argument x_i of f.
struct OpenValueRateTerm {
  std::uint32_t derivative = 0;  ///< number of the leaf f_i
  Fraction argument = {};        ///< x_i
};

/// For every open value f of a model, the terms of df/dt = sum_i f_i dx_i/dt. No terms if the rate
/// is unknown, for example for second derivatives.
using OpenValueRates = std::vector<std::vector<OpenValueRateTerm>>;
[[nodiscard]] OpenValueRates open_value_rates(ClosedForms& forms, const Model& model,
                                              const FixedParameters& fixed);

/// The rates of leaves along a curve. Parameters have rate 0. The rates of inputs, and of leaves
/// that the lists do not contain, are unknown.
struct LeafRates {
  std::vector<Fraction> coordinates = {};  ///< dq_i/ds; empty: dq_i/ds = v_i
  std::vector<Fraction> velocities = {};
  std::vector<Fraction> accelerations = {};
  OpenValueRates open_values = {};
  Fraction time = {};
};

/// dx/ds = sum dx/dleaf dleaf/ds, with `rates` = dleaf/ds. None if the sum is over budget, a rate
/// is unknown, or x contains a function with kinks.
[[nodiscard]] std::optional<Fraction> directional_derivative(ClosedForms& forms, const Fraction& x,
                                                             const LeafRates& rates);

/// dx/dq_k, k = `coordinate`. `coordinates` is the number of coordinates; x must not contain
/// velocities. None as for directional_derivative().
[[nodiscard]] std::optional<Fraction> partial_derivative(ClosedForms& forms, const Fraction& x,
                                                         std::uint32_t coordinate,
                                                         std::size_t coordinates);

/// dx/dt along the motion at u = 0, for the forward dynamics `accelerations`, one per velocity. The
/// empty sum proves that x is conserved. None as for directional_derivative().
[[nodiscard]] std::optional<Fraction> unforced_rate(
    ClosedForms& forms, const Fraction& x, const std::vector<Fraction>& accelerations,
    const std::vector<Fraction>& coordinate_rates = {}, const OpenValueRates& open_values = {});

/// The closed form of `expression`, with the `fixed` parameters as numbers. New atoms are added to
/// `forms`. None if the closed form is over budget.
[[nodiscard]] std::optional<Fraction> closed_form(ClosedForms& forms, const Model& model,
                                                  const FixedParameters& fixed,
                                                  ExpressionId expression);

}  // namespace elgen
