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

/// The names of the constants "NAME_1", "NAME_2", ..., or their values.
std::vector<std::string> texts_of(const TemplateRow& row, const std::vector<SineConstant>& numbers,
                                  std::string_view name) {
  std::vector<std::string> texts;
  for (const SineConstant& number : numbers) {
    if (number.name.starts_with(name)) texts.push_back(row.at(number.name).string_value());
  }
  return texts;
}

/// The powers of x^2 that polynomials of up to `most` terms need, except x^2.
TemplateData powers_data(std::size_t most) {
  TemplateData higher(TemplateData::type::list);
  for (std::size_t level = 1; most > std::size_t{1} << level; ++level) {
    higher.push_back(TemplateRow{{"power", std::string(powers.at(level))},
                                 {"base", std::string(powers.at(level - 1))}});
  }
  return higher;
}

}  // namespace

TemplateRow sine_data(const SineNumbers& numbers, ScalarKind scalar, const LiteralWriter& literal,
                      SineSpelling spelling) {
  const bool is_float = scalar == ScalarKind::single_precision;
  TemplateRow row{{"element", std::string(name_of(scalar))},
                  {"integer", is_float ? "uint32_t" : "uint64_t"},
                  {"to_sign", is_float ? "30" : "62"},
                  {"sign_bit", is_float ? "31" : "63"},
                  {"half", literal(0.5)},
                  {"one", literal(1)}};
  std::vector<SineConstant> all = numbers.joint;
  all.insert(all.end(), numbers.lone.begin(), numbers.lone.end());
  for (const auto& [name, value] : all)
    row[name] = spelling == SineSpelling::names ? name : literal(value);
  const auto texts = [&](std::string_view name) { return texts_of(row, all, name); };
  row["parts"] = template_list(texts("part_"), 2, "part");
  const std::string element(name_of(scalar));
  const std::string type = spelling == SineSpelling::names ? "Native" : element;
  const EstrinPolynomial sine(texts("sine_"), "odd", type);
  const EstrinPolynomial cosine(texts("cosine_"), "even", type);
  row["powers"] = powers_data(std::max(texts("sine_").size(), texts("cosine_").size()));
  std::vector<std::string> lines = sine.lines();
  lines.insert(lines.end(), cosine.lines().begin(), cosine.lines().end());
  row["lines"] = template_list(lines, 0, "line");
  row["sine"] = sine.value();
  row["cosine"] = cosine.value();
  row["lone"] = optional_section(false);
  if (!numbers.lone.empty()) {
    const EstrinPolynomial lone(texts("lone_"), "odd", element);
    row["lone"] = TemplateRow{{"parts", template_list(texts("pi_"), 1, "part")},
                              {"powers", powers_data(texts("lone_").size())},
                              {"lines", template_list(lone.lines(), 0, "line")},
                              {"polynomial", lone.value()}};
  }
  row["constants"] = repeated_section(all, [&literal](const SineConstant& number) {
    return TemplateRow{{"constant", number.name}, {"number", literal(number.value)}};
  });
  return row;
}

TemplateData trigonometry_tables(const std::vector<ScalarKind>& scalars,
                                 const std::function<SineNumbers(ScalarKind)>& numbers_of) {
  const TemplateData elements = repeated_section(scalars, [&](ScalarKind scalar) {
    const auto literal = [scalar](double value) {
      const bool is_float = scalar == ScalarKind::single_precision;
      return shortest_literal(exact_value(value), scalar) + (is_float ? "F" : "");
    };
    return sine_data(numbers_of(scalar), scalar, literal, SineSpelling::names);
  });
  return optional_section(!scalars.empty(), TemplateRow{{"elements", elements}});
}

}  // namespace elgen
