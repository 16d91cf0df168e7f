#include "formula/drawing.hpp"

#include <catch2/catch.hpp>

using namespace elgen;

namespace {

std::string drawn(const std::string& latex, Alphabet alphabet) {
  return text_of(draw_glyphs(read_latex(latex), alphabet), "");
}

}  // namespace

TEST_CASE("a formula on one line, in Unicode and in ASCII") {
  struct Row {
    std::string latex, unicode, ascii;
  };
  const std::vector<Row> rows{
      {"m l^{2}", "m l²", "m l^2"},
      {"\\frac{1}{2} m \\dot{\\theta}_{1}^{2}", "½ m θ̇₁²", "1/2 m dot(theta1)^2"},
      {"\\ddot{q}", "q̈", "ddot(q)"},
      {"-m l \\dot{\\theta} \\sin \\theta", "-m l θ̇ sin θ", "-m l dot(theta) sin theta"},
      {"\\sin \\theta \\cos \\theta", "sin θ cos θ", "sin theta cos theta"},
      {"(A - C) \\sin^{2} \\theta", "(A - C) sin² θ", "(A - C) sin^2 theta"},
      {"\\sin \\left( a + b \\right)", "sin(a + b)", "sin(a + b)"},
      {"M(q) \\ddot{q} + g(q)", "M(q) q̈ + g(q)", "M(q) ddot(q) + g(q)"},
      {"l \\left( a - b \\right)^{2}", "l (a - b)²", "l (a - b)^2"},
      {"M_{1, 2}", "M₁₂", "M12"},
      {"M_{1, 12}", "M₁,₁₂", "M1,12"},
      {"x_{\\mathrm{cart}}", "x_cart", "x_cart"},
      {"I_{xx, 3} q_{\\mathrm{hip}}", "I_xx_3 qₕᵢₚ", "I_xx_3 q_hip"},
      {"I_{xx, \\mathrm{link03}}", "I_xx_link03", "I_xx_link03"},
      {"m \\dot{\\mathrm{elbow}}_{\\mathrm{left}, 2}^{2}", "m dot(elbow_left_2)²",
       "m dot(elbow_left_2)^2"},
      {"\\ddot{\\mathrm{elbow}} + \\ddot{\\ell}", "ddot(elbow) + ℓ̈", "ddot(elbow) + ddot(ell)"},
      {"\\sqrt{x}", "√(x)", "sqrt(x)"},
      {"a \\cdot b", "a ⋅ b", "a * b"},
      {"S = \\int L dt", "S = ∫ L dt", "S = int L dt"},
      {"{\\delta} \\mathbf{q} = \\mathbf{0}", "δq = 0", "delta q = 0"},
      {"\\dot{\\mathbf{q}}^{\\top} \\boldsymbol{\\tau}", "q̇ᵀ τ", "dot(q)^T tau"},
      {"m_{1} l_{2}", "m₁ l₂", "m1 l2"},
      {"\\theta \\text{, so } p", "θ, so p", "theta, so p"},
      {"\\frac{\\partial L}{\\partial q}", "∂L\n──\n∂q", "dL\n--\ndq"},
  };
  for (const Row& row : rows) {
    INFO(row.latex);
    CHECK(drawn(row.latex, Alphabet::unicode) == row.unicode + "\n");
    CHECK(drawn(row.latex, Alphabet::ascii) == row.ascii + "\n");
  }
}

TEST_CASE("brackets grow with the fraction inside them") {
  CHECK(drawn("m \\left( 1 + \\frac{a}{b} \\right)^{2}", Alphabet::unicode) ==
        "  ⎛    a⎞²\nm ⎜1 + ─⎟\n  ⎝    b⎠\n");
}

TEST_CASE("a fraction is drawn in line on request") {
  const Glyphs tree = read_latex("\\frac{\\partial \\tau}{\\partial q}");
  CHECK(text_of(draw_glyphs(tree, Alphabet::unicode, FractionStyle::in_line), "") == "∂τ/∂q\n");
  const Glyphs rate = read_latex("\\frac{d}{dt} x + \\frac{a}{m l}");
  CHECK(text_of(draw_glyphs(rate, Alphabet::unicode, FractionStyle::in_line), "") ==
        "d/dt x + a/(m l)\n");
}

TEST_CASE("unmatched brackets are drawn unchanged") {
  CHECK(drawn("a + (b", Alphabet::unicode) == "a + (b\n");
  CHECK(drawn("b) c", Alphabet::unicode) == "b) c\n");
}

TEST_CASE("a matrix has square brackets") {
  const std::vector<TextBlock> cells{{{"a"}, 0}, {{"0"}, 0}};
  CHECK(text_of(draw_matrix(cells, 1, Alphabet::unicode), "") == "⎡ a ⎤\n⎣ 0 ⎦\n");
  CHECK(text_of(draw_matrix(cells, 2, Alphabet::ascii), "") == "[ a   0 ]\n");
}

TEST_CASE("combining accents take no column") {
  CHECK(terminal_width("θ̇₁") == 2);
  CHECK(terminal_width("q̈") == 1);
  CHECK(terminal_width("m l²") == 4);
}

TEST_CASE("blocks are aligned on one baseline") {
  const TextBlock half = stack_blocks({{"1"}, 0}, {{"2"}, 0}, "-");
  const TextBlock drawn = join_blocks(half, {{" m"}, 0});
  CHECK(text_of(drawn, "") == "1\n- m\n2\n");
  CHECK(text_of(join_blocks({{"m "}, 0}, half), "  ") == "    1\n  m -\n    2\n");
}

TEST_CASE("a fraction is as wide as its wider part") {
  CHECK(text_of(stack_blocks({{"a + b"}, 0}, {{"c"}, 0}, "-"), "") == "a + b\n-----\n  c\n");
}

TEST_CASE("cells of a grid are centred or left-aligned") {
  const std::vector<TextBlock> cells{{{"a + b"}, 0}, {{"c"}, 0}, {{"d"}, 0}, {{"e"}, 0}};
  CHECK(text_of(draw_grid(cells, 2), "") == "a + b   c\n  d     e\n");
  CHECK(text_of(draw_grid(cells, 2, Alignment::left), "") == "a + b   c\nd       e\n");
}

TEST_CASE("rows of a grid with tall cells are separated by a blank line") {
  const TextBlock half = stack_blocks({{"1"}, 0}, {{"2"}, 0}, "-");
  CHECK(text_of(draw_grid({half, {{"x"}, 0}}, 1), "") == "1\n-\n2\n\nx\n");
}

TEST_CASE("brackets are as high as their neighbour") {
  CHECK(text_of(draw_bracket("(", {{"x"}, 0}, Alphabet::ascii), "") == "(\n");
  CHECK(text_of(draw_bracket("(", {{"x", "y", "z"}, 1}, Alphabet::ascii), "") == "/\n|\n\\\n");
}
