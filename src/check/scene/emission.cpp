// Emission: words of the choice table become enumerators, and what does not go together is refused
// where it is written.
#include "check/scene/emission.hpp"

#include <algorithm>
#include <array>

#include "check/expressions/values.hpp"
#include "check/names/reserved_names.hpp"

namespace elgen {

std::string_view name_of(Storage storage) {
  return storage == Storage::row_major ? "row-major" : "column-major";
}

namespace {

LanguageId language_named(std::string_view name) {
  const auto* const row = std::find_if(language_table.begin(), language_table.end(),
                                       [name](const LanguageRow& r) { return r.name == name; });
  return row == language_table.end() ? LanguageId::cpp : row->id;
}

bool fits_one_scalar(const Numerics& numerics) {
  return numerics.scalars.size() == 1 && numerics.scalars.front() != ScalarKind::long_double;
}

void check_together(const FileSyntax* syntax, const Emission& emission, const Scene& scene,
                    Report& report) {
  const LanguageRow& language = language_row(emission.language);
  const std::string name = in_backticks(language.name);
  const KeySyntax* scalar = find_key(syntax, "numeric", "scalar");
  if (scalar != nullptr && language.scalars == LanguageScalars::one &&
      !fits_one_scalar(scene.numerics)) {
    report.add(Code::E610, scalar->value.span,
               "code in " + name + " is written for one scalar, `float` or `double`");
  }
  if (emission.eigen && emission.language != LanguageId::cpp) {
    report.add(Code::E611, find_key(syntax, "emit", "eigen")->key_span,
               "`eigen` needs C++, and `language` is " + name);
  }
}

bool lists(const KeySyntax& key, std::string_view word) {
  const auto& items = key.value.items;
  return std::any_of(items.begin(), items.end(),
                     [word](const ValueSyntax& item) { return item.text == word; });
}

/// Code is always written.
void read_files(const KeySyntax& key, Emission& emission, Report& report) {
  emission.equations = lists(key, "equations");
  emission.page = lists(key, "page");
  if (lists(key, "header")) return;
  report.add(Code::E112, key.value.span, "`files` has no `header`, which is always written");
}

}  // namespace

Emission read_emission(Context& context, const FileSyntax* syntax, const Scene& scene) {
  Emission emission;
  emission.name_space = scene.base_name;
  emission.name_space_span = context.model.name_span;
  if (const KeySyntax* key = find_key(syntax, "emit", "namespace")) {
    emission.name_space = key->value.text;
    emission.name_space_span = key->value.span;
    (void)check_name(key->value.text, key->value.span, context.report);
  }
  if (const KeySyntax* key = find_key(syntax, "emit", "language")) {
    emission.language = language_named(key->value.text);
  }
  if (const KeySyntax* key = find_key(syntax, "emit", "storage")) {
    const bool is_column_major = key->value.text == name_of(Storage::column_major);
    emission.storage = is_column_major ? Storage::column_major : Storage::row_major;
  }
  const KeySyntax* eigen = find_key(syntax, "emit", "eigen");
  emission.eigen = eigen != nullptr && eigen->value.boolean;
  if (const KeySyntax* key = find_key(syntax, "emit", "files")) {
    read_files(*key, emission, context.report);
  }
  check_together(syntax, emission, scene, context.report);
  return emission;
}
}  // namespace elgen
