// diff: what changed between two versions of a model or a scene, as mathematics.
//
//     keys of the files      the causes, by their place in the parsed trees
//     entries of outputs     what follows: equal (proved, or sampled), or different
//     the interface          what callers of the code rely on
//
// The entries of an output are written over the leaves of both, which meet by their names. Entries
// that are computed alike are equal; of the rest the difference is proved to be zero by its closed
// form, or found to be at 64 random points, or it is a difference. Roots and kinks that agree at
// all points, inside the ranges and beyond, are not told apart: they may differ at others.
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

/// In the order of what it costs those who use the code.
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

/// None where no impact has this word.
[[nodiscard]] std::optional<Impact> find_impact(std::string_view word);

/// Names that were given to the same things, old -> new.
using Renames = std::map<std::string, std::string>;

/// Numbers that stand for parameters, by their names.
using ParameterValues = std::map<std::string, Constant>;

/// One step towards a value: a key, or an item of a list.
struct KeyStep {
  std::string key = {};
  std::size_t item = 0;  ///< from 1; 0: a key
  friend bool operator==(const KeyStep&, const KeyStep&) = default;
};

/// "vector[2]", "start.value"
[[nodiscard]] std::string text_of(const std::vector<KeyStep>& path);

/// One key that differs. Spans point into what there is.
struct KeyChange {
  std::string table = {};          ///< as in the key table: "gravity", "scene.parameters"
  std::string entry = {};          ///< as it is read: "[gravity]", "[[point]] bob"
  std::vector<KeyStep> path = {};  ///< empty: the whole entry
  bool is_order = false;           ///< of entries, or of keys that are names
  std::string before = {};         ///< as written; "" where it is new
  std::string after = {};          ///< "" where it is gone
  Span old_at = {};
  Span new_at = {};
  Impact impact = Impact::equal;  ///< of its system, at most: what follows is told of all together
};

/// Entries are matched by `name` (else `on`, `at`, `frame`, else by their number), keys by name,
/// items of lists by number. An entry that is new or gone is one change. In the order of `after`,
/// what is gone last. Cost: quadratic in the entries of a file and the keys of an entry.
[[nodiscard]] std::vector<KeyChange> changed_keys(const FileSyntax& before, const FileSyntax& after,
                                                  const Renames& renames = {});

enum class EntryVerdict : std::uint8_t {
  identical,       ///< computed alike
  equal,           ///< written differently
  not_told_apart,  ///< no point shows a difference, which proves nothing of roots and kinks
  different,
  added,
  removed,
};

/// A state at which the versions differ, rounded to three digits.
struct Witness {
  std::string at = {};  ///< "theta = 0.3, dot(x) = -1.2": what the entry depends on
  double before = 0;
  double after = 0;
};

struct EntryChange {
  std::string place = {};  ///< "gravity[2]", "linearization.A[1,2]"
  std::string unit = {};   ///< of the entry; "" where it is not known
  EntryVerdict verdict = EntryVerdict::identical;
  bool is_proved = false;       ///< equal: by the closed form of the difference
  bool is_told_apart = true;    ///< not where nothing but a proof is missing
  std::string before = {};      ///< closed forms; "" where there is none
  std::string after = {};       ///< that is short enough to read
  std::string difference = {};  ///< after - before
  double share = 0;             ///< largest change, of the entry's largest magnitude at the samples
  std::optional<Witness> witness = {};
};

/// One output of either version.
struct OutputChange {
  std::string name = {};
  std::size_t entry_count = 0;            ///< of the version that has more
  std::vector<EntryChange> entries = {};  ///< those that are not identical
};

struct InterfaceChange {
  Impact impact = Impact::equal;
  std::string text = {};   ///< "there is no function `bias` any more"
  bool is_silent = false;  ///< callers compile and mean something else, as the text says
};

/// The operations that emitted functions execute, by their names.
using OperationsByName = std::map<std::string, OperationCounts>;

