// compare: finds the changes between two versions, and the impact of each change.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <set>

#include "diff/renamed.hpp"
#include "elgen/diff.hpp"
#include "verify/structure/expectations.hpp"

namespace elgen {
namespace {

constexpr std::array impact_rows{
#define ELGEN_IMPACT(name, doc) ImpactRow{#name, doc},
#include "elgen/impacts.def"
#undef ELGEN_IMPACT
};

/// Keys, in any entry, on which no equation depends. The `sample` of a function without an
/// expression only affects runs.
constexpr std::array descriptive_keys{"doc",   "latex",  "title",    "description", "reference",
                                      "range", "limits", "min",      "max",         "rate_range",
                                      "wrap",  "start",  "singular", "sample"};

/// True if a step of the key's path is in `descriptive_keys` and is not a name that a user chose.
bool has_descriptive_key(const KeyChange& change) {
  std::string table = change.table;
  for (const PathComponent& step : change.path) {
    const bool is_name = has_names_for_keys(table);
    if (!is_name && std::ranges::count(descriptive_keys, step.key) > 0) return true;
    table += "." + (is_name ? "*" : step.key);
  }
  return false;
}

/// True if the key affects drawings only.
bool affects_drawing_only(const KeyChange& change) {
  return !change.path.empty() && elgen::is_drawing_key(change.table, change.path.front().key);
}

/// True if only a number changes: `m` or `m.value` of a model, `fixed` or an accuracy of a scene.
bool changes_only_number(const KeyChange& change) {
  if (change.table == "scene.parameters") return true;
  const bool is_both = !change.before.empty() && !change.after.empty();
  if (change.is_reordering || !is_both) return false;
  const std::vector<PathComponent>& path = change.path;
  if (change.table == "scene.numeric") {
    const std::string& key = path.front().key;
    return key == "trigonometry" || key == "max_error" || key == "ranges";
  }
  return change.table == "parameters" && (path.size() == 1 || path[1].key == "value");
}

/// The least impact of a changed key, before values and equations are compared. If a scene begins
/// or ceases to fix a parameter, the impact is at least `values`, because a parameter becomes a
/// number, or a number becomes a parameter.
Impact least_impact(const KeyChange& change) {
  const bool is_fixed =
      change.table == "scene.parameters" && (change.before.empty() || change.after.empty());
  const bool is_secondary = is_fixed || change.table == "expect" || change.table == "equilibrium" ||
                            has_descriptive_key(change);
  return is_secondary ? Impact::values : Impact::equal;
}

bool has_entry_verdict(const std::vector<OutputChange>& outputs, EntryVerdict verdict) {
  return std::ranges::any_of(outputs, [verdict](const OutputChange& output) {
    return std::ranges::count(output.entries, verdict, &EntryChange::verdict) > 0;
  });
}

void mark_undecided_different(std::vector<OutputChange>& outputs) {
  for (OutputChange& output : outputs) {
    for (EntryChange& entry : output.entries) {
      if (entry.verdict == EntryVerdict::undecided) entry.verdict = EntryVerdict::different;
    }
  }
}

Impact impact_of(const std::vector<KeyChange>& keys) {
  Impact worst = Impact::equal;
  for (const KeyChange& key : keys) worst = std::max(worst, least_impact(key));
  return worst;
}

/// True if the change moves an equilibrium. Equations may then change, because a scene may expand
/// the equations about this equilibrium.
bool is_moved_equilibrium(const KeyChange& key) {
  if (key.table != "equilibrium" || key.path.empty()) return false;
  return key.path.front().key == "at" || key.path.front().key == "inputs";
}

bool may_change_equations(const KeyChange& key) {
  if (affects_drawing_only(key)) return false;
  if (is_moved_equilibrium(key)) return true;
  return least_impact(key) == Impact::equal && !changes_only_number(key);
}

/// True if callers see what the key declares: names, orders, functions, or the target language.
bool affects_interface(const KeyChange& key) {
  constexpr std::array tables{"model",  "sizes",      "coordinate", "input",
                              "output", "constraint", "parameters", "function"};
  const bool is_seen = key.is_reordering || key.table.starts_with("scene.") ||
                       std::ranges::count(tables, key.table) > 0;
  return is_seen && (may_change_equations(key) || key.table == "scene.parameters");
}

/// Sets the impact of each key to the worst impact that this key alone may have.
void set_key_impacts(SystemChange& system, Impact of_entries) {
  Impact of_interface = Impact::equal;
  for (const InterfaceChange& change : system.interface) {
    if (change.impact > Impact::values) of_interface = std::max(of_interface, change.impact);
  }
  const bool is_said = std::ranges::any_of(system.keys, affects_interface);
  for (KeyChange& key : system.keys) {
    if (affects_drawing_only(key)) continue;
    const bool is_equation = may_change_equations(key);
    key.impact = is_equation ? of_entries : Impact::values;
    const bool may_break = is_said ? affects_interface(key) : is_equation;
    if (may_break) key.impact = std::max(key.impact, of_interface);
  }
}

/// Adds the renames of the components of renamed wrenches: f_tx of f.
void rename_components(const Model& before, Renames& renames) {
  for (const Input& input : before.inputs) {
    const std::string wrench = input.indexed_name.substr(0, input.indexed_name.find('['));
    const auto found = renames.find(wrench);
    if (wrench.empty() || found == renames.end()) continue;
    renames[input.name] = found->second + input.name.substr(wrench.size());
  }
}

std::string source_text(const SourcePointer& source) { return source ? source->text : ""; }

/// The syntax of the scene; an empty file for a model without a scene.
const FileSyntax& scene_syntax(const Version& version) {
  static const FileSyntax no_keys;
  return version.scene == nullptr ? no_keys : *version.scene;
}

bool has_same_texts(const Version& before, const Version& after) {
  return source_text(before.model.source) == source_text(after.model.source) &&
         source_text(scene_syntax(before).source) == source_text(scene_syntax(after).source);
}

/// The parameters that only the newer version has, each with the value 0.
ParameterValues new_parameters(const Version& before, const Version& after,
                               const Renames& renames) {
  ParameterValues values;
  for (const Parameter& now : after.checked.model.parameters) {
    const auto is_it = [&](const Parameter& old) {
      return apply_renames(old.name, renames) == now.name;
    };
    if (std::ranges::any_of(before.checked.model.parameters, is_it)) continue;
    values.emplace(now.name, rational_constant(0));
  }
  return values;
}

/// "at mt = 0 all entries equal the old entries (proved)"; "" if an entry differs, or if the newer
/// version has no new parameter.
std::string extension_text(const Version& before, const Version& after,
                           const CompareOptions& options) {
  const ParameterValues values = new_parameters(before, after, options.renames);
  if (values.empty()) return {};
  bool is_proved = true;
  for (const OutputChange& output : output_changes(before, after, options.renames, values)) {
    for (const EntryChange& entry : output.entries) {
      const bool is_new = entry.verdict == EntryVerdict::added;
      const bool is_undecided = entry.verdict == EntryVerdict::undecided;
      const bool is_old =
          is_new || entry.verdict == EntryVerdict::equal || (is_undecided && !options.is_strict);
      if (!is_old) return {};
      is_proved = is_proved && (entry.is_proved || is_new);
    }
  }
  std::string names;
  for (const auto& [name, value] : values) names += fmt::format("{} = ", name);
  return fmt::format("at {}0 all entries equal the old entries ({})", names,
                     is_proved ? "proved" : "at 64 random points");
}

/// The names of the [[expect]] entries that do not hold.
std::set<std::string> wrong_expectations(const Version& version) {
  const SystemUnderTest subject{version.checked.model, version.checked.scene, version.program};
  std::set<std::string> wrong;
  for (const CertificateRow& row : check_expectations(subject, nullptr, 1).rows) {
    if (row.verdict == Verdict::fails) wrong.insert(row.subject);
  }
  return wrong;
}

std::vector<std::string> broken_expectations(const Version& before, const Version& after) {
  const std::set<std::string> now = wrong_expectations(after);
  if (now.empty()) return {};
  const std::set<std::string> old = wrong_expectations(before);
  std::vector<std::string> broken;
  std::ranges::set_difference(now, old, std::back_inserter(broken));
  return broken;
}

Diagnostics new_warnings(const Version& before, const Version& after) {
  Diagnostics found = after.warnings;
  std::erase_if(found, [&before](const Diagnostic& now) {
    return std::ranges::any_of(before.warnings, [&now](const Diagnostic& old) {
      return old.code == now.code && old.message == now.message;
    });
  });
  return found;
}

/// The changed keys of the model, then of the scene.
std::vector<KeyChange> all_changed_keys(const Version& before, const Version& after,
                                        const Renames& renames) {
  std::vector<KeyChange> keys = changed_keys(before.model, after.model, renames);
  const std::vector<KeyChange> more =
      changed_keys(scene_syntax(before), scene_syntax(after), renames);
  keys.insert(keys.end(), more.begin(), more.end());
  return keys;
}

/// The functions whose numbers of operations changed; none if a version has no numbers of
/// operations.
std::optional<std::vector<OperationsChange>> operations_changes(const Version& before,
                                                                const Version& after) {
  if (before.operations == nullptr || after.operations == nullptr) return std::nullopt;
  std::vector<OperationsChange> changes;
  for (const auto& [name, now] : *after.operations) {
    const auto old = before.operations->find(name);
    if (old == before.operations->end() || old->second == now) continue;
    changes.push_back({name, old->second, now});
  }
  return changes;
}

/// The impact of entries that differ. `are_values`: only values of parameters changed.
Impact impact_of_entries(const SystemChange& system, bool are_values) {
  if (are_values) return Impact::values;
  return system.extension.empty() ? Impact::different : Impact::extended;
}

}  // namespace

const ImpactRow& impact_row(Impact impact) { return impact_rows[static_cast<std::size_t>(impact)]; }

std::optional<Impact> find_impact(std::string_view word) {
  const auto found = std::ranges::find(impact_rows, word, &ImpactRow::word);
  if (found == impact_rows.end()) return std::nullopt;
  return static_cast<Impact>(found - impact_rows.begin());
}

bool has_changes(const SystemChange& system) {
  return !system.keys.empty() || !system.interface.empty();
}

SystemChange compare(const Version& before, const Version& after, const CompareOptions& options) {
  CompareOptions all = options;
  rename_components(before.checked.model, all.renames);
  const Renames& renames = all.renames;
  SystemChange result{.name = after.checked.scene.base_name};
  result.keys = all_changed_keys(before, after, renames);
  if (has_same_texts(before, after)) return result;
  result.impact = impact_of(result.keys);
  if (result.keys.empty() && renames.empty()) return result;
  result.outputs = output_changes(before, after, renames);
  if (options.is_strict) mark_undecided_different(result.outputs);
  result.is_certain = !has_entry_verdict(result.outputs, EntryVerdict::undecided);
  result.interface = interface_changes(before, after, renames);
  result.operations = operations_changes(before, after);
  result.warnings = new_warnings(before, after);
  result.broken_expectations = broken_expectations(before, after);
  Impact of_entries = Impact::equal;
  const bool are_values = std::ranges::none_of(result.keys, may_change_equations);
  if (has_entry_verdict(result.outputs, EntryVerdict::different)) {
    if (!are_values) result.extension = extension_text(before, after, all);
    of_entries = impact_of_entries(result, are_values);
  }
  set_key_impacts(result, of_entries);
  result.impact = std::max(result.impact, of_entries);
  for (const InterfaceChange& change : result.interface) {
    result.impact = std::max(result.impact, change.impact);
  }
  const std::set<std::string>& wanted = options.reported_outputs;
  std::erase_if(result.outputs, [&wanted](const OutputChange& output) {
    return !wanted.empty() && wanted.count(output.name) == 0;
  });
  return result;
}

}  // namespace elgen
