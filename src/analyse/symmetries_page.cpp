// The page of symmetries: a row for each with its change and its integral, the claim, and the
// integrals as a model states them.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>

#include "analyse/generators.hpp"
#include "analyse/leaf_search.hpp"
#include "analyse/page.hpp"
#include "forms/present/arithmetic.hpp"

namespace elgen {
namespace {

bool is_nothing(const std::optional<Fraction>& form) { return form && form->numerator.empty(); }

const char* name_of(SymmetryKind kind) {
  switch (kind) {
    case SymmetryKind::coordinate:
    case SymmetryKind::translation:
      return "translation";
    case SymmetryKind::boost:
      return "boost";
    case SymmetryKind::rotation:
      return "rotation";
    case SymmetryKind::turn:
      return "turn";
    case SymmetryKind::other:
      return "other";
    case SymmetryKind::time:
      return "time";
  }
  return "";
}

class SymmetriesPage {
 public:
  SymmetriesPage(const CheckedModel& checked, const Symmetries& symmetries)
      : checked_(checked),
        model_(checked.model),
        symmetries_(symmetries),
        forms_(symmetries.forms),
        all_(checked.model),
        symbols_(symbols_of(checked.model)) {}

  AnalysisPage operator()() {
    AnalysisPage page;
    page.title = title();
    if (!symmetries_.all.empty()) page.parts = rows();
    page.parts.push_back({.doc = claims()});
    const std::vector<std::string> names = conserved();
    if (names.empty()) return page;
    std::string list;
    for (const std::string& name : names) {
      list += fmt::format("{}\"{}\"", list.empty() ? "" : ", ", name);
    }
    page.parts.push_back({.title = "[[expect]]", .doc = fmt::format("conserved = [{}]", list)});
    return page;
  }

  /// The integrals that forces leave alone, as an [[expect]] of the model states them: it has no
  /// names for quaternions, and knows nothing of what a scene changes.
  std::vector<std::string> conserved() {
    std::vector<std::string> result;
    if (!checked_.scene.canonical.empty()) return result;
    Arithmetic arithmetic(forms_.algebra);
    LeafSearch quaternions(forms_.algebra, [this](const Atom& leaf) {
      return leaf.leaf == Opcode::coordinate && model_.coordinates[leaf.index].rotation;
    });
    for (const Symmetry& symmetry : symmetries_.all) {
      if (symmetry.is_special || !symmetry.total || !is_nothing(symmetry.loss)) continue;
      const Value whole = arithmetic.subtract(symmetry.by_names, *symmetry.total);
      if (!whole || quaternions.holds(*whole)) continue;
      if (const auto formula = read(whole)) result.push_back(formula->text);
    }
    return result;
  }

  nlohmann::ordered_json json() {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    const auto text_of = [&](const std::optional<Fraction>& form) {
      const std::optional<Printed> formula = read(form);
      return formula ? nlohmann::ordered_json(formula->text) : nlohmann::ordered_json(nullptr);
    };
    for (const Symmetry& symmetry : symmetries_.all) {
      nlohmann::ordered_json entry{{"kind", name_of(symmetry.kind)}};
      nlohmann::ordered_json change = nlohmann::ordered_json::array();
      for (const Fraction& along : symmetry.displacement) change.push_back(text_of(along));
      entry["displacement"] = change;
      entry["time"] = text_of(symmetry.generator.back());
      entry["integral"] = text_of(symmetry.by_names);
      entry["closed_form"] = text_of(symmetry.closed);
      entry["F"] = text_of(symmetry.total);
      entry["rate"] = text_of(symmetry.rate);
      entry["proved"] = symmetry.is_proved;
      entry["generic"] = !symmetry.is_special;
      list.push_back(std::move(entry));
    }
    return {{"model", model_.name},
            {"unknowns", symmetries_.unknowns},
            {"exact", symmetries_.is_exact},
            {"complete", symmetries_.is_complete},
            {"sampled", symmetries_.sampled},
            {"states", symmetries_.states},
            {"symmetries", list},
            {"conserved", conserved()}};
  }

 private:
  [[nodiscard]] std::optional<Printed> read(const std::optional<Fraction>& form) const {
    return printed(model_, forms_.algebra, form);
  }

