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

template <Alphabet alphabet, FractionStyle fractions>
double drawn_width(const Glyphs& glyphs) {
  return static_cast<double>(draw_glyphs(glyphs, alphabet, fractions).width());
}

template <Alphabet alphabet>
PageMetrics page_shape(const Screen& screen) {
  return {static_cast<double>(screen.columns - page_indent.size()),
          &drawn_width<alphabet, FractionStyle::stacked>,
          &drawn_width<alphabet, FractionStyle::in_line>, 3};
}

/// Draws formulas in the alphabet of a screen and within its width.
class ScreenDrawing {
 public:
  explicit ScreenDrawing(const Screen& screen)
      : alphabet_(screen.alphabet),
        shape_(screen.alphabet == Alphabet::unicode ? page_shape<Alphabet::unicode>(screen)
                                                    : page_shape<Alphabet::ascii>(screen)) {}

  [[nodiscard]] std::string draw_formula(const Formula& formula) const {
    return text_of(draw(glyphs_of(formula)), page_indent);
  }

 protected:
  static constexpr std::size_t most_lines = 9;  ///< of a matrix in the overview

  [[nodiscard]] bool is_unicode() const { return alphabet_ == Alphabet::unicode; }

  /// "kg*m^2" as "kg m²" in Unicode; in ASCII `text` is unchanged.
  [[nodiscard]] std::string spell_unit(const std::string& text) const {
    return is_unicode() ? unicode_unit(text) : text;
  }

  [[nodiscard]] bool fits_screen(const TextBlock& drawn) const {
    return static_cast<double>(drawn.width()) <= shape_.width && drawn.lines.size() <= most_lines;
  }

  [[nodiscard]] TextBlock draw_equation(const Glyphs& left, const TextBlock& right,
                                        std::size_t least = 0) const {
    const TextBlock drawn = draw(left, FractionStyle::in_line);
    const std::size_t missing = least - std::min(least, drawn.width());
    return join_blocks(
        join_blocks({{std::string(missing, ' ')}, 0}, join_blocks(drawn, {{" = "}, 0})), right);
  }

  [[nodiscard]] TextBlock draw(const Glyphs& glyphs,
                               FractionStyle fractions = FractionStyle::stacked) const {
    return draw_glyphs(glyphs, alphabet_, fractions);
  }

  [[nodiscard]] TextBlock draw_cells(const TypesetEquation& equation,
                                     const std::vector<TextBlock>& cells) const {
    if (cells.size() == 1) return cells.front();
    return draw_matrix(cells, equation.columns, alphabet_);
  }

  Alphabet alphabet_;
  PageMetrics shape_;
};

/// Draws the variables and matrices of an overview.
class Overview : public ScreenDrawing {
 public:
  using ScreenDrawing::ScreenDrawing;

  /// "q = (x [m], θ [rad])"
  [[nodiscard]] std::string tuple_text(std::string_view name,
                                       const std::vector<PageVariable>& list) const {
    std::string text;
    for (const PageVariable& v : list) {
      const TextBlock symbol = draw(glyphs_of(v.symbol));
      text += fmt::format(
          "{}{}{}", text.empty() ? "" : ", ", symbol.lines[symbol.base],
          v.unit == "1" || v.unit.empty() ? "" : fmt::format(" [{}]", spell_unit(v.unit)));
    }
    return fmt::format("{} = ({})", name, text);
  }

  /// A matrix that fits the screen. "…12" replaces an entry of 12 columns, the widest entry first,
  /// until the matrix fits. If the matrix never fits, only its size is shown.
  [[nodiscard]] std::string fold_matrix(const TypesetEquation& equation) const {
    std::vector<TextBlock> cells;
    for (const Glyphs& entry : equation.entries) cells.push_back(draw(entry));
    for (std::size_t folds = 0; folds <= cells.size(); ++folds) {
      const TextBlock drawn = draw_equation(equation.left, draw_cells(equation, cells));
      if (fits_screen(drawn)) return text_of(drawn, page_indent);
      TextBlock& widest = *std::ranges::max_element(cells, {}, &TextBlock::width);
      widest = {{fmt::format("{}{}", is_unicode() ? "…" : "...", widest.width())}, 0};
    }
    const auto zeros = std::ranges::count(equation.entries, read_latex("0"));
    const std::string size =
        fmt::format("{} x {} entries, {} of them 0", equation.rows, equation.columns, zeros);
    return text_of(draw_equation(equation.left, {{size}, 0}), page_indent);
  }
};

class ScreenPagePrinter : public ScreenDrawing {
 public:
  using ScreenDrawing::ScreenDrawing;

  [[nodiscard]] std::string draw_line(const Formula& formula, std::string_view indent) const {
    return text_of(draw(glyphs_of(formula), FractionStyle::in_line), indent);
  }

  /// One line per variable: symbol, value with unit, description.
  [[nodiscard]] std::string draw_variables(const std::vector<PageVariable>& list) const {
    std::vector<TextBlock> cells;
    for (const PageVariable& v : list) {
      const std::string value = v.value.empty() ? "" : "= " + v.value;
      const std::string in_unit = v.unit == "1" ? "" : spell_unit(v.unit);
      const char* const between = value.empty() || in_unit.empty() ? "" : " ";
      cells.push_back(draw(glyphs_of(v.symbol)));
      cells.push_back({{fmt::format("{}{}{}", value, between, in_unit)}, 0});
      cells.push_back({{v.doc}, 0});
    }
    return text_of(draw_grid(cells, 3, Alignment::left), page_indent);
  }

