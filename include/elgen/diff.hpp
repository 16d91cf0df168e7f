// diff: the changes between two versions of a model or a scene, as mathematics.
//
//     keys of the files      the causes, by position in the parsed trees
//     entries of outputs     the effects: equal (proved or sampled), or different
//     the interface          names, types and order that callers of the code rely on
//
// Entries of both versions are written over the union of their leaves, matched by name. Entries
// with the same instructions are identical. Otherwise the closed form of the difference proves
// equality, or 64 random points show it, or the entries differ. Entries with roots or kinks that
// agree at all points, inside the ranges and beyond, remain undecided, since they may differ
// elsewhere.
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

/// In ascending order of the harm to users of the code.
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

/// None if no impact has this word.
[[nodiscard]] std::optional<Impact> find_impact(std::string_view word);

/// Renamed entries, old name -> new name.
using Renames = std::map<std::string, std::string>;

/// Numbers that replace parameters, by name.
using ParameterValues = std::map<std::string, Constant>;

/// One step of a path to a value: a key, or an item of a list.
struct KeyStep {
  std::string key = {};
  std::size_t item = 0;  ///< counted from 1; 0: a key
  friend bool operator==(const KeyStep&, const KeyStep&) = default;
};

/// "vector[2]", "start.value"
[[nodiscard]] std::string text_of(const std::vector<KeyStep>& path);

/// One changed key. Spans point into the version that has the key.
struct KeyChange {
  std::string table = {};          ///< as in the key table: "gravity", "scene.parameters"
  std::string entry = {};          ///< for readers: "[gravity]", "[[point]] bob"
  std::vector<KeyStep> path = {};  ///< empty: the whole entry
  bool is_order = false;           ///< the order of entries, or of keys that are names, changed
  std::string before = {};         ///< as written; "" if the key is new
  std::string after = {};          ///< "" if the key is gone
  Span old_at = {};
  Span new_at = {};
  Impact impact = Impact::equal;  ///< the worst effect that this key may have on its system;
                                  ///< effects are known only together
};

/// Entries are matched by `name`, else `on`, `at` or `frame`, else by number; keys by name; items
/// of lists by number. A new or missing entry is one change. Changes are in the order of `after`,
/// with missing keys last. Cost: quadratic in the entries of a file and in the keys of an entry.
[[nodiscard]] std::vector<KeyChange> changed_keys(const FileSyntax& before, const FileSyntax& after,
                                                  const Renames& renames = {});

enum class EntryVerdict : std::uint8_t {
  identical,  ///< the same instructions
  equal,      ///< different instructions, equal values
  undecided,  ///< undecided: equal at all points, but with roots or kinks, so that points
              ///< prove nothing
  different,
  added,
  removed,
};

/// A state at which the versions differ, rounded to three digits.
struct Witness {
  std::string at = {};  ///< "theta = 0.3, dot(x) = -1.2": the leaves on which the entry depends
  double before = 0;
  double after = 0;
};

struct EntryChange {
  std::string place = {};  ///< "gravity[2]", "linearization.A[1,2]"
  std::string unit = {};   ///< of the entry; "" if unknown
  EntryVerdict verdict = EntryVerdict::identical;
  bool is_proved = false;       ///< `equal` is proved by the closed form of the difference
  bool is_certain = true;       ///< false if the entry is undecided only because a proof is missing
  std::string before = {};      ///< closed form; "" if there is none
  std::string after = {};       ///< that is short enough to read
  std::string difference = {};  ///< after - before
  double share = 0;  ///< largest change / largest magnitude of the entry, over the samples
  std::optional<Witness> witness = {};
};

/// One output of either version.
struct OutputChange {
  std::string name = {};
  std::size_t entry_count = 0;            ///< of the version with more entries
  std::vector<EntryChange> entries = {};  ///< without identical ones
};

struct InterfaceChange {
  Impact impact = Impact::equal;
  std::string text = {};   ///< "there is no function `bias` any more"
  bool is_silent = false;  ///< callers still compile, with the changed meaning that `text` states
};

/// Executed operations of emitted functions, by the name of the function.
using OperationsByName = std::map<std::string, OperationCounts>;

/// One side of a comparison. All of it outlives the comparison.
struct Version {
  const FileSyntax& model;
  const FileSyntax* scene = nullptr;  ///< null: the built-in scene `full`
  const CheckedModel& checked;
  const Program& program;       ///< with chosen forms if files are emitted, else before the choice
  const Diagnostics& warnings;  ///< of the model
  const OperationsByName* operations = nullptr;  ///< of the emitted functions; null: unknown
};

struct CompareOptions {
  Renames renames = {};
  std::set<std::string> only = {};  ///< names of the outputs to report; empty: all
  bool is_strict = false;           ///< undecided entries count as different
};

/// The changes that callers of the code see: coordinates, inputs, parameters, outputs, the target.
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
  std::string name = {};  ///< base name of the newer version
  std::string path = {};  ///< of the newer version; "" if unknown
  Impact impact = Impact::equal;
  std::vector<KeyChange> keys = {};
  std::vector<OutputChange> outputs = {};
  std::vector<InterfaceChange> interface = {};
  std::optional<std::vector<OperationsChange>> operations = {};  ///< none: unknown
  bool is_certain = true;  ///< false if some entries are equal only at points
  /// If `extended`: values of the new parameters at which all entries equal the old ones.
  std::string extension = {};
  /// Entries of [[expect]] that held before and fail now: "gravity[2,1]".
  std::vector<std::string> broken_expectations = {};
  Diagnostics warnings = {};  ///< only new ones
};

/// Compares two versions. `impact` considers all outputs, even if options.only hides some.
[[nodiscard]] SystemChange compare(const Version& before, const Version& after,
                                   const CompareOptions& options = {});

/// True if more than comments, blanks and the order of keys changed.
[[nodiscard]] bool has_changes(const SystemChange& system);

/// A model or scene with errors in either version, and the first error.
struct UnreadableSystem {
  std::string path = {};
  Diagnostic error;
};

/// The models and scenes that one command compares.
struct DiffReport {
  std::vector<SystemChange> systems = {};
  std::vector<std::string> added = {};    ///< paths that only the newer side has
  std::vector<std::string> removed = {};  ///< paths that only the older side has
  std::vector<UnreadableSystem> unreadable = {};
};

/// True if something was compared, or nothing was unreadable.
[[nodiscard]] bool has_verdict(const DiffReport& report);

/// The worst impact of all readable systems; at least `extended` if one was added, `breaks` if one
/// was removed.
[[nodiscard]] Impact impact_of(const DiffReport& report);

/// A dozen lines for people; changes shared by several systems are listed once with their names.
/// `lists_all` adds every key and every entry.
[[nodiscard]] std::string to_text(const DiffReport& report, bool lists_all);

/// A comment for a pull request: the same lines, then every entry in a collapsed block.
[[nodiscard]] std::string to_markdown(const DiffReport& report);

/// Workflow commands of GitHub. First an error, with its reason, for every system that breaks, is
/// removed or is unreadable; then the causes, each with its effect. GitHub shows ten per step, so
/// the last command counts the rest.
[[nodiscard]] std::string to_annotations(const DiffReport& report);

/// JSON for programs. Every change has a stable id: the position of the key in the file, or of the
/// entry in the output.
[[nodiscard]] std::string to_json(const DiffReport& report);

}  // namespace elgen
