// Pages and sentences: their content, and the escaping of markup in each language.
#include <catch2/catch.hpp>
#include <limits>

#include "choose/chosen.hpp"
#include "elgen/page.hpp"
#include "print/small_page.hpp"
#include "support/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

std::vector<std::string> notes(const std::string& scene) {
  const CheckedModel checked = checked_scene(read_model("cart_pole"), scene);
  return scene_notes(checked.model, checked.scene);
}

}  // namespace

TEST_CASE("text is escaped in every language, and vectors are columns") {
  struct PageRow {
    std::string (*page)(const Page& page);
    std::string part;
  };
  const PageRow row = GENERATE(values<PageRow>({
      {html_page, "<title>A &amp; B_1</title>"},
      {html_page, "100 % of x &lt; y"},
      {html_page, "<mtr><mtd><mrow><mn>0</mn></mrow></mtd></mtr>"},
      {latex_document, "A \\& B\\_1"},
      {latex_document, "100 \\% of x \\textless{} y"},
      {latex_document,
       "$m_{1}$ & \\texttt{m1} & 0.5 & $\\mathrm{kg}$ & mass \\textbar{} of *one* \\\\\n"},
      {latex_document, "\\end{document}\n"},
      {markdown_page, "# A \\& B\\_1\n"},
      {markdown_page, "100 % of x \\< y\n"},
      {markdown_page, "| $m_{1}$ | `m1` | 0.5 | kg | mass \\| of \\*one\\* |"},
      {markdown_page, "$$\ng = \\begin{pmatrix}\n0 \\\\\nm_{1} g\n\\end{pmatrix}\n$$"},
  }));
  INFO(row.part);
  CHECK(mentions(row.page(small_page()), row.part));
}

TEST_CASE("empty sections are omitted") {
  const std::string page = markdown_page(small_page());
  CHECK(mentions(page, "\n## Gravity\n"));
  CHECK(mentions(page, "M \\ddot{q} = 0"));
  Page without = small_page();
  without.parameters.clear();
  CHECK_FALSE(mentions(markdown_page(without), "| "));
}

TEST_CASE("text with line breaks, dollars and back-ticks stays in its table row") {
  Page page = small_page();
  page.parameters.front().doc = "one\ntwo for $5 and `six`";
  CHECK(mentions(markdown_page(page), "| kg | one two for \\$5 and \\`six\\` |\n"));
}

TEST_CASE("units, titles with formulas, and lines mixing prose and formulas are printed") {
  Page mixed = small_page();
  mixed.parameters.front().unit = "kg*m^2/s^(1/2)";
  const PageSection equation{
      .title = row_of({prose("Equation of"), latex_formula("\\theta_1")}),
      .lines = {row_of({latex_formula("L"), prose("lacks"), latex_formula("x_1")})}};
  const PageSection of_user{.title = prose("tip"), .function = "tip"};
  mixed.sections = {equation, of_user};
  mixed.title = row_of({prose("A & B at"), latex_formula("x = 1")});
  struct PageParts {
    std::string (*page)(const Page& page);
    std::vector<std::string> parts;
  };
  const std::vector<PageParts> rows{
      {markdown_page,
       {"# A \\& B at $x = 1$\n", "| kg m²/s^(1/2) |", "\n## Equation of $\\theta_{1}$\n",
        "\n$L$ lacks $x_{1}$\n", "\n## `tip`\n"}},
      {latex_document,
       {"A \\& B at $x = 1$}", "& $\\mathrm{kg\\,m^{2}/s^{1/2}}$ &",
        "\\subsection*{Equation of $\\theta_{1}$}", "\n$L$ lacks $x_{1}$\n",
        "\\subsection*{\\normalfont\\texttt{tip}}"}},
      {html_page,
       {"<title>A &amp; B at x = 1</title>", "<td>kg m<sup>2</sup>/s<sup>1/2</sup></td>",
        "<h2>Equation of <math>", "</math> lacks <math>", "<h2><code>tip</code></h2>"}}};
  for (const PageParts& row : rows) {
    const std::string page = row.page(mixed);
    INFO(page);
    for (const std::string& part : row.parts) CHECK(mentions(page, part));
  }
}

