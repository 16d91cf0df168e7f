// screen_page: a page for a terminal, and an overview that fits one screen.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "elgen/page.hpp"
#include "formula/drawing.hpp"
#include "model/symbols.hpp"
#include "print/display.hpp"

namespace elgen {
namespace {

constexpr std::string_view page_indent = "  ";

template <Alphabet alphabet, Fractions fractions>
double drawn_width(const Glyphs& glyphs) {
  return static_cast<double>(drawing(glyphs, alphabet, fractions).width());
}

template <Alphabet alphabet>
PageShape shape_of(const Screen& screen) {
  return {static_cast<double>(screen.columns - page_indent.size()),
          &drawn_width<alphabet, Fractions::stacked>, &drawn_width<alphabet, Fractions::in_line>,
          3};
}

/// Draws formulas in the alphabet of a screen and within its width.
class ScreenDrawing {
 public:
  explicit ScreenDrawing(const Screen& screen)
      : alphabet_(screen.alphabet),
        shape_(screen.alphabet == Alphabet::unicode ? shape_of<Alphabet::unicode>(screen)
                                                    : shape_of<Alphabet::ascii>(screen)) {}

  [[nodiscard]] std::string formula(const Formula& formula) const {
    return text_of(draw(glyphs_of(formula)), page_indent);
  }

 protected:
  static constexpr std::size_t most_lines = 9;  ///< of a matrix in the overview

  [[nodiscard]] bool is_unicode() const { return alphabet_ == Alphabet::unicode; }

  /// "kg*m^2" as "kg m²" in Unicode; in ASCII `text` is unchanged.
  [[nodiscard]] std::string unit(const std::string& text) const {
    return is_unicode() ? unit_text(text, " ", small_exponent) : text;
  }

  [[nodiscard]] bool fits(const Block& drawn) const {
    return static_cast<double>(drawn.width()) <= shape_.width && drawn.lines.size() <= most_lines;
  }

  [[nodiscard]] Block equated(const Glyphs& left, const Block& right, std::size_t least = 0) const {
    const Block drawn = draw(left, Fractions::in_line);
    const std::size_t missing = least - std::min(least, drawn.width());
    return join_blocks(
        join_blocks({{std::string(missing, ' ')}, 0}, join_blocks(drawn, {{" = "}, 0})), right);
  }

  [[nodiscard]] Block draw(const Glyphs& glyphs, Fractions fractions = Fractions::stacked) const {
    return drawing(glyphs, alphabet_, fractions);
  }

  [[nodiscard]] Block matrix_of(const SetEquation& equation,
                                const std::vector<Block>& cells) const {
    if (cells.size() == 1) return cells.front();
    return matrix_drawing(cells, equation.columns, alphabet_);
  }

  Alphabet alphabet_;
  PageShape shape_;
};

/// Draws the variables and matrices of an overview.
class Overview : public ScreenDrawing {
 public:
  using ScreenDrawing::ScreenDrawing;

  /// "q = (x [m], θ [rad])"
  [[nodiscard]] std::string tuple(std::string_view name,
                                  const std::vector<PageVariable>& list) const {
    std::string text;
    for (const PageVariable& v : list) {
      const Block symbol = draw(glyphs_of(v.symbol));
      text +=
          fmt::format("{}{}{}", text.empty() ? "" : ", ", symbol.lines[symbol.base],
                      v.unit == "1" || v.unit.empty() ? "" : fmt::format(" [{}]", unit(v.unit)));
    }
    return fmt::format("{} = ({})", name, text);
  }

