// screen_page: a sheet as a terminal shows it, and the part of it that fits one screen.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "elgen/render.hpp"
#include "render/display.hpp"
#include "render/drawing.hpp"
#include "render/symbols.hpp"

namespace elgen {
namespace {

constexpr std::string_view page_indent = "  ";

template <Alphabet alphabet, Fractions fractions>
double drawn_width(const LatexTree& tree) {
  return static_cast<double>(drawing(tree, alphabet, fractions).width());
}

template <Alphabet alphabet>
PageShape shape_of(const Screen& screen) {
  return {static_cast<double>(screen.columns - page_indent.size()),
          &drawn_width<alphabet, Fractions::stacked>, &drawn_width<alphabet, Fractions::in_line>,
          3};
}

/// Formulas in the alphabet of a screen, no wider than it is.
class ScreenDrawing {
 public:
  explicit ScreenDrawing(const Screen& screen)
      : alphabet_(screen.alphabet),
        shape_(screen.alphabet == Alphabet::unicode ? shape_of<Alphabet::unicode>(screen)
                                                    : shape_of<Alphabet::ascii>(screen)) {}

  [[nodiscard]] std::string formula(const std::string& latex) const {
    return text_of(draw(latex), page_indent);
  }

 protected:
  static constexpr std::size_t most_lines = 9;  ///< of one matrix on the first screen

  [[nodiscard]] bool is_unicode() const { return alphabet_ == Alphabet::unicode; }

  /// "kg*m^2" -> "kg m²"
  [[nodiscard]] std::string unit(const std::string& text) const {
    return is_unicode() ? unit_text(text, " ", small_exponent) : text;
  }

  [[nodiscard]] bool fits(const Block& drawn) const {
    return static_cast<double>(drawn.width()) <= shape_.width && drawn.lines.size() <= most_lines;
  }

  [[nodiscard]] Block equated(const std::string& left, const Block& right,
                              std::size_t least = 0) const {
    const Block drawn = draw(left, Fractions::in_line);
    const std::size_t missing = least - std::min(least, drawn.width());
    return beside(beside({{std::string(missing, ' ')}, 0}, beside(drawn, {{" = "}, 0})), right);
  }

  [[nodiscard]] Block draw(const std::string& latex,
                           Fractions fractions = Fractions::stacked) const {
    return drawing(read_latex(latex), alphabet_, fractions);
  }

  [[nodiscard]] Block matrix_of(const SheetEquation& equation,
                                const std::vector<Block>& cells) const {
    if (cells.size() == 1) return cells.front();
    return matrix_drawing(cells, equation.columns, alphabet_);
  }

  Alphabet alphabet_;
  PageShape shape_;
};

/// The parts of an overview.
class Overview : public ScreenDrawing {
 public:
  using ScreenDrawing::ScreenDrawing;

  /// "q = (x [m], θ [rad])"
  [[nodiscard]] std::string tuple(std::string_view name,
                                  const std::vector<SheetVariable>& list) const {
    std::string text;
    for (const SheetVariable& v : list) {
      const Block symbol = draw(v.symbol);
      text +=
          fmt::format("{}{}{}", text.empty() ? "" : ", ", symbol.lines[symbol.base],
                      v.unit == "1" || v.unit.empty() ? "" : fmt::format(" [{}]", unit(v.unit)));
    }
    return fmt::format("{} = ({})", name, text);
  }

  /// The matrix on one screen: its widest entries are folded until it fits, and all of it where
  /// that is not enough.
  [[nodiscard]] std::string folded(const SheetEquation& equation) const {
    std::vector<Block> cells;
    for (const std::string& entry : equation.entries) cells.push_back(draw(entry));
    for (std::size_t folds = 0; folds <= cells.size(); ++folds) {
      const Block drawn = equated(equation.left, matrix_of(equation, cells));
      if (fits(drawn)) return text_of(drawn, page_indent);
      Block& widest = *std::ranges::max_element(cells, {}, &Block::width);
      widest = {{fmt::format("{}{}", is_unicode() ? "…" : "...", widest.width())}, 0};
    }
    const auto zeros = std::ranges::count(equation.entries, "0");
    const std::string size =
        fmt::format("{} x {} entries, {} of them 0", equation.rows, equation.columns, zeros);
    return text_of(equated(equation.left, {{size}, 0}), page_indent);
  }
};

class ScreenPage : public ScreenDrawing {
 public:
  using ScreenDrawing::ScreenDrawing;

