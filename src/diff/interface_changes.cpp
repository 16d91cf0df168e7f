// interface_changes: compares the names, counts, orders and units on which callers rely.
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "diff/renamed.hpp"
#include "elgen/diff.hpp"
#include "elgen/step_methods.hpp"
#include "elgen/wording.hpp"
#include "emit/interface/code_interface.hpp"
#include "model/requests.hpp"
#include "numbers/exact_number.hpp"

namespace elgen {
namespace {

/// An element of an array or a member of Parameters, which callers know by its name or position.
struct InterfaceMember {
  std::string name = {};
  std::string unit = {};
  std::size_t size = 1;
  std::optional<Unit> parsed_unit = {};  ///< `unit` for comparisons: rad is 1
};

using InterfaceMembers = std::vector<InterfaceMember>;

template <class Entry>
std::string unit_text_of(const Entry& entry) {
  return entry.unit_text;
}

/// The derived unit of f or phi, because models do not declare this unit.
std::string unit_text_of(const Constraint& constraint) {
  return constraint.unit ? to_string(*constraint.unit) : "";
}

template <class List>
InterfaceMembers members(const List& list, const Renames& renames) {
  InterfaceMembers all;
  for (const auto& entry : list) {
    all.push_back({apply_renames(entry.name, renames), unit_text_of(entry)});
    if constexpr (requires { entry.count; }) all.back().size = entry.count;
    if constexpr (requires { entry.unit; }) all.back().parsed_unit = entry.unit;
  }
  return all;
}

/// The members of the emitted Parameters.
InterfaceMembers members(const Model& model, const std::vector<ParameterArray>& arrays,
                         const Renames& renames) {
  InterfaceMembers all = members(arrays, renames);
  for (std::size_t i = 0; i < arrays.size(); ++i) {
    const bool is_known = arrays[i].first < model.parameters.size();
    if (is_known) all[i].parsed_unit = model.parameters[arrays[i].first].unit;
  }
  return all;
}

std::string name_list(const InterfaceMembers& members) {
  return fmt::format("{}", fmt::join(column_words(members, &InterfaceMember::name), ", "));
}

const InterfaceMember* find_member(const InterfaceMembers& members, const std::string& name) {
  const auto found = std::ranges::find(members, name, &InterfaceMember::name);
  return found == members.end() ? nullptr : &*found;
}

/// The changes found so far.
struct InterfaceChangeList {
  std::vector<InterfaceChange> all = {};

  void add(Impact impact, std::string text) { all.push_back({impact, std::move(text)}); }
  template <class... Values>
  void add(Impact impact, fmt::format_string<Values...> text, Values&&... values) {
    add(impact, fmt::format(text, std::forward<Values>(values)...));
  }

