// The cost of operations relative to a multiplication, by latency (a chain of dependent operations)
// and by throughput (eight independent operations). Source of the cost table in program.hpp.
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "panda7/panda7.hpp"
#include "timing.hpp"

namespace {

volatile double sink = 0.0;

/// A function of n that computes x <- step(x) n times; each call depends on the previous call.
template <class Step>
std::function<void(int)> in_a_row(Step step) {
  return [step](int calls) {
    double x = 0.7;
    for (int i = 0; i < calls; ++i) x = step(x);
    sink = x;
  };
}

/// A function of n that calls `step` n times, on eight independent numbers in turn.
template <class Step>
std::function<void(int)> side_by_side(Step step) {
  return [step](int calls) {
    std::array<double, 8> x{0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8};
    for (int i = 0; i < calls; i += 8) {
      for (double& lane : x) lane = step(lane);
    }
    double sum = 0.0;
    for (const double lane : x) sum += lane;
    sink = sum;
  };
}

struct Rows {
  std::vector<std::string> names;
  std::vector<std::function<void(int)>> alternatives;

  template <class Step>
  void add(const std::string& name, Step step) {
    names.push_back(name);
    alternatives.push_back(in_a_row(step));
    alternatives.push_back(side_by_side(step));
  }
};

}  // namespace

int main() {
  const volatile double almost_one = std::nextafter(1.0, 2.0);
  const double factor = almost_one;
  Rows rows;
  rows.add("multiplication", [=](double x) { return x * factor; });
  rows.add("addition", [=](double x) { return x + factor; });
  rows.add("division", [=](double x) { return factor / x; });
  rows.add("square root", [=](double x) { return std::sqrt(x) * factor; });
  rows.add("sine", [=](double x) { return std::sin(x) + factor; });
  rows.add("sine and cosine", [=](double x) { return std::sin(x) * std::cos(x) + factor; });
  rows.add("in line", [=](double x) {
    const auto [sine, cosine] = panda7::detail::SineCosine<double>::of(x);
    return sine * cosine + factor;
  });
  rows.add("exponential", [=](double x) { return std::exp(-x); });
  const std::vector<double> ns = bench::medians(rows.alternatives, 8000, 401);
  std::printf("%-16s %12s %12s   ns (in multiplications)\n", "operation", "in a row",
              "side by side");
  for (std::size_t i = 0; i < rows.names.size(); ++i) {
    std::printf("%-16s %6.2f (%4.1f) %6.2f (%4.1f)\n", rows.names[i].c_str(), ns[2 * i],
                ns[2 * i] / ns[0], ns[2 * i + 1], ns[2 * i + 1] / ns[1]);
  }
}
