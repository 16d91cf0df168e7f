// Symmetries: kind, integral, F and rate of each symmetry; the effect of forces; the exact text of
// the page around the formulas; JSON.
#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "analyse/symmetries_testing.hpp"
#include "elgen/analysis_pages.hpp"
#include "elgen/page.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

using Kind = SymmetryKind;

/// One symmetry: `integral` is I + F in names of the model, `total` is F, and `rate` is dI/dt.
struct ExpectedSymmetry {
  Kind kind;
  const char* integral;
  const char* total = "0";
  const char* rate = "0";
};

void check_all(const std::string& model, const std::vector<ExpectedSymmetry>& expected,
               const std::vector<std::string>& fixed = {}) {
  FoundSymmetries found(symmetric_model(model), fixed);
  INFO(model << "\n" << found.page());
  CHECK(found.all().size() == expected.size());
  for (const auto& [kind, integral, total, rate] : expected) {
    INFO(integral);
    const Symmetry& symmetry = found.symmetry_with(integral);
    CHECK(symmetry.kind == kind);
    CHECK(found.equals(symmetry.gauge_function, total));
    CHECK(found.equals(symmetry.rate, rate));
    CHECK(symmetry.is_proved);
  }
}

/// Checks that the symmetry with this `integral` has I + F = `closed`, written out in q and v.
void check_closed(const std::string& model, const std::string& integral,
                  const std::string& closed) {
  FoundSymmetries found(symmetric_model(model));
  INFO(model << ": " << integral);
  CHECK(found.equals(found.symmetry_with(integral).velocity_form, closed));
}

/// `page` without its formulas: each row ends after the generator, and the list of integrals ends
/// after its first line.
std::string without_formulas(const std::string& page) {
  const std::string gap = "   ";
  std::string result;
  for (std::string line : split_lines(page)) {
    const std::size_t change = line.find_first_not_of(' ', line.find(gap, 2));
    if (change != std::string::npos) line.resize(std::min(line.find(gap, change), line.size()));
    for (const char* const before_formula : {"  time   E", "  conserved = ["}) {
      if (starts_with(line, before_formula)) line = before_formula;
    }
    const auto begins_line = [&line](const char* const start) { return starts_with(line, start); };
    const std::array formulas{"  p(", "  t*p(", "  F = ", "  E = ", "  d/dt = "};
    if (std::ranges::none_of(formulas, begins_line)) result += line + "\n";
  }
  return result;
}

/// Checks that the formulas in the JSON `row`, parsed again, equal the closed forms of `symmetry`.
void check_row(FoundSymmetries& found, const Symmetry& symmetry, const nlohmann::json& row) {
  CHECK(found.equals(symmetry.momentum_form, row.at("integral")));
  CHECK(found.equals(symmetry.velocity_form, row.at("closed_form")));
  CHECK(found.equals(symmetry.gauge_function, row.at("F")));
  CHECK(found.equals(symmetry.rate, row.at("rate")));
  CHECK(found.equals(symmetry.generator.back(), row.at("time")));
  CHECK(row.at("proved").get<bool>());
  REQUIRE(row.at("displacement").size() == symmetry.displacement.size());
  for (std::size_t i = 0; i < symmetry.displacement.size(); ++i) {
    CHECK(found.equals(symmetry.displacement[i], row.at("displacement").at(i)));
  }
}

std::string page_frame(const std::string& model) {
  return without_formulas(FoundSymmetries(symmetric_model(model)).page());
}

}  // namespace

TEST_CASE("cart-pole: a translation, a boost with its F, and the work of the force") {
  check_all("cart_pole", {{Kind::coordinate, "p(x)", "0", "u"},
                          {Kind::boost, "t*p(x)", "(M + m)*x + m*l*sin(theta)", "u*t"},
                          {Kind::time, "E", "0", "u*dot(x)"}});
}

TEST_CASE("free fall conserves p + m g t, and the integral of the boost") {
  check_all("falling", {{Kind::coordinate, "p(x)"},
                        {Kind::coordinate, "p(z)", "-m*g*t"},
                        {Kind::boost, "t*p(x)", "m*x"},
                        {Kind::boost, "t*p(z)", "m*z - m*g*t^2/2"},
                        {Kind::time, "E"}});
  check_all("atwood", {{Kind::coordinate, "p(x)", "(m1 - m2)*g*t"},
                       {Kind::boost, "t*p(x)", "(m1 + m2)*x + (m1 - m2)*g*t^2/2"},
                       {Kind::time, "E"}});
}

