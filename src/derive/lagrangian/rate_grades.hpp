// The parts of an expression that are constant, linear and quadratic in the rates.
//
// With f(q, s v, t) = f0 + s f1 + s^2 f2 + …, T = T2 + T1 + T0 and V = V1 + V0 are the grades of
// the energies. Taylor's formula through the definitions:
//
//     f0 = f(x0),   f1 = sum df/dx x1,   f2 = sum df/dx x2 + 1/2 sum sum d2f/dxdy x1 y1   (all at
//     x0)
//
//     before    w = dot(q) + N, T = 1/2*J*w^2
//     after     w0 = N, w1 = dot(q);  T2 = 1/2*J*w1^2, T1 = J*w0*w1, T0 = 1/2*J*w0^2
#pragma once

#include <array>
#include <vector>

#include "elgen/lagrangian.hpp"

namespace elgen {

class RateGrades {
 public:
  RateGrades(Definitions& definitions, const std::vector<GiNaC::ex>& rates);

  /// f0, f1, f2 of any expression over the definitions. Throws GiNaC's pole_error where f has no
  /// value at zero rates.
  [[nodiscard]] std::array<GiNaC::ex, 3> operator()(const GiNaC::ex& value);

 private:
  [[nodiscard]] std::array<GiNaC::ex, 3> from_known(const GiNaC::ex& value) const;
  void split(std::uint32_t definition);

  Definitions& definitions_;
  ExpressionMap<std::array<GiNaC::ex, 3>> parts_;  // of what depends on the rates
  std::vector<bool> known_;
};

}  // namespace elgen
