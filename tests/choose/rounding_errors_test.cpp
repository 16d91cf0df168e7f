// Ways to write one value, and which of them may stand for which.
#include "choose/rounding_errors.hpp"

#include <catch2/catch.hpp>
#include <functional>

#include "choose/chosen.hpp"
#include "lower/graph/from_program.hpp"
#include "support/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// Forms that are not joined into one on the way, as those of a model text would be.
struct Ways {
  Expressions way;
  Expressions reference;
};

const LeafNames leaves{{{"a", "b"}, {"x", "y"}, {"x", "y"}, {"x", "y"}, {}, "t"}, false};

Ref parameter(Graph& graph, std::uint32_t index) { return graph.leaf(Opcode::parameter, index); }
Ref coordinate(Graph& graph, std::uint32_t index) { return graph.leaf(Opcode::coordinate, index); }

Expressions value(const std::function<Ref(Graph&)>& build) {
  Expressions result;
  result.values = {build(result.graph)};
  return result;
}

Ref squared(Graph& graph, Ref x) { return graph.product({{x, 2}}); }

bool is_precise(const Ways& ways, Leaves kind) {
  return is_as_precise(ways.way, ways.reference, mixed_points(leaves), kind);
}

/// b + a y, and with -2 a x + 2 a (x + y/2) for a y.
Ways with_cancelling_terms() {
  const auto plain = [](Graph& g) {
    const Ref product = g.product({{parameter(g, 0), 1}, {coordinate(g, 1), 1}});
    return g.sum({parameter(g, 1), product});
  };
  const auto cancelling = [](Graph& g) {
    const Ref a = parameter(g, 0);
    const Ref x = coordinate(g, 0);
    const Ref half = g.product({{g.rational(cln::cl_RA(1) / 2), 1}, {coordinate(g, 1), 1}});
    const Ref two = g.rational(2);
    const Ref whole = g.product({{two, 1}, {a, 1}, {g.sum({x, half}), 1}});
    return g.sum({parameter(g, 1), whole, -g.product({{two, 1}, {a, 1}, {x, 1}})});
  };
  return {value(cancelling), value(plain)};
}

/// cos(x + 1), whole and taken apart.
Ways with_phase() {
  const auto whole = [](Graph& g) {
    return g.call(FunctionId::cos, {g.sum({coordinate(g, 0), g.rational(1)})});
  };
  const auto apart = [](Graph& g) {
    const Ref x = coordinate(g, 0);
    const auto both = [&](FunctionId f) {
      return g.product({{g.call(f, {x}), 1}, {g.call(f, {g.rational(1)}), 1}});
    };
    return g.sum({both(FunctionId::cos), -both(FunctionId::sin)});
  };
  return {value(whole), value(apart)};
}

/// a + cos(x - y), and with the cosine taken apart.
Ways with_difference_of_angles() {
  const auto whole = [](Graph& g) {
    const Ref angle = g.sum({coordinate(g, 0), -coordinate(g, 1)});
    return g.sum({parameter(g, 0), g.call(FunctionId::cos, {angle})});
  };
  const auto apart = [](Graph& g) {
    const auto both = [&](FunctionId f) {
      return g.product({{g.call(f, {coordinate(g, 0)}), 1}, {g.call(f, {coordinate(g, 1)}), 1}});
    };
    return g.sum({parameter(g, 0), both(FunctionId::cos), both(FunctionId::sin)});
  };
  return {value(whole), value(apart)};
}

/// (a - sqrt(x^2 + y^2))^2, and with its square multiplied out.
Ways with_square() {
  const auto root = [](Graph& g) {
    return g.square_root(g.sum({squared(g, coordinate(g, 0)), squared(g, coordinate(g, 1))}));
  };
  const auto square = [root](Graph& g) { return squared(g, g.sum({parameter(g, 0), -root(g)})); };
  const auto sum = [root](Graph& g) {
    const Ref twice = g.product({{g.rational(2), 1}, {parameter(g, 0), 1}, {root(g), 1}});
    return g.sum({squared(g, parameter(g, 0)), squared(g, coordinate(g, 0)),
                  squared(g, coordinate(g, 1)), -twice});
  };
  return {value(square), value(sum)};
}

