// sine_data: polynomials by Estrin's scheme, whose chain of dependent operations is shorter than
// Horner's. In C++ the coefficients are members, so that device code and tests can read them.
#include "emit/code/sine_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "numbers/exact_number.hpp"
#include "numbers/scalar_literal.hpp"

namespace elgen {
namespace {

TemplateData template_list(const std::vector<std::string>& texts, std::size_t first,
                           const char* hole) {
  TemplateData list(TemplateData::type::list);
  for (std::size_t i = first; i < texts.size(); ++i) list.push_back(TemplateData(hole, texts[i]));
  return list;
}

/// The names of x^2, x^4, x^8 in the templates.
constexpr std::array<std::string_view, 3> powers{"square", "fourth", "eighth"};

/// Combines neighbours: terms to s0 = c0 + c1 x^2, sums to s0 + s1 x^4, and the results with x^8.
/// `polynomial` in program/evaluate/sines.cpp uses the same order.
class EstrinPolynomial {
 public:
  EstrinPolynomial(std::vector<std::string> terms, const std::string& name, std::string_view type)
      : terms_(std::move(terms)) {
    for (std::size_t level = 0; terms_.size() > 1; ++level) {
      std::vector<std::string> sums;
      for (std::size_t i = 0; i < terms_.size(); i += 2) {
        const bool is_first = level == 0 && i + 1 < terms_.size();
        sums.push_back(is_first ? fmt::format("{}_{}", name, sums.size() + 1) : terms_[i]);
        if (i + 1 == terms_.size()) continue;
        lines_.push_back(fmt::format("{}{} = {} + {} * {};",
                                     is_first ? fmt::format("{} ", type) : "", sums.back(),
                                     terms_[i], terms_[i + 1], powers.at(level)));
      }
      terms_ = std::move(sums);
    }
  }

  [[nodiscard]] const std::vector<std::string>& lines() const { return lines_; }
  [[nodiscard]] const std::string& value() const { return terms_.front(); }

 private:
  std::vector<std::string> terms_;
  std::vector<std::string> lines_ = {};
};

}  // namespace

TemplateRow sine_data(const std::vector<SineConstant>& numbers, ScalarKind scalar,
                      const LiteralWriter& literal, SineSpelling spelling) {
  const bool is_float = scalar == ScalarKind::single_precision;
  TemplateRow row{{"element", std::string(name_of(scalar))},
                  {"integer", is_float ? "uint32_t" : "uint64_t"},
                  {"to_sign", is_float ? "30" : "62"},
                  {"half", literal(0.5)},
                  {"one", literal(1)}};
  std::vector<std::string> parts;
  std::vector<std::string> sines;
  std::vector<std::string> cosines;
  for (const auto& [name, value] : numbers) {
    const std::string text = spelling == SineSpelling::names ? name : literal(value);
    row[name] = text;
    if (name.starts_with("part_")) parts.push_back(text);
    if (name.starts_with("sine_")) sines.push_back(text);
    if (name.starts_with("cosine_")) cosines.push_back(text);
  }
  row["parts"] = template_list(parts, 2, "part");
  TemplateData higher(TemplateData::type::list);
  const std::size_t most = std::max(sines.size(), cosines.size());
  for (std::size_t level = 1; most > std::size_t{1} << level; ++level) {
    higher.push_back(TemplateRow{{"power", std::string(powers.at(level))},
                                 {"base", std::string(powers.at(level - 1))}});
  }
  row["powers"] = std::move(higher);
  const std::string type =
      spelling == SineSpelling::names ? "Native" : std::string(name_of(scalar));
  const EstrinPolynomial sine(std::move(sines), "odd", type);
  const EstrinPolynomial cosine(std::move(cosines), "even", type);
  std::vector<std::string> lines = sine.lines();
  lines.insert(lines.end(), cosine.lines().begin(), cosine.lines().end());
  row["lines"] = template_list(lines, 0, "line");
  row["sine"] = sine.value();
  row["cosine"] = cosine.value();
  row["constants"] = repeated_section(numbers, [&literal](const SineConstant& number) {
    return TemplateRow{{"constant", number.name}, {"number", literal(number.value)}};
  });
  return row;
}

TemplateData trigonometry_tables(const Numerics& numerics, SineArithmetic arithmetic,
                                 const std::vector<ScalarKind>& scalars) {
  const TemplateData elements = repeated_section(scalars, [&](ScalarKind scalar) {
    const auto literal = [scalar](double value) {
      const bool is_float = scalar == ScalarKind::single_precision;
      return shortest_literal(exact_value(value), scalar) + (is_float ? "F" : "");
    };
    return sine_data(sine_constants(numerics, arithmetic, scalar), scalar, literal,
                     SineSpelling::names);
  });
  return optional_section(!scalars.empty(), TemplateRow{{"elements", elements}});
}

}  // namespace elgen
