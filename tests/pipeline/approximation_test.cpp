// The equations of a scene that expands about an equilibrium are the Taylor polynomials of the
// exact equations.
#include <catch2/catch.hpp>

#include "derive/formulate/written_out.hpp"
#include "elgen/equations_of_motion.hpp"
#include "elgen/evaluate.hpp"
#include "elgen/specialise.hpp"
#include "pipeline/pipeline_testing.hpp"
#include "support/models.hpp"

namespace elgen::test {
namespace {

using cln::cl_R;
using cln::cl_RA;

/// The products of models/`model`.toml for `output`, in the scene `lines` unless `lines` is empty.
Products near_products(const std::string& model, const std::string& output,
                       const std::string& lines) {
  return derived(inputs_of(model_file(model), lines), output, {Goal::self_check});
}

Arguments<Real> arguments(const Products& products, const std::vector<cl_R>& q,
                          const std::vector<cl_R>& v, const std::vector<cl_R>& a) {
  Arguments<Real> state;
  for (const Parameter& parameter : products.checked->model.parameters) {
    state.parameters.emplace_back(parameter.value);
  }
  state.q = {q.begin(), q.end()};
  state.v = {v.begin(), v.end()};
  state.a = {a.begin(), a.end()};
  state.u.assign(products.checked->model.inputs.size(), Real(0));
  return state;
}

std::vector<Real> values(const Products& products, const Arguments<Real>& at) {
  return evaluate(*products.program, products.program->functions.front(), at);
}

/// Derives the rows M a + bias of a model, and substitutes all definitions.
struct WrittenOut {
  explicit WrittenOut(const CheckedModel& checked)
      : lagrangian(*specialise(*formulate(checked.model), checked)) {
    OutputRequest request;
    request.kind = OutputKind::inverse_dynamics;
    request.name = "inverse_dynamics";
    request.rows = static_cast<std::uint32_t>(checked.model.velocities.size());
    const auto equations = derive(lagrangian, {request}, {});
    for (const GiNaC::ex& entry : equations->outputs.front().fields.front().entries) {
      rows.push_back(written_out(equations->definitions, entry));
    }
  }
  Lagrangian lagrangian;
  std::vector<GiNaC::ex> rows;
};

/// The Taylor polynomial of `row` at q = v = a = 0, of total degree `order` in q, v and a.
GiNaC::ex truncated(const GiNaC::ex& row, const Symbols& symbols, int order) {
  const GiNaC::symbol s("s");
  GiNaC::exmap scaled;
  for (const auto* list : {&symbols.q, &symbols.v, &symbols.a}) {
    for (const GiNaC::ex& leaf : *list) scaled[leaf] = s * leaf;
  }
  const GiNaC::ex along = row.subs(scaled, GiNaC::subs_options::no_pattern);
  return GiNaC::series_to_poly(along.series(s == 0, order + 1)).subs(s == 1);
}

/// Maps each symbol of `from` to the symbol for the same leaf in `to`.
GiNaC::exmap renaming(const Symbols& from, const Symbols& to) {
  GiNaC::exmap map{{from.t, to.t}};
  const auto add = [&](const std::vector<GiNaC::ex>& x, const std::vector<GiNaC::ex>& y) {
    for (std::size_t i = 0; i < x.size(); ++i) map[x[i]] = y[i];
  };
  add(from.parameters, to.parameters);
  add(from.q, to.q);
  add(from.v, to.v);
  add(from.a, to.a);
  return map;
}

void check_truncation(const std::string& model, const std::string& about, int order) {
  const std::string text = model_file(model);
  const WrittenOut exact(checked_model(text));
  const WrittenOut expanded(
      approximated(text, "order = " + std::to_string(order) + "\nabout = { " + about + " = 0 }"));
  const GiNaC::exmap names = renaming(expanded.lagrangian.symbols, exact.lagrangian.symbols);
  for (std::size_t i = 0; i < exact.rows.size(); ++i) {
    const GiNaC::ex expected = truncated(exact.rows[i], exact.lagrangian.symbols, order);
    const GiNaC::ex derived = expanded.rows[i].subs(names, GiNaC::subs_options::no_pattern);
    GiNaC::ex difference = (derived - expected).expand();
    // sin^2 and cos^2 of the time remain, so sin^2 = 1 - cos^2 is applied.
    const GiNaC::ex wildcard = GiNaC::wild();
    difference = difference.subs(pow(sin(wildcard), 2) == 1 - pow(cos(wildcard), 2)).expand();
    INFO(model << " row " << i << ": " << difference);
    CHECK(difference.is_zero());
  }
}

/// A force that depends on the angle of the pole; the cart may be anywhere.
const std::string pushed_cart = R"toml(format = 1
[model]
name = "model"
[[coordinate]]
name = "x"
[[coordinate]]
name = "th"
[energy]
T = "dot(x)^2 + dot(x)*dot(th)*cos(th) + dot(th)^2"
V = "cos(th)"
[[input]]
name = "u"
[[force]]
on = "x"
value = "sin(th)*u"
)toml";

cl_R size(const Real& x) { return cln::abs(x.value()); }

}  // namespace

