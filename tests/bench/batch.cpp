// Nanoseconds per state of the inverse dynamics and the mass matrix of panda7: one state at a time
// in double, and in batches of double and of float, whose arrays have the default stride or
// padded(count). Prints rows of a Markdown table.
#include <cmath>
#include <cstdio>
#include <string>

#include "panda7_states/panda7_states_batch.hpp"
#include "timing.hpp"

namespace {

namespace arm = panda7_states;

struct Layout {
  std::size_t count;
  std::size_t stride;
};

template <class T>
struct States {
  explicit States(std::size_t stride)
      : q(numbers(3.0, stride)), v(numbers(2.0, stride)), a(numbers(4.0, stride)) {
    result.resize(49 * stride);
  }

  static std::vector<T> numbers(double scale, std::size_t stride) {
    std::vector<T> list(7 * stride);
    for (std::size_t i = 0; i < list.size(); ++i) {
      list[i] = static_cast<T>(scale * std::sin(scale * static_cast<double>(i)));
    }
    return list;
  }

  std::vector<T> q, v, a, result;
};

std::array<double, 7> state(const std::vector<double>& numbers, std::size_t i, std::size_t stride) {
  std::array<double, 7> result;
  for (std::size_t k = 0; k < 7; ++k) result[k] = numbers[k * stride + i];
  return result;
}

template <std::size_t Size>
void store(const std::array<double, Size>& values, std::size_t i, std::size_t stride, double* to) {
  for (std::size_t k = 0; k < Size; ++k) to[k * stride + i] = values[k];
}

/// The two functions, called with all states.
template <class T, class Torques, class Matrices>
std::vector<std::function<void(int)>> both(const Layout& layout, const Torques& torques,
                                           const Matrices& matrices) {
  const auto repeated = [&layout](const auto& evaluate) {
    return [=, states = States<T>(layout.stride)](int calls) mutable {
      for (int call = 0; call < calls; ++call) {
        bench::keep(states);
        evaluate(layout, states);
      }
    };
  };
  return {repeated(torques), repeated(matrices)};
}

std::vector<std::function<void(int)>> one_by_one(const Layout& layout) {
  return both<double>(
      layout,
      [](const Layout& at, States<double>& all) {
        for (std::size_t i = 0; i < at.count; ++i) {
          store(
              arm::inverse_dynamics<double>({}, state(all.q, i, at.stride),
                                            state(all.v, i, at.stride), state(all.a, i, at.stride)),
              i, at.stride, all.result.data());
        }
      },
      [](const Layout& at, States<double>& all) {
        for (std::size_t i = 0; i < at.count; ++i) {
          store(arm::mass_matrix<double>({}, state(all.q, i, at.stride)), i, at.stride,
                all.result.data());
        }
      });
}

template <class T>
std::vector<std::function<void(int)>> in_batches(const Layout& layout) {
  return both<T>(
      layout,
      [](const Layout& at, States<T>& all) {
        arm::batch::inverse_dynamics<T>({}, at.count, all.q.data(), all.v.data(), all.a.data(),
                                        all.result.data(), at.stride);
      },
      [](const Layout& at, States<T>& all) {
        arm::batch::mass_matrix<T>({}, at.count, all.q.data(), all.result.data(), at.stride);
      });
}

}  // namespace

int main() {
  std::vector<std::string> names;
  std::vector<std::size_t> counts;
  std::vector<std::function<void(int)>> alternatives;
  const auto add = [&](const std::string& name, const Layout& layout,
                       const std::vector<std::function<void(int)>>& functions) {
    const bool is_padded = layout.stride == arm::batch::padded(layout.count);
    names.push_back(name + ", " + std::to_string(layout.count) + " states" +
                    (is_padded ? ", padded" : ""));
    counts.push_back(layout.count);
    alternatives.insert(alternatives.end(), functions.begin(), functions.end());
  };
  add("one state, double", {1000, 1000}, one_by_one({1000, 1000}));
  for (const std::size_t count : {std::size_t(1000), std::size_t(1024)}) {
    for (const std::size_t stride : {count, arm::batch::padded(count)}) {
      const Layout layout{count, stride};
      add("batch, double", layout, in_batches<double>(layout));
      add("batch, float", layout, in_batches<float>(layout));
    }
  }
  const std::vector<double> ns = bench::medians(alternatives, 3, 101);
  const auto per_state = [&](std::size_t i) { return ns[i] / counts[i / 2]; };
  for (std::size_t i = 0; i < names.size(); ++i) {
    std::printf("| %s | %.1f | 1/%.1f | %.1f | 1/%.1f |\n", names[i].c_str(), per_state(2 * i),
                per_state(0) / per_state(2 * i), per_state(2 * i + 1),
                per_state(1) / per_state(2 * i + 1));
  }
}