  [[nodiscard]] std::string title(const std::string& title, const std::string& latex) const {
    return latex.empty() ? title + "\n" : text_of(draw(latex, Fractions::in_line), "");
  }

  [[nodiscard]] std::string line(const std::string& latex) const {
    return text_of(draw(latex, Fractions::in_line), page_indent);
  }

  /// Symbol, value and unit, what it is: a line each.
  [[nodiscard]] std::string variables(const std::vector<SheetVariable>& list) const {
    std::vector<Block> cells;
    for (const SheetVariable& v : list) {
      const std::string value = v.value.empty() ? "" : "= " + v.value;
      const std::string in_unit = v.unit == "1" ? "" : unit(v.unit);
      const char* const between = value.empty() || in_unit.empty() ? "" : " ";
      cells.push_back(draw(v.symbol));
      cells.push_back({{fmt::format("{}{}{}", value, between, in_unit)}, 0});
      cells.push_back({{v.doc}, 0});
    }
    return text_of(grid(cells, 3, Alignment::left), page_indent);
  }

  [[nodiscard]] std::string table(const SheetTable& table) const {
    if (table.heads.empty()) return {};
    const bool has_heads =
        std::ranges::any_of(table.heads, [](const std::string& head) { return !head.empty(); });
    std::vector<Block> cells;
    for (const auto* const list : {&table.heads, &table.cells}) {
      if (list == &table.heads && !has_heads) continue;
      for (const std::string& latex : *list) cells.push_back(draw(latex, Fractions::in_line));
    }
    return text_of(grid(cells, table.heads.size(), Alignment::left), page_indent);
  }

  [[nodiscard]] std::string equations(const SheetOutput& output) const {
    const bool is_row = output.is_row && !output.equations.empty();
    std::string text = is_row ? row(output.equations) : "";
    if (!text.empty()) return text;
    const std::vector<SheetEquation>& all = output.equations;
    if (!output.is_aligned) {
      for (const SheetEquation& each : all) text += equation(each);
      return text;
    }
    for (const DisplayBlock& block : aligned_blocks(all, shape_)) text += aligned(block);
    return text;
  }

 private:
  [[nodiscard]] std::string equation(const SheetEquation& equation) const {
    const bool is_list = is_listed(equation, shape_);
    if (is_list && equation.columns > 1) {
      const auto [matrix, named] = named_entries(equation, shape_);
      if (fits_as_matrix(matrix, shape_)) {
        const Display names{matrix.left, matrix.columns, matrix.entries};
        return display(names, Fractions::in_line) + list(named);
      }
    }
    const bool leaves_out = leaves_out_zeros(equation, shape_);
    return list(equation) +
           (leaves_out ? fmt::format("{}all other entries are 0\n", page_indent) : "");
  }

  /// All equations side by side; empty where that is too wide, or one is no matrix that fits.
  [[nodiscard]] std::string row(const std::vector<SheetEquation>& equations) const {
    Block all;
    for (const SheetEquation& equation : equations) {
      std::vector<Block> cells;
      for (const std::string& entry : equation.entries) cells.push_back(draw(entry));
      if (all.width() > 0) all = beside(all, {{"  "}, 0});
      all = beside(all, equated(equation.left, matrix_of(equation, cells)));
    }
    return fits(all) ? text_of(all, page_indent) : "";
  }

  [[nodiscard]] std::string list(const SheetEquation& equation) const {
    std::string text;
    for (const Display& part : displays(equation, shape_)) text += display(part);
    return text;
  }

