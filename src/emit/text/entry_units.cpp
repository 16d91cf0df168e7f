// entry_units: rows separated by ";", entries by ",".
#include "emit/text/entry_units.hpp"

#include <set>

#include "check/judge/output_units.hpp"

namespace elgen {
namespace {

constexpr std::size_t longest_list = 60;  // beside the name of a field, on one line

}  // namespace

std::string units_text(const Model& model, OutputKind kind, const Field& field) {
  std::string list;
  std::set<std::string> different;
  for (std::size_t i = 0; i < field.rows; ++i) {
    for (std::size_t j = 0; j < field.columns; ++j) {
      const std::optional<Unit> unit = unit_of_entry(model, {kind, field.name, i, j});
      if (!unit) return "";
      const std::string text = to_string(*unit);
      different.insert(text);
      if (i + j > 0) list += j == 0 && field.columns > 1 ? "; " : ", ";
      list += text;
    }
  }
  if (different.size() == 1) return *different.begin();
  return list.size() <= longest_list ? list : "";
}

}  // namespace elgen
