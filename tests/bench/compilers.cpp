// Times M, gravity, inverse and forward dynamics of one emitted header in double. MODEL is the
// namespace and HEADER the path of the header. Prints a line "FUNCTION NANOSECONDS" for each of
// these four functions: the minimum of many repetitions.
#include HEADER

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "timing.hpp"

namespace {

namespace emitted = ::MODEL;

/// Nanoseconds; a tenth of a millisecond is much longer than a clock reading and shorter than a
/// time slice.
constexpr double length_of_repetition = 1e5;
constexpr int repetitions = 101;

template <class Vector>
Vector numbers(double first) {
  Vector result{};
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = first + 0.1875 * static_cast<double>(i);
  }
  return result;
}

struct State {
  emitted::Parameters<double> p = {};
  emitted::Coordinates<double> q = numbers<emitted::Coordinates<double>>(0.375);
  emitted::Velocities<double> v = numbers<emitted::Velocities<double>>(0.8125);
  emitted::Velocities<double> a = numbers<emitted::Velocities<double>>(-1.0625);
  emitted::Inputs<double> u = numbers<emitted::Inputs<double>>(1.5625);
};

template <class Call>
double nanoseconds(const Call& call, int calls) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  for (int i = 0; i < calls; ++i) call();
  return std::chrono::duration<double, std::nano>(Clock::now() - start).count() / calls;
}

template <class Call>
void print(const char* name, const Call& call) {
  const int calls = static_cast<int>(length_of_repetition / (nanoseconds(call, 100) + 1)) + 1;
  double least = nanoseconds(call, calls);
  for (int i = 1; i < repetitions; ++i) least = std::min(least, nanoseconds(call, calls));
  std::printf("%s %.3f\n", name, least);
}

}  // namespace

int main() {
  State s;
  // Hides the state from the optimiser, so that every call is computed.
#define PRINT(name, ...)                            \
  print(#name, [&s] {                               \
    bench::keep(s);                                 \
    const auto result = emitted::name(__VA_ARGS__); \
    bench::keep(result);                            \
  })
  PRINT(mass_matrix, s.p, s.q);
  PRINT(gravity, s.p, s.q);
  PRINT(inverse_dynamics, s.p, s.q, s.v, s.a);
  PRINT(forward_dynamics, s.p, s.q, s.v, s.u);
#undef PRINT
}
