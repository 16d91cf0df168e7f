// Arguments for functions of emitted headers, and calls that pass only the needed arguments.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

namespace compiled {

/// `number` in every component. Dyadic numbers are exact in all types.
template <class Scalar>
Scalar made(double number) {
  Scalar result;
  result = static_cast<Scalar>(number);
  return result;
}
/// `start`, and x + 11/64 + x/1024 after each entry x. All entries, sums and differences differ.
template <class Scalar, std::size_t Size>
std::array<Scalar, Size> state(double start) {
  std::array<Scalar, Size> result{};
  double number = start;
  for (Scalar& entry : result) {
    entry = made<Scalar>(number);
    number += 11.0 / 64.0 + number / 1024.0;
  }
  return result;
}

/// The arguments of all functions; `call` passes a subset.
template <class Parameters, class Coordinates, class Velocities, class Inputs, class Scalar>
struct Arguments {
  Parameters p;
  Coordinates q;
  Velocities v, a;
  Inputs u;
  Scalar t;
};

template <class Function, class All>
auto call(const Function& f, const All& x) {
  const auto& [p, q, v, a, u, t] = x;
  using P = decltype(p);
  using Q = decltype(q);
  using V = decltype(v);
  using U = decltype(u);
  using T = decltype(t);
  if constexpr (std::is_invocable_v<Function, P, Q>) {
    return f(p, q);
  } else if constexpr (std::is_invocable_v<Function, P, Q, V>) {
    return f(p, q, v);
  } else if constexpr (std::is_invocable_v<Function, P, Q, V, V>) {
    return f(p, q, v, a);
  } else if constexpr (std::is_invocable_v<Function, P, Q, V, U>) {
    return f(p, q, v, u);
  } else if constexpr (std::is_invocable_v<Function, P, Q, T>) {
    return f(p, q, t);
  } else if constexpr (std::is_invocable_v<Function, P, Q, V, T>) {
    return f(p, q, v, t);
  } else if constexpr (std::is_invocable_v<Function, P, Q, V, V, T>) {
    return f(p, q, v, a, t);
  } else if constexpr (std::is_invocable_v<Function, P, Q, V, V, U>) {
    return f(p, q, v, a, u);
  } else if constexpr (std::is_invocable_v<Function, P, Q, V, V, U, T>) {
    return f(p, q, v, a, u, t);
  } else {
    return f(p, q, v, u, t);
  }
}

}  // namespace compiled
