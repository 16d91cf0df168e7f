// The report of `drop_below`: every term with its bound, and what every entry is off by at most.
// Bounds are rounded up to three digits.
#include <fmt/format.h>

#include "base/columns.hpp"
#include "base/number_text.hpp"
#include "check/judge/output_units.hpp"
#include "elgen/drop.hpp"
#include "elgen/wording.hpp"

namespace elgen {
namespace {

using cln::cl_RA;

constexpr int digits = 3;

/// The smallest number of so many digits that is not less.
std::string rounded_up(const cl_RA& value) {
  if (cln::zerop(value)) return "0";
  Decimal decimal = rounded_decimal(value, digits);
  if (value_of(decimal) < value) {
    // Trailing zeros were cut off: the last of the digits is one of them.
    while (integer_text(decimal.significand).size() < digits) {
      decimal.significand = decimal.significand * 10;
      --decimal.exponent;
    }
    decimal.significand = decimal.significand + 1;
  }
  return exact_text(value_of(decimal));
}

std::string with_unit(const std::string& number, const Model& model, const EntryPlace& place) {
  const std::optional<Unit> unit = unit_of_entry(model, place);
  const std::string text = unit ? to_string(*unit) : "1";
  return text == "1" ? number : number + " " + text;
}

/// "mass_matrix[1,2]", "gravity[2]", "kinetic_energy"
std::string entry_name(OutputKind output, std::size_t row, std::size_t column) {
  const OutputRow& known = output_row(output);
  const FieldRow& shape = known.fields.front();
  if (shape.rows == Extent::one) return std::string(known.name);
  if (shape.columns == Extent::one) return fmt::format("{}[{}]", known.name, row + 1);
  return fmt::format("{}[{},{}]", known.name, row + 1, column + 1);
}

/// Cells end with the blanks between columns.
using TableRows = std::vector<std::vector<std::string>>;

std::string table(const TableRows& rows) {
  return fmt::format("{}\n", fmt::join(aligned(rows), "\n"));
}

std::string dropped_table(const Model& model, const Reduction& reduction) {
  TableRows rows{{"entry  ", "dropped term  ", "at most"}};
  for (const DroppedTerm& term : reduction.terms) {
    const EntryPlace place{term.output, "", term.row, term.column};
    rows.push_back({entry_name(term.output, term.row, term.column) + "  ", term.text + "  ",
                    with_unit(rounded_up(term.bound), model, place)});
  }
  return table(rows);
}

/// "1.2e-7 N*m, 0.0001 of its largest term's bound", "1.2e-7 N*m + 3.1e-8 kg*m^2 |a[1]|"; empty
/// where it is 0.
std::string error_text(const Model& model, const EntryPlace& place, const EntryError& error) {
  std::string text;
  if (cln::plusp(error.constant)) text = with_unit(rounded_up(error.constant), model, place);
  for (std::size_t j = 0; j < error.by_acceleration.size(); ++j) {
    if (cln::zerop(error.by_acceleration[j])) continue;
    const EntryPlace mass{OutputKind::mass_matrix, "", place.row, j};
    text += (text.empty() ? "" : " + ") +
            with_unit(rounded_up(error.by_acceleration[j]), model, mass) +
            fmt::format(" |a[{}]|", j + 1);
  }
  if (error.largest && cln::plusp(*error.largest) && !text.empty()) {
    text += fmt::format(", {} of its largest term's bound",
                        rounded_up(error.constant / *error.largest));
  }
  return text;
}

std::string error_table(const Model& model, const Reduction& reduction) {
  TableRows rows{{"entry  ", "off by at most"}};
  for (const ReducedOutput& output : reduction.outputs) {
    for (std::size_t i = 0; i < output.errors.size(); ++i) {
      const EntryPlace place{output.kind, "", i / output.columns, i % output.columns};
      std::string text = error_text(model, place, output.errors[i]);
      if (text.empty()) continue;
      rows.push_back({entry_name(output.kind, place.row, place.column) + "  ", std::move(text)});
    }
  }
  return table(rows);
}

/// The bound of an error over the bound of the largest term of its entry; both are of the ranges.
cl_RA largest_relative(const Reduction& reduction) {
  cl_RA relative = 0;
  for (const ReducedOutput& output : reduction.outputs) {
    for (const EntryError& error : output.errors) {
      if (!error.largest || cln::zerop(*error.largest)) continue;
      relative = cln::max(relative, error.constant / *error.largest);
    }
  }
  return relative;
}

}  // namespace

std::string dropped_summary(const Program& program) {
  if (!program.reduction) return {};
  const Reduction& reduction = *program.reduction;
  const std::size_t count = reduction.terms.size();
  const bool grows = find_reduced(reduction, OutputKind::inverse_dynamics) != nullptr;
  if (count == 0) {
    return fmt::format("No term is below {} of its entry.", exact_text(reduction.below));
  }
  return fmt::format(
      "Approximate: {} below {} of the largest of their entry left out. Within the declared "
      "ranges an entry is off by at most {} of what its largest term can be{}.",
      counted(count, "term"), exact_text(reduction.below), rounded_up(largest_relative(reduction)),
      grows ? ", and inverse_dynamics by shares of the accelerations as well" : "");
}

std::string dropped_page(const Model& model, const Program& program) {
  if (!program.reduction) return "nothing is dropped: no `drop_below` in a scene\n";
  std::string text = dropped_summary(program) + "\n";
  if (program.reduction->terms.empty()) return text;
  return text + "\n" + dropped_table(model, *program.reduction) + "\n" +
         error_table(model, *program.reduction);
}

}  // namespace elgen
