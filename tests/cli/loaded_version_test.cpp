// Versions of models, scenes and sidecars, as `elgen diff` reads them.
#include <catch2/catch.hpp>

#include "cli/cli_testing.hpp"

namespace elgen::test {

namespace {

/// Two versions of the cart, with what they generate.
class TwoCarts : public Workspace {
 public:
  TwoCarts() {
    prepare("mkdir old new && cp " + models +
                "/cart_pole.toml old && sed 's/\"-g\"/\"g\"/' old/cart_pole.toml > "
                "new/cart_pole.toml && for f in old new; do elgen generate -q -o $f/generated "
                "$f/cart_pole.toml 2> /dev/null; done",
            path());
  }
  [[nodiscard]] Outcome diff(const std::string& words) const {
    return shell("elgen diff " + words, path());
  }
};

const std::string sidecar = "/generated/cart_pole/cart_pole.equations.json";

}  // namespace

TEST_CASE("two sidecars are compared by T, V, D, Q and B") {
  const Outcome outcome = TwoCarts().diff("old" + sidecar + " new" + sidecar);
  CHECK(outcome.status == 1);
  CHECK(starts_with(outcome.output, "changed      V = m*l*g*cos(theta) -> -m*l*g*cos(theta);"));
  CHECK(mentions(outcome.output, "operations   unchanged\n"));
}

TEST_CASE("sidecars of folders without models match by their paths") {
  const Outcome outcome = TwoCarts().diff("old/generated new/generated");
  CHECK(outcome.status == 1);
  CHECK(mentions(outcome.output, "follows      14 of 74 entries differ"));
}

TEST_CASE("a model, and a sidecar, may come from standard input") {
  const TwoCarts carts;
  CHECK(carts.diff("- new/cart_pole.toml < old/cart_pole.toml").status == 1);
  const Outcome outcome = carts.diff("old" + sidecar + " - < new" + sidecar);
  CHECK(outcome.status == 1);
  CHECK(mentions(outcome.output, "V = m*l*g*cos(theta) -> -m*l*g*cos(theta)"));
  CHECK(carts.diff("- - < old/cart_pole.toml").status == 4);
}

TEST_CASE("a sidecar is not compared with a model, nor with what is none") {
  const TwoCarts carts;
  const Outcome mixed = carts.diff("old/cart_pole.toml new" + sidecar);
  CHECK(mixed.status == 2);
  CHECK(mentions(mixed.errors, "is a sidecar of equations, which is compared with another one"));
  prepare("echo '{}' > new/broken.equations.json", carts.path());
  const Outcome broken = carts.diff("old" + sidecar + " new/broken.equations.json");
  CHECK(broken.status == 2);
  CHECK(mentions(broken.errors, "error[E714]: `new/broken.equations.json` is no sidecar"));
}

TEST_CASE("operations of emitted code are told, of large systems they are not counted") {
  const TwoCarts carts;
  prepare("sed 's/l\\*sin(theta)/2*l*sin(theta)/' old/cart_pole.toml > new/cart_pole.toml",
          carts.path());
  CHECK(mentions(carts.diff("old/cart_pole.toml new/cart_pole.toml").output, "\noperations   "));
  prepare("cp " + models +
              "/panda7.toml old && sed 's/value = 9.81/value = 9.8/' old/panda7.toml > "
              "new/panda7.toml",
          carts.path());
  CHECK_FALSE(mentions(carts.diff("old/panda7.toml new/panda7.toml").output, "operations"));
}

}  // namespace elgen::test
