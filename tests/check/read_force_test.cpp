// Forces and declared outputs.
#include <catch2/catch.hpp>
#include <utility>

#include "check_testing.hpp"

namespace elgen::test {
namespace {

const std::string with_points = block(R"toml([[input]]
name = "u"
unit = "N"
[[point]]
name = "p"
at = ["x", "0"]
[[point]]
name = "r"
at = ["0", "0"]
[parameters.b]
value = 1
unit = "N*s/m"
)toml");

TEST_CASE("forces act on a coordinate, or at a point and back on another") {
  CHECK(dumped(with_points + "[[force]]\nname = \"damper\"\non = \"x\"\nvalue = \"u - b*dot(x)\"\n"
                             "[[force]]\nat = \"p\"\nfrom = \"r\"\nvalue = [\"u\", \"0\"]\n",
               "force") == "force damper on x = [u - b*dot(x)]\nforce  at p from r = [u, 0, 0]\n");
}

TEST_CASE("outputs are one value or several, with Jacobians where asked") {
  CHECK(dumped(with_points +
                   "[[output]]\nname = \"tip\"\nvalue = [\"x(p)\", \"y(p)\"]\njacobian = true\n"
                   "[[output]]\nname = \"length\"\nvalue = \"x\"\n",
               "output") == "output tip = [x(p), y(p)], jacobian\noutput length = [x]\n");
}

TEST_CASE("what forces and outputs may not be") {
  const std::vector<std::pair<std::string, std::string>> rows{
      {"[[force]]\nvalue = \"u\"\n",
       "E112 24:1 none of `on`, `at` and `frame` says where the force acts\n"},
      {"[[force]]\nat = \"p\"\non = \"x\"\nvalue = \"u\"\n",
       "E112 26:1 a force has one of `on`, `at` and `frame`\n"},
      {"[[force]]\non = \"p\"\nvalue = \"u\"\n", "E201 25:7 unknown coordinate `p`\n"},
      {"[[force]]\non = \"x\"\nvalue = [\"u\", \"0\"]\n",
       "E104 26:9 a list, but a generalized force is one number\n"},
      {"[[force]]\nat = \"p\"\nvalue = \"u\"\n", "E516 26:10 1 component, but the point has 2\n"},
      {"[[force]]\nat = \"p\"\nfrom = \"s\"\nvalue = [\"u\", \"0\"]\n",
       "E201 26:9 unknown point `s`\n"},
      {"[[force]]\non = \"x\"\nvalue = \"u*u/u\"\n",
       "E509 26:10 `u*u/u` is not linear in the inputs\n"},
      {"[[force]]\non = \"x\"\nvalue = \"u*tanh(dot(x)*b/u)\"\n",
       "E509 26:10 `u*tanh(dot(x)*b/u)` is not linear in the inputs\n"},
      {"[[force]]\non = \"x\"\nvalue = \"b*dot(x)*u*x/(x*b*dot(x))\"\n",
       "E509 26:10 `b*dot(x)*u*x/(x*b*dot(x))` multiplies an input by a rate\n"},
      {"[[force]]\non = \"x\"\nvalue = \"m*x\"\n",
       "E403 26:10 `m*x` is in kg*m, but a force is in N\n"},
      {"[[force]]\non = \"x\"\nvalue = \"m*dot(dot(x))\"\n",
       "E502 26:12 `dot(dot(x))` is a second derivative, and a force takes none\n"},
      {"[[output]]\nname = \"o\"\nvalue = \"dot(x)\"\n",
       "E319 26:10 `dot(x)` is a rate, and an output takes none\n"},
      {"[[output]]\nname = \"bias\"\nvalue = \"x\"\n",
       "E609 25:9 another output is already called `bias`\n"},
      {"[[output]]\nname = \"o\"\nvalue = \"x\"\njacobian = true\n[[output]]\nname = "
       "\"o_jacobian\"\n"
       "value = \"x\"\n",
       "E609 29:9 another output is already called `o_jacobian`\n"},
      {"[[output]]\nname = \"u\"\nvalue = \"x\"\n",
       "E203 25:9 `u` is already an input | first at line 13\n"},
  };
  for (const auto& [entries, expected] : rows) {
    INFO(entries);
    CHECK(messages(with_points + entries) == expected);
  }
}

TEST_CASE("kinks are allowed in forces") {
  CHECK(messages(with_points + "[[force]]\non = \"x\"\nvalue = \"-min(abs(b*dot(x)), 1*b*dot(x)) + "
                               "sign(dot(x))*u\"\n")
            .substr(0, 10) == "E509 26:10");
  CHECK(messages(with_points + "[[force]]\non = \"x\"\nvalue = \"-b*abs(dot(x))\"\n").empty());
}

}  // namespace
}  // namespace elgen::test