TEST_CASE("the expansion near the bottom is the truncated equation, term by term") {
  check_truncation("simple_pendulum", "theta", 3);
  check_truncation("rotating_hoop", "theta", 3);
  check_truncation("rotating_hoop", "theta", 5);
  check_truncation("cart_pole", "x = 0, theta", 2);
}

TEST_CASE("the first-order expansion about the upright equals the linearization") {
  const std::string lines = "[approximate]\norder = 1\nabout = { x = 0, theta = 0 }\n";
  const Products exact = near_products("cart_pole", "linearization", "");
  const Products linear = near_products("cart_pole", "linearization", lines);
  const cl_R third = cl_RA(1) / 3;
  const auto there = values(exact, arguments(exact, {0, 0}, {0, 0}, {0, 0}));
  const auto anywhere =
      values(linear, arguments(linear, {third, 2 * third}, {third, -third}, {0, 0}));
  REQUIRE(there.size() == anywhere.size());
  for (std::size_t i = 0; i < there.size(); ++i) {
    CHECK(cln::abs(there[i].value() - anywhere[i].value()) < cln::expt(cl_R(10), -50));
  }
  // M = 1, m = 1/10, l = 1/2, g = 9.81: dx'' = -m g/M theta, dtheta'' = (M + m) g/(M l) theta.
  const cl_R g = cl_RA(981) / 100;
  CHECK(cln::abs(anywhere[2 * 4 + 1].value() + g / 10) < cln::expt(cl_R(10), -50));
  CHECK(cln::abs(anywhere[3 * 4 + 1].value() - g * 11 / 5) < cln::expt(cl_R(10), -50));
}

TEST_CASE("with one small coordinate the error has the promised order") {
  const std::string lines =
      "[parameters]\nfixed = { g = 0 }\n"
      "[approximate]\norder = 2\nabout = { q2 = 0 }\nsmall = [\"q2\"]\n";
  const Products exact =
      near_products("two_link_arm", "inverse_dynamics", "[parameters]\nfixed = { g = 0 }\n");
  const Products expanded = near_products("two_link_arm", "inverse_dynamics", lines);
  const auto errors = [&](const cl_R& s) {
    const auto at = arguments(exact, {cl_RA(7) / 10, s / 2}, {cl_RA(3) / 2, s}, {2, -s * 3});
    const auto left = values(exact, at);
    const auto right = values(expanded, at);
    return std::vector<cl_R>{size(left[0] - right[0]), size(left[1] - right[1])};
  };
  const auto coarse = errors(cl_RA(1) / 100'000);
  const auto fine = errors(cl_RA(1) / 1'000'000);
  CHECK(coarse[1] / fine[1] > 999);
  CHECK(coarse[1] / fine[1] < 1001);
  CHECK(coarse[0] / fine[0] > 9990);
}

TEST_CASE("the force on a coordinate that is not small keeps one more order in all texts") {
  const Workspace workspace;
  workspace.write("model.toml", pushed_cart);
  workspace.write("near.scene.toml",
                  "format = 1\nmodel = \"model.toml\"\nname = \"near\"\n"
                  "[outputs]\ninput_matrix = true\nbias = true\nforward_dynamics = true\n"
                  "[approximate]\norder = 2\nabout = { th = 0 }\n");
  const Outcome shown = workspace.run("elgen show near.scene.toml");
  INFO(shown.output + shown.errors);
  CHECK(mentions(shown.output, "input_matrix[1] = th*(1 - 1/6*th^2)"));
  CHECK(failure_of(workspace.run("elgen generate -q -o out near.scene.toml")) == "");
  CHECK(failure_of(workspace.run("elgen verify --build written --samples 16 near.scene.toml")) ==
        "");
}

}  // namespace elgen::test
