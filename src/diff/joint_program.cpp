// joint_program: joins functions by value numbering, which finds instructions that the joint
// function already contains. Matches entries by the names of rows and columns in the output table.
#include "diff/joint_program.hpp"

#include <algorithm>

#include "diff/renamed.hpp"
#include "emit/interface/code_interface.hpp"
#include "model/output_units.hpp"
#include "model/requests.hpp"
#include "program/network/instructions.hpp"

namespace elgen {
namespace {

LeafNames with_renames(LeafNames names, const Renames& renames) {
  for_each_leaf(
      [&renames](Opcode, std::uint32_t, std::string& name) { name = apply_renames(name, renames); },
      static_cast<LeafValues<std::string>&>(names));
  return names;
}

Assumption weaker_assumption(Assumption x, Assumption y) {
  if (x == Assumption::none || y == Assumption::none) return Assumption::none;
  return x == y ? x : Assumption::nonnegative;
}

/// Appends the instructions of a function to another function; returns the indices of the entries.
class FunctionCopier {
 public:
  FunctionCopier(const Program& from, const LeafValues<std::uint32_t>& places, Program& to,
                 InstructionBuilder& instructions)
      : from_(from), places_(places), to_(to), instructions_(instructions) {}

  std::vector<std::uint32_t> operator()(const Function& function, const ParameterValues& values) {
    std::vector<std::uint32_t> copies;
    for (Instruction i : function.instructions) {
      if (is_leaf(i.opcode)) {
        i = map_leaf(i, values);
      } else if (i.opcode == Opcode::constant) {
        i.a = intern_constant(from_.constants[i.a], to_.constants);
      }
      copies.push_back(instructions_.add(renumber_operands(i, copies)));
    }
    std::vector<std::uint32_t> entries;
    for (const std::uint32_t entry : entries_of(function)) entries.push_back(copies[entry]);
    return entries;
  }

 private:
  Instruction map_leaf(Instruction i, const ParameterValues& values) {
    const auto value = i.opcode == Opcode::parameter
                           ? values.find(leaf_of(from_.leaves, i.opcode, i.a))
                           : values.end();
    if (value != values.end()) {
      return {.opcode = Opcode::constant, .a = intern_constant(value->second, to_.constants)};
    }
    if (leaf_list(places_, i.opcode) != nullptr) i.a = leaf_of(places_, i.opcode, i.a);
    return i;
  }

