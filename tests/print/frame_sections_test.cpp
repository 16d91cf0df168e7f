// Sections on frames and their bodies: parents, angular velocities, positions, velocities and
// kinetic energies.
#include <catch2/catch.hpp>

#include "elgen/pipeline.hpp"
#include "print/small_page.hpp"
#include "support/inputs.hpp"
#include "support/models.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

Products derived(const std::string& text) {
  return products_with(&Products::steps, inputs_of(text), {.goals = {Goal::steps}});
}

std::string derivation(const std::string& text) {
  const Products products = derived(text);
  return text_of(derivation_sections(products.checked->model, *products.steps));
}

/// The lines of a section, without its title.
std::string section(const std::string& text, const std::string& title) {
  const std::size_t begin = text.find("\n" + title + "\n");
  if (begin == std::string::npos) return {};
  const std::size_t first = begin + title.size() + 2;
  return text.substr(first, text.find("\n\n", first) - first + 1);
}

const std::string& gimbals() {
  static const std::string text = model_text("gimbals", R"toml(
[[coordinate]]
name = "alpha"
unit = "rad"
[[coordinate]]
name = "beta"
unit = "rad"
[[coordinate]]
name = "gamma"
unit = "rad"
[parameters]
A1 = { value = 0.01, unit = "kg*m^2" }
A2 = { value = 0.005, unit = "kg*m^2" }
B2 = { value = 0.006, unit = "kg*m^2" }
C2 = { value = 0.007, unit = "kg*m^2" }
A = { value = 0.002, unit = "kg*m^2" }
C = { value = 0.004, unit = "kg*m^2" }
m = { value = 0.5, unit = "kg" }
[[frame]]
name = "outer"
parent = "world"
rotate = [["z", "alpha"]]
[[frame]]
name = "inner"
parent = "outer"
rotate = [["x", "beta"]]
[[frame]]
name = "rotor"
parent = "inner"
rotate = [["y", "gamma"]]
[[body]]
name = "outer"
frame = "outer"
mass = "m"
inertia = ["A1", "A1", "A1"]
[[body]]
name = "inner"
frame = "inner"
mass = "m"
inertia = ["A2", "B2", "C2"]
[[body]]
name = "rotor"
frame = "rotor"
mass = "m"
inertia = ["A", "C", "A"]
)toml");
  return text;
}

/// A planar chain of `count` links; the first link hangs in the world.
std::string chain(int count) {
  std::string text = "[parameters]\nm = 2\nl = \"7/10\"\nJ = \"1/9\"\n";
  for (int i = 1; i <= count; ++i) {
    const std::string number = std::to_string(i);
    const std::string parent = i == 1 ? "world" : "link" + std::to_string(i - 1);
    text += "[[coordinate]]\nname = \"q" + number + "\"\n[[frame]]\nname = \"link" + number +
            "\"\nparent = \"" + parent + "\"\ntranslate = [\"0\", \"" + (i == 1 ? "0" : "-l") +
            "\"]\nrotate = [[\"z\", \"q" + number + "\"]]\n[[body]]\nname = \"link" + number +
            "\"\nframe = \"link" + number +
            "\"\nmass = \"m\"\ncom = [\"0\", \"-l/2\"]\ninertia = \"J\"\n";
  }
  return model_text("chain", text);
}

}  // namespace

TEST_CASE("a gyroscope in two gimbals is printed as in a book") {
  const std::string text = derivation(gimbals());
  INFO(text);
  CHECK(section(text, "Frames") ==
        "  Pose H of each frame in its parent: translations and rotations, in order.\n"
        "  frame   parent   H\n"
        "  outer   world    Rot_z(alpha)\n"
        "  inner   outer    Rot_x(beta)\n"
        "  rotor   inner    Rot_y(gamma)\n");
  const std::string spins = section(text, "Angular velocities");
  CHECK(mentions(spins, "\n  omega_outer = (0, 0, dot(alpha))\n"));
  CHECK(mentions(spins,
                 "\n  omega_inner = (dot(beta), dot(alpha)*sin(beta), dot(alpha)*cos(beta))\n"));
  CHECK(mentions(spins,
                 "\n  omega_rotor = (dot(beta)*cos(gamma) - dot(alpha)*cos(beta)*sin(gamma), "
                 "dot(alpha)*sin(beta) + dot(gamma), "
                 "dot(alpha)*cos(beta)*cos(gamma) + dot(beta)*sin(gamma))\n"));
  CHECK_FALSE(mentions(spins, "nu: "));
  const std::string centres = section(text, "Centres of mass");
  CHECK(mentions(centres, "\n  r_outer = 0\n  r_inner = 0\n  r_rotor = 0\n"));
  const std::string energies = section(text, "Kinetic energies");
  CHECK(mentions(energies, "\n  T_outer = 1/2*A1*dot(alpha)^2\n"));
  CHECK(mentions(energies,
                 "\n  T_inner = 1/2*(B2*sin(beta)^2 + C2*cos(beta)^2)*dot(alpha)^2 + "
                 "1/2*A2*dot(beta)^2\n"));
  CHECK(mentions(energies,
                 "\n  T_rotor = 1/2*(A*cos(beta)^2 + C*sin(beta)^2)*dot(alpha)^2 + "
                 "1/2*A*dot(beta)^2 + 1/2*C*dot(gamma)^2 + C*dot(alpha)*dot(gamma)*sin(beta)\n"));
  CHECK_FALSE(mentions(text, "Omitted"));
}

