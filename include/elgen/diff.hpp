// diff: the changes between two versions of a model or a scene, as mathematics.
//
//     keys of the files      the causes, by position in the parsed trees
//     entries of outputs     the effects: equal (proved or sampled), or different
//     the interface          names, types and order that callers of the code rely on
//
// Entries of both versions are written over the union of their leaves, matched by name. Entries
// with the same instructions are identical. Otherwise, equality is proved by the closed form of the
// difference, or shown by 64 random points; if neither succeeds, the entries differ. Entries with
// roots or kinks that agree at all points, inside the ranges and beyond, are undecided: they may
// differ elsewhere.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "elgen/program.hpp"
#include "elgen/scene.hpp"
#include "elgen/syntax.hpp"

namespace elgen {

/// The effect of a change on users of the code (impacts.def), in ascending order of the harm.
enum class Impact : std::uint8_t {
#define ELGEN_IMPACT(name, doc) name,
#include "elgen/impacts.def"
#undef ELGEN_IMPACT
};

struct ImpactRow {
  std::string_view word;
  std::string_view doc;
};

[[nodiscard]] const ImpactRow& impact_row(Impact impact);

/// The impact with ImpactRow::word = `word`; none if no impact has this word.
[[nodiscard]] std::optional<Impact> find_impact(std::string_view word);

/// Renamed entries, old name -> new name.
using Renames = std::map<std::string, std::string>;

/// Name of a parameter -> the number that replaces the parameter.
using ParameterValues = std::map<std::string, Constant>;

/// One component of a path to a value: a key, or an item of a list.
struct PathComponent {
  std::string key = {};
  std::size_t item = 0;  ///< number of the item, from 1; 0: the component is a key
  friend bool operator==(const PathComponent&, const PathComponent&) = default;
};

/// `path` as text: "vector[2]", "start.value".
[[nodiscard]] std::string text_of(const std::vector<PathComponent>& path);

/// One changed key. Spans point into the version that has the key.
struct KeyChange {
  std::string table = {};  ///< name of the table in key_table(): "gravity", "scene.parameters"
  std::string entry = {};  ///< name of the entry for readers: "[gravity]", "[[point]] bob"
  std::vector<PathComponent> path = {};  ///< path of the key in the entry; empty: the whole entry
  bool is_reordering = false;  ///< true: the order of entries, or of keys that are names, changed
  std::string before = {};     ///< old value as written; "" if the key is new
  std::string after = {};      ///< new value as written; "" if the key is gone
  Span old_span = {};
  Span new_span = {};
  Impact impact = Impact::equal;  ///< the worst effect that this key alone could have; the actual
                                  ///< effect is determined for all changed keys together
};

/// The changed keys, in the order of `after`, with missing keys last. Entries are matched by
/// `name`, else by `on`, `at` or `frame`, else by number; keys by name; items of lists by
/// number. A new or missing entry is one change. Cost: quadratic in the entries of a file and in
/// the keys of an entry.
[[nodiscard]] std::vector<KeyChange> changed_keys(const FileSyntax& before, const FileSyntax& after,
                                                  const Renames& renames = {});

enum class EntryVerdict : std::uint8_t {
  identical,  ///< the same instructions
  equal,      ///< different instructions, equal values
  undecided,  ///< equal at all points, but with roots or kinks: points are not conclusive
  different,
  added,
  removed,
};

/// A state at which an entry differs.
struct Witness {
  /// "theta = 0.3, dot(x) = -1.2": the leaves of the entry, in three digits.
  std::string state_text = {};
  double before = 0;  ///< value of the entry in the older version
  double after = 0;   ///< value of the entry in the newer version
};

struct EntryChange {
  std::string place = {};  ///< "gravity[2]", "linearization.A[1,2]"
  std::string unit = {};   ///< unit of the entry; "" if unknown
  EntryVerdict verdict = EntryVerdict::identical;
  bool is_proved = false;       ///< true: the closed form of the difference proves `equal`
  bool is_certain = true;       ///< false: sampled points agree, but prove nothing
  std::string before = {};      ///< closed form; "" if none is short enough to read
  std::string after = {};       ///< closed form; "" if none is short enough to read
  std::string difference = {};  ///< closed form of `after` - `before`; "" if too long
  double relative_change =
      0;  ///< largest |change| / largest magnitude of the entry, over the sampled states
  std::optional<Witness> witness = {};
};

/// The changes of one output, which may exist in only one of the versions.
struct OutputChange {
  std::string name = {};
  std::size_t entry_count = 0;            ///< number of entries in the version with more entries
  std::vector<EntryChange> entries = {};  ///< all entries that are not identical
};

struct InterfaceChange {
  Impact impact = Impact::equal;
  std::string text = {};   ///< "function `bias` is removed"
  bool is_silent = false;  ///< true: callers still compile, but the meaning changes as `text` says
};

/// Executed operations of emitted functions, by the name of the function.
using OperationsByName = std::map<std::string, OperationCounts>;

/// One side of a comparison. The objects to which a Version refers must outlive the comparison.
struct Version {
  const FileSyntax& model;
  const FileSyntax* scene = nullptr;  ///< null: the built-in scene `full`
  const CheckedModel& checked;
  const Program& program;       ///< in chosen forms if an output is a step, else in recursive form
  const Diagnostics& warnings;  ///< warnings and notes of the pipeline
  const OperationsByName* operations = nullptr;  ///< counts of all emitted functions; null: unknown
};

struct CompareOptions {
  Renames renames = {};
  std::set<std::string> reported_outputs = {};  ///< names of the outputs to report; empty: all
  bool is_strict = false;                       ///< true: undecided entries count as different
};

/// The changes that callers of the code see: of coordinates, inputs, parameters, outputs, and the
/// target language.
[[nodiscard]] std::vector<InterfaceChange> interface_changes(const Version& before,
                                                             const Version& after,
                                                             const Renames& renames = {});

/// The changes of each output, in the order of the newer version; removed outputs last. `values`
/// replace parameters of the newer version.
[[nodiscard]] std::vector<OutputChange> output_changes(const Version& before, const Version& after,
                                                       const Renames& renames = {},
                                                       const ParameterValues& values = {});

/// The executed operations of the emitted function of one name in both versions.
struct OperationsChange {
  std::string function = {};
  OperationCounts before = {};
  OperationCounts after = {};
};

struct SystemChange {
  std::string name = {};  ///< Scene::base_name of the newer version
  std::string path = {};  ///< path of the newer version; "" if unknown
  Impact impact = Impact::equal;
  std::vector<KeyChange> keys = {};
  std::vector<OutputChange> outputs = {};
  std::vector<InterfaceChange> interface = {};
  /// The functions whose numbers of operations changed; none: the numbers are unknown.
  std::optional<std::vector<OperationsChange>> operations = {};
  bool is_certain = true;  ///< false: some entries are undecided
  /// If `impact` is `extended`: "at mt = 0 all entries equal the old entries (proved)".
  std::string extension = {};
  /// Entries of [[expect]] that fail in the newer version, but not in the older: "gravity[2,1]".
  std::vector<std::string> broken_expectations = {};
  Diagnostics warnings = {};  ///< only warnings that the older version lacks
};

/// All changes from `before` to `after`. `impact` considers all outputs; `outputs` has only
/// options.reported_outputs.
[[nodiscard]] SystemChange compare(const Version& before, const Version& after,
                                   const CompareOptions& options = {});

/// True if more than comments, blanks and the order of keys changed.
[[nodiscard]] bool has_changes(const SystemChange& system);

/// A model or scene that has errors in one of its versions, and the first of these errors.
struct UnreadableSystem {
  std::string path = {};
  Diagnostic error;
};

/// The changes of all models and scenes that one run of `elgen diff` compares.
struct DiffReport {
  std::vector<SystemChange> systems = {};
  std::vector<std::string> added = {};    ///< paths that only the newer side has
  std::vector<std::string> removed = {};  ///< paths that only the older side has
  std::vector<UnreadableSystem> unreadable = {};
};

/// False if `report` contains unreadable systems and nothing else, so that the report has no
/// impact.
[[nodiscard]] bool has_verdict(const DiffReport& report);

/// The worst impact of all readable systems; at least `extended` if a system was added, `breaks` if
/// a system was removed.
[[nodiscard]] Impact impact_of(const DiffReport& report);

/// `report` in about a dozen lines for people. A change that several systems share is listed once,
/// with the names of the systems. If `lists_all`, the text also lists every key and every entry.
[[nodiscard]] std::string to_text(const DiffReport& report, bool lists_all);

/// A comment for a pull request: the lines of to_text(), then every entry in a collapsed block.
[[nodiscard]] std::string to_markdown(const DiffReport& report);

/// Workflow commands of GitHub. First an error, with its reason, for every system that breaks, is
/// removed or is unreadable; then the changed keys, each with its effect. GitHub shows only ten
/// commands per step of a job: if more than ten keys changed, nine keys are shown, and a last
/// command counts all other keys.
[[nodiscard]] std::string to_annotations(const DiffReport& report);

/// `report` as JSON for programs. Every change has a stable id: the path of the key in the file, or
/// the place of the entry in the output.
[[nodiscard]] std::string to_json(const DiffReport& report);

}  // namespace elgen