  /// `left` are the columns of the longest left side of a block; lines go on behind it.
  [[nodiscard]] std::string display(const Display& part, Fractions fractions = Fractions::stacked,
                                    std::size_t left = 0) const {
    std::vector<Block> rights;
    for (const std::string& latex : part.texts) {
      const bool continues = part.columns == 0 && !rights.empty();
      rights.push_back(draw(continues ? "{} " + latex : latex, fractions));
    }
    if (part.columns > 0) rights = {matrix_drawing(rights, part.columns, alphabet_)};
    std::string text;
    for (const Block& right : rights) {
      const bool is_first = text.empty();
      const bool is_alone = is_first && part.left.empty();
      const Block behind{{std::string(left + 3, ' ')}, 0};
      text += text_of(is_alone   ? right
                      : is_first ? equated(part.left, right, left)
                                 : beside(behind, right),
                      page_indent);
    }
    return text;
  }

  [[nodiscard]] std::string aligned(const DisplayBlock& block) const {
    std::size_t left = 0;
    for (const Display& part : block) {
      left = std::max(left, draw(part.left, Fractions::in_line).width());
    }
    std::string text;
    for (const Display& part : block) text += display(part, Fractions::stacked, left);
    return text;
  }
};

/// The terms of the equation of motion, in its order.
constexpr std::array overview_outputs{OutputKind::mass_matrix, OutputKind::velocity_force,
                                      OutputKind::drift,       OutputKind::gravity,
                                      OutputKind::dissipation, OutputKind::applied_force};

std::vector<const SheetOutput*> shown_first(const Sheet& sheet) {
  std::vector<const SheetOutput*> shown;
  for (const OutputKind kind : overview_outputs) {
    for (const SheetOutput& output : sheet.outputs) {
      const bool says = !output.equations.empty() || !output.definition.empty();
      if (output.kind == kind && says) shown.push_back(&output);
    }
  }
  if (!shown.empty()) return shown;
  for (const SheetOutput& output : sheet.outputs) {
    if (!output.equations.empty() && shown.size() < 3) shown.push_back(&output);
  }
  return shown;
}

}  // namespace

std::string screen_page(const Sheet& sheet, const Screen& screen) {
  const ScreenPage page(screen);
  std::string text = page.title(sheet.title, sheet.title_latex);
  for (const std::string& note : sheet.notes) text += note + "\n";
  if (!sheet.equation_of_motion.empty()) text += "\n" + page.formula(sheet.equation_of_motion);
  for (const auto* const list :
       {&sheet.coordinates, &sheet.inputs, &sheet.functions, &sheet.parameters}) {
    if (!list->empty()) text += "\n" + page.variables(*list);
  }
  for (const SheetOutput& output : sheet.outputs) {
    text += "\n";
    if (!output.title.empty()) text += page.title(output.title, output.title_latex);
    if (!output.doc.empty()) text += fmt::format("  {}\n", output.doc);
    const bool is_defined_alone = output.equations.empty() && !output.definition.empty();
    if (is_defined_alone) text += page.formula(output.definition);
    for (const std::string& line : output.lines) text += page.line(line);
    text += page.equations(output) + page.table(output.table);
  }
  return text;
}

std::string overview(const Sheet& sheet, const Screen& screen) {
  const Overview page(screen);
  std::string text = fmt::format("{}\n\n{}", sheet.title, page.formula(sheet.equation_of_motion));
  text += fmt::format("  {}\n", page.tuple("q", sheet.coordinates));
  if (!sheet.inputs.empty()) text += fmt::format("  {}\n", page.tuple("u", sheet.inputs));
  for (const SheetOutput* const output : shown_first(sheet)) {
    text += "\n";
    if (output->equations.empty()) text += page.formula(output->definition);
    for (const SheetEquation& equation : output->equations) text += page.folded(equation);
  }
  return text;
}

}  // namespace elgen
