// screen_page: a sheet as a terminal shows it, and the part of it that fits one screen.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "elgen/render.hpp"
#include "render/display.hpp"
#include "render/drawing.hpp"

namespace elgen {
namespace {

constexpr std::string_view page_indent = "  ";

template <Alphabet alphabet>
double drawn_width(const LatexTree& tree) {
  return static_cast<double>(drawing(tree, alphabet).width());
}

class ScreenPage {
 public:
  explicit ScreenPage(const Screen& screen)
      : alphabet_(screen.alphabet),
        shape_{static_cast<double>(screen.columns - page_indent.size()),
               screen.alphabet == Alphabet::unicode ? &drawn_width<Alphabet::unicode>
                                                    : &drawn_width<Alphabet::ascii>,
               3} {}

  [[nodiscard]] std::string formula(const std::string& latex) const {
    return text_of(draw(latex), page_indent);
  }

  [[nodiscard]] std::string title(const std::string& latex) const {
    return text_of(draw(latex, Fractions::in_line), "");
  }

  [[nodiscard]] std::string line(const std::string& latex) const {
    return text_of(draw(latex, Fractions::in_line), page_indent);
  }

  /// Symbol, value and unit, what it is: a line each.
  [[nodiscard]] std::string variables(const std::vector<SheetVariable>& list) const {
    std::vector<Block> cells;
    for (const SheetVariable& v : list) {
      const std::string value = v.value.empty() ? "" : "= " + v.value;
      const std::string unit = v.unit == "1" ? "" : unit_text(v.unit);
      const char* const between = value.empty() || unit.empty() ? "" : " ";
      cells.push_back(draw(v.symbol));
      cells.push_back({{fmt::format("{}{}{}", value, between, unit)}, 0});
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

  /// "q = (x [m], θ [rad])"
  [[nodiscard]] std::string tuple(std::string_view name,
                                  const std::vector<SheetVariable>& list) const {
    std::string text;
    for (const SheetVariable& v : list) {
      const Block symbol = draw(v.symbol);
      text += fmt::format(
          "{}{}{}", text.empty() ? "" : ", ", symbol.lines[symbol.base],
          v.unit == "1" || v.unit.empty() ? "" : fmt::format(" [{}]", unit_text(v.unit)));
    }
    return fmt::format("{} = ({})", name, text);
  }

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

 private:
  static constexpr std::size_t most_lines = 9;  ///< of one matrix on the first screen

  [[nodiscard]] bool is_unicode() const { return alphabet_ == Alphabet::unicode; }

  /// "kg*m^2" -> "kg m²"
  [[nodiscard]] std::string unit_text(std::string unit) const {
    if (!is_unicode()) return unit;
    std::ranges::replace(unit, '*', ' ');
    return with_small_exponents(unit);
  }

  [[nodiscard]] bool fits(const Block& drawn) const {
    return static_cast<double>(drawn.width()) <= shape_.width && drawn.lines.size() <= most_lines;
  }

  [[nodiscard]] Block equated(const std::string& left, const Block& right) const {
    return beside(beside(draw(left, Fractions::in_line), {{" = "}, 0}), right);
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

  [[nodiscard]] std::string list(const SheetEquation& equation) const {
    std::string text;
    for (const Display& part : displays(equation, shape_)) text += display(part);
    return text;
  }

  [[nodiscard]] std::string display(const Display& part,
                                    Fractions fractions = Fractions::stacked) const {
    if (part.columns > 0) {
      std::vector<Block> cells;
      for (const std::string& latex : part.texts) cells.push_back(draw(latex, fractions));
      return text_of(equated(part.left, matrix_drawing(cells, part.columns, alphabet_)),
                     page_indent);
    }
    std::string text;
    for (const std::string& latex : part.texts) {
      const bool is_first = text.empty();
      const Block line =
          is_first ? equated(part.left, draw(latex)) : beside({{"   "}, 0}, draw("{} " + latex));
      text += text_of(line, page_indent);
    }
    return text;
  }

  Alphabet alphabet_;
  PageShape shape_;
};

/// The terms of the equation of motion, in its order.
constexpr std::array overview_outputs{OutputKind::mass_matrix, OutputKind::velocity_force,
                                      OutputKind::drift,       OutputKind::gravity,
                                      OutputKind::dissipation, OutputKind::applied_force};

std::vector<const SheetOutput*> shown_first(const Sheet& sheet) {
  std::vector<const SheetOutput*> shown;
  for (const OutputKind kind : overview_outputs) {
    for (const SheetOutput& output : sheet.outputs) {
      if (output.kind == kind && !output.equations.empty()) shown.push_back(&output);
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
  std::string text = sheet.title_latex.empty() ? sheet.title + "\n" : page.title(sheet.title_latex);
  for (const std::string& note : sheet.notes) text += note + "\n";
  if (!sheet.equation_of_motion.empty()) text += "\n" + page.formula(sheet.equation_of_motion);
  for (const auto* const list :
       {&sheet.coordinates, &sheet.inputs, &sheet.functions, &sheet.parameters}) {
    if (!list->empty()) text += "\n" + page.variables(*list);
  }
  for (const SheetOutput& output : sheet.outputs) {
    const std::string& function = output.function;
    text += "\n";
    if (!output.title.empty()) {
      text += fmt::format("{}{}\n", output.title, function.empty() ? "" : ": " + function);
    }
    if (!output.doc.empty()) text += fmt::format("  {}\n", output.doc);
    for (const std::string& line : output.lines) text += page.line(line);
    const bool is_row = output.is_row && !output.equations.empty();
    const std::string row = is_row ? page.row(output.equations) : "";
    text += row;
    for (const SheetEquation& equation : output.equations) {
      if (row.empty()) text += page.equation(equation);
    }
    text += page.table(output.table);
  }
  return text;
}

std::string overview(const Sheet& sheet, const Screen& screen) {
  const ScreenPage page(screen);
  std::string text = fmt::format("{}\n\n{}", sheet.title, page.formula(sheet.equation_of_motion));
  text += fmt::format("  {}\n", page.tuple("q", sheet.coordinates));
  if (!sheet.inputs.empty()) text += fmt::format("  {}\n", page.tuple("u", sheet.inputs));
  for (const SheetOutput* const output : shown_first(sheet)) {
    text += "\n";
    for (const SheetEquation& equation : output->equations) text += page.folded(equation);
  }
  return text;
}

}  // namespace elgen
