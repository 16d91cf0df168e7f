// A model with every function that keeps digits (log1p, sinc, ...): derivatives computed by hand
// agree, the code is verified, and C99 code compiles without warnings.
#include <catch2/catch.hpp>
#include <string>

#include "support/shell.hpp"

using namespace elgen::test;

namespace {

constexpr const char* kept_model = R"toml(format = 1
[model]
name = "kept"
[[coordinate]]
name = "x"
range = [-1, 1]
[[coordinate]]
name = "y"
range = [0.2, 8]
[parameters]
k = 2
[energy]
T = "1/2*dot(x)^2 + 1/2*dot(y)^2"
V = "k*(log1p(x^2) + expm1(-y) + hypot(x, 2 + y) + sinc(x) + cosc(x - y) + stumpff(y, 3) + stumpff(x, -3))"
[[expect]]
gravity = ["k*(2*x/(1 + x^2) + x/sqrt(x^2 + (2 + y)^2) + x*(stumpff(x, 3) - cosc(x)) + x*(stumpff(x, -4) - 3*stumpff(x, -5)) + (x - y)*(2*stumpff(x - y, 4) - stumpff(x - y, 3)))",
           "k*(-exp(-y) + (2 + y)/sqrt(x^2 + (2 + y)^2) + (y - x)*(2*stumpff(y - x, 4) - stumpff(y - x, 3)) + y*(3*stumpff(y, 5) - stumpff(y, 4)))"]
)toml";

constexpr const char* kept_c_scene = R"toml(format = 1
model = "kept.toml"
name = "c"
[numeric]
scalar = ["float"]
[emit]
language = "c99"
)toml";

}  // namespace

TEST_CASE("functions that keep digits are derived, emitted and verified") {
  const Workspace folder;
  folder.write("kept.toml", kept_model);
  CHECK(failure_of(folder.run("elgen verify -v --quick kept.toml")) == "");
  folder.prepare("elgen generate -q -o out kept.toml");
  const std::string header = folder.read("out/kept/kept.hpp");
  CHECK(mentions(header, "detail::stumpff<Scalar>(q[0], 3)"));
  CHECK(mentions(header, "detail::stumpff<Scalar>(q[0], -4)"));
  CHECK(mentions(header, "  using std::sinh;\n"));
  CHECK_FALSE(mentions(header, "sign, min and max of ordered scalars"));
}

TEST_CASE("C99 code defines the functions that its library lacks") {
  const Workspace folder;
  folder.write("kept.toml", kept_model);
  folder.write("kept_c.scene.toml", kept_c_scene);
  folder.prepare("elgen generate -q -o out kept_c.scene.toml");
  CHECK(mentions(folder.read("out/kept_c/kept_c.h"), "static inline float kept_c_stumpff("));
  CHECK(mentions(folder.read("out/kept_c/kept_c.h"), "  if (k < 0) ratio = sinhf("));
  folder.write("side.c", "#include \"out/kept_c/kept_c.h\"\nint side;\n");
  folder.prepare("cc -std=c99 -Wall -Wextra -Wpedantic -Wconversion -Werror -c side.c -o side.o");
}
