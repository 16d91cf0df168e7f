#include "model/symbols.hpp"

#include <catch2/catch.hpp>

#include "formula/drawing.hpp"
#include "support/models.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

std::vector<std::string> latex_of(const Formulas& symbols) {
  std::vector<std::string> all;
  for (const Formula& symbol : symbols) all.push_back(to_latex(glyphs_of(symbol)));
  return all;
}

}  // namespace

TEST_CASE("names become symbols") {
  const std::vector<std::pair<std::string, std::string>> rows{
      {"x", "x"},
      {"theta", "\\theta"},
      {"theta1", "\\theta_{1}"},
      {"l[2]", "l_{2}"},
      {"Omega", "\\Omega"},
      {"mass", "\\mathrm{mass}"},
      {"m_cart", "m_{\\mathrm{cart}}"},
      {"q_hip_left", "q_{\\mathrm{hip}, \\mathrm{left}}"},
      {"joint_4_stiction", "\\mathrm{joint}_{4, \\mathrm{stiction}}"},
      {"Ixx_link03", "I_{xx, \\mathrm{link03}}"},
      {"I3yz", "I_{3yz}"},
      {"Jz2", "J_{z, 2}"},
      {"xi_xy", "\\xi_{xy}"},
      {"xy", "\\mathrm{xy}"},
      {"Jm", "J_{m}"},
      {"kf", "k_{f}"},
      {"Jm1", "J_{m, 1}"},
      {"km[2]", "k_{m, 2}"},
      {"mu", "\\mu"},
      {"Xi", "\\Xi"},
      {"mu1", "\\mu_{1}"},
      {"Jm_arm", "\\mathrm{Jm}_{\\mathrm{arm}}"},
      {"abc", "\\mathrm{abc}"},
  };
  for (const auto& [name, expected] : rows) {
    INFO(name);
    CHECK(to_latex(symbol_of_name(name)) == expected);
  }
}

TEST_CASE("a model's own LaTeX is used") {
  CHECK(to_latex(symbol_of_name("phi", "\\varphi")) == "\\varphi");
}

TEST_CASE("if a symbol draws nothing, the name is drawn") {
  for (const char* const key : {"{}", " ", "^", "\\dot", "\\mathrm{}", "\\dot{}", "_{}", "{{}}"}) {
    INFO(key);
    CHECK(to_latex(symbol_of_name("theta1", key)) == "\\theta_{1}");
  }
}

TEST_CASE("an input named after its coordinate has the scripts of the coordinate's symbol") {
  const CheckedModel checked =
      checked_model(model_text("driven",
                               "[[coordinate]]\nname = \"elbow\"\nlatex = 'q_2'\n"
                               "[[coordinate]]\nname = \"wrist\"\n[parameters]\nm = 1\n"
                               "[energy]\nT = \"m*(dot(elbow)^2 + dot(wrist)^2)\"\n"
                               "[[input]]\nname = \"tau_elbow\"\non = \"elbow\"\n"
                               "[[input]]\nname = \"tau_wrist\"\non = \"wrist\"\n"
                               "[[input]]\nname = \"u_tau_elbow\"\non = \"elbow\"\n"));
  CHECK(latex_of(ModelSymbols(checked.model).leaf_symbols().u) ==
        std::vector<std::string>{"\\tau_{2}", "\\tau_{\\mathrm{wrist}}",
                                 "u_{\\tau, \\mathrm{elbow}}"});
}

TEST_CASE("two long names do not get the same symbol") {
  const CheckedModel checked = checked_model(model_text(
      "alike",
      "[[coordinate]]\nname = \"left_hip\"\n[[coordinate]]\nname = \"left_hip_\"\n[parameters]\n"
      "Ixx_hip = 1\nI_xx_hip = 2\n[energy]\n"
      "T = \"Ixx_hip*dot(left_hip)^2 + I_xx_hip*dot(left_hip_)^2\"\n"));
  const LeafValues<Formula> symbols = ModelSymbols(checked.model).leaf_symbols();
  CHECK(latex_of(symbols.v) == std::vector<std::string>{"\\dot{\\mathrm{left}}_{\\mathrm{hip}}",
                                                        "\\dot{\\mathrm{left}}_{\\mathrm{hip}}'"});
  CHECK(latex_of(symbols.parameters) ==
        std::vector<std::string>{"I_{xx, \\mathrm{hip}}", "I_{xx, \\mathrm{hip}}'"});
}

TEST_CASE("a pair of letters stays a word beside the name with an underscore") {
  const CheckedModel checked = checked_model(
      model_text("pairs",
                 "[[coordinate]]\nname = \"x\"\n[parameters]\nJm = 1\nJ_m = 2\nkf = 3\n"
                 "[energy]\nT = \"(Jm + J_m + kf)*dot(x)^2\"\n"));
  CHECK(latex_of(ModelSymbols(checked.model).leaf_symbols().parameters) ==
        std::vector<std::string>{"\\mathrm{Jm}", "J_{m}", "k_{f}"});
}

TEST_CASE("two quantities never share a symbol") {
  const CheckedModel checked = checked_model(
      model_text("alike",
                 "[sizes]\nn = 2\n[[coordinate]]\nname = \"x\"\n[[coordinate]]\nname = \"x_\"\n"
                 "[parameters]\nm1 = 1\nm_1 = 2\nl = { value = 1, size = \"n\" }\nl2 = 3\n"
                 "mass = 3\nF = { value = 1, latex = \"\\\\mathrm{mass}\" }\n"
                 "[energy]\nT = \"m1*dot(x)^2 + m_1*dot(x_)^2 + sum(i, 1, n, l[i])*mass*F*l2\"\n"));
  const ModelSymbols symbols(checked.model);
  CHECK(latex_of(symbols.leaf_symbols().q) == std::vector<std::string>{"x", "x'"});
  CHECK(latex_of(symbols.leaf_symbols().v) == std::vector<std::string>{"\\dot{x}", "\\dot{x}'"});
  CHECK(latex_of(symbols.leaf_symbols().parameters) ==
        std::vector<std::string>{"m_{1}", "m_{1}'", "l_{1}", "l_{2}", "l_{2}'", "\\mathrm{mass}",
                                 "\\mathrm{mass}'"});
  ModelSymbols more = symbols;
  CHECK(to_latex(more.make_distinct(symbol_of_name("F_quaternion"))) == "F_{\\mathrm{quaternion}}");
  CHECK(to_latex(more.make_distinct(symbol_of_name("F_quaternion_"))) ==
        "F_{\\mathrm{quaternion}}'");
  CHECK(to_mathml(read_latex("m_{1}'")) != to_mathml(read_latex("m_{1}")));
}

TEST_CASE("exponents of units are superscripts") {
  CHECK(format_unit("kg*m^2/s^-1", " ", small_exponent) == "kg m²/s⁻¹");
  CHECK(format_unit("kg^(1/2) * m", " ", small_exponent) == "kg^(1/2) m");
  CHECK(format_unit("", " ", small_exponent).empty());
}
