#include "elgen/choose.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "choose/chosen.hpp"
#include "choose/text_errors.hpp"
#include "elgen/evaluate.hpp"
#include "support/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

Arguments<double> somewhere(const Model& model) {
  double next = 0.3;
  Arguments<double> at = make_leaf_values<double>(
      model, [&next](Opcode, const auto&) { return next += 0.17; }, [](Opcode) { return 0.0; });
  at.t = next;
  return at;
}

ChosenForms with_form(const std::string& text, Form form) {
  ChosenForms result{checked_model(text), {}, {}, {}};
  for (OutputRequest& output : result.checked.scene.outputs) output.form = form;
  const auto lagrangian = formulate(result.checked.model);
  const auto equations = derive(*lagrangian, result.checked.scene.outputs, {});
  const auto recursive = lower(*equations, result.checked.scene.outputs, {});
  result.forms = present(*recursive);
  result.choice =
      *choose(*recursive, result.forms,
              domain_of({result.checked.model, result.checked.scene, recursive->leaves}),
              result.checked.scene);
  return result;
}

/// The errors of the recursive form, as the reference for the chosen form.
FormErrors errors_of(const ChosenForms& c, std::size_t function) {
  const Function& text = c.recursive.functions[function];
  const Domain domain = domain_of({c.checked.model, c.checked.scene, c.recursive.leaves});
  return {c.recursive, text, comparison_points(c.recursive, text, domain)};
}

}  // namespace

TEST_CASE("the preference speed chooses the cheaper form, on a tie the closed form") {
  for (const auto& [name, text] : systems()) {
    INFO(name);
    const ChosenForms c = chosen(text, {}, Preference::speed);
    REQUIRE(c.choice.costs.size() == c.choice.program.functions.size());
    for (std::size_t i = 0; i < c.choice.costs.size(); ++i) {
      const FormCosts& costs = c.choice.costs[i];
      INFO(costs.function);
      const bool is_closed = costs.chosen_form == Form::closed;
      const bool is_cheaper = costs.closed && cost(*costs.closed) <= cost(costs.recursive);
      // The choice ignores the costs of pivot guards; with guards the chosen form may cost more.
      const bool has_pivots = c.choice.program.functions[i].kind == OutputKind::forward_dynamics;
      CHECK((has_pivots || is_closed == is_cheaper));
      CHECK(c.choice.program.functions[i].form == costs.chosen_form);
      const OperationCounts emitted = count_operations(c.choice.program.functions[i]);
      CHECK(emitted == (is_closed ? *costs.closed : costs.recursive));
    }
    CHECK(find_invariant_violation(c.choice.program).empty());
  }
}

TEST_CASE("a chosen form is neither inaccurate nor loses more digits than the tolerated loss") {
  for (const auto& [name, text] : systems()) {
    INFO(name);
    const ChosenForms c = chosen(text);
    for (std::size_t i = 0; i < c.choice.program.functions.size(); ++i) {
      const Function& own = c.choice.program.functions[i];
      const FormErrors errors = errors_of(c, i);
      INFO(own.name);
      CHECK_FALSE(errors.first_inaccurate_entry(c.choice.program, own));
      CHECK(errors.worst_loss(c.choice.program, own) <= tolerated_loss);
    }
  }
}

TEST_CASE("balanced forms cost at most a quarter more, unless the cheaper form is inaccurate") {
  for (const auto& [name, text] : systems()) {
    INFO(name);
    const ChosenForms fast = chosen(text, {}, Preference::speed);
    const ChosenForms c = chosen(text);
    for (std::size_t i = 0; i < c.choice.program.functions.size(); ++i) {
      const Function& own = c.choice.program.functions[i];
      const Function& cheapest = fast.choice.program.functions[i];
      INFO(own.name);
      const std::size_t price = cost(count_operations(own));
      const std::size_t least = cost(count_operations(cheapest));
      if (errors_of(c, i).first_inaccurate_entry(fast.choice.program, cheapest)) continue;
      CHECK(4 * price <= 5 * least + 16);  // 16 is 4 times the cost of a division
    }
  }
}