  [[nodiscard]] Printed title() const {
    const bool turns = !all_.rotations.empty();
    const Printed change{turns ? "dq = A q + b + c t, turns R^T s + b" : "dq = A q + b + c t",
                         turns ? "{\\delta} q = A q + b + c t, \\text{turns } R^{\\top} s + b"
                               : "{\\delta} q = A q + b + c t"};
    const std::size_t count = symmetries_.all.size();
    const Printed time{fmt::format("dt constant: {}", count),
                       fmt::format("{{\\delta}} t \\text{{ constant: {}}}", count)};
    const Printed subject = titled(checked_, "symmetries of L,") + change;
    return Printed{subject.text + ", " + time.text, subject.latex + ", " + time.latex};
  }

  [[nodiscard]] bool is_about_time_alone() const {
    return std::ranges::all_of(symmetries_.all, [](const Symmetry& symmetry) {
      return symmetry.kind == SymmetryKind::time;
    });
  }

  /// I: "p_x" = "m v"; "p_x t - F", "F" = "m x"; "E" = "…" with a note.
  struct IntegralText {
    Printed left = {};
    std::optional<PageMatrix> equation = {};
    Printed note = {};

    [[nodiscard]] Printed in_one_line() const {
      Printed result = left;
      if (equation) {
        const char* const comma = left.text.empty() ? "" : ",   ";
        const char* const latex = left.text.empty() ? "" : ", \\quad ";
        const Printed& value = equation->entries[0];
        result = {fmt::format("{}{}{} = {}", left.text, comma, equation->left.text, value.text),
                  fmt::format("{}{}{} = {}", left.latex, latex, equation->left.latex, value.latex)};
      }
      if (note.text.empty()) return result;
      return {result.text + "   " + note.text, result.latex + " \\quad " + note.latex};
    }
  };

  /// A row each; where one of them is too wide to be read, lines.
  std::vector<PagePart> rows() {
    constexpr std::size_t widest = 120;
    const bool has_change = !is_about_time_alone();
    const bool has_rate = std::ranges::any_of(
        symmetries_.all, [](const Symmetry& symmetry) { return !is_nothing(symmetry.rate); });
    PageTable table;
    table.heads.resize(2U + (has_change ? 1U : 0U) + (has_rate ? 1U : 0U));
    std::vector<PagePart> blocks;
    std::vector<std::size_t> widths(table.heads.size(), 0);
    for (const Symmetry& symmetry : symmetries_.all) {
      const IntegralText formula = integral(symmetry);
      const Printed moved = change(symmetry);
      const std::optional<PageMatrix> flow = rate(symmetry);
      std::vector<Printed> row{name(symmetry)};
      if (has_change) row.push_back(moved);
      row.push_back(formula.in_one_line());
      if (has_rate) row.push_back(flow ? in_one_line(*flow) : Printed{});
      for (std::size_t i = 0; i < row.size(); ++i) {
        widths[i] = std::max(widths[i], row[i].text.size());
      }
      table.cells.insert(table.cells.end(), row.begin(), row.end());
      blocks.push_back({.lines = lines(symmetry, moved, formula)});
      for (const std::optional<PageMatrix>& equation : {formula.equation, flow}) {
        if (equation) blocks.back().matrices.push_back(*equation);
      }
    }
    const std::size_t width = std::accumulate(widths.begin(), widths.end(), std::size_t{0});
    if (width > widest) return blocks;
    return {{.table = std::move(table)}};
  }

  /// "rotation: dx = -y, dy = x", and what stands beside its equations.
  [[nodiscard]] std::vector<Printed> lines(const Symmetry& symmetry, const Printed& moved,
                                           const IntegralText& formula) const {
    const Printed own = name(symmetry);
    std::vector<Printed> result{
        symmetry.kind != SymmetryKind::coordinate
            ? prose(own.text + ":") + moved
            : Printed{own.text + ": " + moved.text, own.latex + " \\text{: } " + moved.latex}};
    for (const Printed& line : {formula.left, formula.note}) {
      if (!line.text.empty()) result.push_back(line);
    }
    return result;
  }

