// Stages that need the results of several stages: steps and their costs, pages that show the forms
// of code, and derivations as text.
#include "pipeline/combined_stages.hpp"

#include <algorithm>
#include <stdexcept>

#include "pipeline/pipeline_testing.hpp"

namespace elgen::test {

namespace {

Products cart_with(const std::string& outputs) {
  return run_pipeline(inputs_of(model_file("cart_pole"), "[outputs]\n" + outputs), {});
}

}  // namespace

TEST_CASE("a step is the last function, with a cost and without closed forms") {
  const Products products =
      cart_with("step = { method = \"rk4\" }\nmass_matrix = true\ndynamics = true\n");
  INFO(format(products.diagnostics));
  REQUIRE(products.self_check);
  const Program& program = *products.program;
  REQUIRE(program.functions.size() == 3);
  CHECK(program.functions.back().kind == OutputKind::step);
  CHECK(program.readable.size() == 3);
  CHECK(program.readable.back().fields.empty());
  REQUIRE(products.costs.size() == 3);
  CHECK(products.costs.back().function == "step");
  CHECK(products.costs.back().recursive == count_operations(program.functions.back()));
}

TEST_CASE("a step alone needs no other output") {
  const Products products = cart_with("step = { method = \"rk4\" }\n");
  INFO(format(products.diagnostics));
  CHECK(products.self_check);
  CHECK(products.program->functions.size() == 1);
}

TEST_CASE("a method that does not apply stops the pipeline before it emits anything") {
  const Products products = cart_with("step = { method = \"verlet\" }\n");
  CHECK_FALSE(products.files);
  REQUIRE_FALSE(products.diagnostics.empty());
  CHECK(products.diagnostics.front().code == Code::E622);
}

TEST_CASE("if a page fails, code is emitted, and a note says that the page has the forms of code") {
  const Products products = derived(inputs_of(model_file("cart_pole")), "gravity");
  const Result<PagePrograms> book = make_page_or_code(
      *products.program, []() -> PagePrograms { throw std::logic_error("a wheel came off"); });
  REQUIRE(book);
  CHECK(book->program.functions.size() == 1);
  CHECK_FALSE(book->program.readable.empty());
  CHECK_FALSE(book->steps);
  CHECK(format(book.diagnostics) ==
        "elgen: note[E915]: the page shows the forms of code: a wheel came off\n");
}

TEST_CASE("a page has no derivation if all rows are too long to read") {
  const auto has_derivation = [](int links, const std::string& output) {
    const Products products =
        products_with(&Products::page_programs, inputs_of(model_file("chain")),
                      {.scene = {.outputs = {make_source("--outputs", output)},
                                 .sizes = {make_source("--size", "n=" + std::to_string(links))}},
                       .goals = {Goal::typeset}});
    return products.page_programs->steps.has_value();
  };
  for (const std::string output : {"forward_dynamics", "gravity"}) {
    INFO(output);
    CHECK(has_derivation(3, output));
    CHECK_FALSE(has_derivation(40, output));
  }
}

TEST_CASE("dL/dq and d/dt dL/dv are separate steps") {
  const Products products = products_with(
      &Products::steps, inputs_of(model_file("simple_pendulum")), {.goals = {Goal::steps}});
  const Program& program = products.steps->program;
  const auto is_theta = [](const Function& function) { return function.name == "theta"; };
  const auto theta = std::find_if(program.functions.begin(), program.functions.end(), is_theta);
  REQUIRE(theta != program.functions.end());
  std::vector<std::vector<std::string>> steps;
  for (const Formulas& entries :
       equations(program, static_cast<std::size_t>(theta - program.functions.begin())).entries) {
    steps.push_back(texts_of(entries));
  }
  const std::vector<std::vector<std::string>> expected{
      {"m*l^2*dot(theta)"},
      {"m*l^2*dot(dot(theta))"},
      {"-m*g*l*sin(theta)"},
      {"0"},
      {"0"},
      {"m*l^2*dot(dot(theta)) + m*g*l*sin(theta)"}};
  CHECK(steps == expected);
  CHECK(products.steps->masses == std::vector<std::string>{"bob"});
}

namespace {

/// The text of a model's derivation.
std::string steps_of(const std::string& text) {
  const Products products =
      products_with(&Products::steps, inputs_of(text), {.goals = {Goal::steps}});
  return text_of(derivation_sections(products.checked->model, *products.steps));
}

}  // namespace

TEST_CASE("a derivation lists masses on frames and other masses") {
  const std::string governor = R"toml(format = 1
[model]
name = "governor"
[[coordinate]]
name = "alpha"
unit = "rad"
range = [0.1, 1.4]
[parameters]
m = { value = 1, unit = "kg" }
M = { value = 2, unit = "kg" }
l = { value = 0.3, unit = "m" }
Omega = { value = 12, unit = "rad/s" }
[[frame]]
name = "spindle"
parent = "world"
rotate = [["z", "Omega*t"]]
[[point]]
name = "left"
frame = "spindle"
at = ["l*sin(alpha)", "0", "-l*cos(alpha)"]
mass = "m"
[[body]]
name = "right"
frame = "spindle"
com = ["-l", "0", "0"]
mass = "m"
[[body]]
name = "spindle"
frame = "spindle"
mass = 0
inertia = ["0", "0", "M*l^2"]
[[point]]
name = "sleeve"
at = ["0", "0", "-2*l*cos(alpha)"]
mass = "M"
)toml";
  const std::string text = steps_of(governor);
  INFO(text);
  CHECK(mentions(text, "\n  r_left = ("));
  CHECK(mentions(text, "\n  r_right = ("));
  CHECK(mentions(text, "\n  T_spindle = "));
  CHECK_FALSE(mentions(text, "r_spindle"));
  CHECK(
      mentions(text, "\n  Positions of the masses as functions of the coordinates.\n  sleeve = "));
  CHECK_FALSE(mentions(text, "Positions are omitted"));
}