TEST_CASE("in a magnetic field F depends on the gauge, and the number of symmetries does not") {
  check_all("magnetic_symmetric_gauge", {{Kind::coordinate, "p(x)", "e*B*y/2"},
                                         {Kind::coordinate, "p(y)", "-e*B*x/2"},
                                         {Kind::rotation, "x*p(y) - y*p(x)"},
                                         {Kind::time, "E"}});
  check_all("magnetic_landau_gauge", {{Kind::coordinate, "p(x)", "e*B*y"},
                                      {Kind::coordinate, "p(y)"},
                                      {Kind::rotation, "x*p(y) - y*p(x)", "e*B*(x^2 - y^2)/2"},
                                      {Kind::time, "E"}});
  check_closed("magnetic_symmetric_gauge", "E", "m*(dot(x)^2 + dot(y)^2)/2");
}

TEST_CASE("translations in time may have an F") {
  check_all("accelerated_lift", {{Kind::time, "E", "m*A*l*cos(theta) + m*A*(g - A)*t^2/2"}});
  check_all("gauge_of_time", {{Kind::coordinate, "p(x)", "k*x*t"},
                              {Kind::boost, "t*p(x)", "m*x + k*x*t^2"},
                              {Kind::time, "E", "-k*x^2/2"}});
  check_all("pushed_by_time",
            {{Kind::coordinate, "p(x)", "f*t^2/2"}, {Kind::boost, "t*p(x)", "m*x + f*t^3/3"}});
  check_all("fading_push",
            {{Kind::coordinate, "p(x)", "f*exp(-k*t)*(w*sin(w*t) - k*cos(w*t))/(k^2 + w^2)"},
             {Kind::boost, "t*p(x)",
              "m*x + f*exp(-k*t)*(t*(w*sin(w*t) - k*cos(w*t))/(k^2 + w^2) + (2*k*w*sin(w*t) - "
              "(k^2 - w^2)*cos(w*t))/(k^2 + w^2)^2)"}});
}

TEST_CASE("time combines with a translation, a boost, a rotation, a scaling") {
  check_all("travelling_wave", {{Kind::other, "c*p(x) - E"}});
  check_all("travelling_wave_numbers", {{Kind::other, "3*p(x) - E"}});
  check_all("accelerated_wave", {{Kind::other, "A*t*p(x) - E", "m*A*x"}});
  check_all("turning_trough", {{Kind::other, "w*(x*p(y) - y*p(x)) - E"}});
  check_all("growing_mass", {{Kind::coordinate, "p(x)"}, {Kind::other, "-gamma*x*p(x)/2 - E"}});
  check_all("growing_oscillator", {{Kind::other, "-gamma*x*p(x)/2 - E"}});
}

TEST_CASE(
    "symmetries that move several coordinates: a screw, the centre of mass, an elliptic rotation") {
  check_all("helix_in_cylinder", {{Kind::translation, "p(phi) + h*p(z)"}, {Kind::time, "E"}});
  check_all("two_body", {{Kind::translation, "p(x1) + p(x2)"},
                         {Kind::boost, "t*(p(x1) + p(x2))", "m1*x1 + m2*x2"},
                         {Kind::time, "E"}});
  check_all("two_unequal_masses", {{Kind::other, "m1*x*p(y) - m2*y*p(x)"}, {Kind::time, "E"}});
  check_all("double_pendulum", {{Kind::translation, "p(theta1) + p(theta2)"}, {Kind::time, "E"}},
            {"g=0"});
}

