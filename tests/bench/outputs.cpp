// Operations and times of all functions of one emitted header. MODEL is its namespace, HEADER its
// path, and FUNCTIONS a file with one line FUNCTION(name, additions, …) for each function. Prints
// rows of a Markdown table.
#include <cstdio>
#include <experimental/simd>

#include "repeated.hpp"

namespace {

using Pack = std::experimental::native_simd<double>;

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
