// Sizes in the model, in the scene and in options.
#include <catch2/catch.hpp>

#include "check/expressions/parameters.hpp"
#include "check_testing.hpp"

namespace elgen::test {

namespace {

const std::string free_masses = R"toml(format = 1
[model]
name = "masses"
[sizes]
n = 2
[[coordinate]]
for = "i in 1..n"
name = "x[i]"
[energy]
T = "sum(i, 1, n, dot(x[i])^2)"
)toml";

const std::string scene_head = "format = 1\nmodel = \"a.toml\"\nname = \"s\"\n";

std::size_t coordinates(const CheckOptions& wanted) {
  return checked(free_masses, wanted).model.coordinates.size();
}

}  // namespace

TEST_CASE("sizes of options override the sizes of the model") {
  const Limits limits;
  Context context(limits);
  context.sizes = {{"n", 1}, {"m", 1}};
  SceneOptions options;
  options.sizes = {make_source("command line", "m=4,n=5")};
  read_sizes(context, {}, nullptr, options);
  CHECK(context.sizes == Sizes{{"m", 4}, {"n", 5}});
  CHECK(context.report.error_count() == 0);
}

TEST_CASE("sizes are integers so small that sums and products of two do not overflow") {
  const auto answer = [](const std::string& option) {
    const Limits limits;
    Context context(limits);
    context.sizes = {{"n", 1}};
    SceneOptions options;
    options.sizes = {make_source("command line", option)};
    read_sizes(context, {}, nullptr, options);
    return context.report.error_count() == 0 ? std::to_string(context.sizes["n"])
                                             : context.report.sorted_diagnostics().front().message;
  };
  CHECK(answer("n=1000000000") == "1000000000");
  CHECK(answer("n=-1000000000") == "-1000000000");
  const std::string reason = " is not integer arithmetic over sizes and indices";
  CHECK(answer("n=1000000001") == "`1000000001`" + reason);
  CHECK(answer("n=-9223372036854775807") == "`9223372036854775807`" + reason);
  CHECK(answer("n=99999999999999999999") == "`99999999999999999999`" + reason);
  CHECK(answer("n=2.5") == "`2.5`" + reason);
  CHECK(answer("n") == "`n` has no value");
}

TEST_CASE("a scene overrides sizes, an option overrides both") {
  CheckOptions wanted;
  CHECK(coordinates(wanted) == 2);
  wanted.scene = scene_head + "[sizes]\nn = 3\n";
  CHECK(coordinates(wanted) == 3);
  wanted.sizes = {"n=5"};
  CHECK(coordinates(wanted) == 5);
}

TEST_CASE("uses of a size with a reserved name are not reported") {
  CHECK(messages("format = 1\n[model]\nname = \"a\"\n[sizes]\nint = 2\n[[coordinate]]\n"
                 "for = \"i in 1..int\"\nname = \"q[i]\"\n[parameters]\n"
                 "m = { size = \"int\", value = 1 }\n[energy]\n"
                 "T = \"sum(i, 1, int, m[i]*dot(q[i])^2)\"\n") ==
        "E204 5:1 `int` is reserved: it is a keyword of C++ | `int_1` is free\n");
}

TEST_CASE("unknown sizes are reported at their position") {
  CheckOptions wanted;
  wanted.scene = scene_head + "[sizes]\nm = 3\n";
  CHECK(messages(free_masses, wanted) == "E605 5:1 unknown size `m`\n");
  wanted.scene.clear();
  wanted.sizes = {"n=3, size=2"};
  CHECK(messages(free_masses, wanted) == "E605 1:6 unknown size `size`\n");
}

TEST_CASE("malformed sizes are reported at their position") {
  const auto said = [](const std::string& size) {
    return messages(free_masses, {.sizes = {size}});
  };
  CHECK(said("n") == "E606 1:1 `n` has no value\n");
  CHECK(said("n=") == "E606 1:1 `n=` has no value\n");
  CHECK(said("n=x") == "E201 1:3 unknown index `x`\n");
  CHECK(said("n=2.5") == "E318 1:3 `2.5` is not integer arithmetic over sizes and indices\n");
}

TEST_CASE("a size may be too small for a repetition") {
  CHECK(messages(free_masses, {.sizes = {"n=0"}}) == "E209 7:8 from 1 to 0 there is no element\n");
}

TEST_CASE("a size may not have the name of a parameter") {
  CHECK(messages(free_masses + "[parameters]\nn = 3\n") ==
        "E203 12:1 `n` is already a size | first at line 5\n");
}

}  // namespace elgen::test
