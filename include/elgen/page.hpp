// Page: the readable content of a model, a derivation or an analysis: formulas as trees, words as
// text. A page can be printed as text, on a screen, and as Markdown, LaTeX and HTML.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "elgen/choose.hpp"
#include "elgen/formula.hpp"
#include "elgen/frame_quantities.hpp"
#include "elgen/model.hpp"
#include "elgen/program.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// The equation name = value of an intermediate value of a function.
struct NamedFormula {
  Formula name = {};   ///< "sin_theta", "t_4f2a"
  Formula value = {};  ///< over leaves and the names of earlier values
};

struct FunctionEquations {
  std::vector<NamedFormula> definitions = {};  ///< in the order of evaluation
  std::vector<Formulas> entries = {};          ///< one list per field, row-major
};

/// A function as named definitions and entries. `names`: for each instruction a name in the model
/// language, or "" to substitute the instruction. Entries of at most 12 operations are written over
/// the leaves. Definitions that no entry needs are omitted.
[[nodiscard]] FunctionEquations function_equations(const Program& program, const Function& function,
                                                   const std::vector<std::string>& names);

/// The equations of program.functions[index] in its readable closed form, over leaves and named
/// values. Without a readable form, the equations have the names of the emitted code.
[[nodiscard]] FunctionEquations equations(const Program& program, std::size_t index);

/// The equations of program.functions[index] in the symbols of the model, for pages. Definitions of
/// at most three operations are substituted; definitions without a name are called xi_1, xi_2, ….
[[nodiscard]] FunctionEquations equations(const Model& model, const Program& program,
                                          std::size_t index);

/// The first entry of program.readable[0] over the leaves, in the symbols of the model.
[[nodiscard]] Formula first_entry_formula(const Model& model, const Program& program);

/// The matrix equation "M(q) a + C(q,v) v + g(q) = B(q) u", with constraints "+ A(q)^T lambda" on
/// the right. A term is omitted if the model cannot have it or if its function is zero. If the
/// program has neither M nor a function of v, p or a, the equation is "g(q) = B(q) u".
[[nodiscard]] Formula equation_of_motion(const Model& model, const Program& program);

/// The lines that explain the symbols of equation_of_motion(): "q = (x [m], theta [rad])"; "v =
/// dq/dt, a = dv/dt" or "at rest"; "u = (F [N])"; "lambda = (lambda_rod [N])"; and with constraints
/// the equation that the accelerations satisfy.
[[nodiscard]] std::vector<std::string> variable_lines(const Model& model, const Program& program);

/// The expression in the symbols of the model, with its names unexpanded.
[[nodiscard]] Formula expression_formula(const Model& model, ExpressionId expression);

/// A conserved quantity: the name, for example "p(phi)", and the definition.
struct ConservedQuantity {
  std::string name = {};
  Formula definition = {};
};
/// The quantities that the outputs of the program prove to be constant along every motion. The
/// energy function: if L does not contain t, no input, force or dissipation acts, and constraints
/// do no work. A momentum: if L does not contain the coordinate, and no input, force, dissipation
/// or constraint acts on the coordinate. Empty if the scene expands the equations.
[[nodiscard]] std::vector<ConservedQuantity> conserved_quantities(const Model& model,
                                                                  const Program& program);

/// A coordinate, an input, an open function or a parameter.
struct PageVariable {
  Formula symbol = {};
  std::string name = {};  ///< as in the model: "l[1..5]"
  std::string unit = {};
  std::string value = {};  ///< value of a parameter: "0.5", "2, 3"; otherwise ""
  std::string doc = {};
};

/// The equation left = a number, or left = a matrix of `rows` x `columns` entries.
struct PageEquation {
  Formula left = {};
  std::uint32_t rows = 1;
  std::uint32_t columns = 1;
  Formulas entries = {};       ///< row-major
  bool is_definition = false;  ///< true: `left` is a name that preceding equations contain
};

/// A table: `cells` row by row, with one column for each head. All heads may be empty.
struct PageTable {
  Formulas heads = {};
  Formulas cells = {};
};

/// A section of a page: a title, a text, a definition, lines, equations and a table.
struct PageSection {
  Formula title = {};         ///< "Mass matrix"; may be empty
  std::string function = {};  ///< name in code: "mass_matrix"; an equal title is printed as code
  std::optional<OutputKind> kind = {};
  std::string doc = {};     ///< text below the title, for example what the function returns
  Formula definition = {};  ///< equation that defines the function; may be empty
  Formulas lines = {};      ///< formulas and sentences before the equations
  std::vector<PageEquation> equations = {};
  PageTable table = {};
  bool is_side_by_side =
      false;  ///< true: equations are printed side by side if the screen is wide enough
  /// True: all equations, including equations in `lines`, are aligned at their relation signs.
  bool is_aligned = false;
};

