// sine_data: polynomials by Horner's rule, one coefficient after another. In C++ numbers are
// members, so that device code has their values and tests can read them.
#include "emit/code/sine_data.hpp"

#include <string_view>

#include "numbers/exact_number.hpp"
#include "numbers/scalar_literal.hpp"

namespace elgen {
namespace {

TemplateData rows(const std::vector<std::string>& texts, std::size_t first, const char* hole) {
  TemplateData list(TemplateData::type::list);
  for (std::size_t i = first; i < texts.size(); ++i) list.push_back(TemplateData(hole, texts[i]));
  return list;
}

}  // namespace

TemplateRow sine_data(const std::vector<SineNumber>& numbers, ScalarKind scalar,
                      const SineLiteral& literal, SineSpelling spelling) {
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
    if (name.starts_with("sine_")) sines.insert(sines.begin(), text);
    if (name.starts_with("cosine_")) cosines.insert(cosines.begin(), text);
  }
  row["parts"] = rows(parts, 2, "part");
  row["sine"] = sines.front();
  row["sines"] = rows(sines, 1, "coefficient");
  row["cosine"] = cosines.front();
  row["cosines"] = rows(cosines, 1, "coefficient");
  row["constants"] = rows_data(numbers, [&literal](const SineNumber& number) {
    return TemplateRow{{"constant", number.name}, {"number", literal(number.value)}};
  });
  return row;
}

TemplateData trigonometry_tables(const Numerics& numerics, SinesOf arithmetic,
                                 const std::vector<ScalarKind>& scalars) {
  const TemplateData elements = rows_data(scalars, [&](ScalarKind scalar) {
    const auto literal = [scalar](double value) {
      const bool is_float = scalar == ScalarKind::single_precision;
      return shortest_literal(exact_value(value), scalar) + (is_float ? "F" : "");
    };
    return sine_data(sine_numbers(numerics, arithmetic, scalar), scalar, literal,
                     SineSpelling::names);
  });
  return section_if(!scalars.empty(), TemplateRow{{"elements", elements}});
}

}  // namespace elgen
