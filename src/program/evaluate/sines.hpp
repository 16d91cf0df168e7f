// Sines: sine and cosine as emitted code computes them, operation by operation.
//
// k is the integer nearest to 2/pi x. x - k pi/2 = r - rest, |r| <= pi/4: `rest` is the rounding
// error of r. The polynomials s and c have the required accuracy for these r:
//
//     sin(r - rest) = r - (rest - r^3 s(r^2))
//     cos(r - rest) = (1 - r^2/2) + (r^4 c(r^2) + r rest + the rounding error of 1 - r^2/2)
//
// The last two bits of k select sin(x) from +-sin(r - rest) and +-cos(r - rest). pi/2 is a sum
// of parts, so that the product of k and every part except the last is exact. In functions of
// single numbers (not of packs), errors are at most 1.5 ulp (0.9 in float), and 0.5 ulp next to
// multiples of pi/2.
//
// A lone sine or cosine can be faster by a single polynomial over half a period. n is the integer
// nearest to x/pi (cosine: the nearest integer plus 1/2), and x - n pi = r, |r| <= pi/2:
//
//     sin(x) = +-sin(r), cos(x) = +-sin(r),     sin(r) = r + r^3 s(r^2)
//
// The errors are at most 3 ulp: at pi/2 the roundings of r^3 s add to 2.2 u, u half the epsilon,
// and the last sum adds 0.5 u; at 1 the roundings of r add 1.1 u, and all others 1.2 u. The largest
// error seen is 2.6 ulp. So the absolute errors are less than least_lone_sine_error(), and only a
// scene that permits this error has such sines.
#pragma once

#include <cln/rational.h>

#include <cstdint>
#include <string>
#include <vector>

#include "elgen/evaluate.hpp"
#include "elgen/scene.hpp"
#include "program/evaluate/sine_calls.hpp"

namespace elgen {

/// Coefficients of the sine from x^3 on, or of the cosine from x^4 on.
struct SinePolynomial {
  int degree = 0;
  double error = 0;  ///< bound for the angles of its table, without rounding errors
  std::vector<double> coefficients = {};
};

[[nodiscard]] const std::vector<SinePolynomial>& sine_polynomials();
[[nodiscard]] const std::vector<SinePolynomial>& cosine_polynomials();

/// Sines for angles up to pi/2: for float, for double.
[[nodiscard]] const std::vector<SinePolynomial>& lone_sine_polynomials();

/// Constants that reduce an angle by multiples of pi/2 in this scalar.
struct AngleReduction {
  ScalarKind scalar = ScalarKind::double_precision;
  double domain = 0;               ///< the largest angle that is reduced
  std::vector<double> parts = {};  ///< sum to pi/2: leading bits, next bits, the rest rounded
  double inverse = 0;              ///< 2/pi, rounded
  double shift = 0;                ///< 1.5/epsilon: x + shift - shift is the integer nearest to x
  double rounding = 0;             ///< the largest rounding error of a polynomial
};

/// The constants of float or double.
[[nodiscard]] const AngleReduction& angle_reduction(ScalarKind scalar);

/// The polynomial of least degree whose error plus rounding error in `scalar` is at most
/// `max_error`; if no polynomial is as accurate, the polynomial of the largest degree.
[[nodiscard]] const SinePolynomial& lowest_degree_polynomial(const std::vector<SinePolynomial>& all,
                                                             const cln::cl_RA& max_error,
                                                             ScalarKind scalar);

/// The arguments of the emitted function: packs of numbers (one number for each state of a batch),
/// or single numbers. For an angle beyond the domain, a function of packs returns NaN, and a
/// function of numbers calls the library.
enum class SineArithmetic : std::uint8_t { packs, numbers };

/// The permitted absolute error of the polynomials. For packs: trigonometry_error() of `numerics`.
/// For numbers: 2^-52, or 2^-23 in float.
[[nodiscard]] cln::cl_RA sine_error(const Numerics& numerics, SineArithmetic arithmetic,
                                    ScalarKind scalar);

/// True if functions of numbers compute sines inline: `scalar` is float or double, and the scene
/// does not ask for the library.
[[nodiscard]] bool has_inline_sines(const Scene& scene, ScalarKind scalar);

/// The polynomial of lone sines and cosines in functions of numbers; nullptr if the code has no
/// sines in line, or if the scene permits no error of least_lone_sine_error().
[[nodiscard]] const SinePolynomial* lone_sine_polynomial(const Scene& scene, ScalarKind scalar);

/// A constant of the algorithm: "domain", "inverse", "shift", "part_1", "sine_3", "cosine_4". For
/// lone sines "inverse_pi", "pi_1", "lone_3".
struct SineConstant {
  std::string name;
  double value;
};

/// All constants of the algorithm for this scalar, except the constants of lone sines.
[[nodiscard]] std::vector<SineConstant> sine_constants(const Numerics& numerics,
                                                       SineArithmetic arithmetic,
                                                       ScalarKind scalar);

/// The constants of lone sines. Empty if functions of numbers in this scalar have no lone sine, or
/// have no lone_sine_polynomial() for it.
[[nodiscard]] std::vector<SineConstant> lone_sine_constants(const Scene& scene,
                                                            const Program& program,
                                                            ScalarKind scalar);

/// Computes sine and cosine with the bits of emitted code. Scalar: float or double.
template <class Scalar>
class SineEvaluator {
 public:
  SineEvaluator(const Scene& scene, SineArithmetic arithmetic);