  void add_silent_break(const std::string& text) {
    all.push_back(
        {Impact::breaks, text + "; callers still compile but with another meaning", true});
  }
};

std::string unit_text(const InterfaceMember& member) {
  return member.unit.empty() ? "not declared" : member.unit;
}

void compare_units(InterfaceChangeList& changes, const std::string& what,
                   const InterfaceMembers& olds, const InterfaceMembers& news) {
  for (const InterfaceMember& now : news) {
    const InterfaceMember* const old = find_member(olds, now.name);
    if (old == nullptr || old->unit == now.unit) continue;
    // rad is 1, so N*m*s/rad and N*m*s are the same unit.
    const bool is_same =
        old->parsed_unit && now.parsed_unit && *old->parsed_unit == *now.parsed_unit;
    const std::string text = fmt::format("the unit of {} {} is {} (was {})", what,
                                         quote_text(now.name), unit_text(now), unit_text(*old));
    if (is_same) {
      changes.add(Impact::values, text);
    } else {
      changes.add_silent_break(text);
    }
  }
}

/// Compares the names at each position of an array, then the units by name.
void compare_lists(InterfaceChangeList& changes, const std::string& what,
                   const InterfaceMembers& olds, const InterfaceMembers& news) {
  if (olds.size() != news.size()) {
    changes.add(Impact::breaks, "{} (was {}): {} -> {}", count_text(news.size(), what), olds.size(),
                name_list(olds), name_list(news));
  } else if (name_list(olds) != name_list(news)) {
    changes.add_silent_break(fmt::format("the {}s or their order changed: {} -> {}", what,
                                         name_list(olds), name_list(news)));
  }
  compare_units(changes, what, olds, news);
}

std::string_view assumption_text(const Parameter& parameter) {
  constexpr std::array words{"any number", "positive", "nonnegative"};
  return words[static_cast<std::size_t>(parameter.assumption)];
}

void compare_parameter_values(InterfaceChangeList& changes, const Model& before, const Model& after,
                              const Renames& renames) {
  for (const Parameter& now : after.parameters) {
    const auto old = std::ranges::find_if(before.parameters, [&](const Parameter& p) {
      return apply_renames(p.name, renames) == now.name;
    });
    if (old == before.parameters.end()) continue;
    if (old->value != now.value) {
      changes.add(Impact::values, "the value of {} is {} (was {})", quote_text(now.name),
                  exact_text(now.value), exact_text(old->value));
    }
    if (old->assumption != now.assumption) {
      changes.add(Impact::values, "{} is assumed to be {} (was {})", quote_text(now.name),
                  assumption_text(now), assumption_text(*old));
    }
  }
}

void compare_names(InterfaceChangeList& changes, const Version& before, const Version& after,
                   const Renames& renames) {
  const std::vector<ParameterArray> old_arrays =
      emitted_parameters(before.checked.model, before.program);
  for (const auto& [from, to] : renames) {
    const bool is_member = std::ranges::count(old_arrays, from, &ParameterArray::name) > 0;
    changes.add(is_member ? Impact::breaks : Impact::values, "{} is now called {}",
                quote_text(from), quote_text(to));
  }
  if (before.checked.scene.base_name != after.checked.scene.base_name) {
    changes.add(Impact::breaks, "files are called {} (were {})",
                quote_text(after.checked.scene.base_name),
                quote_text(before.checked.scene.base_name));
  }
}

/// Compares the members of Parameters by name and by position.
void compare_parameters(InterfaceChangeList& changes, const InterfaceMembers& olds,
                        const InterfaceMembers& news) {
  for (const InterfaceMember& old : olds) {
    const InterfaceMember* const now = find_member(news, old.name);
    if (now == nullptr) {
      changes.add(Impact::breaks, "parameter {} is removed", quote_text(old.name));
    } else if (now->size != old.size) {
      changes.add(Impact::breaks, "parameter {} has {} (had {})", quote_text(old.name),
                  count_text(now->size, "element"), old.size);
    }
  }
  InterfaceMembers kept = news;
  std::erase_if(
      kept, [&olds](const InterfaceMember& now) { return find_member(olds, now.name) == nullptr; });
  InterfaceMembers stayed = olds;
  std::erase_if(stayed, [&news](const InterfaceMember& old) {
    return find_member(news, old.name) == nullptr;
  });
  if (name_list(kept) != name_list(stayed)) {
    changes.add_silent_break(fmt::format("the members of Parameters changed their order: {} -> {}",
                                         name_list(stayed), name_list(kept)));
  } else if (kept.size() < news.size()) {
    InterfaceMembers added = news;
    std::erase_if(added, [&olds](const InterfaceMember& now) {
      return find_member(olds, now.name) != nullptr;
    });
    const bool are_last =
        find_member(added, news[kept.size()].name) != nullptr &&
        name_list(InterfaceMembers(news.begin(),
                                   news.begin() + static_cast<std::ptrdiff_t>(kept.size()))) ==
            name_list(kept);
    // If members were removed, callers no longer compile, so no caller can confuse members.
    if (are_last || kept.size() < olds.size()) {
      changes.add(Impact::extended, "Parameters has new members: " + name_list(added));
    } else {
      changes.add_silent_break("Parameters has new members, not all at the end: " +
                               name_list(added));
    }
  }
  compare_units(changes, "parameter", olds, news);
}

void compare_steps(InterfaceChangeList& changes, const std::string& name, const StepSpec& old,
                   const StepSpec& now) {
  if (old.method != now.method) {
    changes.add(Impact::different, "the method of {} is {} (was {})", quote_text(name),
                step_method_row(now.method).name, step_method_row(old.method).name);
  } else if (old.composed_order != now.composed_order) {
    changes.add(Impact::different, "{} is of order {} (was {})", quote_text(name), step_order(now),
                step_order(old));
  } else if (old.iterations != now.iterations) {
    changes.add(Impact::different, "{} has {} (had {})", quote_text(name),
                count_text(now.iterations, "iteration"), old.iterations);
  } else if (old.projects != now.projects) {
    changes.add(Impact::different, "{} {}", quote_text(name),
                now.projects ? "ends on the constraints (drifted off before)"
                             : "drifts off the constraints (ended on them before)");
  }
}

void compare_outputs(InterfaceChangeList& changes, const Scene& before, const Scene& after) {
  for (const OutputRequest& old : before.outputs) {
    const OutputRequest* const now = find_request(after, old.name);
    if (now == nullptr) {
      changes.add(Impact::breaks, "function {} is removed", quote_text(old.name));
    } else if (now->kind != old.kind) {
      changes.add_silent_break(
          fmt::format("function {} is a different output", quote_text(old.name)));
    } else if (now->omits_pivots != old.omits_pivots) {
      changes.add(
          Impact::breaks, "{} {}", quote_text(now->name),
          now->omits_pivots ? "no longer returns relative pivots" : "now returns relative pivots");
    } else if (now->step) {
      compare_steps(changes, now->name, *old.step, *now->step);
    }
  }
  for (const OutputRequest& now : after.outputs) {
    if (find_request(before, now.name) != nullptr) continue;
    changes.add(Impact::extended, "function {} is new", quote_text(now.name));
  }
}

bool has_same_shape(const Function& old, const Function& now) {
  return std::ranges::equal(old.fields, now.fields, [](const Field& x, const Field& y) {
    return x.rows == y.rows && x.columns == y.columns;
  });
}

/// The shapes of all fields: "2 x 3, 2 x 1".
std::string shape_text(const Function& function) {
  std::string text;
  for (const Field& field : function.fields) {
    text += fmt::format("{}{} x {}", text.empty() ? "" : ", ", field.rows, field.columns);
  }
  return text;
}

/// Compares the shapes of user outputs and of constraint_residual. All other shapes follow from the
/// lists of coordinates, inputs and constraints.
void compare_shapes(InterfaceChangeList& changes, const Program& before, const Program& after) {
  for (const Function& now : after.functions) {
    const auto old = std::ranges::find(before.functions, now.name, &Function::name);
    const bool is_in_both = old != before.functions.end() && old->kind == now.kind;
    // The shape of the residual depends on the number of position constraints, which no list shows.
    const bool is_compared =
        output_row(now.kind).is_user_output || now.kind == OutputKind::constraint_residual;
    if (!is_in_both || !is_compared || has_same_shape(*old, now)) continue;
    changes.add(Impact::breaks, "{} is {} (was {})", quote_text(now.name), shape_text(now),
                shape_text(*old));
  }
}

/// Compares the rows and columns that are in no list of the interface. For example, the rows of
/// `reaction` are locked coordinates.
struct UnlistedAxes {
  const Version& before;
  const Version& after;
  const Renames& renames;