TEST_CASE("rotations in space turn all points together: x to y, y to z, z to x") {
  check_all("kepler_cartesian", {{Kind::rotation, "x*p(y) - y*p(x)"},
                                 {Kind::rotation, "y*p(z) - z*p(y)"},
                                 {Kind::rotation, "z*p(x) - x*p(z)"},
                                 {Kind::time, "E"}});
  FoundSymmetries two(model_file("two_particles"));
  for (const char* const integral :
       {"x1*p(y1) - y1*p(x1) + x2*p(y2) - y2*p(x2)", "y1*p(z1) - z1*p(y1) + y2*p(z2) - z2*p(y2)",
        "z1*p(x1) - x1*p(z1) + z2*p(x2) - x2*p(z2)"}) {
    CHECK(two.symmetry_with(integral).kind == Kind::rotation);
  }
}

TEST_CASE("charged particle in crossed fields: the boost needs a rotation") {
  check_all("charged_particle",
            {{Kind::coordinate, "p(x)", "e*(B*y/2 + Ex*t)"},
             {Kind::coordinate, "p(y)", "-e*B*x/2"},
             {Kind::coordinate, "p(z)", "e*Ez*t"},
             {Kind::boost, "t*p(z)", "m*z + e*Ez*t^2/2"},
             {Kind::other, "Ex*t*p(x) + B*(y*p(x) - x*p(y))", "Ex*(m*x + e*t*(B*y + Ex*t)/2)"},
             {Kind::time, "E"}});
}

TEST_CASE("momenta and E are written out") {
  check_closed("heavy_top", "p(psi)", "C*(dot(psi) + cos(theta)*dot(phi))");
  check_closed("heavy_top", "p(phi)",
               "A*sin(theta)^2*dot(phi) + C*cos(theta)*(dot(psi) + cos(theta)*dot(phi))");
  check_closed("kepler_plane", "x*p(y) - y*p(x)", "m*(x*dot(y) - y*dot(x))");
  check_closed("open_distance_in_x_y_z", "E", "m*(dot(x)^2 + dot(y)^2 + dot(z)^2)/2 + V");
  check_closed("growing_mass", "p(x)", "m*exp(gamma*t)*dot(x)");
}

TEST_CASE("the page of a damped system does not claim that energy is conserved") {
  FoundSymmetries damped(model_file("two_mass_damper"));
  REQUIRE(damped.all().size() == 1);
  const std::string rate = "-(b + bc)*(dot(x1)^2 + dot(x2)^2) + 2*bc*dot(x1)*dot(x2)";
  CHECK(damped.equals(damped.all()[0].rate, rate));
  CHECK(damped.equals(damped.all()[0].unforced_rate, rate));
  CHECK(damped.json().at("conserved").empty());
  CHECK_FALSE(mentions(damped.page(), "[[expect]]"));
  FoundSymmetries driven(model_file("furuta_pendulum"));
  CHECK(driven.equals(driven.symmetry_with("p(theta1)").rate, "tau - b1*dot(theta1)"));
}

TEST_CASE("with moving constraints E is not T + V, and the page says so") {
  const FoundSymmetries hoop(model_file("rotating_hoop"));
  CHECK(hoop.found().loses_energy);
  CHECK(mentions(hoop.page(), "   (T + V is not conserved)\n"));
  const FoundSymmetries pendulum(model_file("simple_pendulum"));
  CHECK_FALSE(pendulum.found().loses_energy);
  CHECK_FALSE(mentions(pendulum.page(), "T + V"));
}