TEST_CASE("aligned equations and lines that are equations form one block in every language") {
  Page page = small_page();
  PageSection section{.title = prose("Action"), .is_aligned = true};
  section.equations.push_back({latex_formula("T"), 1, 1, {latex_formula("b")}});
  section.lines = {latex_formula("S = \\int L dt"),
                   row_of({latex_formula("L"), prose("lacks"), latex_formula("t")})};
  page.sections = {section};
  const std::string aligned = "S &= \\int L dt \\\\\nT &= b\n\\end{aligned}\n";
  CHECK(mentions(markdown_page(page), "$$\n\\begin{aligned}\n" + aligned + "$$"));
  CHECK(mentions(latex_document(page), "\\[\n\\begin{aligned}\n" + aligned + "\\]"));
  const std::string html = html_page(page);
  CHECK(mentions(
      html, "<mtable class=\"lines\" displaystyle=\"true\">\n<mtr><mtd><mrow><mrow><mi>S</mi>"));
  CHECK(mentions(html, "<mi>T</mi></mrow><mo>=</mo></mrow></mtd><mtd><mrow><mrow><mi>b</mi>"));
}

TEST_CASE("blocks of many lines break across pages") {
  Page page = small_page();
  PageSection section{.title = prose("Many"), .is_aligned = true};
  for (int i = 0; i < 12; ++i) {
    section.equations.push_back({latex_formula("a"), 1, 1, {latex_formula("b")}});
  }
  page.sections = {section};
  CHECK(mentions(latex_document(page), "\\begin{align*}\na &= b \\\\\na &= b"));
}

TEST_CASE("links and images in titles are plain text") {
  Page page = small_page();
  page.title = prose("[here](http://a) ![](http://b/c.png) <img src=x> &#33;");
  CHECK(mentions(markdown_page(page),
                 "# \\[here\\](http://a) !\\[\\](http://b/c.png) \\<img src=x> \\&#33;\n"));
}

TEST_CASE("a page has variables and parameters, but no drift and no struct of all outputs") {
  const ChosenForms c = chosen(read_model("cart_pole"));
  const Page page = model_page(c.checked.model, c.checked.scene, c.choice.program);
  CHECK(page.coordinates.size() == 2);
  CHECK(latex_of(page.coordinates[1].symbol) == "\\theta");
  CHECK(page.parameters.size() == 4);
  for (const PageSection& output : page.sections) {
    CHECK(output.function != "drift");
    CHECK(output.function != "dynamics");
  }
}

TEST_CASE("zeros are shown and long outputs omitted on request") {
  const ChosenForms c = chosen(read_model("cart_pole"));
  const auto count = [&](const PageOptions& options) {
    const Page page = model_page(c.checked.model, c.checked.scene, c.choice.program, options);
    std::size_t equations = 0;
    for (const PageSection& output : page.sections) equations += output.equations.empty() ? 0 : 1;
    return equations;
  };
  CHECK(count({true}) > count({}));
  CHECK(count({false, 2}) < count({}));
}

TEST_CASE("a text page is in the model language") {
  const ChosenForms c = chosen(read_model("cart_pole"));
  const std::string page = text_page(c.checked.model, c.checked.scene, c.choice.program);
  CHECK(mentions(page, "  q = (x, theta)\n  v = dq/dt, a = dv/dt\n"));
  CHECK(mentions(page, "\nmass_matrix\n  mass_matrix[1,1] = M + m\n"));
  CHECK(mentions(page, "  potential_energy = m*l*g*cos(theta)\n"));
  CHECK_FALSE(mentions(page, "drift"));
  CHECK(mentions(text_page(c.checked.model, c.checked.scene, c.choice.program, {true}),
                 "  drift[2] = 0\n"));
}

