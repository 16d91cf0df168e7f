// The equation of motion with its variables, and headings of outputs.
#include <catch2/catch.hpp>

#include "choose/chosen.hpp"
#include "emit/fixture.hpp"
#include "model/symbols.hpp"
#include "print/sections.hpp"
#include "print/small_page.hpp"
#include "support/models.hpp"
#include "support/systems.hpp"

namespace elgen::test {

namespace {

std::string equation(const Subject& subject) {
  return text_of(equation_of_motion(subject.model, subject.program));
}

using Lines = std::vector<std::string>;

Lines lines_of(const std::string& text, const SceneOptions& options = {}) {
  const ChosenForms c = chosen(text, options);
  return variable_lines(c.checked.model, c.choice.program);
}

}  // namespace

TEST_CASE("terms that are zero or impossible in a model are omitted") {
  const ChosenForms c = chosen(read_model("cart_pole"));
  const Formula equation = equation_of_motion(c.checked.model, c.choice.program);
  CHECK(text_of(equation) == "M(q) a + C(q,v) v + g(q) = B(q) u");
  CHECK(latex_of(equation) ==
        "M(\\mathbf{q}) \\ddot{\\mathbf{q}} + C(\\mathbf{q},\\dot{\\mathbf{q}}) "
        "\\dot{\\mathbf{q}} + "
        "\\mathbf{g}(\\mathbf{q}) = B(\\mathbf{q}) \\mathbf{u}");
}

TEST_CASE("without functions of motion the equation at rest is printed") {
  ChosenForms c = chosen(read_model("cart_pole"));
  auto& functions = c.choice.program.functions;
  const auto moves = [](const Function& f) { return f.kind != OutputKind::gravity; };
  functions.erase(std::remove_if(functions.begin(), functions.end(), moves), functions.end());
  const auto at_rest = [&c] {
    return text_of(equation_of_motion(c.checked.model, c.choice.program));
  };
  CHECK(at_rest() == "g(q) = B(q) u");
  c.checked.model.may_drift = true;
  CHECK(at_rest() == "drift(q,0) + g(q) = B(q) u");
}

TEST_CASE("with rotations the rates are v") {
  const ChosenForms c = chosen(read_model("tumbler"));
  CHECK(latex_of(equation_of_motion(c.checked.model, c.choice.program)) ==
        "M(\\mathbf{q}) \\mathbf{a} + C(\\mathbf{q},\\mathbf{v}) \\mathbf{v} = B(\\mathbf{q}) "
        "\\mathbf{u}");
}

TEST_CASE("a term without information is kept") {
  Subject subject = cart_pole();
  CHECK(equation(subject) == "M(q) a + C(q,v) v + g(q) = B(q) u");
  subject.model.may_drift = true;
  CHECK(equation(subject) == "M(q) a + C(q,v) v + drift(q,v) + g(q) = B(q) u");
}

TEST_CASE("a term that is zero in the program is omitted, and a side without terms is 0") {
  Subject subject = cart_pole();
  subject.program = read_program(
      "coordinates x theta\nfunction gravity\n  0 = constant 0\n  result 2 1 = 0 0\n"
      "function drift\n  0 = constant 0\n  result 2 1 = 0 0\n");
  subject.model.inputs.clear();
  subject.model.may_drift = true;
  CHECK(equation(subject) == "M(q) a + C(q,v) v = 0");
}

TEST_CASE("dissipation, other forces and time have their terms") {
  Subject subject = cart_pole();
  subject.model.energies.D = 0;
  subject.model.forces.emplace_back();
  subject.model.uses_time = subject.model.may_drift = true;
  CHECK(equation(subject) ==
        "M(q,t) a + C(q,v,t) v + drift(q,v,t) + g(q,t) + dD/dv = B(q,t) u + Q(q,v,t)");
}

TEST_CASE("an L that is not quadratic in the rates has a bias only") {
  Subject subject = cart_pole();
  subject.model.is_quadratic = false;
  CHECK(equation(subject) == "M(q,v) a + bias(q,v) = B(q) u");
}

TEST_CASE("multipliers are on the right side, after the inputs") {
  const ChosenForms rod = chosen(read_model("rod"));
  const Formula equation = equation_of_motion(rod.checked.model, rod.choice.program);
  CHECK(text_of(equation) == "M(q) a + g(q) = A(q)^T lambda");
  CHECK(mentions(latex_of(equation), "= A(\\mathbf{q})^{\\top} \\boldsymbol{\\lambda}"));
  const ChosenForms disc = chosen(read_model("disc"));
  CHECK(text_of(equation_of_motion(disc.checked.model, disc.choice.program)) ==
        "M(q) a = B(q) u + A(q)^T lambda");
  CHECK(lines_of(read_model("disc")) == Lines{"q = (x, y, phi, psi)", "v = dq/dt, a = dv/dt",
                                              "u = (tau)",
                                              "lambda = (lambda_roll_1, lambda_roll_2)",
                                              "A a = -gamma, (f, r) = constraint_residual"});
}

TEST_CASE("time-independent constraints conserve E, and momenta that none of them changes") {
  const auto conserved = [](const std::string& text) {
    const ChosenForms c = chosen(text);
    Lines names;
    for (const auto& each : conserved_quantities(c.checked.model, c.choice.program)) {
      names.push_back(each.name);
    }
    return names;
  };
  const std::string rod = read_model("rod");
  CHECK(conserved(rod) == Lines{"E"});
  const auto with_equation = [&rod](const std::string& equation) {
    return replaced(rod, "(x^2 + y^2)/2 = l^2/2", equation);
  };
  CHECK(conserved(with_equation("y = l")) == Lines{"E", "p(x)"});
  CHECK(conserved(with_equation("y = omega*l*t")) == Lines{"p(x)"});
  const std::string disc = read_model("disc");
  const std::string input = "[[input]]\nname = \"tau\"\non = \"phi\"\n";
  CHECK(conserved(std::string(disc).erase(disc.find(input), input.size())) == Lines{"p(psi)"});
}

TEST_CASE("variable lines show coordinates, velocities as rates, and inputs") {
  CHECK(lines_of(read_model("cart_pole")) ==
        Lines{"q = (x, theta)", "v = dq/dt, a = dv/dt", "u = (u)"});
}

TEST_CASE("a long list of names is abbreviated to the first two and the last") {
  const ChosenForms c = chosen(read_model("cart_pole"));
  Model model = c.checked.model;
  for (int i = 0; i < 20; ++i) model.coordinates.push_back(model.coordinates[1]);
  CHECK(variable_lines(model, c.choice.program).front() == "q = (x, theta, ..., theta)");
}

TEST_CASE("without functions of motion the variables say `at rest`") {
  SceneOptions options;
  options.outputs = {make_source("command line", "gravity")};
  CHECK(lines_of(read_model("cart_pole"), options).at(1) == "at rest");
}

TEST_CASE("velocities that are not rates have names") {
  const Lines lines = lines_of(read_model("tumbler"));
  REQUIRE(lines.size() >= 3);
  CHECK(lines[1].rfind("v = (", 0) == 0);
  CHECK(lines[2] == "dq/dt = N(q) v: coordinate_rates");
}

TEST_CASE("every output of the table has a symbol and a sentence") {
  const ChosenForms c = chosen(read_model("everything"));
  for (const Function& function : c.choice.program.functions) {
    INFO(function.name);
    CHECK_FALSE(latex_of(elgen::heading(c.checked.model, function).symbol).empty());
    CHECK(output_doc(c.checked.model, function).back() == '.');
  }
}

TEST_CASE("a model without a title uses its name as title") {
  Model model;
  model.name = "double_pendulum";
  CHECK(page_title(model) == "Double pendulum");
  model.title = "two rods";
  CHECK(page_title(model) == "two rods");
}

TEST_CASE("with rotations definitions use v, a and N instead of rates") {
  const auto definition_of = [](const std::string& text, OutputKind kind) {
    const ChosenForms c = chosen(text);
    for (const Function& function : c.choice.program.functions) {
      if (function.kind != kind) continue;
      return latex_of(elgen::heading(c.checked.model, function).definition);
    }
    FAIL("no such output");
    return std::string();
  };
  const std::string plain = read_model("everything");
  CHECK(definition_of(plain, OutputKind::gravity) ==
        "\\mathbf{g} = \\frac{\\partial V_{0}}{\\partial \\mathbf{q}}");
  CHECK(definition_of(plain, OutputKind::inverse_dynamics) ==
        "\\boldsymbol{\\tau} = M \\ddot{\\mathbf{q}} + \\mathbf{bias}");
  const std::string body = read_model("tumbler");
  CHECK(definition_of(body, OutputKind::gravity) ==
        "\\mathbf{g} = N^{\\top} \\frac{\\partial V_{0}}{\\partial \\mathbf{q}}");
  CHECK(definition_of(body, OutputKind::inverse_dynamics) ==
        "\\boldsymbol{\\tau} = M \\mathbf{a} + \\mathbf{bias}");
  CHECK(mentions(definition_of(body, OutputKind::coriolis_matrix),
                 "[\\boldsymbol{\\omega}]_{\\times}"));
}

}  // namespace elgen::test