  void compare(InterfaceChangeList& changes, const std::string& lines, Extent extent) const {
    std::vector<std::string> olds = names_without_leaf(before.checked.model, extent);
    for (std::string& name : olds) name = apply_renames(name, renames);
    const std::vector<std::string> news = names_without_leaf(after.checked.model, extent);
    if (olds == news) return;
    changes.add_silent_break(fmt::format("the {} are {} (were {})", lines, fmt::join(news, ", "),
                                         fmt::join(olds, ", ")));
  }
};

void compare_unlisted_axes(InterfaceChangeList& changes, const Version& before,
                           const Version& after, const Renames& renames) {
  const UnlistedAxes lines{before, after, renames};
  for (const Function& now : after.program.functions) {
    const auto old = std::ranges::find(before.program.functions, now.name, &Function::name);
    if (old == before.program.functions.end() || old->kind != now.kind) continue;
    for (const FieldRow& row : output_row(now.kind).fields) {
      const std::string part = row.name.empty() ? "" : "." + std::string(row.name);
      const std::string of = " of " + quote_text(now.name + part);
      lines.compare(changes, "rows" + of, row.rows);
      lines.compare(changes, "columns" + of, row.columns);
    }
  }
}

void compare_header(InterfaceChangeList& changes, const char* suffix, bool was_there,
                    bool is_there) {
  if (was_there == is_there) return;
  changes.add(is_there ? Impact::extended : Impact::breaks, "header NAME{}.hpp is {}", suffix,
              is_there ? "new" : "removed");
}

void compare_target(InterfaceChangeList& changes, const Scene& before, const Scene& after) {
  const Emission& old = before.emission;
  const Emission& now = after.emission;
  if (old.language != now.language) changes.add(Impact::breaks, "the language of the code differs");
  if (name_space(before) != name_space(after) && before.base_name == after.base_name) {
    changes.add(Impact::breaks, "the namespace is {} (was {})", quote_text(name_space(after)),
                quote_text(name_space(before)));
  }
  if (old.storage != now.storage) {
    changes.add_silent_break(fmt::format("matrices are stored {} (were {})", name_of(now.storage),
                                         name_of(old.storage)));
  }
  compare_header(changes, "_eigen", old.has_eigen_header, now.has_eigen_header);
  compare_header(changes, "_batch", old.has_batch_header, now.has_batch_header);
  const InnerScalar old_inner = before.numerics.inner;
  const InnerScalar inner = after.numerics.inner;
  const bool was_wide = old_inner != InnerScalar::same;
  const bool is_wide = inner != InnerScalar::same;
  compare_header(changes, "_wide", was_wide, is_wide);
  if (was_wide && is_wide && old_inner != inner) {
    changes.add(Impact::values, "NAME_wide.hpp computes in {} (was {})",
                inner_scalar_row(inner).name, inner_scalar_row(old_inner).name);
  }
  if (before.numerics.trigonometry_error != after.numerics.trigonometry_error) {
    changes.add(Impact::values, "the allowed error of sines and cosines differs");
  }
  if (before.numerics.has_library_sines != after.numerics.has_library_sines) {
    changes.add(Impact::values, "sines and cosines outside batches are {} (were {})",
                after.numerics.has_library_sines ? "from the library" : "in line",
                before.numerics.has_library_sines ? "from the library" : "in line");
  }
  if (before.numerics.max_error != after.numerics.max_error) {
    changes.add(Impact::values, "the error bound that the scene promises for its outputs differs");
  }
  if (before.numerics.scalars != after.numerics.scalars) {
    const bool is_in_types = language_row(now.language).scalars == LanguageScalars::one;
    changes.add(is_in_types ? Impact::breaks : Impact::values,
                "the scalar types of the code differ");
  }
}

}  // namespace

std::vector<InterfaceChange> interface_changes(const Version& before, const Version& after,
                                               const Renames& renames) {
  const Model& old = before.checked.model;
  const Model& now = after.checked.model;
  InterfaceChangeList changes;
  const InterfaceMembers olds = members(old, emitted_parameters(old, before.program), renames);
  const InterfaceMembers news = members(now, emitted_parameters(now, after.program), {});
  compare_names(changes, before, after, renames);
  compare_lists(changes, "coordinate", members(old.coordinates, renames),
                members(now.coordinates, {}));
  compare_lists(changes, "input", members(old.inputs, renames), members(now.inputs, {}));
  compare_lists(changes, "constraint", members(old.constraints, renames),
                members(now.constraints, {}));
  compare_lists(changes, "open value", members(old.open_values, renames),
                members(now.open_values, {}));
  compare_parameters(changes, olds, news);
  compare_parameter_values(changes, old, now, renames);
  if (old.uses_time != now.uses_time) {
    changes.add(Impact::breaks,
                now.uses_time ? "every function now takes t" : "no function takes t any longer");
  }
  compare_outputs(changes, before.checked.scene, after.checked.scene);
  compare_shapes(changes, before.program, after.program);
  compare_unlisted_axes(changes, before, after, renames);
  compare_target(changes, before.checked.scene, after.checked.scene);
  return std::move(changes.all);
}

}  // namespace elgen
