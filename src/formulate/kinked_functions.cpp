// The kinked functions of forces, opaque to GiNaC: kept as written, never evaluated or
// differentiated.
#include <stdexcept>

#include "elgen/lagrangian.hpp"

namespace elgen {

namespace {

using GiNaC::ex;

// check() lets these stand in forces only, so a derivative is a mistake of elgen's own.
ex no_derivative(const ex& /*x*/, unsigned /*argument*/) {
  throw std::logic_error("derivative of a kinked function");
}
ex no_derivative_2(const ex& /*x*/, const ex& /*y*/, unsigned /*argument*/) {
  throw std::logic_error("derivative of a kinked function");
}

}  // namespace

REGISTER_FUNCTION(elgen_abs, derivative_func(no_derivative))
REGISTER_FUNCTION(elgen_sign, derivative_func(no_derivative))
REGISTER_FUNCTION(elgen_min, derivative_func(no_derivative_2))
REGISTER_FUNCTION(elgen_max, derivative_func(no_derivative_2))

}  // namespace elgen