  const Program& from_;
  const LeafValues<std::uint32_t>& places_;
  Program& to_;
  InstructionBuilder& instructions_;
};

}  // namespace

JointProgram::JointProgram(const Program& before, const Program& after, const Renames& renames)
    : before_(before), after_(after) {
  new_places_ = add_leaves(after.leaves);
  old_places_ = add_leaves(with_renames(before.leaves, renames));
}

auto JointProgram::add_leaves(const LeafNames& names) -> LeafIndices {
  LeafNames& joint = joint_.leaves;
  joint.uses_time = joint.uses_time || names.uses_time;
  LeafIndices places;
  const std::size_t known_before = joint.parameters.size();
#define ELGEN_LEAVES(kind, member, ...)                                                \
  for (const std::string& name : names.member) {                                       \
    const auto found = std::ranges::find(joint.member, name);                          \
    places.member.push_back(static_cast<std::uint32_t>(found - joint.member.begin())); \
    if (found == joint.member.end()) joint.member.push_back(name);                     \
  }
#define ELGEN_LEAF(kind, member, ...) \
  if (joint.member.empty()) joint.member = names.member;
#include "elgen/leaves.def"
#undef ELGEN_LEAVES
#undef ELGEN_LEAF
  // A parameter that both versions have gets the weaker of the two assumptions.
  joint.assumptions.resize(joint.parameters.size(), Assumption::none);
  for (std::uint32_t i = 0; i < names.parameters.size(); ++i) {
    Assumption& assumption = joint.assumptions[places.parameters[i]];
    const Assumption one = assumption_of(names, i);
    assumption = places.parameters[i] < known_before ? weaker_assumption(assumption, one) : one;
  }
  return places;
}

JointFunction JointProgram::join(const Function& before, const Function& after,
                                 const JointParameterValues& values) {
  JointFunction joint;
  joint.function.name = after.name;
  InstructionBuilder instructions(joint.function);
  joint.before = FunctionCopier(before_, old_places_, joint_, instructions)(before, values.before);
  joint.after = FunctionCopier(after_, new_places_, joint_, instructions)(after, values.after);
  return joint;
}

namespace {

using Labels = std::vector<std::string>;

/// The labels of rows or columns, in the names of the newer version. Rows of an [[output]] are
/// numbered, because the output may have been renamed.
Labels labels_of(const Model& model, const Renames& renames, Extent extent,
                 std::uint32_t user = 0) {
  Labels labels;
  for (const FieldLine& line : extent_lines(model, extent, user)) {
    labels.push_back(line.is_numbered ? std::to_string(line.number + 1)
                                      : apply_renames(line.text(), renames));
  }
  return labels;
}

/// The labels "1", "2", …, for fields that the output table lacks, such as the diagonal of M.
Labels number_labels(std::uint32_t count) {
  Labels labels;
  for (std::uint32_t i = 1; i <= count; ++i) labels.push_back(std::to_string(i));
  return labels;
}

/// Identifies an entry of an output.
struct EntryKey {
  std::string field = {};
  std::string row = {};
  std::string column = {};
  friend auto operator<=>(const EntryKey&, const EntryKey&) = default;
};

struct LabelledEntry {
  EntryKey key = {};
  std::string place = {};
  std::string unit = {};
};

/// True if both versions have the same order of elimination, on which the pivots of M and of
/// A M^-1 A^T depend.
bool has_same_pivot_order(const Model& before, const Model& after, const Renames& renames) {
  return labels_of(before, renames, Extent::pivots) == labels_of(after, {}, Extent::pivots);
}

std::vector<LabelledEntry> label_entries(const Model& model, const Function& function,
                                         const Renames& renames) {
  std::vector<LabelledEntry> all;
  for (const Field& field : function.fields) {
    const FieldRow& row = field_row(function.kind, field.name);
    const bool is_named = field.name == row.name;
    const auto labels = [&](Extent extent, std::uint32_t count) {
      return is_named ? labels_of(model, renames, extent, function.user) : number_labels(count);
    };
    const Labels rows = labels(row.rows, field.rows);
    const Labels columns = labels(row.columns, field.columns);
    const std::string name = field.name.empty() ? function.name : function.name + "." + field.name;
    for (std::size_t i = 0; i < field.entries.size(); ++i) {
      const std::size_t r = i / field.columns;
      const std::size_t c = i % field.columns;
      all.push_back({{field.name, rows[r], columns[c]},
                     name + index_text(field, i),
                     unit_text_of_entry(model, {function.kind, field.name, r, c})});
    }
  }
  return all;
}

}  // namespace

std::vector<MatchedEntry> match_entries(const Model& old_model, const Function& before,
                                        const Model& new_model, const Function& after,
                                        const Renames& renames) {
  const std::vector<LabelledEntry> olds = label_entries(old_model, before, renames);
  const std::vector<LabelledEntry> news = label_entries(new_model, after, {});
  const bool has_pivots =
      !output_row(after.kind).gives_pivots || has_same_pivot_order(old_model, new_model, renames);
  const auto is_compared = [has_pivots](const LabelledEntry& entry) {
    return has_pivots || entry.key.field != "relative_pivots";
  };
  std::map<EntryKey, std::size_t> known;
  for (std::size_t i = 0; i < olds.size(); ++i) {
    if (is_compared(olds[i])) known.emplace(olds[i].key, i);
  }
  std::vector<MatchedEntry> matched;
  for (std::size_t i = 0; i < news.size(); ++i) {
    if (!is_compared(news[i])) continue;
    MatchedEntry entry{{}, i, news[i].place, news[i].unit};
    if (const auto old = known.find(news[i].key); old != known.end()) {
      entry.before = old->second;
      known.erase(old);
    }
    matched.push_back(std::move(entry));
  }
  for (std::size_t i = 0; i < olds.size(); ++i) {
    if (known.count(olds[i].key) > 0) matched.push_back({i, {}, olds[i].place, olds[i].unit});
  }
  return matched;
}

}  // namespace elgen
