// Energies and forces of an expanded Lagrangian as polynomials, and Taylor coefficients through
// definitions.
#include "derive/specialise/expand.hpp"

#include <catch2/catch.hpp>

#include "derive/formulate/written_out.hpp"
#include "derive/specialise/passes.hpp"
#include "elgen/specialise.hpp"
#include "support/systems.hpp"

using namespace elgen;
using namespace elgen::test;
using GiNaC::ex;

namespace {

struct Expanded {
  Lagrangian lagrangian;
  ex kinetic;
  ex potential;
  ex dissipation;
};

Expanded energies(const std::string& model, const std::string& lines) {
  const CheckedModel checked = approximated(model, lines);
  Expanded result{*specialise(*formulate(checked.model), checked), 0, 0, 0};
  const auto sum = [&](const EnergyTerms& terms) {
    return written_out(result.lagrangian.definitions, GiNaC::add(values_of(terms))).expand();
  };
  result.kinetic = sum(result.lagrangian.kinetic);
  result.potential = sum(result.lagrangian.potential);
  result.dissipation = sum(result.lagrangian.dissipation);
  return result;
}

ex force(const Expanded& e, std::size_t index) {
  return written_out(e.lagrangian.definitions, e.lagrangian.forces[index]).expand();
}

const std::string spring = model_text("spring", R"toml(
[[coordinate]]
name = "x"
[parameters]
m = 2
k = 3
b = 1
[energy]
T = "1/2*m*dot(x)^2"
V = "k*(1 - cos(x))"
D = "b*(cosh(dot(x)) - 1)"
[[input]]
name = "u"
[[force]]
on = "x"
value = "u*cos(x)"
)toml");

/// Leaves x, y, p and definitions over them.
struct Leaves {
  Definitions definitions;
  ex x = GiNaC::realsymbol("x");
  ex y = GiNaC::realsymbol("y");
  ex p = GiNaC::realsymbol("p");

  Leaves() {
    add_leaf(definitions, p, Opcode::parameter);
    add_leaf(definitions, x, Opcode::coordinate);
    add_leaf(definitions, y, Opcode::velocity);
  }

  ex expanded(const ex& value, const std::vector<SmallLeaf>& small, unsigned order) {
    TaylorSeries series(definitions, small, order);
    return written_out(definitions, series(value)).expand();
  }
};

}  // namespace

TEST_CASE("forces on coordinates that are not small are expanded to one order more") {
  const std::string cart = model_text("cart", R"toml(
[[coordinate]]
name = "x"
[[coordinate]]
name = "th"
[energy]
T = "dot(x)^2 + dot(th)^2"
V = "cosh(th)"
[[input]]
name = "u"
[[point]]
name = "tip"
at = ["x + sin(th)", "cos(th)"]
[[force]]
on = "x"
value = "u*sin(th)"
[[force]]
on = "th"
value = "u*sin(th)"
[[force]]
at = "tip"
value = ["u*cos(th)", "0"]
)toml");
  const Expanded e = energies(cart, "order = 2\nabout = { th = 0 }");
  const Symbols& s = e.lagrangian.symbols;
  const ex& th = s.q[1];
  const ex& u = s.u[0];
  // Force on x: u (sin + cos) to order 3; force on th: u (sin + cos^2) to order 2.
  CHECK((force(e, 0) - u * (1 + th - th * th / 2 - th * th * th / 6)).expand().is_zero());
  CHECK((force(e, 1) - u * (1 + th - th * th)).expand().is_zero());
}

TEST_CASE("energies are expanded to one order more than the equations") {
  const Expanded e = energies(spring, "order = 1\nabout = { x = 0 }");
  const Symbols& s = e.lagrangian.symbols;
  const ex& x = s.q[0];
  const ex& v = s.v[0];
  const ex& m = s.parameters[0];
  const ex& k = s.parameters[1];
  CHECK(e.kinetic.is_equal(m * v * v / 2));
  CHECK(e.potential.is_equal(k * x * x / 2));
  CHECK(e.dissipation.is_equal(s.parameters[2] * v * v / 2));
  CHECK(force(e, 0).is_equal(s.u[0]));
  const Expanded third = energies(spring, "order = 3\nabout = { x = 0 }");
  const Symbols& t = third.lagrangian.symbols;
  const ex& y = t.q[0];
  CHECK(third.potential.is_equal((t.parameters[1] * (y * y / 2 - pow(y, 4) / 24)).expand()));
  CHECK(force(third, 0).is_equal((t.u[0] * (1 - y * y / 2)).expand()));
}

TEST_CASE("inputs near a value count as small, like coordinates") {
  const Expanded e = energies(spring, "order = 1\nabout = { x = \"pi/3\", u = 2 }");
  const Symbols& s = e.lagrangian.symbols;
  // u cos(x) near x = pi/3, u = 2: 1 + (u - 2)/2 - sqrt(3) (x - pi/3).
  const ex deviation = s.q[0] - GiNaC::Pi / 3;
  const ex expected = 1 + (s.u[0] - 2) / 2 - sqrt(ex(3)) * deviation;
  CHECK((force(e, 0) - expected).expand().is_zero());
}

