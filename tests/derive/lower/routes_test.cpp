// Forward dynamics is lowered by the cheapest route.
#include <catch2/catch.hpp>

#include "derive/framed.hpp"
#include "elgen/lower.hpp"
#include "support/links.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

struct Routes {
  explicit Routes(const std::string& text)
      : system(text),
        request(system.request("forward_dynamics")),
        equations(*derive(system.lagrangian, {request}, {})) {}

  [[nodiscard]] Function lowered() const { return lowered(equations); }

  /// Forward dynamics lowered by elimination of M, without the alternative by articulated bodies.
  [[nodiscard]] Function lowered_by_elimination() const {
    EquationsOfMotion usual = equations;
    usual.alternatives.clear();
    return lowered(usual);
  }

  [[nodiscard]] Function lowered(const EquationsOfMotion& from) const {
    const Result<Program> program = lower(from, {request}, {});
    if (!program) throw std::runtime_error(format(program.diagnostics));
    return program->functions.front();
  }

  Framed system;
  OutputRequest request;
  EquationsOfMotion equations;
};

std::size_t cost_of(const Function& function) { return cost(count_operations(function)); }

}  // namespace

TEST_CASE("with few velocities there is one route, which eliminates from the first velocity",
          "[frames]") {
  CHECK_FALSE(Framed(links_text(9)).lagrangian.eliminates_last_first);
  CHECK(Framed(links_text(10)).lagrangian.eliminates_last_first);
  CHECK(Routes(links_text(9)).equations.alternatives.empty());
  CHECK(Routes(read_model("two_turns")).equations.alternatives.empty());
}

TEST_CASE("a chain of twenty revolute joints is solved by articulated bodies, which cost less",
          "[frames]") {
  const Routes routes(links_text(20));
  REQUIRE(routes.equations.outputs.size() == 1);
  REQUIRE(routes.equations.alternatives.size() == 1);
  const std::size_t chosen = cost_of(routes.lowered());
  CHECK(10 * chosen < 9 * cost_of(routes.lowered_by_elimination()));
}

TEST_CASE("M is eliminated if this costs less", "[frames]") {
  // Ten wheels on one carriage are not coupled with each other.
  std::string text;
  std::string names = "x";
  for (int i = 1; i <= 10; ++i) {
    const std::string number = std::to_string(i);
    names += " q" + number;
    text += "[[frame]]\nname = \"w" + number + "\"\nparent = \"carriage\"\ntranslate = [\"l*" +
            number + "\", \"0\", \"l/9\"]\nrotate = [[\"y\", \"q" + number +
            "\"]]\n[[body]]\nname = \"b" + number + "\"\nframe = \"w" + number +
            "\"\nmass = \"m1\"\ncom = [\"l/5\", \"0\", \"0\"]\ninertia = [\"A\", \"B\", \"C\"]\n";
  }
  const std::string carriage =
      "[[frame]]\nname = \"carriage\"\nparent = \"world\"\ntranslate = [\"x\", \"0\", \"0\"]\n"
      "[[body]]\nname = \"hull\"\nframe = \"carriage\"\nmass = \"m2\"\n";
  const Routes routes(frame_model("wagon", names, carriage + text));
  REQUIRE(routes.equations.alternatives.size() == 1);
  CHECK(cost_of(routes.lowered()) <= cost_of(routes.lowered_by_elimination()));
}

TEST_CASE("without pivots M_ii is not computed, and accelerations are the only field", "[frames]") {
  const Routes usual(links_text(20));
  Framed system(links_text(20));
  OutputRequest request = usual.request;
  request.omits_pivots = true;
  const EquationsOfMotion equations = *derive(system.lagrangian, {request}, {});
  const Result<Program> program = lower(equations, {request}, {});
  REQUIRE(program);
  const Function& alone = program->functions.front();
  REQUIRE(alone.fields.size() == 1);
  CHECK(alone.fields.front().name.empty());
  CHECK(alone.fields.front().entries.size() == 20);
  // M_ii needs composite inertias, which cost more than a twentieth of the function with pivots.
  CHECK(20 * cost_of(alone) < 19 * cost_of(usual.lowered()));
}

TEST_CASE("M of a long chain is not derived for forward dynamics", "[frames]") {
  const Routes routes(links_text(60));
  CHECK(routes.equations.outputs.empty());
  REQUIRE(routes.equations.alternatives.size() == 1);
  CHECK(routes.lowered().fields.size() == 2 + 1);
}