/// Twice the angle by one call, and by two.
Ways with_double_angle() {
  const auto one = [](Graph& g) {
    return g.call(FunctionId::sin, {g.product({{g.rational(2), 1}, {coordinate(g, 0), 1}})});
  };
  const auto two = [](Graph& g) {
    const Ref x = coordinate(g, 0);
    return g.product(
        {{g.rational(2), 1}, {g.call(FunctionId::sin, {x}), 1}, {g.call(FunctionId::cos, {x}), 1}});
  };
  return {value(one), value(two)};
}

/// Nowhere defined.
Ways without_value() {
  const auto root = [](Graph& g) {
    return g.square_root(-g.sum({g.rational(1), squared(g, coordinate(g, 0))}));
  };
  return {value(root), value(root)};
}

Ways reversed(Ways ways) { return {std::move(ways.reference), std::move(ways.way)}; }

/// Functions of which a closed form is emitted that is less precise than the one that judges it.
std::vector<std::string> imprecise(const std::string& text) {
  const Program program = chosen(text).choice.program;
  const MixedPoints points = mixed_points(program.leaves);
  std::vector<std::string> result;
  for (std::size_t i = 0; i < program.functions.size(); ++i) {
    const Function& function = program.functions[i];
    const Function& readable = program.readable[i];
    if (function.form != Form::closed || readable.fields.empty()) continue;
    const std::vector<std::uint32_t> entries = entries_of(readable);
    for (std::size_t e = 0; e < entries.size(); ++e) {
      const Expressions emitted = from_program(program, function, {entries_of(function)[e]});
      const Expressions judge = from_program(program, readable, {entries[e]});
      // B counts the rounding of what sums of angles are made of: either is no more than it says.
      const bool is_precise = is_as_precise(emitted, judge, points, Leaves::exact) ||
                              is_as_precise(emitted, judge, points, Leaves::rounded);
      if (!is_precise) result.push_back(function.name + " " + std::to_string(e));
    }
  }
  return result;
}

}  // namespace

TEST_CASE("terms that cancel are seen, other countings of the same roundings are admitted") {
  CHECK_FALSE(is_precise(with_cancelling_terms(), Leaves::exact));
  CHECK_FALSE(is_precise(with_cancelling_terms(), Leaves::rounded));
  CHECK(is_precise(reversed(with_cancelling_terms()), Leaves::exact));
  CHECK(is_precise(with_square(), Leaves::exact));
  CHECK(is_precise(with_square(), Leaves::rounded));
  CHECK(is_precise(with_double_angle(), Leaves::exact));
  CHECK(is_precise(reversed(with_double_angle()), Leaves::exact));
}

TEST_CASE("a sum of angles has as many digits as its angles, and no more") {
  CHECK_FALSE(is_precise(with_phase(), Leaves::exact));
  CHECK(is_precise(with_phase(), Leaves::rounded));
}

TEST_CASE("nothing is admitted where nothing has a value") {
  CHECK_FALSE(is_precise(without_value(), Leaves::exact));
}

TEST_CASE("the code of a closed form is as precise as what judges it") {
  for (const auto& [name, text] : systems()) {
    INFO(name);
    CHECK(imprecise(text) == std::vector<std::string>());
  }
  // The shortest way to write its second velocity force is as it was derived, where c cos(y) x' y'
  // cancels: elsewhere the constant angle 1 + sqrt(2) is joined with y.
  CHECK(imprecise(model_text("phase", R"toml(
[[coordinate]]
name = "x"
[[coordinate]]
name = "y"
[parameters]
p = 1
[energy]
T = "(-cos(sqrt(2) + 1))/2*(dot(x) + sin(y)*dot(y))^2 + 3/2*dot(x)^2 + (p + cos(x - y)^2)/2*dot(y)^2"
)toml"))
            .empty());
}

TEST_CASE("a difference of angles is rounded where the angles themselves are not") {
  const Ways difference = with_difference_of_angles();
  CHECK_FALSE(is_precise(difference, Leaves::exact));
  CHECK(is_precise(difference, Leaves::rounded));
  CHECK(is_precise({difference.way, difference.way}, Leaves::exact));
  CHECK(is_precise(with_double_angle(), Leaves::exact));
}
