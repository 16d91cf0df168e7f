// elgen show: the printed pages in each notation, and the costs of generation for each output.
#include <catch2/catch.hpp>
#include <filesystem>
#include <regex>
#include <string>
#include <utility>

#include "cli/cli_testing.hpp"

namespace elgen::test {
namespace {

Outcome show(const std::string& words) {
  const Workspace workspace;
  return workspace.run("elgen show " + words);
}

bool has_program(const std::string& name) {
  const Workspace workspace;
  return workspace.run("command -v " + name).status == 0;
}

std::string costs(const std::string& input) {
  const Workspace workspace;
  const Outcome outcome = workspace.run("elgen show -q --what cost " + models + "/" + input);
  CHECK(outcome.status == 0);
  return outcome.output;
}

}  // namespace

TEST_CASE("show prints non-zero entries in the model language") {
  const Outcome outcome = show(model_path("cart_pole"));
  CHECK(outcome.status == 0);
  CHECK(mentions(outcome.output, "  M(q) a + C(q,v) v + g(q) = B(q) u\n"));
  CHECK(mentions(outcome.output, "\n  mass_matrix[1,2] = m*l*cos(theta)\n"));
  CHECK_FALSE(mentions(outcome.output, "drift"));
}

TEST_CASE("a chain of one mass has no springs between masses") {
  const Workspace workspace;
  workspace.write("springs.toml", R"toml(format = 1
[model]
name = "springs"
[sizes]
n = 3
[[coordinate]]
for = "i in 1..n"
name = "x[i]"
unit = "m"
[parameters]
m = { value = 2, unit = "kg" }
k = { value = 5, unit = "N/m" }
[energy]
T = "sum(i, 1, n, 1/2*m*dot(x[i])^2)"
V = "1/2*k*x[1]^2 + sum(i, 1, n - 1, 1/2*k*(x[i + 1] - x[i])^2)"
)toml");
  const Outcome one = workspace.run("elgen show --size n=1 springs.toml");
  INFO(one.output + one.errors);
  CHECK(one.status == 0);
  CHECK(mentions(one.output, "potential_energy = 1/2*k*x[1]^2"));
  CHECK(workspace.run("elgen generate -q --size n=1 springs.toml").status == 0);
  workspace.prepare("sed 's/n = 3/n = 1/' springs.toml > one.toml");
  CHECK(workspace.run("elgen verify --build written --samples 16 one.toml").status == 0);
}

TEST_CASE("outputs named on the command line are shown, even if zero") {
  const Outcome outcome = show(model_path("cart_pole") + " --what drift");
  CHECK(outcome.status == 0);
  CHECK(mentions(outcome.output, "  drift[1] = 0\n"));
  CHECK_FALSE(mentions(outcome.output, "mass_matrix"));
}

TEST_CASE("the steps of a derivation follow a textbook") {
  const Outcome outcome = show(model_path("simple_pendulum") + " --what steps");
  CHECK(outcome.status == 0);
  for (const char* line :
       {"Positions\n", "  d(bob)/dt = (l*dot(theta)*cos(theta), l*dot(theta)*sin(theta))\n",
        "  T = 1/2*m*l^2*dot(theta)^2\n", "  V = -m*g*l*cos(theta)\n",
        "  dL/d(dot(theta)) = m*l^2*dot(theta)\n",
        "  d/dt dL/d(dot(theta)) = m*l^2*dot(dot(theta))\n", "  dL/dtheta = -m*g*l*sin(theta)\n",
        "L does not contain t, so E is conserved\n",
        "Equations of motion\n  m*l^2*dot(dot(theta)) + m*g*l*sin(theta) = 0\n"
        "  dot(dot(theta)) = -g/l*sin(theta)\n"}) {
    INFO(line);
    CHECK(mentions(outcome.output, line));
  }
}

TEST_CASE("cyclic coordinates are named, with the condition for conservation") {
  const std::string free = show(model_path("spherical_pendulum") + " --what steps").output;
  CHECK(mentions(free, "  L does not contain phi, so p_phi = dL/d(dot(phi)) is conserved\n"));
  const std::string driven = show(model_path("cart_pole") + " --what steps").output;
  CHECK(mentions(driven, "L does not contain x, so p_x = "));
  CHECK(mentions(driven, "conserved if no force and no dissipation act on it"));
  const std::string moving = show(model_path("rotating_hoop") + " --what lagrangian").output;
  CHECK(mentions(moving, "  L = "));
  CHECK_FALSE(mentions(moving, "Equation of"));
}

TEST_CASE("the cost of both forms, and the emitted form") {
  const Outcome outcome = show(model_path("two_link_arm") + " --what cost");
  CHECK(outcome.status == 0);
  CHECK(mentions(outcome.output, "emitted\n"));
  CHECK(mentions(outcome.output, "inverse_dynamics              closed "));
  CHECK(mentions(outcome.output, "inverse_dynamics              recursive "));
}

TEST_CASE("pages in every notation") {
  const std::string latex = show(model_path("cart_pole") + " --as latex").output;
  CHECK(starts_with(latex, "\\documentclass"));
  CHECK(mentions(latex, "M + m & m l \\cos \\theta \\\\\n"));
  const std::string html = show(model_path("cart_pole") + " --as mathml").output;
  CHECK(starts_with(html, "<!DOCTYPE html>\n"));
  CHECK(mentions(html, "<mi>cos</mi>"));
  const std::string markdown = show(model_path("cart_pole") + " --as markdown").output;
  CHECK(mentions(markdown, "\n## Mass matrix\n"));
  const std::string json = show(model_path("cart_pole") + " --as json").output;
  CHECK(mentions(json, "\"entries\": [\"M + m\", \"m*l*cos(theta)\""));
}

TEST_CASE("a page of MathML fits a phone, and a browser aligns its equations at their signs") {
  const std::string html = show(model_path("double_pendulum") + " --what steps --as mathml").output;
  CHECK(mentions(html, "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"));
  if (!has_program("chromium")) return;
  const Workspace workspace;
  const std::string page = replaced(html, "</body>", "<output id=\"state\"></output></body>");
  const std::string shown = state_in_browser(workspace, page, R"js(
    const spreads = [...document.querySelectorAll("mtable.lines")].map((table) => {
      const cells = [...table.children].map((row) => row.children[0].children[0]);
      const ends = cells.filter((cell) => cell.children.length > 0)
        .map((cell) => cell.getBoundingClientRect().right);
      return Math.max(...ends) - Math.min(...ends);
    });
    document.getElementById("state").textContent = [spreads.length > 3, 1 > Math.max(...spreads)];
  )js");
  CHECK(mentions(shown, ">true,true"));
}

TEST_CASE("symmetries are shown in every notation, of models and of scenes") {
  const std::string words = model_path("kepler_polar") + " -q --what symmetries";
  const Outcome text = show(words);
  CHECK(text.status == 0);
  CHECK(mentions(text.output, "\n  phi    dphi = 1   p(phi) = m*r^2*dot(phi)\n"));
  CHECK(mentions(text.output, "\n[[expect]]\n  conserved = [\"p(phi)\", \"E\"]\n"));
  for (const auto& [notation, part] :
       {std::pair{"unicode", "  φ      δφ = 1   "}, std::pair{"latex", "${\\delta} \\varphi = 1$"},
        std::pair{"mathml", "<mi>δ</mi><mi>φ</mi>"},
        std::pair{"markdown", "${\\delta} \\varphi = 1$"},
        std::pair{"json", "\"integral\": \"p(phi)\""}}) {
    INFO(notation);
    const Outcome outcome = show(words + " --as " + notation);
    CHECK(outcome.status == 0);
    CHECK(mentions(outcome.output, part));
  }
  const Outcome mixed = show(model_path("kepler_polar") + " --what symmetries,gravity");
  CHECK(mixed.status == 2);
  CHECK(mentions(mixed.errors, "`symmetries` cannot be combined with other words"));
  const Outcome steady = show(std::string(ELGEN_SOURCE_DIR) +
                              "/models/scenes/kepler_polar_routh.scene.toml -q --what symmetries");
  CHECK(steady.status == 0);
  CHECK(mentions(steady.output, ": symmetries of L with dq = A q + b + c t, dt constant: 1\n"));
}

TEST_CASE("unknown words of show are refused at their position") {
  const Outcome unknown = show(model_path("cart_pole") + " --what mass_matrx");
  CHECK(unknown.status == 2);
  CHECK(mentions(unknown.errors, "error[E601]"));
  CHECK(mentions(unknown.errors, "did you mean `mass_matrix`?"));
  const Outcome mixed = show(model_path("cart_pole") + " --what gravity,steps");
  CHECK(mixed.status == 2);
  CHECK(mentions(mixed.errors, "`steps` cannot be combined with other words"));
  const Outcome cost = show(model_path("cart_pole") + " --what cost --as latex");
  CHECK(cost.status == 2);
  CHECK(mentions(cost.errors, "`cost` is not printed as latex"));
}

TEST_CASE("pdflatex accepts the page of every model, without overfull lines") {
  REQUIRE(has_program("pdflatex"));
  const Workspace workspace;
  for (const std::filesystem::path& path : model_paths()) {
    for (const char* what : {"", " --what steps"}) {
      INFO(path << what);
      const Outcome outcome =
          workspace.run("elgen show -q " + path.string() + what +
                        " --as latex > page.tex && "
                        "pdflatex -interaction=nonstopmode -halt-on-error page.tex");
      CHECK(outcome.status == 0);
      CHECK_FALSE(mentions(outcome.output, "Overfull"));
    }
  }
}

TEST_CASE("robots fit on eight sheets, without hashes as names") {
  REQUIRE(has_program("pdflatex"));
  const Workspace workspace;
  const std::string quadruped = std::string(ELGEN_SOURCE_DIR) + "/tests/urdf/golden/quadruped.toml";
  for (const std::string& robot : {model_path("panda7"), quadruped}) {
    INFO(robot);
    const Outcome outcome = workspace.run("elgen show -q " + robot +
                                          " --as latex > page.tex && "
                                          "pdflatex -interaction=nonstopmode page.tex");
    CHECK(outcome.status == 0);
    CHECK_FALSE(mentions(outcome.output, "Overfull"));
    std::smatch pages;
    REQUIRE(std::regex_search(outcome.output, pages, std::regex("page.pdf \\(([0-9]+) pages")));
    CHECK(std::stoi(pages[1]) <= 8);
    const std::string latex = workspace.read("page.tex");
    CHECK(mentions(latex, "{Named parts}"));
    CHECK_FALSE(mentions(latex, "t_{"));
    const std::string text = show("-q " + robot + " --as text").output;
    CHECK(mentions(text, "\nnamed parts\n"));
    CHECK_FALSE(mentions(text, "\n  t_"));
  }
}

TEST_CASE("numbers give the same equations as fixed parameters") {
  const Workspace workspace;
  workspace.write("named.toml", R"toml(format = 1
[model]
name = "rod_on_cart"
[[coordinate]]
name = "x"
unit = "m"
armature = "J"
[[coordinate]]
name = "th"
unit = "rad"
[parameters]
J = { value = 0.02, unit = "kg" }
M = { value = 2, unit = "kg" }
h = { value = 0.5, unit = "m" }
Iz = { value = "1/30", unit = "kg*m^2" }
g = { value = 9.81, unit = "m/s^2" }
F = { value = 3, unit = "N" }
[[point]]
name = "cart"
at = ["x", 0]
mass = "M"
[[frame]]
name = "arm"
parent = "world"
translate = ["x", "h"]
rotate = [["z", "th"]]
[[body]]
name = "rod"
frame = "arm"
mass = "M"
com = ["h", 0]
inertia = "Iz"
[gravity]
vector = [0, "-g"]
[[force]]
at = "cart"
value = ["F", 0]
)toml");
  workspace.prepare(
      "sed -e '/parameters/,/^F/d' -e 's/\"J\"/0.02/; s/\"M\"/2/; s/\"h\"/0.5/; s/\"F\"/3/' "
      "-e 's/\"Iz\"/\"1\\/30\"/; s/\"-g\"/-9.81/' named.toml > plain.toml; "
      "sed '/^unit/d' plain.toml > free.toml");
  const auto equations = [&](const std::string& words) {
    const Outcome outcome = workspace.run("elgen show -q " + words);
    CHECK(outcome.status == 0);
    CHECK(outcome.errors.empty());
    const std::size_t first = outcome.output.find("mass_matrix");
    REQUIRE(first != std::string::npos);
    return outcome.output.substr(first);
  };
  const std::string named = equations("named.toml --fix all");
  CHECK(equations("plain.toml") == named);
  CHECK(equations("free.toml") == named);
  CHECK(mentions(workspace.run("elgen show plain.toml").errors, "note[E405]"));
}

TEST_CASE("outputs of a model have a cost and a time") {
  const std::string text = costs("simple_pendulum.toml");
  CHECK(mentions(text, "\noutput "));
  CHECK(mentions(text, "cost         alone\n"));
  CHECK(mentions(text, "\ngenerated in "));
  CHECK_FALSE(mentions(text, "full model"));
}

TEST_CASE("a scene is compared with its full model") {
  const std::string text = costs("scenes/two_link_arm_elbow.scene.toml");
  CHECK(mentions(text, "cost  full model   share"));
  // M of the scene has 1 entry and costs 3; M of the full model has 4 entries and costs 39.
  CHECK(mentions(text, "\nmass_matrix              3  "));
  CHECK(mentions(text, "reaction                41           -"));
  CHECK(mentions(text, "ms, the full model in "));
}

TEST_CASE("a scene is compared with the full model of the same size") {
  const Workspace workspace;
  const std::string scene = "format = 1\nmodel = \"" + models + "/chain.toml\"\nname = \"long\"\n";
  workspace.write("long.scene.toml", scene + "[sizes]\nn = 4\n");
  workspace.write("same.scene.toml", scene);
  for (const std::string& command :
       {std::string("long.scene.toml"), std::string("same.scene.toml --size n=4"),
        std::string("long.scene.toml --size n=3")}) {
    INFO(command);
    const Outcome outcome = workspace.run("elgen show -q --what cost " + command);
    CHECK(outcome.status == 0);
    // Nothing is fixed or locked, so every output costs as much as in the full model.
    CHECK(mentions(outcome.output, "   100 %"));
    const std::size_t row = outcome.output.find("\nmass_matrix ", outcome.output.find("\noutput "));
    REQUIRE(row != std::string::npos);
    CHECK(mentions(outcome.output.substr(row, 70), " 100 %"));
  }
}

TEST_CASE("the page names the limit that ended the search, by default from the seconds") {
  const auto ending = [](const std::string& limits) {
    const std::string text =
        show(limits + " --what equilibria " + model_path("body_on_springs")).output;
    const std::size_t at = text.find("; the limit ");
    return at == std::string::npos ? text : text.substr(at, text.find(':', at) - at);
  };
  // Without a sanitizer 28e6 enclosures take at most a second, so the limit of 60 s ends no search.
  CHECK(ending("--limit seconds=60 --limit enclosures=1000000") ==
        "; the limit enclosures=1000000 ended the search");
  CHECK(ending("--limit enclosures=1000000 --limit seconds=60") ==
        "; the limit enclosures=1000000 ended the search");
#ifndef ELGEN_HARDENED
  CHECK(ending("--limit seconds=3") == "; the limit enclosures=21000000 ended the search");
#endif
}

}  // namespace elgen::test
