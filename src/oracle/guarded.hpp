// Guarded computations: CLN and the oracle throw where a value does not exist; callers get an empty
// optional.
#pragma once

#include <cln/exception.h>

#include <optional>

#include "numbers/more_digits.hpp"
#include "oracle/real_functions.hpp"

namespace elgen::oracle {

template <class Computation>
auto attempt(const Computation& computation) -> std::optional<decltype(computation())> {
  try {
    return computation();
  } catch (const cln::runtime_exception&) {
    return std::nullopt;
  } catch (const OutsideDomain&) {
    return std::nullopt;
  }
}

/// To as many digits as its angles ask for: without them a value may seem not to exist.
template <class Computation>
auto guarded(const Computation& computation) -> std::optional<decltype(computation())> {
  return with_enough_digits([&] { return attempt(computation); });
}

}  // namespace elgen::oracle