  [[nodiscard]] std::string draw_table(const PageTable& table) const {
    if (table.heads.empty()) return {};
    const bool has_heads =
        std::ranges::any_of(table.heads, [](const Formula& head) { return !head.is_empty(); });
    std::vector<TextBlock> cells;
    for (const auto* const list : {&table.heads, &table.cells}) {
      if (list == &table.heads && !has_heads) continue;
      for (const Formula& cell : *list) {
        cells.push_back(draw(glyphs_of(cell), FractionStyle::in_line));
      }
    }
    return text_of(draw_grid(cells, table.heads.size(), Alignment::left), page_indent);
  }

  [[nodiscard]] std::string draw_equations(const PageSection& section) const {
    std::vector<TypesetEquation> all;
    for (const PageEquation& each : section.equations) all.push_back(typeset_equation(each));
    std::string text = section.is_side_by_side && !all.empty() ? draw_side_by_side(all) : "";
    if (!text.empty()) return text;
    if (!section.is_aligned) {
      for (const TypesetEquation& each : all) text += draw_entries(each);
      return text;
    }
    for (const DisplayBlock& block : aligned_blocks(all, shape_)) text += draw_aligned_block(block);
    return text;
  }

 private:
  [[nodiscard]] std::string draw_entries(const TypesetEquation& equation) const {
    const bool is_list = is_listed(equation, shape_);
    if (is_list && equation.columns > 1) {
      const auto [matrix, named] = named_entries(equation, shape_);
      if (fits_as_matrix(matrix, shape_)) {
        const DisplayedEquation names{matrix.left, matrix.columns, matrix.entries};
        return draw_display(names, FractionStyle::in_line) + draw_displays(named);
      }
    }
    const bool leaves_out = omits_zeros(equation, shape_);
    return draw_displays(equation) +
           (leaves_out ? fmt::format("{}all other entries are 0\n", page_indent) : "");
  }

  /// All equations side by side; "" if they do not fit the screen.
  [[nodiscard]] std::string draw_side_by_side(const std::vector<TypesetEquation>& equations) const {
    TextBlock all;
    for (const TypesetEquation& equation : equations) {
      std::vector<TextBlock> cells;
      for (const Glyphs& entry : equation.entries) cells.push_back(draw(entry));
      if (all.width() > 0) all = join_blocks(all, {{"  "}, 0});
      all = join_blocks(all, draw_equation(equation.left, draw_cells(equation, cells)));
    }
    return fits_screen(all) ? text_of(all, page_indent) : "";
  }

  [[nodiscard]] std::string draw_displays(const TypesetEquation& equation) const {
    std::string text;
    for (const DisplayedEquation& part : lay_out_equation(equation, shape_))
      text += draw_display(part);
    return text;
  }

  /// Draws a display. `left`: the width of the longest left side in the block of the display.
  [[nodiscard]] std::string draw_display(const DisplayedEquation& part,
                                         FractionStyle fractions = FractionStyle::stacked,
                                         std::size_t left = 0) const {
    std::vector<TextBlock> rights;
    for (const Glyphs& row : part.rows) {
      const bool continues = part.columns == 0 && !rights.empty();
      rights.push_back(draw(continues ? continuation_row(row) : row, fractions));
    }
    if (part.columns > 0) rights = {draw_matrix(rights, part.columns, alphabet_)};
    std::string text;
    for (const TextBlock& right : rights) {
      const bool is_first = text.empty();
      const bool is_alone = is_first && part.left.parts.empty();
      const TextBlock behind{{std::string(left + 3, ' ')}, 0};
      text += text_of(is_alone   ? right
                      : is_first ? draw_equation(part.left, right, left)
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

  [[nodiscard]] std::string draw_aligned_block(const DisplayBlock& block) const {
    std::size_t left = 0;
    for (const DisplayedEquation& part : block) {
      left = std::max(left, draw(part.left, FractionStyle::in_line).width());
    }
    std::string text;
    for (const DisplayedEquation& part : block)
      text += draw_display(part, FractionStyle::stacked, left);
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
  const ScreenPagePrinter printer(screen);
  std::string text = printer.draw_line(page.title, "");
  for (const std::string& note : page.notes) text += note + "\n";
  if (!page.equation_of_motion.is_empty())
    text += "\n" + printer.draw_formula(page.equation_of_motion);
  for (const auto* const list :
       {&page.coordinates, &page.inputs, &page.functions, &page.parameters}) {
    if (!list->empty()) text += "\n" + printer.draw_variables(*list);
  }
  for (const PageSection& section : page.sections) {
    text += "\n";
    if (!section.title.is_empty()) text += printer.draw_line(section.title, "");
    if (!section.doc.empty()) text += fmt::format("  {}\n", section.doc);
    const bool is_defined_alone = section.equations.empty() && !section.definition.is_empty();
    if (is_defined_alone) text += printer.draw_formula(section.definition);
    for (const Formula& line : section.lines) text += printer.draw_line(line, page_indent);
    text += printer.draw_equations(section) + printer.draw_table(section.table);
  }
  return text;
}

std::string overview(const Page& page, const Screen& screen) {
  const Overview printer(screen);
  std::string text =
      fmt::format("{}\n\n{}", text_of(page.title), printer.draw_formula(page.equation_of_motion));
  text += fmt::format("  {}\n", printer.tuple_text("q", page.coordinates));
  if (!page.inputs.empty()) text += fmt::format("  {}\n", printer.tuple_text("u", page.inputs));
  for (const PageSection* const section : overview_sections(page)) {
    text += "\n";
    if (section->equations.empty()) text += printer.draw_formula(section->definition);
    for (const PageEquation& equation : section->equations) {
      text += printer.fold_matrix(typeset_equation(equation));
    }
  }
  return text;
}

}  // namespace elgen
