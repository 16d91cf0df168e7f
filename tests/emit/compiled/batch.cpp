// Bounds the errors of batches of 0 to 100 states, and of the sines of packs, in double and in
// float. The references are functions of one state in long double. A longer stride must not change
// results.
#include <algorithm>
#include <cstdio>
#include <limits>
#include <vector>

#include "panda7_rollouts/panda7_rollouts_batch.hpp"

namespace {

namespace arm = panda7_rollouts;
using Exact = long double;

double number(std::size_t i) { return 3.0 * std::sin(1.7 * static_cast<double>(i)); }

template <class T>
std::vector<T> numbers(std::size_t size, std::size_t start) {
  std::vector<T> result(size);
  for (std::size_t i = 0; i < size; ++i) result[i] = static_cast<T>(number(i + start));
  return result;
}

template <class T>
std::array<Exact, 7> state(const std::vector<T>& numbers, std::size_t count, std::size_t i) {
  std::array<Exact, 7> result{};
  for (std::size_t k = 0; k < 7; ++k) result[k] = numbers[k * count + i];
  return result;
}

/// The largest error of the torques relative to the largest torque; 1 if the batch writes beyond
/// `torques`.
template <class T>
double worst_error(std::size_t count) {
  const std::vector<T> q = numbers<T>(7 * count, 0);
  const std::vector<T> v = numbers<T>(7 * count, 1000);
  const std::vector<T> a = numbers<T>(7 * count, 2000);
  std::vector<T> torques(7 * count + 1, T(77));
  arm::batch::inverse_dynamics<T>({}, count, q.data(), v.data(), a.data(), torques.data());
  if (torques.back() < T(77) || torques.back() > T(77)) return 1;
  Exact largest = 0;
  Exact error = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto exact = arm::inverse_dynamics<Exact>({}, state(q, count, i), state(v, count, i),
                                                    state(a, count, i));
    for (std::size_t k = 0; k < 7; ++k) {
      largest = std::max(largest, std::abs(exact[k]));
      error = std::max(error, std::abs(exact[k] - static_cast<Exact>(torques[k * count + i])));
    }
  }
  return count == 0 ? 0.0 : static_cast<double>(error / largest);
}

/// The 7 rows of `count` numbers, with `stride` numbers from one row to the next. Numbers between
/// rows are 77.
template <class T>
std::vector<T> spread(const std::vector<T>& numbers, std::size_t count, std::size_t stride) {
  std::vector<T> result(7 * stride, T(77));
  for (std::size_t k = 0; k < 7; ++k) {
    for (std::size_t i = 0; i < count; ++i) result[k * stride + i] = numbers[k * count + i];
  }
  return result;
}

/// True if the torques are the same with both strides, and nothing is written between rows.
template <class T>
bool is_same_at_stride(std::size_t count, std::size_t stride) {
  const std::vector<T> q = numbers<T>(7 * count, 0);
  std::vector<T> torques(7 * count), at_stride(7 * stride, T(77));
  arm::batch::inverse_dynamics<T>({}, count, q.data(), q.data(), q.data(), torques.data());
  const std::vector<T> rows = spread(q, count, stride);
  arm::batch::inverse_dynamics<T>({}, count, rows.data(), rows.data(), rows.data(),
                                  at_stride.data(), stride);
  return at_stride == spread(torques, count, stride);
}

template <class T>
double worst_trigonometry(T domain) {
  Exact error = 0;
  for (int i = 0; i < 400'000; ++i) {
    const T scale = i % 2 == 0 ? domain : T(10);
    const T x = scale * static_cast<T>(std::sin(0.7 * i));
    const auto [sine, cosine] = arm::detail::SineCosine<arm::batch::Pack<T>>::of(x);
    error = std::max(error, std::abs(std::sin(Exact(x)) - Exact(sine.native[0])));
    error = std::max(error, std::abs(std::cos(Exact(x)) - Exact(cosine.native[0])));
  }
  return static_cast<double>(error);
}

template <class T>
bool is_outside(T angle) {
  const arm::batch::Pack<T> x(angle);
  return std::isnan(sin(x).native[0]) && std::isnan(cos(x).native[0]);
}

/// True if std::tie assigns both numbers of a SineCosine, as functions in parts do.
template <class T>
bool is_tied() {
  const arm::batch::Pack<T> x(T(0.5));
  arm::batch::Pack<T> sine, cosine;
  std::tie(sine, cosine) = arm::detail::SineCosine<arm::batch::Pack<T>>::of(x);
  return sine.native[0] > T(0.4) && sine.native[0] < T(0.5) && cosine.native[0] > T(0.8);
}

/// True if padded(count) is an odd multiple of 16, and less than 32 longer than `count`.
constexpr bool is_padded(std::size_t count) {
  const std::size_t stride = arm::batch::padded(count);
  return stride >= count && stride < count + 32 && stride % 32 == 16;
}
static_assert(is_padded(1) && is_padded(16) && is_padded(17) && is_padded(33) && is_padded(1024));

bool within(const char* what, double error, double most) {
  if (error <= most) return true;
  std::printf("%s: %g > %g\n", what, error, most);
  return false;
}

}  // namespace

int main() {
  bool is_right = true;
  for (const std::size_t count : {0U, 1U, 2U, 3U, 7U, 8U, 9U, 15U, 16U, 17U, 100U}) {
    is_right &= within("torques in double", worst_error<double>(count), 2e-15);
    is_right &= within("torques in float", worst_error<float>(count), 2e-6);
    const bool is_same = is_same_at_stride<double>(count, count) &&
                         is_same_at_stride<double>(count, count + 1) &&
                         is_same_at_stride<float>(count, arm::batch::padded(count));
    if (!is_same) std::printf("%zu states with a stride\n", count);
    is_right &= is_same;
  }
  is_right &= within("sines in double", worst_trigonometry(1e5), 0x1p-52);
  is_right &= within("sines in float", worst_trigonometry(1e3F), 0x1p-23);
  const bool is_nan = is_outside(1.0001e5) && is_outside(-1.0001e5) && is_outside(1.001e3F) &&
                      is_outside(std::numeric_limits<double>::infinity());
  if (!is_nan) std::puts("a sine beyond the domain");
  const bool are_tied = is_tied<double>() && is_tied<float>();
  if (!are_tied) std::puts("a sine and a cosine that are tied");
  return is_right && is_nan && are_tied ? 0 : 1;
}
