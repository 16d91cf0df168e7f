// Equations of a Program as a reader sees them: in the language of models, in LaTeX, and as pages.
//
// A page shows a Sheet: formulas in LaTeX, everything else plain text. MathML is translated from
// the LaTeX, so that all pages show the same.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "elgen/choose.hpp"
#include "elgen/model.hpp"
#include "elgen/program.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// One named value of a function, as an equation to read.
struct EquationLine {
  std::string name;   ///< "sin_theta", "t_4f2a"
  std::string value;  ///< over leaves and earlier names
};

struct FunctionEquations {
  std::vector<EquationLine> definitions = {};          ///< in the order of evaluation
  std::vector<std::vector<std::string>> entries = {};  ///< one list per field, row-major
};

/// Prints a function in the model language as named definitions and entries over them: an
/// instruction used more than once, or that carries a name, is a definition; everything else is
/// written out where it is used. An entry of at most 12 operations is written out over the leaves;
/// only definitions that other entries need are listed.
[[nodiscard]] FunctionEquations equations(const Program& program, const Function& function);
/// The same with other names than temporary_names: "" where something is written out.
[[nodiscard]] FunctionEquations equations(const Program& program, const Function& function,
                                          const std::vector<std::string>& names);

/// The closed form of functions[index] with every entry written out over the leaves, where there is
/// one to read; else what `equations` gives.
[[nodiscard]] FunctionEquations readable_equations(const Program& program, std::size_t index);

/// The same in LaTeX.
[[nodiscard]] FunctionEquations latex_equations(const Model& model, const Program& program,
                                                std::size_t index);
/// The equations of a function whose definitions have these names.
[[nodiscard]] FunctionEquations latex_equations(const Model& model, const Program& program,
                                                const Function& function,
                                                const std::vector<std::string>& names);

/// "M(q) a + C(q,v) v + g(q) = B(q) u", "+ A(q)^T lambda" where there are constraints, and the same
/// in LaTeX: a term is left out where the model cannot have it, or where the function that would
/// hold it is there and is zero. Where no function knows of motion, the equation is that at rest:
/// "g(q) = B(q) u".
struct EquationOfMotion {
  std::string text = {};
  std::string latex = {};
};
[[nodiscard]] EquationOfMotion equation_of_motion(const Model& model, const Program& program);

/// "q = (x [m], theta [rad])", "v = dq/dt, a = dv/dt" or "at rest", "u = (F [N])", "lambda =
/// (lambda_rod [N])" and what the accelerations obey: a line each.
[[nodiscard]] std::vector<std::string> variable_lines(const Model& model, const Program& program);

/// A conserved quantity: "p(phi)", and in LaTeX what it is.
struct ConservedQuantity {
  std::string name = {};
  std::string definition = {};
};
/// The energy function and the momenta of cyclic coordinates that are constant along every motion,
/// as far as the outputs of the program prove it: L contains no t, or not the coordinate, and no
/// input, force, dissipation or constraint acts. None of a scene that expands the equations.
[[nodiscard]] std::vector<ConservedQuantity> conserved_quantities(const Model& model,
                                                                  const Program& program);

/// Whether some function is about more than positions and forces at rest.
[[nodiscard]] bool knows_motion(const Model& model, const Program& program);

/// A coordinate, an input, an open function or a parameter.
struct SheetVariable {
  std::string symbol = {};  ///< LaTeX
  std::string name = {};    ///< as in the model; "l[1..5]"
  std::string unit = {};
  std::string value = {};  ///< of parameters: "0.5", "2, 3"
  std::string doc = {};
};

/// `left` = a number, or a matrix of `rows` x `columns` entries. All of it LaTeX.
struct SheetEquation {
  std::string left = {};
  std::uint32_t rows = 1;
  std::uint32_t columns = 1;
  std::vector<std::string> entries = {};
};

/// Cells in LaTeX, row by row, below the heads of their columns, all of which may be empty.
struct SheetTable {
  std::vector<std::string> heads = {};
  std::vector<std::string> cells = {};
};

/// In titles, lines and cells \text{…} outside of braces is prose, and all else is formulas.
struct SheetOutput {
  std::string title = {};     ///< "Mass matrix"; may be empty
  std::string function = {};  ///< in code: "mass_matrix"; shown where it is the title
  std::optional<OutputKind> kind = {};
  std::string doc = {};         ///< what it is, in a sentence
  std::string definition = {};  ///< LaTeX: how it is defined; may be empty
  std::vector<SheetEquation> equations = {};
  std::vector<std::string> lines = {};  ///< LaTeX, a formula or a sentence each, before equations
  SheetTable table = {};
  bool is_row = false;           ///< equations stand side by side where the screen is wide enough
  std::string title_latex = {};  ///< the title with its formulas; may be empty
  /// Equations, and those lines that are some, stand below each other, aligned at their signs.
  bool is_aligned = false;
};