  /// The only velocity along which a symmetry moves.
  [[nodiscard]] static std::size_t moved_velocity(const Symmetry& symmetry) {
    const auto moved = std::ranges::find_if(symmetry.displacement,
                                            [](const Fraction& x) { return !x.numerator.empty(); });
    return static_cast<std::size_t>(moved - symmetry.displacement.begin());
  }

  [[nodiscard]] Printed name(const Symmetry& symmetry) const {
    if (symmetry.kind != SymmetryKind::coordinate) return prose(name_of(symmetry.kind));
    return symbols_.q[model_.velocities[moved_velocity(symmetry)].coordinate];
  }

  /// "dx = -y, dy = x", "dt = 1"
  Printed change(const Symmetry& symmetry) const {
    std::vector<Printed> parts;
    for (std::size_t i = 0; i < all_.scalars(); ++i) {
      const Fraction& along = symmetry.displacement[all_.velocities[i]];
      if (along.numerator.empty()) continue;
      parts.push_back(moved(symbols_.q[all_.coordinates[i]], along));
    }
    for (std::size_t r = 0; r < all_.rotations.size(); ++r) add_turns(parts, symmetry, r);
    const Fraction& time = symmetry.generator.back();
    if (!time.numerator.empty()) parts.push_back(moved(symbols_.t, time));
    return with_commas(parts);
  }

  /// "attitude turned by R^T (0, 0, 1)"
  void add_turns(std::vector<Printed>& parts, const Symmetry& symmetry,
                 std::size_t rotation) const {
    const Printed world = triple(symmetry, all_.world_turn(rotation, 0));
    const Printed body = triple(symmetry, all_.body_turn(rotation, 0));
    if (world.text.empty() && body.text.empty()) return;
    const Printed sum = world.text.empty() || body.text.empty() ? Printed{} : Printed{"+", "+"};
    const Printed turned =
        world.text.empty() ? Printed{} : Printed{"R^T " + world.text, "R^{\\top} " + world.latex};
    parts.push_back(prose(model_.rotations[rotation].name + " turned by") + turned + sum + body);
  }

  [[nodiscard]] Printed triple(const Symmetry& symmetry, std::size_t first) const {
    std::vector<Printed> entries;
    bool is_none = true;
    for (std::size_t k = first; k < first + axis_count; ++k) {
      is_none = is_none && symmetry.generator[k].numerator.empty();
      entries.push_back(read(symmetry.generator[k]).value_or(Printed{"?", "?"}));
    }
    if (is_none) return {};
    const Printed list = with_commas(entries);
    return {"(" + list.text + ")", "(" + list.latex + ")"};
  }

  [[nodiscard]] Printed moved(const Printed& symbol, const Fraction& along) const {
    const Printed formula = read(along).value_or(prose("a long form"));
    return elgen::equation({"d" + symbol.text, "{\\delta} " + symbol.latex}, formula);
  }

  [[nodiscard]] IntegralText integral(const Symmetry& symmetry) const {
    const Printed names = read(symmetry.by_names).value_or(prose("a long form"));
    const Printed less{names.text + " - F", names.latex + " - F"};
    IntegralText result;
    result.note = note(symmetry);
    if (!symmetry.total) {
      result.left = {less.text + ", F has no closed form",
                     less.latex + " \\text{, } F \\text{ has no closed form}"};
      return result;
    }
    if (!is_nothing(symmetry.total)) {
      result.left = less;
      result.equation = equation({"F", "F"}, read(symmetry.total).value_or(prose("a long form")));
      return result;
    }
    if (turns(symmetry)) {  // written out, as long again as the components
      result.equation = equation({"I", "I"}, names);
    } else if (const std::optional<Printed> closed = read(symmetry.closed)) {
      result.equation = equation(names, *closed);
    } else {
      result.left = names;
    }
    return result;
  }

  [[nodiscard]] Printed note(const Symmetry& symmetry) const {
    if (symmetry.is_rounded) return prose("(six digits, at these values of the parameters)");
    if (symmetry.is_special) return prose("(at these values of the parameters)");
    if (symmetry.kind != SymmetryKind::time || !symmetries_.loses_energy) return {};
    return {"(T + V is not conserved)", "(T + V \\text{ is not conserved})"};
  }