  struct SineCosinePair {
    Scalar sine;
    Scalar cosine;
  };
  [[nodiscard]] SineCosinePair evaluate(Scalar angle) const;

  /// sin or cos of `angle`, alone in its function.
  [[nodiscard]] Scalar evaluate_lone(FunctionId function, Scalar angle) const;

  /// lone_sine_calls() of the function if these calls have a polynomial; else empty.
  [[nodiscard]] std::vector<bool> lone_calls(const Function& function) const;

 private:
  const AngleReduction& reduction_;
  SineArithmetic arithmetic_;
  bool is_library_;
  SineCosinePairing pairing_;
  std::vector<Scalar> lone_ = {};  ///< coefficients; empty without lone_sine_polynomial()
  std::vector<Scalar> sine_;
  std::vector<Scalar> cosine_;
};

/// Rules of fold.hpp that reproduce the bits of emitted code.
template <class Scalar>
struct EmittedCodeRules : interpreter::NumberRules<Scalar> {
  const SineEvaluator<Scalar>& sines;

  [[nodiscard]] Scalar call(FunctionId function, const Scalar& x, const Scalar& y) const {
    if (function == FunctionId::sin) return sines.evaluate(x).sine;
    if (function == FunctionId::cos) return sines.evaluate(x).cosine;
    return interpreter::call(function, x, y);
  }
};

/// The entries of all fields, with the bits of emitted code.
template <class Scalar>
[[nodiscard]] std::vector<Scalar> evaluate_as_emitted(const Program& program,
                                                      const Function& function,
                                                      const Arguments<Scalar>& arguments,
                                                      const SineEvaluator<Scalar>& sines) {
  const EmittedCodeRules<Scalar> rules{{arguments}, sines};
  const std::vector<bool> is_lone = sines.lone_calls(function);
  if (is_lone.empty()) return entries_of(function, fold<Scalar>(rules, program, function));
  std::vector<Scalar> values(is_lone.size());
  for (std::size_t at = 0; at < is_lone.size(); ++at) {
    const Instruction& i = function.instructions[at];
    values[at] = is_lone[at] ? sines.evaluate_lone(i.function, values[i.a])
                             : fold_instruction(rules, program, i, values);
  }
  return entries_of(function, values);
}

}  // namespace elgen