  /// A matrix that fits the screen. The widest entries are replaced by their widths, one after the
  /// other, until the matrix fits. If the matrix never fits, only its size is shown.
  [[nodiscard]] std::string folded(const SetEquation& equation) const {
    std::vector<Block> cells;
    for (const Glyphs& entry : equation.entries) cells.push_back(draw(entry));
    for (std::size_t folds = 0; folds <= cells.size(); ++folds) {
      const Block drawn = equated(equation.left, matrix_of(equation, cells));
      if (fits(drawn)) return text_of(drawn, page_indent);
      Block& widest = *std::ranges::max_element(cells, {}, &Block::width);
      widest = {{fmt::format("{}{}", is_unicode() ? "…" : "...", widest.width())}, 0};
    }
    const auto zeros = std::ranges::count(equation.entries, read_latex("0"));
    const std::string size =
        fmt::format("{} x {} entries, {} of them 0", equation.rows, equation.columns, zeros);
    return text_of(equated(equation.left, {{size}, 0}), page_indent);
  }
};

class ScreenPage : public ScreenDrawing {
 public:
  using ScreenDrawing::ScreenDrawing;

  [[nodiscard]] std::string line(const Formula& formula, std::string_view indent) const {
    return text_of(draw(glyphs_of(formula), Fractions::in_line), indent);
  }

  /// One line per variable: symbol, value with unit, description.
  [[nodiscard]] std::string variables(const std::vector<PageVariable>& list) const {
    std::vector<Block> cells;
    for (const PageVariable& v : list) {
      const std::string value = v.value.empty() ? "" : "= " + v.value;
      const std::string in_unit = v.unit == "1" ? "" : unit(v.unit);
      const char* const between = value.empty() || in_unit.empty() ? "" : " ";
      cells.push_back(draw(glyphs_of(v.symbol)));
      cells.push_back({{fmt::format("{}{}{}", value, between, in_unit)}, 0});
      cells.push_back({{v.doc}, 0});
    }
    return text_of(grid(cells, 3, Alignment::left), page_indent);
  }

  [[nodiscard]] std::string table(const PageTable& table) const {
    if (table.heads.empty()) return {};
    const bool has_heads =
        std::ranges::any_of(table.heads, [](const Formula& head) { return !head.is_empty(); });
    std::vector<Block> cells;
    for (const auto* const list : {&table.heads, &table.cells}) {
      if (list == &table.heads && !has_heads) continue;
      for (const Formula& cell : *list) {
        cells.push_back(draw(glyphs_of(cell), Fractions::in_line));
      }
    }
    return text_of(grid(cells, table.heads.size(), Alignment::left), page_indent);
  }

  [[nodiscard]] std::string equations(const PageSection& section) const {
    std::vector<SetEquation> all;
    for (const PageEquation& each : section.equations) all.push_back(set_equation(each));
    std::string text = section.is_row && !all.empty() ? row(all) : "";
    if (!text.empty()) return text;
    if (!section.is_aligned) {
      for (const SetEquation& each : all) text += equation(each);
      return text;
    }
    for (const DisplayBlock& block : aligned_blocks(all, shape_)) text += aligned(block);
    return text;
  }

 private:
  [[nodiscard]] std::string equation(const SetEquation& equation) const {
    const bool is_list = is_listed(equation, shape_);
    if (is_list && equation.columns > 1) {
      const auto [matrix, named] = named_entries(equation, shape_);
      if (fits_as_matrix(matrix, shape_)) {
        const Display names{matrix.left, matrix.columns, matrix.entries};
        return display(names, Fractions::in_line) + list(named);
      }
    }
    const bool leaves_out = omits_zeros(equation, shape_);
    return list(equation) +
           (leaves_out ? fmt::format("{}all other entries are 0\n", page_indent) : "");
  }

  /// All equations side by side; "" if they do not fit the screen.
  [[nodiscard]] std::string row(const std::vector<SetEquation>& equations) const {
    Block all;
    for (const SetEquation& equation : equations) {
      std::vector<Block> cells;
      for (const Glyphs& entry : equation.entries) cells.push_back(draw(entry));
      if (all.width() > 0) all = join_blocks(all, {{"  "}, 0});
      all = join_blocks(all, equated(equation.left, matrix_of(equation, cells)));
    }
    return fits(all) ? text_of(all, page_indent) : "";
  }