TEST_CASE("a derivation says why it has no positions") {
  const auto steps = [](const std::string& model, const std::string& scene) {
    const Products products = products_with(&Products::steps, inputs_of(model_file(model), scene),
                                            {.goals = {Goal::steps}});
    return text_of(derivation_sections(products.checked->model, *products.steps));
  };
  CHECK(mentions(steps("cart_pole", "[approximate]\norder = 1\nabout = { x = 0, theta = 0 }\n"),
                 " L = T - V. Positions are omitted, because the energies are expanded.\n"));
  CHECK(mentions(steps("kepler_polar", "[routh]\nphi = \"0.6\"\n"),
                 " Positions are omitted, because Routh's function replaces T and V.\n"));
}

TEST_CASE("a derivation names the rows that are too long for its equations of motion") {
  const std::string text = steps_of(model_file("body_on_springs"));
  CHECK(mentions(text, "\n  Omitted rows, too long to read in one piece: roll, pitch. "));
  CHECK_FALSE(mentions(text, "Positions are omitted"));
  CHECK_FALSE(mentions(text, " + 0 = 0"));
}

// Meriam, Kraige, Dynamics: a uniform ladder that slides along a smooth wall and a smooth floor.
TEST_CASE("steps of a constrained model end with accelerations and multipliers") {
  const std::string text = steps_of(read_model("ladder"));
  INFO(text);
  const std::size_t rows = text.find("\nEquations of motion\n");
  REQUIRE(rows != std::string::npos);
  const std::string end = text.substr(rows);
  CHECK(mentions(end, "\n  dot(dot(theta)) = 3/2*g/L*sin(theta)\n"));
  CHECK(mentions(end,
                 "\n  lambda_floor = -1/2*m*L*dot(theta)^2*cos(theta) + 1/4*m*g*(4 - "
                 "3*sin(theta)^2)\n"));
  CHECK(mentions(end,
                 "\n  lambda_wall = -1/2*m*L*dot(theta)^2*sin(theta) + "
                 "3/4*m*g*sin(theta)*cos(theta)\n"));
  CHECK_FALSE(mentions(end, "Too long"));
}

TEST_CASE("steps of three coupled coordinates end with their accelerations, D stands as typed") {
  const std::string text = steps_of(read_model("crane"));
  INFO(text);
  CHECK(mentions(text, "\n  D = 1/2*b*dot(x)^2\n"));
  CHECK(mentions(text, "\n  dE/dt = v^T (Q - dD/dv)\n"));
  CHECK(mentions(text, "\n  dot(dot(x)) = -b/M*dot(x) + F/M - S*sin(theta)/M\n"));
  CHECK(mentions(text, "\n  dot(dot(l)) = "));
  CHECK(mentions(text, "\n  dot(dot(theta)) = "));
}

TEST_CASE("steps name the accelerations that are too long, and the command that prints them") {
  const std::string text = steps_of(model_file("chain"));
  INFO(text);
  CHECK(mentions(text, "Too long for this page: acceleration of q[1], acceleration of q[2], "));
  CHECK(mentions(text, " elgen show --what forward_dynamics prints them.\n"));
  CHECK_FALSE(mentions(text, "--what steps"));
}

TEST_CASE("a short side of a long row keeps its book form") {
  const std::string text = steps_of(model_file("body_on_springs"));
  CHECK(mentions(text, "\n  dL/d(dot(x)) = m*dot(x)\n"));
  CHECK_FALSE(mentions(text, " - 0 = "));
}

}  // namespace elgen::test
