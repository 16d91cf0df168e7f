// Instantiates every function of one emitted header for double. The benchmark measures the time to
// compile this file. MODEL, HEADER and FUNCTIONS as in outputs.cpp.
#include HEADER

#include "../support/emitted_calls.hpp"

namespace emitted = ::MODEL;

using All = compiled::Arguments<emitted::Parameters<double>, emitted::Coordinates<double>,
                                emitted::Velocities<double>, emitted::Inputs<double>, double>;

#define FUNCTION(name, ...)                                                                    \
  auto call_##name(const All& all) {                                                           \
    return compiled::call(                                                                     \
        [](const auto&... x) -> decltype(emitted::name(x...)) { return emitted::name(x...); }, \
        all);                                                                                  \
  }
#include FUNCTIONS
#undef FUNCTION