TEST_CASE("a page ends with the conserved quantities") {
  const auto orbit = [](const std::string& more) {
    return chosen(model_text("orbit", R"toml([[coordinate]]
name = "r"
range = [1, 2]
[[coordinate]]
name = "phi"
[energy]
T = "1/2*(dot(r)^2 + r^2*dot(phi)^2)"
)toml" + more));
  };
  const auto text = [](const ChosenForms& c) {
    return text_page(c.checked.model, c.checked.scene, c.choice.program);
  };
  const ChosenForms free = orbit("V = \"-1/r\"\n");
  CHECK(text(free).ends_with("\n\nconserved: E, p(phi)\n"));
  const PageSection last =
      model_page(free.checked.model, free.checked.scene, free.choice.program).sections.back();
  CHECK(text_of(last.title) == "Conserved");
  REQUIRE(last.lines.size() == 2);
  CHECK(latex_of(last.lines[1]) == "p_{\\phi} = \\frac{\\partial L}{\\partial \\dot{\\phi}}");
  CHECK(text(orbit("V = \"-t/r\"\n")).ends_with("\n\nconserved: p(phi)\n"));
  const std::string push =
      "V = \"f*r\"\n[[function]]\nname = \"f\"\nof = [\"t\"]\nsample = \"cos(t)\"\n";
  CHECK(text(orbit(push)).ends_with("\n\nconserved: p(phi)\n"));
  CHECK(text(orbit("D = \"dot(r)^2\"\n")).ends_with("\n\nconserved: p(phi)\n"));
  CHECK_FALSE(mentions(text(orbit("D = \"dot(phi)^2\"\n")), "conserved"));
  CHECK_FALSE(mentions(text(orbit("V = \"sin(phi - t)\"\n")), "conserved"));
}

TEST_CASE("a cost page lists both forms and marks the emitted form") {
  FormCosts row{.function = "bias", .recursive = {.add = 2}, .closed = OperationCounts{.mul = 1}};
  row.chosen_form = Form::closed;
  row.closed_loss = 0;
  row.recursive_loss = 1e3;
  CHECK(mentions(
      cost_page({row}),
      "bias      closed          0      1     0     0      0     0       1       0  emitted\n"
      "bias      recursive       2      0     0     0      0     0       2     3.0\n"));
  row.recursive_loss = std::numeric_limits<double>::infinity();
  CHECK(mentions(cost_page({row}), "     all\n"));
  row.is_demanded = true;
  CHECK(mentions(cost_page({row}), "  requested\n"));
}

TEST_CASE("notes list outputs left out of full, and how to get them") {
  Scene scene;
  scene.omitted_outputs = {{OmissionReason::too_many_entries, {"mass_matrix", "linearization"}},
                           {OmissionReason::kinked_force, {"forward_dynamics_derivatives"}}};
  CHECK(scene_notes(Model{}, scene) ==
        std::vector<std::string>{
            "Left out, with more than 4096 entries: mass_matrix, linearization. To emit "
            "one, name it in a scene or with --outputs.",
            "Left out, because forces with abs, sign, min or max have no derivatives: "
            "forward_dynamics_derivatives."});
}

TEST_CASE("notes list what a scene fixes and locks") {
  CHECK(notes("") == std::vector<std::string>{});
  CHECK(notes("doc = \"Upright.\"\n[parameters]\nfixed = { l = \"1/2\", g = 9.81 }\n"
              "[lock]\nx = { value = \"sin(2*t)\" }\n") ==
        std::vector<std::string>{"Upright.", "Fixed: l = 0.5, g = 9.81.", "Locked: x = sin(2*t)."});
}

TEST_CASE("exact equations have no note about an expansion") {
  CHECK(expansion_text(checked_model(read_model("cart_pole")).model).empty());
}

TEST_CASE("a note names the expansion point and order, and inputs if they are small") {
  const CheckedModel all =
      approximated(read_model("cart_pole"), "order = 1\nabout = { x = 0, theta = \"pi/2\" }");
  CHECK(scene_notes(all.model, all.scene) == std::vector<std::string>{expansion_text(all.model)});
  CHECK(expansion_text(all.model) ==
        "Expanded about x = 0, theta = pi/2, u = 0: correct to order 1 in the deviations, the "
        "rates and the accelerations together.");
  const CheckedModel some =
      approximated(read_model("cart_pole"), "order = 2\nabout = { theta = 0 }");
  CHECK(expansion_text(some.model) ==
        "Expanded about theta = 0: correct to order 2 in the equations of theta, and to order 3 in "
        "other equations. The order counts the deviations, their rates and their accelerations "
        "together. All other variables are exact.");
}