/// One version of what is compared; all of it outlives the comparison.
struct Version {
  const FileSyntax& model;
  const FileSyntax* scene = nullptr;  ///< null: the built-in scene `full`
  const CheckedModel& checked;
  const Program& program;       ///< before forms are chosen, where nothing is made of these
  const Diagnostics& warnings;  ///< of the model
  const OperationsByName* operations = nullptr;  ///< of what is emitted, where that is known
};

struct CompareOptions {
  Renames renames = {};
  std::set<std::string> only = {};  ///< outputs that are told, by name; empty: all
  bool is_strict = false;           ///< entries that are not told apart are different
};

/// The changes that callers of the code see: coordinates, inputs, parameters, outputs, the target.
[[nodiscard]] std::vector<InterfaceChange> interface_changes(const Version& before,
                                                             const Version& after,
                                                             const Renames& renames = {});

/// The changes of each output, in the order of the newer version; removed ones last. `values` are
/// of parameters of the newer version.
[[nodiscard]] std::vector<OutputChange> output_changes(const Version& before, const Version& after,
                                                       const Renames& renames = {},
                                                       const ParameterValues& values = {});

/// The operations that emitted functions of one name execute.
struct OperationsChange {
  std::string function = {};
  OperationCounts before = {};
  OperationCounts after = {};
};

struct SystemChange {
  std::string name = {};  ///< base name of the newer version
  std::string path = {};  ///< of the newer version; "" where that is not known
  Impact impact = Impact::equal;
  std::vector<KeyChange> keys = {};
  std::vector<OutputChange> outputs = {};
  std::vector<InterfaceChange> interface = {};
  std::optional<std::vector<OperationsChange>> operations = {};  ///< none: not known
  bool is_told_apart = true;  ///< not where some entries are equal at points alone
  /// If `extended`: values of new parameters at which all entries equal the old ones.
  std::string extension = {};
  /// Entries of [[expect]] that held, and hold no longer: "gravity[2,1]".
  std::vector<std::string> broken_expectations = {};
  Diagnostics warnings = {};  ///< that are new
};

/// The impact is judged by all outputs, whichever are told.
[[nodiscard]] SystemChange compare(const Version& before, const Version& after,
                                   const CompareOptions& options = {});

/// Whether there is more to tell than comments, blanks and the order of keys.
[[nodiscard]] bool has_changes(const SystemChange& system);

/// A model or scene that has errors in either version, and the first of them.
struct UnreadableSystem {
  std::string path = {};
  Diagnostic error;
};

/// Models and scenes that were compared together, each with its own.
struct DiffReport {
  std::vector<SystemChange> systems = {};
  std::vector<std::string> added = {};    ///< paths that only the newer side has
  std::vector<std::string> removed = {};  ///< or the older one
  std::vector<UnreadableSystem> unreadable = {};
};

/// Whether something was compared, or nothing was unreadable.
[[nodiscard]] bool has_verdict(const DiffReport& report);

/// The worst of all that can be read; `extended` where something was added, `breaks` where it was
/// removed.
[[nodiscard]] Impact impact_of(const DiffReport& report);

/// A dozen lines for people, of several systems each with the names of those that it is about; with
/// `lists_all` every key and every entry.
[[nodiscard]] std::string to_text(const DiffReport& report, bool lists_all);

/// The same as a comment on a pull request: the lines, and behind a fold every entry.
[[nodiscard]] std::string to_markdown(const DiffReport& report);

/// Workflow commands of GitHub: an error for every system that breaks, is gone or cannot be read,
/// with the reason; then the causes, each with what it did. Of these GitHub shows ten a step: the
/// last one counts what is left over.
[[nodiscard]] std::string to_annotations(const DiffReport& report);

/// JSON for programs. Every change has an id that stays: its place in the file, or of the entry.
[[nodiscard]] std::string to_json(const DiffReport& report);

}  // namespace elgen
