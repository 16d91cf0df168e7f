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
#pragma once

#include <cln/rational.h>

#include <cstdint>
#include <string>
#include <vector>

#include "elgen/evaluate.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// Coefficients of the sine from x^3 on, or of the cosine from x^4 on.
struct SinePolynomial {
  int degree = 0;
  double error = 0;  ///< bound for angles up to pi/4, without rounding errors
  std::vector<double> coefficients = {};
};

[[nodiscard]] const std::vector<SinePolynomial>& sine_polynomials();
[[nodiscard]] const std::vector<SinePolynomial>& cosine_polynomials();

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

/// A constant of the algorithm: "domain", "inverse", "shift", "part_1", "sine_3", "cosine_4".
struct SineConstant {
  std::string name;
  double value;
};

/// All constants of the algorithm for this scalar.
[[nodiscard]] std::vector<SineConstant> sine_constants(const Numerics& numerics,
                                                       SineArithmetic arithmetic,
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

 private:
  const AngleReduction& reduction_;
  SineArithmetic arithmetic_;
  bool is_library_;
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
  return entries_of(function, fold<Scalar>(rules, program, function));
}

}  // namespace elgen