  /// Whether a rotation turns about axes of the world.
  [[nodiscard]] bool turns(const Symmetry& symmetry) const {
    for (std::size_t u = all_.world_turn(0, 0); u < all_.time(); ++u) {
      if (!symmetry.generator[u].numerator.empty()) return true;
    }
    return false;
  }

  static PageMatrix equation(const Printed& left, const Printed& right) {
    return {left, 1, 1, {right}};
  }

  /// "d/dt" = "u t"; none where nothing acts.
  [[nodiscard]] std::optional<PageMatrix> rate(const Symmetry& symmetry) const {
    if (is_nothing(symmetry.rate)) return std::nullopt;
    const Printed otherwise{
        "(dq - v dt).(B u + Q - dD/dv)",
        "({\\delta} q - v {\\delta} t) \\cdot (B u + Q - \\partial D/\\partial v)"};
    return equation({"d/dt", "\\text{d/dt}"}, read(symmetry.rate).value_or(otherwise));
  }

  static Printed in_one_line(const PageMatrix& rate) {
    const Printed& value = rate.entries[0];
    return {"d/dt = " + value.text, "\\text{d/dt = }" + value.latex};
  }

  [[nodiscard]] std::string claims() const {
    const std::size_t count = symmetries_.all.size();
    if (!symmetries_.is_exact && symmetries_.states == 0) {
      return "not decided: no state within the ranges has a value";
    }
    const std::string unknowns = fmt::format("{} unknowns", symmetries_.unknowns);
    const std::string subject = count == 0 ? "there are none" : "these are all";
    const bool is_generic = symmetries_.sampled_elsewhere == count &&
                            std::ranges::none_of(symmetries_.all, &Symmetry::is_special);
    const bool agrees = symmetries_.states > 0 && symmetries_.sampled == count;
    std::string line = verdict();
    if (symmetries_.is_complete) {
      line += fmt::format("{} of this form ({}, exactly)", subject, unknowns);
    } else if (is_generic) {
      line += fmt::format("{} of this form ({}, sampled)", subject, unknowns);
    } else if (agrees) {
      line += fmt::format("{} of this form at the values of the parameters ({}, sampled)", subject,
                          unknowns);
    } else {
      line += fmt::format("these are at least those of this form ({})", unknowns);
    }
    if (symmetries_.states == 0 || agrees) return line;
    return line + fmt::format("; at the values of the parameters there {} {} ({})",
                              symmetries_.sampled == 1 ? "is" : "are", symmetries_.sampled,
                              sampled());
  }

  [[nodiscard]] std::string sampled() const {
    return fmt::format("sampled at {} states in 160 digits", symmetries_.states);
  }

  /// "conserved: proved; "
  [[nodiscard]] std::string verdict() const {
    if (symmetries_.all.empty()) return {};
    const bool are_proved = std::ranges::all_of(symmetries_.all, &Symmetry::is_proved);
    const bool is_free = std::ranges::all_of(
        symmetries_.all, [](const Symmetry& symmetry) { return is_nothing(symmetry.rate); });
    return fmt::format("{}: {}; ", is_free ? "conserved" : "conserved where d/dt is 0",
                       are_proved             ? "proved"
                       : symmetries_.is_exact ? "dL = dF/dt is proved"
                                              : sampled());
  }

  const CheckedModel& checked_;
  const Model& model_;
  const Symmetries& symmetries_;
  ClosedForms forms_;  ///< a copy: reading forms adds to their algebra
  GeneratorClass all_;
  LeafValues<Printed> symbols_;
};

}  // namespace

Sheet symmetries_sheet(const CheckedModel& checked, const Symmetries& symmetries) {
  return sheet_of(SymmetriesPage(checked, symmetries)());
}

std::string symmetries_text(const CheckedModel& checked, const Symmetries& symmetries) {
  return text_of(SymmetriesPage(checked, symmetries)());
}

std::string symmetries_json(const CheckedModel& checked, const Symmetries& symmetries) {
  return SymmetriesPage(checked, symmetries).json().dump(1) + "\n";
}

}  // namespace elgen
