// Resolver, names: what each name means, and what is said of those that mean nothing.
#include <catch2/catch.hpp>
#include <utility>

#include "check_testing.hpp"

namespace elgen::test {
namespace {

const std::string pushed_masses = R"toml(format = 1
[model]
name = "masses"
[sizes]
n = 3
[[coordinate]]
for = "i in 1..n"
name = "x[i]"
unit = "m"
[parameters]
m = { size = "n", value = [1, 2, 3], unit = "kg" }
k = { value = 10, unit = "N/m" }
[[point]]
name = "top"
at = ["0", "0"]
[[input]]
name = "u"
unit = "N"
on = "x[n]"
[energy]
T = "sum(i, 1, n, 1/2*m[i]*dot(x[i])^2)"
)toml";

std::string masses_error(const std::string& text) {
  return messages(pushed_masses + "V = \"" + text + "\"\n");
}

TEST_CASE("indices are resolved while repetitions are expanded") {
  CHECK(dumped(pushed_masses, "energy T") ==
        "energy T = 1/2*m[1]*dot(x[1])^2 + 1/2*m[2]*dot(x[2])^2 + 1/2*m[3]*dot(x[3])^2\n");
  CHECK(dumped(pushed_masses + "V = \"k*x[n-1]*x[max(1, n-2)]\"\n", "energy V") ==
        "energy V = k*x[2]*x[1]\n");
  CHECK(dumped(pushed_masses, "input") == "input u [N], on x[3]\n");
}

TEST_CASE("sizes and running indices are numbers inside expressions") {
  CHECK(dumped(pushed_masses + "V = \"n*k*sum(i, 1, 2, i*x[i]^2)\"\n", "energy V") ==
        "energy V = 3*k*(1*x[1]^2 + 2*x[2]^2)\n");
}

TEST_CASE("pi and time are known") {
  CHECK(dumped(pushed_masses + "V = \"k*x[1]^2*cos(pi*t*sqrt(k/m[1]))\"\n", "energy V") ==
        "energy V = k*x[1]^2*cos(pi*t*sqrt(k/m[1]))\n");
  CHECK(dumped(pushed_masses + "V = \"k*x[1]^2*cos(t*sqrt(k/m[1]))\"\n", "time") == "time yes\n");
  CHECK(dumped(pushed_masses, "time") == "time no\n");
}

TEST_CASE("names that mean nothing here are told apart") {
  const std::vector<std::pair<std::string, std::string>> rows{
      {"kk", "E201 22:6 unknown name `kk` | did you mean `k`? (parameter, line 12)"},
      {"sin", "E316 22:6 `sin` has no argument | write `sin(…)`"},
      {"x(y)", "E201 22:8 unknown point `y`"},
      {"k*x", "E208 22:8 `x` needs an index: `x` has the elements 1 to 3"},
      {"k[1]", "E208 22:6 `k` takes no index"},
      {"x[4]", "E207 22:6 there is no `x[4]`: `x` has the elements 1 to 3"},
      {"x[n+1]", "E207 22:6 `x[n+1]` is `x[4]`, but `x` has the elements 1 to 3"},
      {"sum(i, 1, n, x[i-1])", "E207 22:19 `x[i-1]` is `x[0]`, but `x` has the elements 1 to 3"},
      {"x[k]", "E201 22:8 unknown index `k`"},
      {"x[1.5]", "E318 22:8 `1.5` is not integer arithmetic over sizes and indices"},
      {"top", "E319 22:6 `top` is a point, not a number | its components are `x(top)` and so on"},
  };
  for (const auto& [text, error] : rows) {
    INFO(text);
    CHECK(masses_error(text) == error + "\n");
  }
}

TEST_CASE("a very long name is cut in the message") {
  const std::string message = masses_error(std::string(100'000, 'x'));
  CHECK(message == "E201 22:6 unknown name `" + std::string(60, 'x') + "…`\n");
}

TEST_CASE("the uses of a name that failed to be declared are not reported too") {
  const std::string model = R"(format = 1
[model]
name = "a"
[[coordinate]]
name = "q"
[parameters]
double = 2
[energy]
T = "double*dot(q)^2"
)";
  CHECK(messages(model) == "E204 7:1 `double` is reserved: it is a keyword of C++\n");
}

}  // namespace
}  // namespace elgen::test
