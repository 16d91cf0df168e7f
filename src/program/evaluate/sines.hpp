// Sines: sine and cosine as emitted code computes them, operation by operation.
//
// With k the integer nearest to 2/pi x, r - rest = x - k pi/2, |r| <= pi/4, and polynomials in r^2
// that give the wanted accuracy there:
//
//     sin r = r - (rest - r^3 s(r^2))
//     cos r = (1 - r^2/2) + (r^4 c(r^2) + r rest + the rounding error of 1 - r^2/2)
//
// The last two bits of k say which of them is the sine of x, and with which sign. pi/2 is taken off
// in parts, so that k times each but the last is exact. Functions of numbers are off by at most
// 1.5 ulp (0.9 in float), and by 0.5 beside multiples of pi/2.
#pragma once

#include <cln/rational.h>

#include <cstdint>
#include <string>
#include <vector>

#include "elgen/evaluate.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// One polynomial: of the sine from x^3 on, of the cosine from x^4 on.
struct SinePolynomial {
  int degree = 0;
  double error = 0;  ///< at most, for angles up to pi/4, apart from rounding
  std::vector<double> coefficients = {};
};

[[nodiscard]] const std::vector<SinePolynomial>& sine_polynomials();
[[nodiscard]] const std::vector<SinePolynomial>& cosine_polynomials();

/// How a scalar takes multiples of pi/2 off an angle.
struct AngleReduction {
  ScalarKind scalar = ScalarKind::double_precision;
  double domain = 0;               ///< the largest angle
  std::vector<double> parts = {};  ///< of pi/2: its leading bits, the next ones, the rest rounded
  double inverse = 0;              ///< 2/pi, rounded
  double shift = 0;                ///< 1.5/epsilon: x + shift - shift is the integer nearest to x
  double rounding = 0;             ///< the most that rounding adds to the error of a polynomial
};

/// The row of float or double.
[[nodiscard]] const AngleReduction& angle_reduction(ScalarKind scalar);

/// The polynomial of least degree whose error is at most `max_error` with what rounding in `scalar`
/// adds; that of the largest degree where none is.
[[nodiscard]] const SinePolynomial& cheapest(const std::vector<SinePolynomial>& all,
                                             const cln::cl_RA& max_error, ScalarKind scalar);

/// The arithmetic of emitted functions. Beyond the domain packs give NaN, numbers what the library
/// gives.
enum class SinesOf : std::uint8_t { packs, numbers };

/// The error that the polynomials of either have, at most: packs may ask for fewer digits.
[[nodiscard]] cln::cl_RA sine_error(const Numerics& numerics, SinesOf arithmetic,
                                    ScalarKind scalar);

/// Whether functions of numbers compute sines in line: of float and double, whichever the scene
/// names, unless it asks for the library.
[[nodiscard]] bool has_sines_in_line(const Scene& scene, ScalarKind scalar);

/// A number of the algorithm: "domain", "inverse", "shift", "part_1", "sine_3", "cosine_4".
struct SineNumber {
  std::string name;
  double value;
};

/// All of them, as they are for a scalar.
[[nodiscard]] std::vector<SineNumber> sine_numbers(const Numerics& numerics, SinesOf arithmetic,
                                                   ScalarKind scalar);

/// Scalar: float or double.
template <class Scalar>
class Sines {
 public:
  Sines(const Scene& scene, SinesOf arithmetic);

  struct Values {
    Scalar sine;
    Scalar cosine;
  };
  [[nodiscard]] Values of(Scalar angle) const;

 private:
  const AngleReduction& reduction_;
  SinesOf arithmetic_;
  bool is_library_;
  std::vector<Scalar> sine_;
  std::vector<Scalar> cosine_;
};

/// The rules of emitted code.
template <class Scalar>
struct CodeRules : interpreter::NumberRules<Scalar> {
  const Sines<Scalar>& sines;

  [[nodiscard]] Scalar call(FunctionId function, const Scalar& x, const Scalar& y) const {
    if (function == FunctionId::sin) return sines.of(x).sine;
    if (function == FunctionId::cos) return sines.of(x).cosine;
    return interpreter::call(function, x, y);
  }
};

/// The entries of all fields as emitted code computes them.
template <class Scalar>
[[nodiscard]] std::vector<Scalar> evaluate_code(const Program& program, const Function& function,
                                                const Arguments<Scalar>& arguments,
                                                const Sines<Scalar>& sines) {
  const CodeRules<Scalar> rules{{arguments}, sines};
  return entries_of(function, fold<Scalar>(rules, program, function));
}

}  // namespace elgen