struct Page {
  Formula title = {};
  std::string description = {};
  std::string reference = {};
  std::vector<std::string> notes = {};  ///< see scene_notes()
  Formula equation_of_motion = {};
  std::vector<PageVariable> coordinates = {};
  std::vector<PageVariable> inputs = {};
  std::vector<PageVariable> functions = {};  ///< open functions
  std::vector<PageVariable> parameters = {};
  std::vector<PageSection> sections = {};
};

/// The steps of a derivation, for readers.
struct ReadableDerivation {
  Program program = {};                  ///< one function per step (elgen/steps.hpp)
  std::vector<std::string> masses = {};  ///< names of the points and bodies of the step `positions`
  Program frames = {};  ///< one function for each of `frame_quantities` (FrameSteps)
  std::vector<FrameQuantity> frame_quantities = {};
  /// Forward dynamics, whose short entries end the steps; without functions if the system is too
  /// large to be solved on paper. None if the steps solve every equation, if forward dynamics does
  /// not exist, and on pages that print forward dynamics elsewhere.
  std::optional<Program> solution = {};
};

/// The programs from which pages are printed.
struct PagePrograms {
  Program program = {};  ///< the emitted functions; Program::readable has textbook forms
  std::optional<ReadableDerivation> steps = {};  ///< none: too long to read, or expanded equations
};

/// Options of a page. `dynamics` repeats other outputs and is never shown.
struct PageOptions {
  bool shows_zeros = false;        ///< true: also shows functions whose entries are all 0
  std::size_t most_entries = 200;  ///< an output with more entries is shown as its definition
  /// The steps whose equations of motion the page shows first; may be null.
  const ReadableDerivation* opening_steps = nullptr;
};

/// Sentences about the scene: its purpose, its fixed, locked and expanded variables, and the
/// outputs that `full` omits.
[[nodiscard]] std::vector<std::string> scene_notes(const Model& model, const Scene& scene);

[[nodiscard]] Page model_page(const Model& model, const Scene& scene, const Program& program,
                              const PageOptions& options = {});

/// One section per step: the action; frames and their bodies; positions; velocities; energies;
/// Lagrange's equation of each coordinate, with conserved quantities and their conditions; the
/// system of all equations. If `title` is not empty, only the section with this title.
[[nodiscard]] std::vector<PageSection> derivation_sections(const Model& model,
                                                           const ReadableDerivation& steps,
                                                           std::string_view title = {});
[[nodiscard]] Page derivation_page(const Model& model, const Scene& scene,
                                   const ReadableDerivation& steps, std::string_view title = {});

/// The titles of two sections of derivation_sections(): the energies, and the system of all
/// equations with its solution.
inline constexpr std::string_view energies_title = "Energies";
inline constexpr std::string_view equations_title = "Equations of motion";

/// A sentence on the expansion of the equations; empty for exact equations.
[[nodiscard]] std::string expansion_text(const Model& model);

/// The page of a scene as text: the equation of motion, the variables, and the entries of all
/// outputs in the model language.
[[nodiscard]] std::string text_page(const Model& model, const Scene& scene, const Program& program,
                                    const PageOptions& options = {});

/// A table with a row for each function: the cost of one call in both forms, the digits that
/// cancelling sums lose (if computed), and the form that is emitted.
[[nodiscard]] std::string cost_page(const std::vector<FormCosts>& costs);

struct Screen {
  std::size_t columns = 80;
  Alphabet alphabet = Alphabet::unicode;
};

/// The title and the sections as text in the model language, one line per entry of an equation.
[[nodiscard]] std::string text_of(const Page& page);
[[nodiscard]] std::string text_of(const std::vector<PageSection>& sections);

/// A page in two-dimensional notation, not wider than the screen. The entries of a matrix that is
/// too wide are replaced by names, which are defined below the matrix.
[[nodiscard]] std::string screen_page(const Page& page, const Screen& screen);

/// The terms of the equation of motion, on about one screen. If a matrix does not fit, its widest
/// entries are replaced by their widths: "…312" for an entry of 312 columns.
[[nodiscard]] std::string overview(const Page& page, const Screen& screen);

/// The page as GitHub Markdown with $$ blocks.
[[nodiscard]] std::string markdown_page(const Page& page);

/// The page as a complete document for pdflatex, which needs the packages amsmath and longtable.
[[nodiscard]] std::string latex_document(const Page& page);

/// The sections, or the complete page, as HTML with MathML Core.
[[nodiscard]] std::string html_sections(const std::vector<PageSection>& sections);
[[nodiscard]] std::string html_page(const Page& page);

}  // namespace elgen
