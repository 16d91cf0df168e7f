// E613 and E614: whether a point is an equilibrium, and whether the expansion about it exists.
#include <catch2/catch.hpp>

#include "inspect/checks.hpp"
#include "inspect/found.hpp"
#include "support/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

Diagnostics diagnostics(const std::string& model, const std::string& lines) {
  const CheckedModel checked = approximated(model, lines);
  return inspect_expansion_point({checked.model, checked.scene});
}

std::string equilibrium_findings(const std::string& model, const std::string& lines) {
  return text_of(diagnostics(model, lines));
}

/// The findings on `model` with an [[equilibrium]] entry that is named `rest` and has `keys`.
std::string entry_findings(const std::string& model, const std::string& keys) {
  const CheckedModel checked =
      checked_model(model + "[[equilibrium]]\nname = \"rest\"\n" + keys + "\n");
  return text_of(inspect_equilibria({checked.model, checked.scene}));
}

const std::string holds_at_own_values =
    " balances it at the values of the parameters; write values with parameters, such as `m*g`, or "
    "fix all parameters: `[parameters] fixed = \"all\"`";

const std::string driven = model_text("driven", R"toml(
[[coordinate]]
name = "q"
[[coordinate]]
name = "p"
[parameters]
m = 2
k = 3
[energy]
T = "1/2*m*(dot(q)^2 + dot(p)^2)"
V = "k*p*sin(q) - m*q + sqrt(1 + q)"
[[input]]
name = "u"
on = "q"
)toml");

}  // namespace

TEST_CASE("models without approximation and true equilibria pass") {
  const CheckedModel exact = checked_model(read_model("cart_pole"));
  CHECK(inspect_expansion_point({exact.model, exact.scene}).empty());
  CHECK(equilibrium_findings(read_model("cart_pole"), "order = 1\nabout = { x = 3, theta = 0 }")
            .empty());
  CHECK(
      equilibrium_findings(read_model("cart_pole"), "order = 1\nabout = { x = 0, theta = \"pi\" }")
          .empty());
  CHECK(equilibrium_findings(read_model("cart_pole"), "order = 2\nabout = { theta = 0 }").empty());
}

TEST_CASE("a leaning pole does not stay at rest") {
  CHECK(equilibrium_findings(read_model("cart_pole"),
                             "order = 1\nabout = { x = 0, theta = \"pi/2\" }") ==
        "E613: `theta` does not stay at rest there: bias - B u is -1.4715");
}

TEST_CASE("an input that balances the point is suggested and accepted") {
  const Diagnostics found_without = diagnostics(driven, "order = 1\nabout = { q = 0, p = 0 }");
  REQUIRE(found_without.size() == 1);
  CHECK(found_without[0].hint == "`u = -3/2`" + holds_at_own_values);
  CHECK(
      equilibrium_findings(driven, "order = 1\nabout = { q = 0, p = 0, u = \"1/2 - m\" }").empty());
}

TEST_CASE("figures hold at the parameters' own values, including 0") {
  const auto offset = [](const std::string& force) {
    return model_text("offset", R"toml(
[[coordinate]]
name = "q"
[parameters]
m = 2
k = 3
c = 0
[energy]
T = "1/2*m*dot(q)^2"
V = ")toml" + force + R"toml("
[[input]]
name = "u"
on = "q"
)toml");
  };
  const std::string about = "order = 1\nabout = { q = 0 }";
  const Diagnostics own = diagnostics(offset("(c - k)*q"), about);
  CHECK(text_of(own) == "E613: `q` does not stay at rest there: bias - B u is -3");
  CHECK(own.at(0).hint == "`u = -3`" + holds_at_own_values);
  const Diagnostics other = diagnostics(offset("c*q"), about);
  CHECK(text_of(other) ==
        "E613: `q` does not stay at rest there: bias - B u is not 0 at other values of the "
        "parameters");
  CHECK(mentions(holds_at_own_values, other.at(0).hint));
}

