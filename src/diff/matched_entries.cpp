// matched_entries: rows and columns have the names of what the output table says they stand for.
#include "diff/matched_entries.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "diff/renamed.hpp"
#include "emit/interface/code_interface.hpp"
#include "model/output_units.hpp"
#include "model/requests.hpp"

namespace elgen {
namespace {

/// The coordinate, rate, input or constraint that a row or column stands for, or its number.
struct LineLabel {
  std::string name = {};
  bool is_rate = false;
  friend auto operator<=>(const LineLabel&, const LineLabel&) = default;
};
using LineLabels = std::vector<LineLabel>;

/// LineLabels of models, with the names of the newer version.
class Labelling {
 public:
  Labelling(const Model& model, const Renames& renames) : model_(model), renames_(renames) {}

  /// Numbers where rows or columns are none of these.
  [[nodiscard]] LineLabels operator()(Extent extent, std::uint32_t count) const {
    LineLabels labels;
    if (extent == Extent::coordinates) add(model_.coordinates, false, labels);
    if (extent == Extent::inputs) add(model_.inputs, false, labels);
    if (extent == Extent::velocities) add(model_.velocities, false, labels);
    if (extent == Extent::states) {
      add(model_.velocities, false, labels);
      add(model_.velocities, true, labels);
    }
    if (extent == Extent::pivots) add(model_.velocities, false, labels);
    if (extent == Extent::constraints || extent == Extent::pivots) {
      add(model_.constraints, false, labels);
    }
    if (extent == Extent::positions) {
      std::vector<Constraint> positions = model_.constraints;
      std::erase_if(positions, [](const Constraint& c) { return !c.is_position; });
      add(positions, false, labels);
    }
    while (labels.size() < count) labels.push_back({std::to_string(labels.size() + 1)});
    return labels;
  }

 private:
  template <class List>
  void add(const List& list, bool is_rate, LineLabels& labels) const {
    for (const auto& entry : list) labels.push_back({renamed(entry.name, renames_), is_rate});
  }

  const Model& model_;
  const Renames& renames_;
};

/// The properties that tell an entry from the others.
struct EntryKey {
  std::string field = {};
  LineLabel row = {};
  LineLabel column = {};
  friend auto operator<=>(const EntryKey&, const EntryKey&) = default;
};

struct Labelled {
  EntryKey key = {};
  std::string place = {};
  std::string unit = {};
};

/// The pivots of M and of A M^-1 A^T depend on the order in which they are eliminated.
bool same_order(const Model& before, const Model& after, const Renames& renames) {
  return Labelling(before, renames)(Extent::pivots, 0) == Labelling(after, {})(Extent::pivots, 0);
}

std::vector<Labelled> labelled(const Model& model, const Function& function,
                               const Renames& renames) {
  const Labelling labels(model, renames);
  std::vector<Labelled> all;
  for (const Field& field : function.fields) {
    const FieldRow& row = field_row(function.kind, field.name);
    const LineLabels rows = labels(row.rows, field.rows);
    const LineLabels columns = labels(row.columns, field.columns);
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

std::vector<MatchedEntry> matched_entries(const Model& old_model, const Function& before,
                                          const Model& new_model, const Function& after,
                                          const Renames& renames) {
  const std::vector<Labelled> olds = labelled(old_model, before, renames);
  const std::vector<Labelled> news = labelled(new_model, after, {});
  const bool has_pivots =
      !output_row(after.kind).gives_pivots || same_order(old_model, new_model, renames);
  const auto is_compared = [has_pivots](const Labelled& entry) {
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
