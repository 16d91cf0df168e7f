// Versions of models and scenes, as `elgen diff` reads them.
#include <catch2/catch.hpp>

#include "cli/cli_testing.hpp"

namespace elgen::test {

namespace {

/// Two versions of the cart.
class TwoCarts : public Workspace {
 public:
  TwoCarts() {
    prepare("mkdir old new && cp " + models +
                "/cart_pole.toml old && sed 's/\"-g\"/\"g\"/' old/cart_pole.toml > "
                "new/cart_pole.toml",
            path());
  }
  [[nodiscard]] Outcome diff(const std::string& words) const {
    return shell("elgen diff " + words, path());
  }
};

}  // namespace

TEST_CASE("a model may come from standard input") {
  const TwoCarts carts;
  CHECK(carts.diff("- new/cart_pole.toml < old/cart_pole.toml").status == 1);
  CHECK(carts.diff("- - < old/cart_pole.toml").status == 4);
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
