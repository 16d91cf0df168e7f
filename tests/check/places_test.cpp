// Places: what may stand where, at the node that brings it in.
#include <catch2/catch.hpp>
#include <utility>

#include "check_testing.hpp"

namespace elgen::test {
namespace {

const std::string entries = R"toml([[input]]
name = "u"
unit = "N"
[define]
speed = "dot(x)"
drive = "u*x"
[parameters.T0]
value = 1
unit = "kg*s^2"
)toml";

TEST_CASE("each ingredient is reported where it comes in, also through a definition") {
  const std::vector<std::pair<std::string, std::string>> rows{
      {"V = \"k*x^2 + u*x\"\n", "E319 12:14 `u` is an input, and V takes none\n"},
      {"V = \"drive\"\n", "E319 12:6 `drive` contains an input, and V takes none\n"},
      {"V = \"T0*dot(dot(x))^2\"\n",
       "E502 12:9 `dot(dot(x))` is a second derivative, and V takes none\n"},
      {"V = \"T0*dot(speed)^2\"\n",
       "E502 12:9 `dot(speed)` is a second derivative, and V takes none\n"},
      {"V = \"k*max(x, 0)^2\"\n",
       "E315 12:8 `max(x, 0)` is a function with a kink, and V takes none | a smooth stand-in is "
       "tanh(x/width)\n"},
      {"V = \"u*x + u*x\"\n",
       "E319 12:6 `u` is an input, and V takes none\nE319 12:12 `u` is an input, and V takes "
       "none\n"},
  };
  for (const auto& [energy, expected] : rows) {
    INFO(energy);
    CHECK(messages(block(energy + entries)) == expected);
  }
}

TEST_CASE("definitions take no accelerations, closed forms take everything") {
  CHECK(messages(block(entries + "[[expect]]\ninverse_dynamics = [\"m*dot(dot(x))\"]\n")).empty());
  CHECK(messages(block("[define]\na = \"m*dot(dot(x))\"\n")) ==
        "E502 13:8 `dot(dot(x))` is a second derivative, and a definition takes none\n");
}

TEST_CASE("the rate of a function with a kink is refused where the function is not") {
  const std::string force = "[[force]]\non = \"x\"\nvalue = \"";
  const std::string refused = " is the rate of a function with a kink | " +
                              std::string("a smooth stand-in is tanh(x/width)\n");
  CHECK(messages(block(force + "k*abs(x)\"\n")).empty());
  CHECK(messages(block(force + "c*dot(abs(x))\"\n[parameters.c]\nvalue = 1\nunit = \"kg/s\"\n")) ==
        "E315 14:12 `dot(abs(x))`" + refused);
  CHECK(messages(block(force + "c*dot(spread)\"\n[parameters.c]\nvalue = 1\nunit = \"kg/s\"\n"
                               "[define]\nspread = \"2*abs(x)\"\n")) ==
        "E315 14:12 `dot(spread)`" + refused);
  // What does not move has the rate 0.
  CHECK(
      messages(block(force + "k*x + c*dot(abs(k))\"\n[parameters.c]\nvalue = 1\nunit = \"m*s\"\n"))
          .empty());
}

TEST_CASE("a rate may stand in an energy, a spin and a force, in nothing else") {
  CHECK(messages(block("D = \"0.5*T0*speed^2/x^2*dot(x)*0\"\n" + entries)).empty());
  CHECK(messages(block("[[prescribed]]\nname = \"w\"\nvalue = \"sin(t)\"\n[[point]]\nname = \"p\"\n"
                       "at = [\"x\", \"0\"]\nmass = \"m*w\"\n"))
            .find("`w` contains time, and a mass takes none") != std::string::npos);
  CHECK(messages(block(entries + "[[point]]\nname = \"p\"\nat = [\"speed*0\", \"0\"]\n")) ==
        "E319 23:8 `speed` contains a rate, and a position takes none\n");
}

}  // namespace
}  // namespace elgen::test
