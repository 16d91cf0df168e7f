// Quaternions that are not of length 1: emitted code scales them back whatever their length.
#include <catch2/catch.hpp>

#include "support/shell.hpp"

namespace elgen::test {
namespace {

std::string printed(const Workspace& folder, const std::string& program) {
  write_text(folder.path() / "main.cpp", program);
  const std::string include = std::string(ELGEN_SOURCE_DIR) + "/generated";
  prepare("c++ -std=c++17 -O1 -I'" + include + "' main.cpp -o main", folder.path());
  return shell("./main", folder.path()).output;
}

/// Prints how far, in epsilons, unit quaternions are from (1, -2, 2, 4)/5.
constexpr const char* lengths = R"cpp(
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <limits>

#include "free_body/free_body.hpp"

  template <class Scalar>
  void print(std::initializer_list<Scalar> sizes) {
    double worst = 0;
    for (const Scalar s : sizes) {
      const auto q = free_body::normalized<Scalar>({}, {1, 2, 3, s, -2 * s, 2 * s, 4 * s});
      const Scalar exact[] = {Scalar(0.2), Scalar(-0.4), Scalar(0.4), Scalar(0.8)};
      for (int i = 0; i < 4; ++i) {
        const double off = std::abs(double(q[3 + i]) - double(exact[i]));
        worst = off <= worst ? worst : off / double(std::numeric_limits<Scalar>::epsilon());
      }
    }
    std::puts(worst <= 4 ? "right" : "wrong");
  }

  int main() {
    print<double>({1e-300, 1e-160, 1e-155, 1.0, 1e155, 1e160, 1e300});
    print<float>({1e-36F, 1e-30F, 1.0F, 1e30F, 1e36F});
  }
)cpp";

}  // namespace

TEST_CASE("quaternions of extreme length are scaled to length 1") {
  const Workspace folder;
  CHECK(printed(folder, lengths) == "right\nright\n");
}

}  // namespace elgen::test
