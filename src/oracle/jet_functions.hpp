// Functions of jets, by the chain rule from the derivatives in functions.def:
//
//     f(x0 + x1 e, y0 + y1 e) = f(x0, y0) + (f_x x1 + f_y y1) e
//
// applied to one generator after another, so that only real functions are left. Powers of s turn
// into generators first: with e = e_1 + ... + e_n, f(x0 + x1(s) e) has at e_1 ... e_j j! times the
// part of f(x0 + x1(s)) of degree j in x1.
#pragma once

#include <cln/rational.h>

#include "elgen/functions.hpp"
#include "oracle/jet.hpp"
#include "oracle/real_functions.hpp"

namespace elgen::oracle {

class JetFunctions {
 public:
  /// f(x), or f(x, y).
  [[nodiscard]] Jet value(FunctionId function, const Jet& x, const Jet& y = {});

  /// x ^ exponent. Whole exponents take every x (negative ones every x but 0), others x > 0, and x
  /// = 0 where the value or derivative asked for exists there.
  [[nodiscard]] Jet power(const Jet& x, const cln::cl_RA& exponent);

 private:
  struct Gradient {
    Jet x;
    Jet y;
  };
  Gradient gradient(FunctionId function, const Jet& x, const Jet& y, const Jet& f);

  RealFunctions real_ = {};
};

}  // namespace elgen::oracle
