// Page: the readable content of a model, a derivation or an analysis, printed as text, on screens,
// as Markdown, LaTeX and HTML.
//
// A page has formulas as trees and words as text. All notations are printed from it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "elgen/choose.hpp"
#include "elgen/formula.hpp"
#include "elgen/model.hpp"
#include "elgen/program.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// One named value of a function, as an equation to read.
struct NamedFormula {
  Formula name = {};   ///< "sin_theta", "t_4f2a"
  Formula value = {};  ///< over leaves and earlier names
};

struct FunctionEquations {
  std::vector<NamedFormula> definitions = {};  ///< in the order of evaluation
  std::vector<Formulas> entries = {};          ///< one list per field, row-major
};

/// A function as named definitions and entries. Instructions that are used more than once or carry
/// a name are definitions; others are written out where they are used. Entries of at most 12
/// operations are written out over the leaves; definitions are listed if other entries need them.
/// `names` has "" for instructions to be written out, else names of the model language.
[[nodiscard]] FunctionEquations equations(const Program& program, const Function& function,
                                          const std::vector<std::string>& names);

/// The closed form of functions[index], each entry written out over the leaves, if there is a
/// readable one; else the function with the names of code.
[[nodiscard]] FunctionEquations equations(const Program& program, std::size_t index);

/// The same in the symbols of the model, for pages. Definitions of at most three operations are
/// written out; others without their own name are xi_1, xi_2, ….
[[nodiscard]] FunctionEquations equations(const Model& model, const Program& program,
                                          std::size_t index);

/// The first entry of readable[0], written out, in the symbols of the model.
[[nodiscard]] Formula first_entry(const Model& model, const Program& program);

/// "M(q) a + C(q,v) v + g(q) = B(q) u", "+ A(q)^T lambda" with constraints. A term is left out if
/// the model cannot have it, or its function exists and is zero. If no function depends on motion,
/// the equation is that at rest: "g(q) = B(q) u".
[[nodiscard]] Formula equation_of_motion(const Model& model, const Program& program);

/// "q = (x [m], theta [rad])", "v = dq/dt, a = dv/dt" or "at rest", "u = (F [N])", "lambda =
/// (lambda_rod [N])" and the equation of the accelerations, one line each.
[[nodiscard]] std::vector<std::string> variable_lines(const Model& model, const Program& program);

/// A conserved quantity "p(phi)" and its equation.
struct ConservedQuantity {
  std::string name = {};
  Formula definition = {};
};
/// The energy function and the momenta of cyclic coordinates that are constant along every motion,
/// if the outputs of the program prove it: L contains no t, or not the coordinate, and no input,
/// force, dissipation or constraint acts. Empty for scenes that expand the equations.
[[nodiscard]] std::vector<ConservedQuantity> conserved_quantities(const Model& model,
                                                                  const Program& program);

/// A coordinate, an input, an open function or a parameter.
struct PageVariable {
  Formula symbol = {};
  std::string name = {};  ///< as in the model; "l[1..5]"
  std::string unit = {};
  std::string value = {};  ///< of parameters: "0.5", "2, 3"
  std::string doc = {};
};

/// `left` = a number, or a matrix of `rows` x `columns` entries.
struct PageEquation {
  Formula left = {};
  std::uint32_t rows = 1;
  std::uint32_t columns = 1;
  Formulas entries = {};       ///< row-major
  bool is_definition = false;  ///< of a name in the equations before it
};

/// Cells row by row, below column heads, which may all be empty.
struct PageTable {
  Formulas heads = {};
  Formulas cells = {};
};

/// A part of a page: one or more paragraphs.
struct PageSection {
  Formula title = {};         ///< "Mass matrix"; may be empty
  std::string function = {};  ///< name in code: "mass_matrix"; shown as the title
  std::optional<OutputKind> kind = {};
  std::string doc = {};     ///< a sentence on its meaning
  Formula definition = {};  ///< its definition; may be empty
  Formulas lines = {};      ///< formulas and sentences before the equations
  std::vector<PageEquation> equations = {};
  PageTable table = {};
  bool is_row = false;  ///< equations are side by side if the screen is wide enough
  /// Equations, including those among the lines, are aligned at their signs.
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
  std::vector<PageVariable> functions = {};  ///< declared without a formula
  std::vector<PageVariable> parameters = {};
  std::vector<PageSection> sections = {};
};