TEST_CASE("the page says if F has no closed form, and expects no integral with such an F") {
  FoundSymmetries found(model_text("gauge", R"toml([[coordinate]]
name = "x"
range = [0.5, 2]
start = { value = 1, rate = 0.1 }
[parameters]
m = { value = 2, assume = "positive" }
a = { value = 3, assume = "positive" }
[energy]
L = "m*dot(x)^2/2 + a*sqrt(x)*dot(x)"
)toml"));
  INFO(found.page());
  CHECK(found.all().size() == 3);
  CHECK_FALSE(found.symmetry_with("p(x)").gauge_function);
  CHECK_FALSE(found.symmetry_with("t*p(x)").gauge_function);
  CHECK(count(found.page(), " - F, F has no closed form\n") == 2);
  CHECK(mentions(found.page(),
                 "  conserved: dL = dF/dt is proved; these are all symmetries of this form"));
  CHECK(mentions(found.page(), "  conserved = [\"E\"]\n"));
}

TEST_CASE("pages list the generators, the claim and the method") {
  CHECK(
      page_frame("cart_pole") ==
      R"(Cart and pole with a force on the cart: symmetries of L with dq = A q + b + c t, dt constant: 3

  x: dx = 1

  boost: dx = t

  time: dt = 1

  conserved if d/dt is 0: proved; these are all symmetries of this form (9 unknown coefficients, exact)

[[expect]]
  conserved = [
)");
  CHECK(page_frame("unequal_at_special_values") ==
        R"(Unequal at special values: symmetries of L with dq = A q + b + c t, dt constant: 1

  time   E

  conserved: proved; these are all symmetries of this form (9 unknown coefficients, exact); at the parameters' values there are 2 (sampled at 8 states in 160 digits)

[[expect]]
  conserved = [
)");
  CHECK(page_frame("shaken_lift") ==
        R"(Shaken lift: symmetries of L with dq = A q + b + c t, dt constant: 0

  there are no symmetries of this form (4 unknown coefficients, exact)
)");
}

TEST_CASE("without closed forms the page says that states were sampled") {
  const FoundSymmetries arm(model_file("panda7"));
  const std::string page = arm.page();
  INFO(page);
  CHECK(mentions(page, "  q1: dq1 = 1\n  p(q1)\n  d/dt = tau1\n"));
  CHECK(mentions(page,
                 "\n  conserved if d/dt is 0: sampled at 13 states in 160 digits; these are all "
                 "symmetries of this form (64 unknown coefficients, sampled)\n"));
  CHECK(mentions(page, "\n[[expect]]\n  conserved = [\"p(q1)\", \"E\"]\n"));
  // Closed forms do not prove t and e^(gamma t) independent, so completeness is only sampled.
  CHECK(mentions(FoundSymmetries(symmetric_model("growing_mass")).page(),
                 "\n  conserved: proved; these are all symmetries of this form (4 unknown "
                 "coefficients, sampled)\n"));
}

TEST_CASE("rotations of bodies about axes of the world and of the body") {
  const std::string page = page_frame("free_body_aac");
  CHECK(mentions(
      page,
      ": symmetries of L with dq = A q + b + c t, rotations by R^T s + b, dt constant: 12\n"));
  for (const char* const row : {"\n  turn: attitude rotated by R^T (1, 0, 0)\n",
                                "\n  turn: attitude rotated by R^T (0, 1, 0)\n",
                                "\n  turn: attitude rotated by R^T (0, 0, 1)\n",
                                "\n  turn: attitude rotated by (0, 0, 1)\n",
                                "\n  rotation: dx = -y, dy = x\n", "\n  time: dt = 1\n"}) {
    INFO(row);
    CHECK(count(page, row) == 1);
  }
  const FoundSymmetries sphere(symmetric_model("free_body_aaa"));
  CHECK(mentions(sphere.page(), "\n  turn: attitude rotated by (1, 0, 0)\n  I = p(attitude[1])\n"));
  CHECK(count(sphere.page(), "\n  turn: ") == 6);
}

TEST_CASE("the integral of dL gets a name that no value of the model has") {
  const auto pushed = [](const std::string& input, const std::string& mass) {
    return FoundSymmetries(
        model_text("pushed", "[[coordinate]]\nname = \"x\"\n[parameters]\nm = " + mass +
                                 "\n[energy]\nT = \"1/2*m*dot(x)^2\"\n[[input]]\nname = \"" +
                                 input + "\"\non = \"x\"\n"));
  };
  const std::string named = pushed("F", "1").page();
  INFO(named);
  CHECK(mentions(named, " - F_1,   F_1 = m*x"));
  CHECK(mentions(named, "d/dt = t*F"));
  CHECK_FALSE(mentions(named, "F = m*x"));
  CHECK(mentions(pushed("u", "1").page(), " - F,   F = m*x"));
  // The LaTeX name of F differs from the LaTeX names of the model, too.
  const FoundSymmetries drawn = pushed("u", "{ value = 1, latex = \"F\" }");
  CHECK(mentions(latex_document(symmetries_page(drawn.checked(), drawn.found())), "F' = F x"));
}

TEST_CASE("pages are printed in the notations of plain text, Unicode and LaTeX") {
  const FoundSymmetries found(model_file("cart_pole"));
  const Page sheet = symmetries_page(found.checked(), found.found());
  CHECK(starts_with(latex_document(sheet), "\\documentclass"));
  CHECK(mentions(latex_document(sheet), "${\\delta} x = t$"));
  CHECK(mentions(html_page(sheet), "<mi>δ</mi>"));
  CHECK(mentions(markdown_page(sheet), "${\\delta} x = t$"));
  const std::string screen = screen_page(sheet, {100, Alphabet::unicode});
  CHECK(mentions(screen, "\n  boost: δx = t\n  t pₓ - F\n  F = "));
}

TEST_CASE("JSON has every formula, in the model language") {
  for (const char* const name :
       {"cart_pole", "charged_particle", "helix_in_cylinder", "fading_push"}) {
    FoundSymmetries found(symmetric_model(name));
    const nlohmann::json page = found.json();
    INFO(page.dump(1));
    CHECK(page.at("model") == name);
    CHECK(page.at("unknowns") == found.found().unknowns);
    CHECK(page.at("exact") == found.found().is_exact);
    CHECK(page.at("complete") == found.found().is_complete);
    CHECK(page.at("sampled") == found.all().size());
    CHECK(page.at("states") == found.found().states);
    REQUIRE(page.at("symmetries").size() == found.all().size());
    REQUIRE(page.at("conserved").size() == found.all().size());
    for (std::size_t i = 0; i < found.all().size(); ++i) {
      const nlohmann::json& row = page.at("symmetries").at(i);
      check_row(found, found.all()[i], row);
      const std::string integral =
          row.at("integral").get<std::string>() + " - (" + row.at("F").get<std::string>() + ")";
      CHECK(found.equals(found.form(integral), page.at("conserved").at(i)));
    }
  }
}

TEST_CASE("in JSON kinds are words, and unknown values are null") {
  const auto kinds = [](const std::string& model) {
    std::vector<std::string> words;
    const nlohmann::json page = FoundSymmetries(symmetric_model(model)).json();
    for (const nlohmann::json& row : page.at("symmetries"))
      words.push_back(row.at("kind").get<std::string>());
    return words;
  };
  CHECK(kinds("cart_pole") == std::vector<std::string>{"translation", "boost", "time"});
  CHECK(kinds("two_unequal_masses") == std::vector<std::string>{"other", "time"});
  CHECK(kinds("kepler_plane") == std::vector<std::string>{"rotation", "time"});
  const nlohmann::json arm = FoundSymmetries(model_file("panda7")).json();
  CHECK_FALSE(arm.at("exact").get<bool>());
  CHECK(arm.at("symmetries").at(1).at("integral") == "E");
  CHECK(arm.at("symmetries").at(1).at("closed_form").is_null());
  CHECK_FALSE(arm.at("symmetries").at(1).at("proved").get<bool>());
}

TEST_CASE("relations that closed forms do not know are found by samples") {
  const auto found = [](const std::string& potential) {
    return FoundSymmetries(
        "format = 1\n[model]\nname = \"related\"\n"
        "[[coordinate]]\nname = \"x\"\nrange = [1, 2]\n"
        "[[coordinate]]\nname = \"y\"\nrange = [1, 2]\n"
        "[parameters]\nm = 2\nk = 3\n[energy]\n"
        "T = \"1/2*m*(dot(x)^2 + dot(y)^2)\"\nV = \"" +
        potential + "\"\n");
  };
  for (const auto& [potential, count] :
       {std::pair{"sqrt(k/m)*sqrt(m)*x^2 + sqrt(k)*y^2", 2U},
        std::pair{"k*(sqrt(x^2)*x - x^2)", 6U},
        std::pair{"k*(exp(x + y) + x*exp(x)*exp(y) - x*exp(x + y))", 3U}}) {
    const FoundSymmetries of(found(potential));
    INFO(of.page());
    CHECK(of.all().size() == count);
    CHECK(mentions(of.page(), "of this form (9 unknown coefficients, sampled)"));
  }
  // A term of 1e-50 is more than a rounding error.
  const FoundSymmetries tiny(found("k*(x^2 + y^2) + 1e-50*x^4"));
  CHECK(tiny.all().size() == 1);
  CHECK(tiny.found().sampled == 1);
}