/// The contents of a page: everything that is worth reading of a model.
struct Sheet {
  std::string title = {};
  std::string description = {};
  std::string reference = {};
  std::vector<std::string> notes = {};  ///< see scene_notes()
  std::string equation_of_motion = {};  ///< LaTeX
  std::vector<SheetVariable> coordinates = {};
  std::vector<SheetVariable> inputs = {};
  std::vector<SheetVariable> functions = {};  ///< left open
  std::vector<SheetVariable> parameters = {};
  std::vector<SheetOutput> outputs = {};
  std::string title_latex = {};  ///< the title with its formulas; may be empty
};

/// A derivation step by step, as it is read.
struct ReadableSteps {
  Program program = {};                    ///< the functions of elgen/steps.hpp
  std::vector<std::string> masses = {};    ///< the names of the fields of "positions"
  std::vector<std::string> left_out = {};  ///< points and bodies with a mass that are none of these
};

/// The content of pages.
struct Book {
  Program program = {};  ///< that of the code; its `readable` is written as books do
  std::optional<ReadableSteps> steps = {};  ///< none where the derivation is too long to be read
};

/// Which functions of a program a page shows. `dynamics` repeats the others and is never shown.
struct PageOptions {
  bool zeros = false;              ///< functions whose entries are all 0
  std::size_t most_entries = 200;  ///< of a sheet: longer outputs stand by their definition alone
  const ReadableSteps* opening = nullptr;  ///< its equations of motion come first
};

/// The contents of a scene beyond a choice of outputs, in sentences: its purpose, what it fixes,
/// what it locks, what it expands, and which outputs `full` leaves out.
[[nodiscard]] std::vector<std::string> scene_notes(const Model& model, const Scene& scene);

[[nodiscard]] Sheet sheet(const Model& model, const Scene& scene, const Program& program,
                          const PageOptions& options = {});

/// The action, positions, velocities, energies, Lagrange's equation of every coordinate, and what
/// is conserved under which condition, and the rows once more: one section per step, or the one of
/// a title.
[[nodiscard]] std::vector<SheetOutput> steps_sections(const Model& model,
                                                      const ReadableSteps& steps,
                                                      std::string_view title = {});
[[nodiscard]] Sheet steps_sheet(const Model& model, const Scene& scene, const ReadableSteps& steps,
                                std::string_view title = {});

/// The sections of T, V and L, and of the rows with what they are solved for.
inline constexpr std::string_view energies_title = "Energies";
inline constexpr std::string_view equations_title = "Equations of motion";

/// The same in the model language; of one section where its title is given.
[[nodiscard]] std::string steps_text(const Model& model, const ReadableSteps& steps,
                                     std::string_view title = {});

/// The effect of a scene's expansion on the equations, a sentence; empty where they are exact.
[[nodiscard]] std::string expansion_text(const Model& model);

/// True where every entry of the function is 0.
[[nodiscard]] bool is_zero(const Program& program, const Function& function);

/// The equation of motion, the variables, and every entry of every output in the model language.
[[nodiscard]] std::string text_page(const Model& model, const Scene& scene, const Program& program,
                                    const PageOptions& options = {});

/// The cost of one call of every function in either form, the digits that it may lose where sums
/// cancel, as far as that was asked, and the form that is emitted.
[[nodiscard]] std::string cost_page(const std::vector<FormCosts>& costs);

/// The characters that a terminal can show.
enum class Alphabet : std::uint8_t {
  unicode,  ///< θ̇₁², √, ½
  ascii     ///< dot(theta1)^2, sqrt, 1/2
};

struct Screen {
  std::size_t columns = 80;
  Alphabet alphabet = Alphabet::unicode;
};

/// Matrices in two dimensions, never wider than the screen: of a matrix too wide its entries get
/// names, and what they are stands below it.
[[nodiscard]] std::string screen_page(const Sheet& sheet, const Screen& screen);

/// The terms of the equation of motion on one screen; a formula that does not fit is folded: "…312"
/// stands for one of 312 characters.
[[nodiscard]] std::string overview(const Sheet& sheet, const Screen& screen);

/// GitHub Markdown with blocks of $$.
[[nodiscard]] std::string markdown_page(const Sheet& sheet);

/// A complete document for pdflatex; needs amsmath and longtable.
[[nodiscard]] std::string latex_document(const Sheet& sheet);

/// A complete page of HTML with MathML Core.
[[nodiscard]] std::string html_page(const Sheet& sheet);

}  // namespace elgen