TEST_CASE("a cart and its pole have vectors with two components") {
  const std::string text = derivation(model_text("cart", R"toml(
[[coordinate]]
name = "x"
[[coordinate]]
name = "theta"
[parameters]
M = 2
m = 1
l = "7/10"
J = "1/9"
[[frame]]
name = "cart"
parent = "world"
translate = ["x", "0"]
[[frame]]
name = "pole"
parent = "cart"
rotate = [["z", "theta"]]
[[body]]
name = "cart"
frame = "cart"
mass = "M"
[[body]]
name = "pole"
frame = "pole"
mass = "m"
com = ["0", "l"]
inertia = "J"
)toml"));
  INFO(text);
  CHECK(mentions(section(text, "Frames"),
                 "\n  cart    world    Trans(x, 0, 0)\n  pole    cart     Rot_z(theta)\n"));
  CHECK(mentions(section(text, "Angular velocities"),
                 "\n  omega_cart = 0\n  omega_pole = dot(theta)\n"));
  CHECK(mentions(section(text, "Centres of mass"),
                 "\n  r_cart = (x, 0)\n  v_cart = (dot(x), 0)\n"
                 "  r_pole = (x - l*sin(theta), l*cos(theta))\n"
                 "  v_pole = (dot(x) - l*dot(theta)*cos(theta), -l*dot(theta)*sin(theta))\n"));
  const std::string energies = section(text, "Kinetic energies");
  CHECK(mentions(energies, "\n  T_cart = 1/2*M*dot(x)^2\n"));
  CHECK(mentions(energies,
                 "\n  T_pole = 1/2*m*dot(x)^2 + 1/2*(J + m*l^2)*dot(theta)^2 - "
                 "m*l*dot(x)*dot(theta)*cos(theta)\n"));
}

TEST_CASE("the velocity of a free body is in the world") {
  const std::string text = derivation(read_model("tumbler"));
  INFO(text);
  CHECK(mentions(section(text, "Frames"), "  body    world    Trans(x, 0, 0) Rot(attitude)\n"));
  const std::string centres = section(text, "Centres of mass");
  CHECK(mentions(centres, "  r: position in the world. v: its rate, if it is not 0.\n"));
  CHECK(mentions(centres, "\n  r_stone = (x, 0, 0)\n  v_stone = (dot(x), 0, 0)\n"));
}

TEST_CASE("a long quantity has components of earlier quantities") {
  const std::string text = derivation(chain(6));
  INFO(text);
  const std::string spins = section(text, "Angular velocities");
  CHECK(mentions(spins, "\n  omega_link2 = dot(q1) + dot(q2)\n"));
  CHECK(mentions(spins, " nu: velocity of its origin, in its axes.\n"));
  CHECK(mentions(spins, "\n  nu_link6 = ("));
  CHECK_FALSE(mentions(spins, "  nu_link2 = ("));
  const std::string centres = section(text, "Centres of mass");
  CHECK(mentions(centres, "\n  r_link1 = (1/2*l*sin(q1), -1/2*l*cos(q1))\n"));
  CHECK(mentions(centres, "\n  v_link1 = (1/2*l*dot(q1)*cos(q1), 1/2*l*dot(q1)*sin(q1))\n"));
  CHECK(mentions(centres, " If these are too long: position c in the frame, and v in the axes"));
  CHECK(mentions(centres, "\n  c_link6 = (0, -1/2*l)\n  v_link6 = ("));
  CHECK_FALSE(mentions(centres, "r_link6"));
  CHECK(mentions(section(text, "Kinetic energies"), "v_link6[1]^2"));
  CHECK(mentions(section(text, "Kinetic energies"), "omega_link6^2"));
  CHECK_FALSE(mentions(text, "Positions are omitted"));
}

TEST_CASE("sections on frames have symbols in all notations") {
  const Products products = derived(gimbals());
  const Page page =
      derivation_page(products.checked->model, products.checked->scene, *products.steps);
  CHECK(mentions(screen_page(page, {80, Alphabet::unicode}), "α̇ cos β"));
  CHECK(mentions(latex_document(page), "\\omega_{\\mathrm{outer}}"));
  CHECK(mentions(markdown_page(page), "\\mathrm{Rot}_{z}(\\alpha)"));
  CHECK(mentions(html_page(page), "<h2>Angular velocities</h2>"));
  CHECK(text_of(page.sections[1].title) == "Frames");
  CHECK(page.sections[1].table.cells.size() == 9);
}