/// The steps of a derivation for readers.
struct ReadableSteps {
  Program program = {};                    ///< the functions of elgen/steps.hpp
  std::vector<std::string> masses = {};    ///< the names of the fields of "positions"
  std::vector<std::string> left_out = {};  ///< points and bodies with mass that are not in `masses`
};

/// The content of pages.
struct Book {
  Program program = {};                     ///< that of the code, with `readable` in textbook form
  std::optional<ReadableSteps> steps = {};  ///< none if the derivation is too long to be read
};

/// The functions of a program that a page shows. `dynamics` repeats others and is never shown.
struct PageOptions {
  bool zeros = false;                      ///< functions whose entries are all 0
  std::size_t most_entries = 200;          ///< outputs with more entries are shown by definition
  const ReadableSteps* opening = nullptr;  ///< their equations of motion come first
};

/// Sentences on a scene beyond its choice of outputs: its purpose, what it fixes, locks and
/// expands, and which outputs `full` leaves out.
[[nodiscard]] std::vector<std::string> scene_notes(const Model& model, const Scene& scene);

/// The page of a model.
[[nodiscard]] Page model_page(const Model& model, const Scene& scene, const Program& program,
                              const PageOptions& options = {});

/// One section per step: the action, positions, velocities, energies, Lagrange's equation of every
/// coordinate with its conserved quantities and their conditions, and all rows together; or only
/// the section with the given title.
[[nodiscard]] std::vector<PageSection> steps_sections(const Model& model,
                                                      const ReadableSteps& steps,
                                                      std::string_view title = {});
[[nodiscard]] Page steps_page(const Model& model, const Scene& scene, const ReadableSteps& steps,
                              std::string_view title = {});

/// The titles of the sections of energies, and of the rows with their solution.
inline constexpr std::string_view energies_title = "Energies";
inline constexpr std::string_view equations_title = "Equations of motion";

/// A sentence on the expansion that a scene applies to the equations; empty for exact ones.
[[nodiscard]] std::string expansion_text(const Model& model);

/// The equation of motion, the variables, and all entries of all outputs in the model language.
[[nodiscard]] std::string text_page(const Model& model, const Scene& scene, const Program& program,
                                    const PageOptions& options = {});

/// The cost of one call of each function in both forms, the digits lost where sums cancel if they
/// were computed, and the emitted form.
[[nodiscard]] std::string cost_page(const std::vector<FormCosts>& costs);

struct Screen {
  std::size_t columns = 80;
  Alphabet alphabet = Alphabet::unicode;
};

/// The title and the sections in the model language, one line per entry of an equation.
[[nodiscard]] std::string text_of(const Page& page);
[[nodiscard]] std::string text_of(const std::vector<PageSection>& sections);

/// A page in two-dimensional notation, at most as wide as the screen. The entries of a matrix that
/// is too wide get names, which are defined below it.
[[nodiscard]] std::string screen_page(const Page& page, const Screen& screen);

/// The terms of the equation of motion on one screen. Formulas that do not fit are folded: "…312"
/// stands for 312 characters.
[[nodiscard]] std::string overview(const Page& page, const Screen& screen);

/// GitHub Markdown with $$ blocks.
[[nodiscard]] std::string markdown_page(const Page& page);

/// A complete document for pdflatex; needs amsmath and longtable.
[[nodiscard]] std::string latex_document(const Page& page);

/// The sections as parts of a page of HTML with MathML Core, and a complete page.
[[nodiscard]] std::string html_parts(const std::vector<PageSection>& sections);
[[nodiscard]] std::string html_page(const Page& page);

}  // namespace elgen
