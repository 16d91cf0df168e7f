// Scene: what is wanted from a model, in parts named after the stages that read them.
#pragma once

#include <cln/real.h>

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "elgen/diagnostic.hpp"
#include "elgen/model.hpp"
#include "elgen/outputs.hpp"
#include "elgen/scalars.hpp"
#include "elgen/step_methods.hpp"
#include "elgen/syntax.hpp"

namespace elgen {

/// The target languages (languages.def).
enum class LanguageId : std::uint8_t {
#define ELGEN_LANGUAGE(id, ...) id,
#include "elgen/languages.def"
#undef ELGEN_LANGUAGE
};

/// Whether emitted functions are generic in their scalar, or written for one.
enum class LanguageScalars : std::uint8_t { any, one };

struct LanguageRow {
  LanguageId id;
  std::string_view name;
  LanguageScalars scalars;
  std::string_view ending;  ///< "cpp": of a source in it
  bool has_more_headers;    ///< on Eigen's types, and in batches
  bool is_interpreted;      ///< in doubles, with the sines of its own library
};

inline constexpr std::array language_table{
#define ELGEN_LANGUAGE(id, name, scalars, ...) \
  LanguageRow{LanguageId::id, name, LanguageScalars::scalars, __VA_ARGS__},
#include "elgen/languages.def"
#undef ELGEN_LANGUAGE
};

[[nodiscard]] constexpr const LanguageRow& language_row(LanguageId id) {
  return language_table[static_cast<std::size_t>(id)];
}

inline constexpr LanguageId default_language = language_table.front().id;

/// The exact number that a parameter is fixed at.
struct FixedValue {
  cln::cl_R number = 0;                   ///< rational, or a float of 100 digits
  std::optional<ExpressionId> form = {};  ///< in Model::expressions, where it is not rational
};

/// By index of the parameter.
using FixedParameters = std::map<std::uint32_t, FixedValue>;

/// specialise: parameters that become exact numbers.
struct Specialisation {
  FixedParameters fixed = {};
};

/// One wanted output, in the order of the output table.
struct OutputRequest {
  OutputKind kind = {};
  std::uint32_t user = 0;  ///< which Model::outputs, for the user_* kinds
  std::string name = {};   ///< of the emitted function: renamed, or the standard one
  LeafSet takes = {};      ///< arguments beside parameters and q (and t where t occurs)
  std::uint32_t rows = 1;  ///< of the (single or first) field
  std::uint32_t columns = 1;
  Span span = {};                     ///< where it was asked for
  std::optional<Form> form = {};      ///< asked for; otherwise the cheaper one
  std::optional<StepSpec> step = {};  ///< of `step` and its derivatives, which a scene describes
  bool without_pivots = false;        ///< of what gives them otherwise
  /// For `completed`: the velocities that determine the others, ascending.
  std::vector<std::uint32_t> independent = {};
};

/// The criterion that decides between rewritings.
enum class Preference : std::uint8_t {
  balanced,  ///< the cheapest, unless another that costs little more keeps many more digits
  speed,     ///< the cheapest
};

/// The numbers that a coordinate, a rate, an input or the like is between.
struct NamedRange {
  std::string name = {};  ///< as models write it: "dot(theta)"
  double low = 0;
  double high = 0;
};

/// choose, emit, toolchain: what code is written for, and compiled for.
struct Numerics {
  Preference prefer = Preference::balanced;
  std::vector<ScalarKind> scalars = {ScalarKind::double_precision};
  InnerScalar inner = InnerScalar::same;  ///< another one asks for a header that computes in it
  std::optional<cln::cl_RA> trigonometry_error = {};  ///< of sines and cosines in batches, at most
  bool has_library_sines = false;  ///< functions of numbers call the library, not polynomials
  /// The largest error of any output, as `tradeoff` measures it; `verify` checks it.
  std::optional<double> max_error = {};
  std::vector<NamedRange> ranges = {};  ///< where, beside the ranges of the model
};

/// The error that the scene asks for, or the least that the scalar can give: 2^-52, 2^-23 in float.
[[nodiscard]] cln::cl_RA trigonometry_error(const Numerics& numerics, ScalarKind scalar);

/// Order in which the entries of a matrix lie in an array.
enum class Storage : std::uint8_t { row_major, column_major };

[[nodiscard]] std::string_view name_of(Storage storage);

/// emit: target.
struct Emission {
  LanguageId language = default_language;
  std::string name_space = {};  ///< of C++, prefix of every name in C; default: base_name
  Span name_space_span = {};    ///< of what gives it that name
  Storage storage = Storage::row_major;
  bool eigen = false;     ///< C++: a second header, of the same functions on Eigen types
  bool batch = false;     ///< C++: another one, of the same functions on arrays of states
  bool equations = true;  ///< the sidecar
  bool page = true;
};

/// Outputs of more entries are chosen only where they are named.
inline constexpr std::uint64_t entries_in_full = 4096;

/// Why the built-in scene `full` does without an output of the model.
enum class LeftOutReason : std::uint8_t {
  too_many_entries,  ///< more than entries_in_full
  kinked_force,      ///< its derivatives would jump, so no scene gets them either
};

[[nodiscard]] std::string_view name_of(LeftOutReason reason);

/// The outputs that `full` leaves out for one reason.
struct LeftOut {
  LeftOutReason reason = LeftOutReason::too_many_entries;
  std::vector<std::string> outputs = {};  ///< in the order of the output table
  Span span = {};                         ///< the kink in the force, or the name of the model
};

/// The sources that files say they were made from: paths relative to the folder that all of them go
/// to, or names of files.
struct SourcePaths {
  std::string model = {};
  std::string scene = {};  ///< "" where the scene is the built-in one
};

/// The values of an output that is in no file, for a page that moves (Purpose::shows_motion).
enum class ShownValues : std::uint8_t { places, masses, laws, integrals };

/// The state that `--state` gives. Values of q and v are the start of the model.
struct StatedStart {
  std::set<std::string> coordinates = {};  ///< named, all four of a rotation
  std::set<std::string> velocities = {};   ///< named, all three of a rotation
  /// Accelerations, momenta, t and h, by their texts: "dot(dot(theta))".
  std::map<std::string, cln::cl_R> others = {};
};

struct Scene {
  SourcePointer source = {};  ///< its file; null: the built-in scene `full`
  SourcePaths paths = {};
  std::string name = {};       ///< "" for the built-in scene `full`
  std::string base_name = {};  ///< <model> or <model>_<scene>: folder, file stem, namespace
  std::string doc = {};
  Specialisation specialisation = {};
  std::vector<OutputRequest> outputs = {};
  std::vector<LeftOut> left_out = {};  ///< empty where the scene names its outputs
  Numerics numerics = {};
  Emission emission = {};
  StatedStart stated = {};
  /// The functions of q, v and t that `--input` gives for inputs, by the name of the input.
  std::map<std::string, ExpressionId> laws = {};
  /// The outputs that a page adds to those of the file, by their numbers in Model::outputs.
  std::map<std::uint32_t, ShownValues> shown = {};
  bool has_options = false;    ///< --outputs, --fix or --size changed it
  std::string canonical = {};  ///< its file and its options, for stamps; "" for full
  /// The texts that spans of the model and of the scene point into, beside their files.
  std::vector<SourcePointer> option_sources = {};
};

/// The request behind a function, or behind a field of `dynamics`; null where the scene has none of
/// that name.
[[nodiscard]] const OutputRequest* find_request(const Scene& scene, std::string_view name);

/// The law of an input; null if it has none.
[[nodiscard]] inline const ExpressionId* find_law(const Scene& scene, const Input& input) {
  const auto found = scene.laws.find(input.name);
  return found == scene.laws.end() ? nullptr : &found->second;
}

struct CheckedModel {
  Model model;
  Scene scene;
};

/// The properties of a checked model that a command needs, besides those its scene asks for.
struct Purpose {
  /// `starts` may name accelerations, momenta, t and h, too (StatedStart::others).
  bool states_all = false;
  /// Functions left open are their samples, if the scene has no expression of them.
  bool closes_functions = false;
  /// Forward dynamics with relative pivots, whatever the model says: a run looks at them.
  bool keeps_pivots = false;
  /// Adds outputs that a page shows of a run: all places, the laws of inputs, what is conserved.
  bool shows_motion = false;
  /// Without the scene's `[approximate]`.
  bool is_exact = false;
  /// Keeps closed forms of more than 4096 nodes too. Otherwise they are read until there, so that
  /// mistakes in them are reported, and dropped.
  bool keeps_large_forms = false;
};

/// A row for each purpose of a command.
namespace purpose {

inline constexpr Purpose generate{};                      ///< also diff, show and vectors
inline constexpr Purpose rest{.closes_functions = true};  ///< equilibria and modes
inline constexpr Purpose evaluate{.states_all = true, .closes_functions = true};
inline constexpr Purpose simulate{
    .closes_functions = true, .keeps_pivots = true, .keeps_large_forms = true};
/// Its table has no conserved quantities, so large closed forms are not needed.
inline constexpr Purpose time_run{.closes_functions = true, .keeps_pivots = true};
inline constexpr Purpose show_motion{
    .closes_functions = true, .keeps_pivots = true, .shows_motion = true};
inline constexpr Purpose verify{.keeps_large_forms = true};
/// The exact model that `max_error` compares an expansion with.
inline constexpr Purpose verify_expansion{.is_exact = true};

}  // namespace purpose

/// --outputs, --fix, --size and the like as given, each a source of its own so that errors can
/// point into it.
struct SceneOptions {
  SourcePaths paths = {};                   ///< empty: names of files
  std::vector<SourcePointer> outputs = {};  ///< "mass_matrix,bias"
  std::optional<StepSpec> step = {};        ///< beside these `step`, by this method
  std::optional<LanguageId> language = {};  ///< in the place of the scene's
  std::vector<SourcePointer> fixed = {};    ///< "NAME", "NAME=VALUE" or "all"
  std::vector<SourcePointer> sizes = {};    ///< "n=20"
  std::vector<SourcePointer> values = {};   ///< "m=2": of parameters that stay parameters
  std::vector<SourcePointer> starts = {};   ///< "theta=1,dot(theta)=0,attitude=[1,0,0,0]"
  std::vector<SourcePointer> laws = {};     ///< "u=-3*theta"
  std::vector<SourcePointer> ranges = {};   ///< "theta=-0.1..0.1"
  Purpose purpose = purpose::generate;      ///< of the command that asks

  /// Whether the files are others than those of the scene.
  [[nodiscard]] bool change_files() const {
    return !outputs.empty() || language || !fixed.empty() || !sizes.empty();
  }
};

/// Resolves both syntaxes. `scene` may be null: the built-in scene `full`.
/// Errors: E2xx names, E3xx domains, E4xx units, E5xx mechanics, E6xx scene, E9xx limits; all of
/// them in one run.
[[nodiscard]] Result<CheckedModel> check(const FileSyntax& model, const FileSyntax* scene,
                                         const SceneOptions& options, const Limits& limits);

}  // namespace elgen
