// Page: what an analysis found, as it is read: once in the model language, once in LaTeX.
#pragma once

#include <string>
#include <vector>

#include "analyse/formulas.hpp"
#include "elgen/analyse.hpp"

namespace elgen {

/// `left` = a number, or a matrix of `rows` x `columns` entries.
struct PageMatrix {
  Printed left = {};
  std::uint32_t rows = 1;
  std::uint32_t columns = 1;
  std::vector<Printed> entries = {};
};

struct PageTable {
  std::vector<Printed> heads = {};
  std::vector<Printed> cells = {};  ///< row-major
};

/// A paragraph: lines between blank lines.
struct PagePart {
  std::vector<Printed> lines = {};
  std::vector<PageMatrix> matrices = {};
  PageTable table = {};
  bool is_row = false;     ///< matrices stand side by side where there is room
  std::string title = {};  ///< above all; may be empty, as the text below it
  std::string doc = {};
};

struct AnalysisPage {
  Printed title = {};
  std::vector<PagePart> parts = {};
};

/// Prose.
[[nodiscard]] Printed prose(const std::string& text);
/// Side by side, a blank between them.
[[nodiscard]] Printed operator+(const Printed& left, const Printed& right);
/// "a, b, c"
[[nodiscard]] Printed with_commas(const std::vector<Printed>& items);
/// "name = value"
[[nodiscard]] Printed equation(const Printed& name, const Printed& value);
/// "a", "a and b", "a, b and c"
[[nodiscard]] Printed listed(const std::vector<Printed>& items);
/// Six digits.
[[nodiscard]] Printed number(const cln::cl_R& value);
[[nodiscard]] Printed number(double value);

/// The symbols of the leaves of a model.
[[nodiscard]] LeafValues<Printed> symbols_of(const Model& model);

/// "TITLE, p_φ = 0.6 N m s: SUBJECT": the model with the momenta that its scene holds.
[[nodiscard]] Printed titled(const CheckedModel& checked, const std::string& subject);

/// Whether a point is the other one with the signs of all angles acos(c) turned.
[[nodiscard]] bool is_mirrored(ClosedForms& forms, const RestPoint& here, const RestPoint& next);

[[nodiscard]] Sheet sheet_of(const AnalysisPage& page);
[[nodiscard]] std::string text_of(const AnalysisPage& page);

}  // namespace elgen
