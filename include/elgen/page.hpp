// Page: what is worth reading of a model, a derivation or an analysis, printed as text, on a
// screen, as Markdown, LaTeX and HTML.
//
// A page has formulas as trees and words as text; all its notations are printed from them.
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

/// A function as named definitions and entries over them: an instruction used more than once, or
/// that carries a name, is a definition; everything else is written out where it is used. An entry
/// of at most 12 operations is written out over the leaves; only definitions that other entries
/// need are listed. `names` are "" where something is written out; names are those of the model
/// language.
[[nodiscard]] FunctionEquations equations(const Program& program, const Function& function,
                                          const std::vector<std::string>& names);

/// The closed form of functions[index] with every entry written out over the leaves, where there is
/// one to read; else the same with the names of code.
[[nodiscard]] FunctionEquations equations(const Program& program, std::size_t index);

/// The same for pages, in the symbols of the model: definitions of at most three operations are
/// written out, and those without a name of their own are xi_1, xi_2, ….
[[nodiscard]] FunctionEquations equations(const Model& model, const Program& program,
                                          std::size_t index);

/// The first entry of readable[0], written out, in the symbols of the model.
[[nodiscard]] Formula first_entry(const Model& model, const Program& program);

/// "M(q) a + C(q,v) v + g(q) = B(q) u", "+ A(q)^T lambda" where there are constraints: a term is
/// left out where the model cannot have it, or where the function that would hold it is there and
/// is zero. Where no function knows of motion, the equation is that at rest: "g(q) = B(q) u".
[[nodiscard]] Formula equation_of_motion(const Model& model, const Program& program);

/// "q = (x [m], theta [rad])", "v = dq/dt, a = dv/dt" or "at rest", "u = (F [N])", "lambda =
/// (lambda_rod [N])" and what the accelerations obey: a line each.
[[nodiscard]] std::vector<std::string> variable_lines(const Model& model, const Program& program);

/// A conserved quantity: "p(phi)", and its equation.
struct ConservedQuantity {
  std::string name = {};
  Formula definition = {};
};
/// The energy function and the momenta of cyclic coordinates that are constant along every motion,
/// as far as the outputs of the program prove it: L contains no t, or not the coordinate, and no
/// input, force, dissipation or constraint acts. None of a scene that expands the equations.
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

/// Cells, row by row, below the heads of their columns, all of which may be empty.
struct PageTable {
  Formulas heads = {};
  Formulas cells = {};
};

/// A part of a page, a paragraph or more.
struct PageSection {
  Formula title = {};         ///< "Mass matrix"; may be empty
  std::string function = {};  ///< in code: "mass_matrix"; shown where it is the title
  std::optional<OutputKind> kind = {};
  std::string doc = {};     ///< what it is, in a sentence
  Formula definition = {};  ///< how it is defined; may be empty
  Formulas lines = {};      ///< a formula or a sentence each, before equations
  std::vector<PageEquation> equations = {};
  PageTable table = {};
  bool is_row = false;  ///< equations stand side by side where the screen is wide enough
  /// Equations, and those lines that are some, stand below each other, aligned at their signs.
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
  std::vector<PageVariable> functions = {};  ///< left open
  std::vector<PageVariable> parameters = {};
  std::vector<PageSection> sections = {};
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
  std::size_t most_entries = 200;  ///< of a page: longer outputs stand by their definition alone
  const ReadableSteps* opening = nullptr;  ///< its equations of motion come first
};

/// The contents of a scene beyond a choice of outputs, in sentences: its purpose, what it fixes,
/// what it locks, what it expands, and which outputs `full` leaves out.
[[nodiscard]] std::vector<std::string> scene_notes(const Model& model, const Scene& scene);

/// Everything that is worth reading of a model.
[[nodiscard]] Page model_page(const Model& model, const Scene& scene, const Program& program,
                              const PageOptions& options = {});

/// The action, positions, velocities, energies, Lagrange's equation of every coordinate, and what
/// is conserved under which condition, and the rows once more: one section per step, or the one of
/// a title.
[[nodiscard]] std::vector<PageSection> steps_sections(const Model& model,
                                                      const ReadableSteps& steps,
                                                      std::string_view title = {});
[[nodiscard]] Page steps_page(const Model& model, const Scene& scene, const ReadableSteps& steps,
                              std::string_view title = {});

/// The sections of T, V and L, and of the rows with what they are solved for.
inline constexpr std::string_view energies_title = "Energies";
inline constexpr std::string_view equations_title = "Equations of motion";

/// The effect of a scene's expansion on the equations, a sentence; empty where they are exact.
[[nodiscard]] std::string expansion_text(const Model& model);

/// The equation of motion, the variables, and every entry of every output in the model language.
[[nodiscard]] std::string text_page(const Model& model, const Scene& scene, const Program& program,
                                    const PageOptions& options = {});

/// The cost of one call of every function in either form, the digits that it may lose where sums
/// cancel, as far as that was asked, and the form that is emitted.
[[nodiscard]] std::string cost_page(const std::vector<FormCosts>& costs);

struct Screen {
  std::size_t columns = 80;
  Alphabet alphabet = Alphabet::unicode;
};

/// In the model language, one line for each entry of an equation: the title and the sections.
[[nodiscard]] std::string text_of(const Page& page);
[[nodiscard]] std::string text_of(const std::vector<PageSection>& sections);

/// Matrices in two dimensions, never wider than the screen: of a matrix too wide its entries get
/// names, and what they are stands below it.
[[nodiscard]] std::string screen_page(const Page& page, const Screen& screen);

/// The terms of the equation of motion on one screen; a formula that does not fit is folded: "…312"
/// stands for one of 312 characters.
[[nodiscard]] std::string overview(const Page& page, const Screen& screen);

/// GitHub Markdown with blocks of $$.
[[nodiscard]] std::string markdown_page(const Page& page);

/// A complete document for pdflatex; needs amsmath and longtable.
[[nodiscard]] std::string latex_document(const Page& page);

/// A complete page of HTML with MathML Core.
[[nodiscard]] std::string html_page(const Page& page);

}  // namespace elgen
