// Operations and time of every function of one emitted header: MODEL its namespace, HEADER its
// path, FUNCTIONS a file with a line FUNCTION(name, additions, …) each. Prints rows of a Markdown
// table.
#include HEADER

#include <cstdio>
#include <experimental/simd>
#include <string>
#include <vector>

#include "../support/emitted_calls.hpp"
#include "timing.hpp"

namespace {

namespace emitted = ::MODEL;
using Pack = std::experimental::native_simd<double>;

template <class Scalar>
using Arguments = compiled::Arguments<emitted::Parameters<Scalar>, emitted::Coordinates<Scalar>,
                                      emitted::Velocities<Scalar>, emitted::Inputs<Scalar>, Scalar>;

/// States that differ, so that no result can be kept from one call to the next.
template <class Scalar>
std::vector<Arguments<Scalar>> some_states() {
  std::vector<Arguments<Scalar>> states;
  for (int i = 0; i < 16; ++i) {
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
      const auto result = compiled::call(function, states[static_cast<std::size_t>(i) % 16]);
      bench::keep(result);
    }
  };
}

struct Operations {
  int add, mul, div, sqrt, sincos, other;
};

template <class Function>
void print_row(const char* name, const Operations& n, Function function) {
  if (n.add + n.mul + n.div + n.sqrt + n.sincos + n.other == 0) return;
  const int work = n.add + n.mul + 20 * (n.div + n.sqrt + n.sincos + n.other);
  const int calls = 20000 / (work + 20) + 1;
  const std::vector<double> ns =
      bench::medians({repeated<double>(function), repeated<Pack>(function)}, calls, 101);
  std::printf("| %s | %d | %d | %d | %d | %.1f | %.1f |\n", name, n.add, n.mul,
              n.div + n.sqrt + n.other, n.sincos, ns[0], ns[1] / static_cast<double>(Pack::size()));
}

}  // namespace

int main() {
#define FUNCTION(name, ...)                                                               \
  print_row(#name, {__VA_ARGS__}, [](const auto&... x) -> decltype(emitted::name(x...)) { \
    return emitted::name(x...);                                                           \
  });
#include FUNCTIONS
#undef FUNCTION
}
