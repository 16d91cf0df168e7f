// Calls of the functions of one emitted header at several states. MODEL is its namespace, HEADER
// its path.
#pragma once

#include HEADER

#include <functional>
#include <vector>

#include "../support/emitted_calls.hpp"
#include "timing.hpp"

namespace {

namespace emitted = ::MODEL;

template <class Scalar>
using Arguments = compiled::Arguments<emitted::Parameters<Scalar>, emitted::Coordinates<Scalar>,
                                      emitted::Velocities<Scalar>, emitted::Inputs<Scalar>, Scalar>;

/// Several states, so that the optimiser cannot reuse the result of the previous call.
template <class Scalar>
std::vector<Arguments<Scalar>> some_states() {
  std::vector<Arguments<Scalar>> states;
  for (int i = 0; i < bench::state_count; ++i) {
    const double shift = i / 128.0;
    states.push_back({{},
                      compiled::state<Scalar, emitted::coordinate_count>(0.375 + shift),
                      compiled::state<Scalar, emitted::velocity_count>(0.8125 - shift),
                      compiled::state<Scalar, emitted::velocity_count>(-1.0625 + shift),
                      compiled::state<Scalar, emitted::input_count>(1.5625 - shift),
                      compiled::made<Scalar>(0.6875)});
  }
  return states;
}

template <class Scalar, class Function>
std::function<void(int)> repeated(Function function) {
  return [function, states = some_states<Scalar>()](int calls) {
    bench::keep(states);
    for (int i = 0; i < calls; ++i) {
      const auto result =
          compiled::call(function, states[static_cast<std::size_t>(i % bench::state_count)]);
      bench::keep(result);
    }
  };
}

}  // namespace
