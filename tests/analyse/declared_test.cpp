// The verdict on each declared [[equilibrium]]: proved, sampled, wrong or open.
#include "analyse/found.hpp"
#include "support/models.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

std::vector<EquilibriumVerdict> verdicts_of(const std::string& text) {
  Products products = products_with(&Products::claims, inputs_of(text), {.goals = {Goal::claims}});
  return std::move(*products.claims);
}

std::string hanging(const std::string& frequency) {
  const std::string pendulum = model_file("simple_pendulum");
  const std::size_t known = pendulum.find("[[equilibrium]]");
  const std::size_t end = pendulum.find("\n\n", known);
  return pendulum.substr(0, known) +
         "[[equilibrium]]\nname = \"hanging\"\nat = { theta = 0 }\nfrequencies_squared = [\"" +
         frequency + "\"]" + (end == std::string::npos ? "\n" : pendulum.substr(end));
}

}  // namespace

TEST_CASE("declared equilibria of models and their frequencies are proved") {
  for (const char* const name : {"simple_pendulum", "rotating_hoop", "cart_pole"}) {
    INFO(name);
    const std::vector<EquilibriumVerdict> all = verdicts_of(model_file(name));
    CHECK_FALSE(all.empty());
    for (const EquilibriumVerdict& one : all) {
      CHECK(one.balance == ClaimStatus::proved);
      CHECK(one.frequencies.value_or(ClaimStatus::proved) == ClaimStatus::proved);
    }
  }
}

TEST_CASE("wrong frequencies are found, with parameters as a witness") {
  CHECK(verdicts_of(hanging("g/l")).at(0).frequencies == ClaimStatus::proved);
  const std::vector<EquilibriumVerdict> wrong = verdicts_of(hanging("2*g/l"));
  CHECK(wrong[0].balance == ClaimStatus::proved);
  CHECK(wrong[0].frequencies == ClaimStatus::wrong);
  CHECK_FALSE(wrong[0].witness.empty());
}

TEST_CASE("equal pendulums and molecules: frequencies with roots are proved") {
  const std::string pendulums = R"toml(format = 1
[model]
name = "pendulums"
[[coordinate]]
name = "a"
unit = "rad"
[[coordinate]]
name = "b"
unit = "rad"
[parameters]
m = { value = 2, unit = "kg", assume = "positive" }
l = { value = 3, unit = "m", assume = "positive" }
g = { value = 9.81, unit = "m/s^2" }
[gravity]
vector = ["0", "-g"]
[[point]]
name = "P"
at = ["l*sin(a)", "-l*cos(a)"]
mass = "m"
[[point]]
name = "Q"
at = ["l*sin(a) + l*sin(b)", "-l*cos(a) - l*cos(b)"]
mass = "m"
[[equilibrium]]
name = "hanging"
at = { a = 0, b = 0 }
frequencies_squared = ["g/l*(2 - sqrt(2))", "g/l*(2 + sqrt(2))"]
)toml";
  CHECK(verdicts_of(pendulums).at(0).frequencies == ClaimStatus::proved);
  const std::string molecule = model_file("triatomic_molecule") + R"toml(
[[equilibrium]]
name = "stretched"
at = { x1 = "-b", x2 = 0, x3 = "b" }
frequencies_squared = [0, "k/m", "k*(1/m + 2/M)"]
)toml";
  const std::vector<EquilibriumVerdict> both = verdicts_of(molecule);
  REQUIRE(both.size() == 1);
  CHECK(both[0].balance == ClaimStatus::proved);
  CHECK(both[0].frequencies == ClaimStatus::proved);
}

TEST_CASE("claims that closed forms do not decide are sampled") {
  const auto well = [](const std::string& square, const std::string& more) {
    return verdicts_of(model_text("well", R"toml(
[[coordinate]]
name = "q"
[parameters]
m = { value = 2, assume = "positive" }
k = { value = 3, min = 1, max = 5 }
[energy]
T = "1/2*m*dot(q)^2"
V = "exp(q) - 2*k*q"
[[equilibrium]]
name = "middle"
at = { q = "log(2*k)" }
frequencies_squared = [")toml" + square + "\"]\n" +
                                              more))
        .at(0);
  };
  const EquilibriumVerdict right = well("2*k/m", "");
  CHECK(right.balance == ClaimStatus::sampled);
  CHECK(right.frequencies == ClaimStatus::sampled);
  CHECK(right.witness.empty());
  const EquilibriumVerdict wrong = well("3*k/m", "");
  CHECK(wrong.balance == ClaimStatus::sampled);
  CHECK(wrong.frequencies == ClaimStatus::wrong);
  CHECK_FALSE(wrong.witness.empty());
  const EquilibriumVerdict never = well("2*k/m", "when = \"k < 0\"\n");
  CHECK(never.balance == ClaimStatus::undecided);
  CHECK(never.frequencies == ClaimStatus::undecided);
}
