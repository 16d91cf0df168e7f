#include "oracle/evaluation.hpp"

#include <catch2/catch.hpp>

#include "oracle/mechanics.hpp"
#include "oracle/samples.hpp"
#include "support/models.hpp"

using namespace elgen;
using namespace elgen::oracle;
using namespace elgen::test;
using cln::cl_R;

namespace {

/// x = 2, v = 3, a = 5, u = 7, p = 11, t = 13
struct Fixture {
  ModelBuilder b;
  Motion motion{{11}, {}, {2}, {3}, {}, {}, {5}, {}, {7}, 13};

  Fixture() { b.coordinate("x").input("u").parameter("p", "11"); }

  cl_R value(const std::string& text, unsigned time_order = 0) {
    const ExpressionId id = b.expression(text);
    Evaluation at(b.model, motion);
    if (time_order == 0) return at.value(id).real();
    return (time_order == 1 ? at.rate(id) : at.second_rate(id)).real();
  }
};

}  // namespace

TEST_CASE("leaves and operations have their values") {
  Fixture f;
  CHECK(f.value("x + x_d + x_dd + u + p + t") == 2 + 3 + 5 + 7 + 11 + 13);
  CHECK(f.value("-x*x_d - x_dd/2") == exact("-17/2"));
  CHECK(f.value("x^3 + x^-1") == exact("17/2"));
  CHECK(f.value("max(x, x_d)*min(x, x_d)") == 6);
  CHECK(agree(f.value("cos(pi)"), -1, 90));
}

TEST_CASE("a name has the value of its definition") {
  Fixture f;
  f.b.definition("twice", "2*x").prescribed("s", "t^2").point("P", {"twice", "s"});
  CHECK(f.value("x(P) + y(P) + z(P)") == 4 + 169);
}

TEST_CASE("rates along the motion: q -> v, v -> a, t -> 1, inputs and parameters -> 0") {
  Fixture f;
  CHECK(f.value("x + 10*x_d + 100*t + u + p", 1) == 3 + 50 + 100);
  CHECK(f.value("x^2", 1) == 12);
  CHECK(f.value("x^2", 2) == 2 * 3 * 3 + 2 * 2 * 5);
  CHECK(f.value("t^3", 2) == 6 * 13);
}

TEST_CASE("time derivatives may be nested and combined with values") {
  Fixture f;
  CHECK(f.value("ddt(x^2)") == 12);
  CHECK(f.value("ddt(ddt(x^2))") == 38);
  CHECK(f.value("x*ddt(x) + ddt(x*ddt(x))") == 6 + 9 + 10);
  CHECK(f.value("x*ddt(x)", 1) == 9 + 10);
}

TEST_CASE("directional derivatives pass through time derivatives") {
  Fixture f;
  const ExpressionId id = f.b.expression("ddt(x^3)");  // 3 x^2 v, d/dx = 6 x v
  displace(f.motion.q, unit_direction(1, 0), generator(0));
  Evaluation at(f.b.model, f.motion);
  CHECK(at.value(id).coefficient(generator(0)) == 36);
}

TEST_CASE("the value and the rate of one expression do not mix") {
  Fixture f;
  f.b.definition("c", "x^2");
  CHECK(f.value("c + ddt(c) + c*ddt(c)") == 4 + 12 + 48);
}

TEST_CASE("a request for a higher derivative evaluates again") {
  Fixture f;
  const ExpressionId id = f.b.expression("x^2");
  Evaluation at(f.b.model, f.motion);
  CHECK(at.value(id).real() == 4);
  CHECK(at.second_rate(id).real() == 38);
  CHECK(at.rate(id).real() == 12);
}

TEST_CASE("only the requested expression is evaluated") {
  Fixture f;
  f.b.expression("1/(x - 2)");
  CHECK(f.value("x + 1") == 3);
  CHECK_THROWS_AS(f.value("1/(x - 2)"), OutsideDomain);
}

TEST_CASE("a chain of thousands of links is evaluated without recursion") {
  const ModelBuilder b = chain(5000);
  Motion motion = make_motion(nominal_state(b.model, {}));
  motion.v.assign(motion.v.size(), Jet(1));
  Evaluation at(b.model, motion);
  CHECK(at.rate(b.model.points.back().position[0]).real() == 5000 * exact("0.3"));
}

TEST_CASE("unknown functions are Taylor polynomials whose coefficients are in the state") {
  const Model model = checked_model(model_text("plane", R"toml([[coordinate]]
name = "x"
[[coordinate]]
name = "y"
[[function]]
name = "V"
of = ["x^2", "y"]
[energy]
T = "1/2*(dot(x)^2 + dot(y)^2)"
V = "V"
)toml"))
                          .model;
  // V = 1, V_1 = 2, V_2 = 3, V_11 = 5, V_12 = 7, V_22 = 11 at x = 1/2, y = 0
  Motion motion{{}, {1, 2, 3, 5, 7, 11}, {cl_R(1) / 2, 0}, {4, 6}, {}, {}, {0, 0}, {}, {}, 0};
  const ExpressionId potential = *model.energies.V;
  CHECK(Evaluation(model, motion).value(potential).real() == 1);
  // d(x^2)/dt = 4, dy/dt = 6; d2(x^2)/dt2 = 32
  CHECK(Evaluation(model, motion).rate(potential).real() == 2 * 4 + 3 * 6);
  CHECK(Evaluation(model, motion).second_rate(potential).real() ==
        2 * 32 + 5 * 16 + 2 * 7 * 24 + 11 * 36);
  displace(motion.q, unit_direction(2, 0), generator(0));
  displace(motion.q, unit_direction(2, 1), generator(1));
  Evaluation at(model, motion);
  CHECK(at.value(potential).coefficient(generator(0) | generator(1)) == 7);
  CHECK_THROWS_AS(at.second_rate(potential), OutsideDomain);
}

TEST_CASE("evaluations at the latest motions are kept, the oldest goes first") {
  Fixture f;
  const ExpressionId id = f.b.expression("x*u");
  RecentEvaluations recent(f.b.model, 2);
  Motion second = f.motion;
  second.q[0] = 4;
  Motion third = f.motion;
  third.u[0] = Jet(generator(0), 1);
  const Evaluation* const first = &recent.at(f.motion);
  CHECK(recent.at(second).value(id).real() == 28);
  CHECK(&recent.at(f.motion) == first);
  CHECK(recent.at(third).value(id).coefficient(generator(0)) == 2);
  CHECK(&recent.at(f.motion) == first);
  CHECK(recent.at(second).value(id).real() == 28);
}