TEST_CASE("point masses, weights and forces at points become terms") {
  const Expanded e = energies(read_model("cart_pole"), "order = 1\nabout = { x = 0, theta = 0 }");
  CHECK(e.lagrangian.masses.empty());
  CHECK(e.lagrangian.point_forces.empty());
  CHECK_FALSE(e.lagrangian.gravity);
  for (const EnergyTerms& terms : {e.lagrangian.kinetic, e.lagrangian.potential}) {
    REQUIRE(terms.size() == 2);
    for (const EnergyTerm& term : terms) CHECK(term.origin == EnergyOrigin::mass);
  }
  const Symbols& s = e.lagrangian.symbols;
  const ex& big = s.parameters[0];
  const ex& m = s.parameters[1];
  const ex& l = s.parameters[2];
  const ex& g = s.parameters[3];
  const ex& xd = s.v[0];
  const ex& td = s.v[1];
  const ex kinetic = (big + m) * xd * xd / 2 + m * l * xd * td + m * l * l * td * td / 2;
  CHECK((e.kinetic - kinetic).expand().is_zero());
  CHECK((e.potential - m * g * l * (1 - s.q[1] * s.q[1] / 2)).expand().is_zero());
}

TEST_CASE("contents of frames are expanded in the world") {
  const std::string arm = model_text("arm", R"toml(
[[coordinate]]
name = "q"
[parameters]
m = 2
l = 3
J = 5
g = 9.81
[[frame]]
name = "arm"
parent = "world"
rotate = [["y", "q"]]
[[body]]
name = "arm"
frame = "arm"
mass = "m"
com = ["0", "0", "-l"]
inertia = ["J", "J", "J"]
[[point]]
name = "tip"
frame = "arm"
at = ["0", "0", "-2*l"]
mass = "m"
[gravity]
vector = ["0", "0", "-g"]
[[input]]
name = "u"
[[input]]
name = "F"
[[force]]
frame = "arm"
value = ["0", "u", "0"]
[[force]]
at = "tip"
value = ["F", "0", "0"]
)toml");
  const Expanded e = energies(arm, "order = 2\nabout = { q = 0 }");
  CHECK(e.lagrangian.tree.bodies.empty());
  CHECK(e.lagrangian.tree.wrenches.empty());
  const Symbols& s = e.lagrangian.symbols;
  const ex& m = s.parameters[0];
  const ex& l = s.parameters[1];
  const ex& q = s.q[0];
  const ex kinetic = (5 * m * l * l + s.parameters[2]) * s.v[0] * s.v[0] / 2;
  CHECK((e.kinetic - kinetic).expand().is_zero());
  CHECK((e.potential + 3 * m * s.parameters[3] * l * (1 - q * q / 2)).expand().is_zero());
  // u - 2 l F cos(q) = u - 2 l F to order 2, because F counts as small like q.
  CHECK((force(e, 0) - s.u[0] + 2 * l * s.u[1]).expand().is_zero());
}

TEST_CASE("an expansion is the Taylor polynomial about the point") {
  Leaves l;
  const ex h = define(l.definitions, l.p * cos(l.x));
  CHECK(l.expanded(h, {{l.x, 0}}, 3).is_equal(l.p - l.p * pow(l.x, 2) / 2));
  const ex about = GiNaC::Pi / 2;
  const ex expected = (-l.p * (l.x - about) + l.p * pow(l.x - about, 3) / 6).expand();
  CHECK(l.expanded(h, {{l.x, about}}, 4).is_equal(expected));
}

TEST_CASE("the order counts all small leaves together, through products and quotients") {
  Leaves l;
  const ex a = define(l.definitions, exp(l.x) * l.y);
  const ex b = define(l.definitions, l.p + l.x);
  const ex value = a / b;
  const std::vector<SmallLeaf> small{{l.x, 0}, {l.y, 0}};
  // y (1 + x + x^2/2) (1/p - x/p^2 + x^2/p^3)
  const ex third = l.y / l.p + l.x * l.y * (1 / l.p - 1 / pow(l.p, 2)) +
                   pow(l.x, 2) * l.y * (1 / (2 * l.p) - 1 / pow(l.p, 2) + 1 / pow(l.p, 3));
  CHECK((l.expanded(value, small, 3) - third).expand().is_zero());
}

TEST_CASE("other leaves are not expanded") {
  Leaves l;
  const ex h = define(l.definitions, sin(l.x) * pow(l.y, 2));
  CHECK(l.expanded(h, {{l.y, 0}}, 1).is_zero());
  CHECK(l.expanded(h, {{l.y, 0}}, 2).is_equal(sin(l.x) * pow(l.y, 2)));
  CHECK(l.expanded(sin(l.p), {{l.x, 0}}, 1).is_equal(sin(l.p)));
}

TEST_CASE("a value that is not differentiable at the point is refused") {
  Leaves l;
  const ex root = define(l.definitions, sqrt(l.x) + l.p);
  CHECK_THROWS_AS(l.expanded(root, {{l.x, 0}}, 1), GiNaC::pole_error);
}