  [[nodiscard]] std::string list(const SetEquation& equation) const {
    std::string text;
    for (const Display& part : displays(equation, shape_)) text += display(part);
    return text;
  }

  /// Draws a display. `left`: width of the longest left side in its block.
  [[nodiscard]] std::string display(const Display& part, Fractions fractions = Fractions::stacked,
                                    std::size_t left = 0) const {
    std::vector<Block> rights;
    for (const Glyphs& row : part.rows) {
      const bool continues = part.columns == 0 && !rights.empty();
      rights.push_back(draw(continues ? continuation_row(row) : row, fractions));
    }
    if (part.columns > 0) rights = {matrix_drawing(rights, part.columns, alphabet_)};
    std::string text;
    for (const Block& right : rights) {
      const bool is_first = text.empty();
      const bool is_alone = is_first && part.left.parts.empty();
      const Block behind{{std::string(left + 3, ' ')}, 0};
      text += text_of(is_alone   ? right
                      : is_first ? equated(part.left, right, left)
                                 : join_blocks(behind, right),
                      page_indent);
    }
    return text;
  }

  /// A continuation line; its leading sign is a binary operator.
  static Glyphs continuation_row(const Glyphs& row) {
    Glyphs result{GlyphKind::row, "", {Glyphs{}}};
    append(result, row, true);
    return result;
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

/// The outputs that are terms of the equation of motion, in order.
constexpr std::array overview_outputs{OutputKind::mass_matrix, OutputKind::velocity_force,
                                      OutputKind::drift,       OutputKind::gravity,
                                      OutputKind::dissipation, OutputKind::applied_force};

std::vector<const PageSection*> overview_sections(const Page& page) {
  std::vector<const PageSection*> shown;
  for (const OutputKind kind : overview_outputs) {
    for (const PageSection& output : page.sections) {
      const bool has_content = !output.equations.empty() || !output.definition.is_empty();
      if (output.kind == kind && has_content) shown.push_back(&output);
    }
  }
  if (!shown.empty()) return shown;
  for (const PageSection& output : page.sections) {
    if (!output.equations.empty() && shown.size() < 3) shown.push_back(&output);
  }
  return shown;
}

}  // namespace

std::string screen_page(const Page& page, const Screen& screen) {
  const ScreenPage printer(screen);
  std::string text = printer.line(page.title, "");
  for (const std::string& note : page.notes) text += note + "\n";
  if (!page.equation_of_motion.is_empty()) text += "\n" + printer.formula(page.equation_of_motion);
  for (const auto* const list :
       {&page.coordinates, &page.inputs, &page.functions, &page.parameters}) {
    if (!list->empty()) text += "\n" + printer.variables(*list);
  }
  for (const PageSection& section : page.sections) {
    text += "\n";
    if (!section.title.is_empty()) text += printer.line(section.title, "");
    if (!section.doc.empty()) text += fmt::format("  {}\n", section.doc);
    const bool is_defined_alone = section.equations.empty() && !section.definition.is_empty();
    if (is_defined_alone) text += printer.formula(section.definition);
    for (const Formula& line : section.lines) text += printer.line(line, page_indent);
    text += printer.equations(section) + printer.table(section.table);
  }
  return text;
}

std::string overview(const Page& page, const Screen& screen) {
  const Overview printer(screen);
  std::string text =
      fmt::format("{}\n\n{}", text_of(page.title), printer.formula(page.equation_of_motion));
  text += fmt::format("  {}\n", printer.tuple("q", page.coordinates));
  if (!page.inputs.empty()) text += fmt::format("  {}\n", printer.tuple("u", page.inputs));
  for (const PageSection* const section : overview_sections(page)) {
    text += "\n";
    if (section->equations.empty()) text += printer.formula(section->definition);
    for (const PageEquation& equation : section->equations) {
      text += printer.folded(set_equation(equation));
    }
  }
  return text;
}

}  // namespace elgen