TEST_CASE("both forms compute the same function") {
  for (const std::string& text : {read_model("cart_pole"), read_model("everything")}) {
    const ChosenForms closed = with_form(text, Form::closed);
    const ChosenForms recursive = with_form(text, Form::recursive);
    const auto at = somewhere(closed.checked.model);
    for (std::size_t i = 0; i < closed.choice.program.functions.size(); ++i) {
      const Function& one = closed.choice.program.functions[i];
      const Function& other = recursive.choice.program.functions[i];
      INFO(one.name);
      CHECK(one.form == Form::closed);
      CHECK(other.form == Form::recursive);
      const auto x = evaluate(closed.choice.program, one, at);
      const auto y = evaluate(recursive.choice.program, other, at);
      REQUIRE(x.size() == y.size());
      // The margin covers about a hundred operations on numbers of order one.
      for (std::size_t k = 0; k < x.size(); ++k)
        CHECK(x[k] == Approx(y[k]).epsilon(1e-12).margin(1e-12));
    }
  }
}

TEST_CASE("sines of angle sums are calls or products, whichever costs less") {
  const ChosenForms c = chosen(model_text("arm", R"toml(
[[coordinate]]
name = "q1"
[[coordinate]]
name = "q2"
[parameters]
m = 1
l = 2
[[point]]
name = "p"
at = ["l*cos(q1) + l*cos(q1 + q2)", "l*sin(q1) + l*sin(q1 + q2)"]
mass = "m"
[gravity]
vector = ["0", "-9.81"]
)toml"));
  std::size_t closed = 0;
  for (const FormCosts& costs : c.choice.costs) {
    if (!costs.closed) continue;
    INFO(costs.function);
    ++closed;
    // At most three calls: for q1, q2 and q2/2. The call for q2 is kept besides the call for q2/2,
    // because sin(q2) and cos(q2) of a call have all digits.
    CHECK(costs.closed->sincos <= 3);
  }
  CHECK(closed > 1);
}

TEST_CASE("the form of an entry does not depend on the other outputs") {
  const ChosenForms all = chosen(read_model("cart_pole"));
  SceneOptions options;
  options.outputs = {make_source("command line", "mass_matrix,gravity")};
  const ChosenForms some = chosen(read_model("cart_pole"), options);
  CHECK(readable(all, "mass_matrix") == readable(some, "mass_matrix"));
  CHECK(readable(all, "gravity") == readable(some, "gravity"));
}

TEST_CASE("an output without a closed form leaves `dynamics` without a closed form") {
  // Each of the ten entries has 330 terms. All ten together exceed the limit of 3000 terms.
  std::string powers;
  for (int k = 1; k <= 10; ++k) {
    powers += (k > 1 ? ", " : "") + ("\"(q + a + b + c + " + std::to_string(k) + "*d)^7\"");
  }
  const std::string text = model_text("lengthy", R"toml(
[[coordinate]]
name = "q"
[parameters]
a = 1
b = 2
c = 3
d = 4
[energy]
T = "1/2*dot(q)^2"
[[output]]
name = "powers"
value = [)toml" + powers + "]\n");
  SceneOptions options;
  options.outputs = {make_source("command line", "mass_matrix,powers,dynamics")};
  const ChosenForms c = chosen(text, options);
  for (const FormCosts& costs : c.choice.costs) {
    INFO(costs.function);
    CHECK((costs.chosen_form == Form::closed) == (costs.function == "mass_matrix"));
  }
  CHECK(find_invariant_violation(c.choice.program).empty());
}

TEST_CASE("the rewriting of nested roots is limited, and the costs say so") {
  const ChosenForms c = chosen(model_text("nested", R"toml(
[[coordinate]]
name = "x"
[parameters]
a = 0.7
b = 0.4
[energy]
T = "1/2*dot(x)^2"
V = "-a*b*tanh(3*x) + 1/2*(((a + x - 0.3)^2 + b^2)^(3/2) - ((a - 0.3)^2 + b^2)^(3/2))"
)toml"));
  for (const FormCosts& costs : c.choice.costs) {
    INFO(costs.function);
    CHECK(costs.limited_entry.has_value() ==
          (costs.function == "potential_energy" || costs.function == "total_energy" ||
           costs.function == "energy_function" || costs.function == "dynamics"));
  }
}
