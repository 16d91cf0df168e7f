// Base parameters. An independent program computes the rank of the regressor, which is the expected
// number of base parameters. The base parameters alone reproduce all forces. The factors of
// regrouped parameters equal factors derived by hand.
#include <catch2/catch.hpp>

#include "analyse/residues.hpp"
#include "numbers/exact_number.hpp"
#include "pipeline/constrained_testing.hpp"
#include "sample/states.hpp"

namespace elgen::test {
namespace {

BaseParameters base_of(const std::string& text) {
  Products products = products_with(&Products::base_parameters, inputs_of(text),
                                    {.goals = {Goal::base_parameters}});
  return std::move(*products.base_parameters);
}

/// The model `text` with an armature of 1 at each coordinate.
std::string with_armatures(std::string text) {
  std::size_t at = 0;
  while ((at = text.find("[[coordinate]]\n", at)) != std::string::npos) {
    at += std::string("[[coordinate]]\n").size();
    text.insert(at, "armature = 1\n");
  }
  return text;
}

/// The model `text` with an armature of 1 and linear friction at each of the `joints` coordinates.
std::string with_friction(const std::string& text, int joints) {
  std::string result = with_armatures(text);
  std::string parameters;
  std::string sum;
  for (int i = 1; i <= joints; ++i) {
    parameters += "friction" + std::to_string(i) + " = { value = 1, unit = \"N*m*s\" }\n";
    sum += (i > 1 ? " + " : "") + ("1/2*friction" + std::to_string(i)) + "*dot(q" +
           std::to_string(i) + ")^2";
  }
  const std::string table = "[parameters]\n";
  const std::size_t at = result.find(table);
  if (at == std::string::npos) {
    result += table + parameters;
  } else {
    result.insert(at + table.size(), parameters);
  }
  return result + "\n[energy]\nD = \"" + sum + "\"\n";
}

/// A pendulum of three point masses on a line, which is vertical at q = -`tilt`.
std::string pendulum(const std::string& tilt) {
  std::string text = R"toml(format = 1
[model]
name = "pendulum"
[[coordinate]]
name = "q"
[parameters]
g = 10
m = 3
[gravity]
vector = ["0", "-g"]
)toml";
  for (const std::string at : {"1", "2", "3"}) {
    const std::string angle = "(q + " + tilt + ")";
    text += "[[point]]\nname = \"p" + at + "\"\nmass = \"m\"\nat = [\"" + at + "*sin" + angle +
            "\", \"-" + at + "*cos" + angle + "\"]\n";
  }
  return text;
}

}  // namespace

TEST_CASE("ranks of the regressors of arms") {
  const auto rank = [](const std::string& text) {
    const BaseParameters found = base_of(text);
    CHECK(found.is_exact);
    return found.base.size();
  };
  const std::string panda = model_file("panda7");
  CHECK(rank(panda) == 43);
  CHECK(rank(with_armatures(panda)) == 48);
  CHECK(rank(with_friction(panda, 7)) == 55);
  const std::string ur5 = model_file("ur5");
  CHECK(rank(ur5) == 36);
  CHECK(rank(with_armatures(ur5)) == 40);
  CHECK(rank(with_friction(ur5, 6)) == 46);
}

TEST_CASE("base parameters alone reproduce the forces") {
  for (const char* const name : {"panda7", "ur5", "furuta_pendulum", "heavy_top", "five_bar"}) {
    INFO(name);
    const std::string text = model_file(name);
    const BaseParameters found = base_of(text);
    const Constrained system(text, "regressor,inverse_dynamics");
    Sampler draw(7);
    State state = system.nominal();
    draw_motion(system.model(), draw, 0, state);
    const ExactNumbers y = system.exactly(OutputKind::regressor, "matrix", state);
    const ExactNumbers rest = system.exactly(OutputKind::regressor, "rest", state);
    const ExactNumbers forces = system.exactly(OutputKind::inverse_dynamics, "", state);
    ExactNumbers by_base = rest;
    for (std::size_t i = 0; i < by_base.size(); ++i) {
      for (const BaseParameter& base : found.base) {
        by_base[i] = by_base[i] + y[i * found.parameters.size() + base.parameter] * base.value;
      }
    }
    check_digits(by_base, forces, 50);
  }
}

TEST_CASE("point masses on a line, tilted by a multiple of a right angle or by another angle") {
  for (const auto& [tilt, is_exact] : {std::pair("pi/2", true), std::pair("pi/10", false)}) {
    const BaseParameters found = base_of(pendulum(tilt));
    CHECK(found.is_exact == is_exact);
    REQUIRE(found.base.size() == 2);
    // The column of a mass at r depends on (r, r^2), and (3, 9) = -3 (1, 1) + 3 (2, 4).
    REQUIRE(found.base[0].regrouped_terms.size() == 1);
    CHECK(double_of(found.base[0].regrouped_terms[0].factor) == Approx(-3).epsilon(1e-15));
    CHECK(double_of(found.base[1].regrouped_terms[0].factor) == Approx(3).epsilon(1e-15));
    CHECK(double_of(found.base[0].value) == Approx(-6).epsilon(1e-15));
    CHECK(found.unidentifiable.empty());
  }
}

TEST_CASE("rational numbers are recovered from their residues") {
  for (const char* const text :
       {"0", "1", "-3/7", "316/1000", "-12345678901234567/98765432109876543"}) {
    const cln::cl_RA number = cln::the<cln::cl_RA>(exact(text));
    CHECK(reconstruct_rational(residue_of(number)) == number);
  }
  // The numerator and the denominator of (3/7)^1000 are too large to be recovered from a residue.
  CHECK_FALSE(reconstruct_rational(cln::expt_pos(residue_of(cln::cl_RA(3) / 7), 1000)));
}

}  // namespace elgen::test