TEST_CASE("a coordinate without a given value must balance everywhere") {
  CHECK_FALSE(equilibrium_findings(driven, "order = 1\nabout = { p = 0 }").empty());
  CHECK(
      equilibrium_findings(driven, "order = 1\nabout = { q = 0, p = 0 }\nsmall = [\"p\"]").empty());
}

TEST_CASE("the power of a root has no expansion about zero") {
  const std::string root = model_text("root", R"toml(
[[coordinate]]
name = "q"
[energy]
T = "1/2*dot(q)^2"
V = "(q^2)^(5/2)"
)toml");
  CHECK(equilibrium_findings(root, "order = 5\nabout = { q = 0 }") ==
        "E614: energies and forces have no derivatives of order 6 there");
}

TEST_CASE("equilibria of a model balance in every row for all free coordinates") {
  CHECK(entry_findings(read_model("cart_pole"), "at = { theta = 0 }").empty());
  CHECK(entry_findings(read_model("cart_pole"), "at = { theta = \"pi\", x = 2 }").empty());
  CHECK(entry_findings(read_model("cart_pole"), "at = { theta = \"pi/2\" }") ==
        "E613: `theta` does not stay at rest there: bias - B u is -1.4715");
  CHECK(entry_findings(read_model("cart_pole"), "at = { theta = 0 }\ninputs = { u = 1 }") ==
        "E613: `x` does not stay at rest there: bias - B u is -1");
  CHECK_FALSE(entry_findings(read_model("cart_pole"), "at = { x = 0 }").empty());
}

TEST_CASE("an equilibrium is checked only if its condition holds") {
  const std::string split = model_text("split", R"toml(
[[coordinate]]
name = "q"
[parameters]
c = { value = -2, min = -5, max = 5 }
k = 3
[energy]
T = "1/2*dot(q)^2"
V = "1/4*k*q^4 - 1/2*c*q^2"
)toml");
  const std::string apart = "at = { q = \"sqrt(c/k)\" }\n";
  const std::string without_value =
      "E613: a value of `rest` does not exist for some values of the parameters";
  CHECK(entry_findings(split, apart + "when = \"c > 0\"").empty());
  CHECK(entry_findings(split, apart + "when = \"0 < c\"").empty());
  CHECK(entry_findings(split, apart) == without_value);
  CHECK(entry_findings(split, apart + "when = \"c < 0\"") == without_value);
  CHECK(entry_findings(split, "at = { q = \"2*sqrt(c/k)\" }\nwhen = \"c > 0\"") ==
        "E613: `q` does not stay at rest there: bias - B u is not 0 at other values of the "
        "parameters");
  CHECK(entry_findings(split, "at = { q = 1 }\nwhen = \"k < 0\"").empty());  // no sample has k < 0
}

TEST_CASE("a system moved by time does not stay at rest") {
  const std::string shaken = model_text("shaken", R"toml(
[[coordinate]]
name = "q"
[parameters]
k = 3
[energy]
T = "1/2*dot(q)^2"
V = "1/2*k*q^2 - q*sin(t)"
)toml");
  CHECK(entry_findings(shaken, "at = { q = 0 }")
            .starts_with("E613: `q` does not stay at rest there"));
}

TEST_CASE("a scene about an equilibrium is checked where the equilibrium exists") {
  const std::string split = model_text("split", R"toml(
[[coordinate]]
name = "q"
[parameters]
c = { value = -2, min = -5, max = 5 }
[energy]
T = "1/2*dot(q)^2"
V = "1/4*q^4 - 1/2*c*q^2"
[[equilibrium]]
name = "apart"
at = { q = "sqrt(c)" }
when = "c > 0"
)toml");
  const std::string about = "order = 1\nabout = \"apart\"";
  CHECK(equilibrium_findings(split, about).empty());
  CHECK(equilibrium_findings(split, about + "\n[parameters]\nfixed = \"all\"") ==
        "E613: it is no equilibrium: `c > 0` does not hold");
}
