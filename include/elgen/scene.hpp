// Scene: the choices for the code of a model: outputs, fixed parameters, arithmetic, target. Each
// part of a scene is for one or more stages.
#pragma once

#include <cln/real.h>

#include <array>
#include <cstdint>
#include <map>
#include <memory>
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

/// `any`: emitted functions are generic in their scalar. `one`: functions use one built-in type.
enum class LanguageScalars : std::uint8_t { any, one };

struct LanguageRow {
  LanguageId id;
  std::string_view name;
  LanguageScalars scalars;
  std::string_view file_extension;  ///< extension of source files: "cpp"
  bool has_more_headers;            ///< scenes may request headers with Eigen types and for batches
  bool groups_angles;               ///< a statement computes the sines of several angles together
  bool is_interpreted;              ///< the language computes in doubles with its own sin, cos, …
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

/// The exact value of a fixed parameter.
struct FixedValue {
  cln::cl_R number = 0;  ///< rational, or a float of 100 digits
  /// The expression of an irrational value, as written; none if `number` is rational.
  std::optional<ExpressionId> exact_expression = {};
};

/// Index of a parameter -> its fixed value.
using FixedParameters = std::map<std::uint32_t, FixedValue>;

/// For the stage specialise: the fixed parameters, which become exact numbers.
struct Specialisation {
  FixedParameters fixed = {};
};

/// One requested output; requests are in the order of the output table.
struct OutputRequest {
  OutputKind kind = {};
  std::uint32_t user = 0;       ///< index in Model::outputs, for the user_* kinds
  std::string name = {};        ///< name of the emitted function
  LeafSet argument_kinds = {};  ///< arguments in addition to parameters, q and (if it occurs) t
  std::uint32_t rows = 1;       ///< shape of the first field
  std::uint32_t columns = 1;
  Span span = {};                     ///< position of the request in the scene or an option
  std::optional<Form> form = {};      ///< the form that the scene demands; none: choose() decides
  std::optional<StepSpec> step = {};  ///< for `step` and its derivatives
  bool omits_pivots = false;          ///< true: relative pivots are not returned
  /// For `completed`: the velocities that determine the other velocities, ascending.
  std::vector<std::uint32_t> independent = {};
};

/// The criterion for the choice between forms of a function.
enum class Preference : std::uint8_t {
  balanced,  ///< the cheapest form, unless a slightly more expensive form keeps many more digits
  speed,     ///< the cheapest form
};

/// The range of a coordinate, rate, input or other leaf.
struct NamedRange {
  std::string name = {};  ///< as models write it: "dot(theta)"
  double low = 0;
  double high = 0;
};

/// For the stages choose and emit, and for the toolchain: the arithmetic of the code.
struct Numerics {
  Preference prefer = Preference::balanced;
  std::vector<ScalarKind> scalars = {ScalarKind::double_precision};
  /// Unless `same`: a further header is emitted that computes in this scalar.
  InnerScalar inner = InnerScalar::same;
  /// Largest absolute error of sines and cosines in batches; none: see trigonometry_error(). If it
  /// is at least least_lone_sine_error(), also of a sine that a function of one state computes
  /// alone.
  std::optional<cln::cl_RA> trigonometry_error = {};
  /// True: functions of one state call sin and cos of the library instead of polynomials.
  bool has_library_sines = false;
  /// The largest permitted error of any output, as `tradeoff` measures it. `verify` checks it.
  std::optional<double> max_error = {};
  /// The ranges in which max_error must hold. They replace the ranges of the model, name by name.
  std::vector<NamedRange> ranges = {};
  /// Index of a parameter -> the range over which `tradeoff` judges errors.
  std::map<std::uint32_t, Interval> varied_parameters = {};

  /// True if a step computes accelerations in float, and sums in double.
  [[nodiscard]] bool has_mixed_precision() const { return inner == InnerScalar::single_precision; }

  /// `scalars`, and float if accelerations are in float.
  [[nodiscard]] std::vector<ScalarKind> computed_scalars() const {
    std::vector<ScalarKind> all = scalars;
    if (has_mixed_precision()) all.push_back(ScalarKind::single_precision);
    return all;
  }
};

/// The largest absolute error of sines and cosines in batches: the error that `numerics` states;
/// otherwise 2^-23 if `scalar` is float, and 2^-52 for other scalars.
[[nodiscard]] cln::cl_RA trigonometry_error(const Numerics& numerics, ScalarKind scalar);

/// The least permitted error for which a sine that a function of one state computes alone has a
/// cheaper polynomial: 4e-16, and 2.2e-7 in float.
[[nodiscard]] cln::cl_RA least_lone_sine_error(ScalarKind scalar);

/// The order of the entries of a matrix in an array.
enum class Storage : std::uint8_t { row_major, column_major };

[[nodiscard]] std::string_view name_of(Storage storage);

/// For the stage emit: the target language and the files.
struct Emission {
  LanguageId language = default_language;
  std::string name_space = {};  ///< namespace in C++, prefix of names in C; "": Scene::base_name
  Span name_space_span = {};    ///< span of the value that sets the namespace
  Storage storage = Storage::row_major;
  bool has_eigen_header = false;  ///< C++: a second header with the same functions on Eigen types
  bool has_batch_header =
      false;                ///< C++: a second header with the same functions on arrays of states
  bool has_sidecar = true;  ///< true: the equations are also written in JSON
  bool has_page = true;
};

/// The built-in scene `full` omits outputs with more entries than this; a scene must name them.
inline constexpr std::uint64_t max_entries_in_full = 4096;

/// Why the built-in scene `full` omits an output.
enum class OmissionReason : std::uint8_t {
  too_many_entries,  ///< more than max_entries_in_full
  kinked_force,      ///< needs derivatives of a force with a kink, so no scene can have the output
};

[[nodiscard]] std::string_view name_of(OmissionReason reason);

/// The outputs that `full` omits for one reason.
struct OmittedOutputs {
  OmissionReason reason = OmissionReason::too_many_entries;
  std::vector<std::string> outputs = {};  ///< in the order of the output table
  Span span = {};                         ///< the kink in the force, or the name of the model
};

/// The source paths in the stamps of emitted files: relative to the output folder, or bare file
/// names.
struct SourcePaths {
  std::string model = {};
  std::string scene = {};  ///< "": the built-in scene
};

/// The kind of values of an [[output]] that is added for an animation (Purpose::shows_motion).
enum class ShownValues : std::uint8_t { places, masses, laws, integrals, kinks };

/// The leaves that `--state` sets. The values of q and v replace the start of the model.
struct StateOverrides {
  std::set<std::string> coordinates = {};  ///< names; of a rotation all four or none
  std::set<std::string> velocities = {};   ///< names; of a rotation all three or none
  /// Name -> value, for accelerations ("dot(dot(theta))"), momenta, t and h.
  std::map<std::string, cln::cl_R> others = {};
};

struct Scene {
  SourcePointer source = {};  ///< the scene file; null: the built-in scene `full`
  SourcePaths paths = {};
  std::string name = {};       ///< "" for the built-in scene `full`
  std::string base_name = {};  ///< <model> or <model>_<scene>: folder, file stem, namespace
  std::string doc = {};
  Specialisation specialisation = {};
  std::vector<OutputRequest> outputs = {};
  std::vector<OmittedOutputs> omitted_outputs = {};  ///< empty if the scene names its outputs
  Numerics numerics = {};
  Emission emission = {};
  StateOverrides state_overrides = {};
  /// Name of an input -> its law of `--input`, a function of q, v and t.
  std::map<std::string, ExpressionId> laws = {};
  /// Index in Model::outputs -> kind of values, for each output that is added for an animation.
  std::map<std::uint32_t, ShownValues> page_outputs = {};
  /// The model without the additions of the scene, on which its [[expect]] are judged; null if the
  /// scene adds no input.
  std::shared_ptr<const Model> model_alone = {};
  bool has_options = false;  ///< true: --outputs, --fix, --size or --language is set
  /// Text of the scene file and of the options of `has_options`; stamps contain a hash of the text.
  /// "" for the built-in scene `full` without options.
  std::string canonical_text = {};
  /// The texts of options, into which spans of the model and the scene point.
  std::vector<SourcePointer> option_sources = {};
};

/// The request of this name, which is also the name of a function and of a field of `dynamics`;
/// null if the scene has no such output.
[[nodiscard]] const OutputRequest* find_request(const Scene& scene, std::string_view name);

/// The law of an input; null if the scene has no law for it.
[[nodiscard]] inline const ExpressionId* find_law(const Scene& scene, const Input& input) {
  const auto found = scene.laws.find(input.name);
  return found == scene.laws.end() ? nullptr : &found->second;
}

/// True if the model or the scene has an [[expect]].
[[nodiscard]] inline bool has_expectations(const Model& model, const Scene& scene) {
  return !model.expectations.empty() ||
         (scene.model_alone != nullptr && !scene.model_alone->expectations.empty());
}

struct CheckedModel {
  Model model;
  Scene scene;
};

/// True if the scene declares the row whose name has this span. Such rows follow the rows of the
/// model in each list.
[[nodiscard]] inline bool is_of_scene(const Model& model, const Span& span) {
  return span.source != nullptr && span.source != model.source.get();
}

/// The requirements of a command on check(), in addition to the scene. Each comment below says what
/// check() does if the member is true.
struct Purpose {
  /// SceneOptions::starts may also name accelerations, momenta, t and h (StateOverrides::others).
  bool accepts_all_leaves = false;
  /// Open functions without an expression in the scene are replaced by their `sample`.
  bool samples_open_functions = false;
  /// Forward dynamics returns relative pivots, even if the model disables them, because a run
  /// monitors them.
  bool keeps_pivots = false;
  /// Outputs are added that the page of a run needs: all places, laws of inputs, conserved
  /// quantities, arguments of functions with kinks.
  bool shows_motion = false;
  /// `[approximate]` of the scene is ignored.
  bool ignores_expansion = false;
  /// Closed forms of [[expect]] with more than 4096 nodes are kept. False: their first 4096 nodes
  /// are checked for mistakes, and the forms are then dropped.
  bool keeps_large_forms = false;
};

/// The values of SceneOptions::purpose, one for each kind of command.
namespace purpose {

inline constexpr Purpose generate{};  ///< for generate, diff, show and vectors
inline constexpr Purpose rest{.samples_open_functions = true};  ///< for equilibria and modes
inline constexpr Purpose evaluate{.accepts_all_leaves = true, .samples_open_functions = true};
inline constexpr Purpose simulate{
    .samples_open_functions = true, .keeps_pivots = true, .keeps_large_forms = true};
/// For runs of `tradeoff --time`. Unlike `simulate`, they list no conserved quantities, so they do
/// not need large forms of [[expect]].
inline constexpr Purpose time_run{.samples_open_functions = true, .keeps_pivots = true};
inline constexpr Purpose show_motion{
    .samples_open_functions = true, .keeps_pivots = true, .shows_motion = true};
inline constexpr Purpose verify{.keeps_large_forms = true};
/// For the exact model, to which `verify` compares an expanded model if it checks `max_error`.
inline constexpr Purpose verify_expansion{.ignores_expansion = true};

}  // namespace purpose

/// The options --outputs, --fix, --size and others. The text of each option is a source, so that an
/// error has a position in this text.
struct SceneOptions {
  SourcePaths paths = {};                   ///< empty: bare file names
  std::vector<SourcePointer> outputs = {};  ///< "mass_matrix,bias"
  std::optional<StepSpec> step = {};        ///< adds the output `step` by this method
  InnerScalar inner = InnerScalar::same;    ///< unless `same`: replaces the scene's inner scalar
  std::optional<LanguageId> language = {};  ///< replaces the language of the scene
  std::vector<SourcePointer> fixed = {};    ///< "NAME", "NAME=VALUE" or "all"
  std::vector<SourcePointer> sizes = {};    ///< "n=20"
  std::vector<SourcePointer> values = {};   ///< "m=2", for parameters that stay parameters
  std::vector<SourcePointer> starts = {};   ///< "theta=1,dot(theta)=0,attitude=[1,0,0,0]"
  std::vector<SourcePointer> laws = {};     ///< "u=-3*theta"
  std::vector<SourcePointer> ranges = {};   ///< "theta=-0.1..0.1"
  std::vector<SourcePointer> over = {};     ///< "m=0.1:10", for Numerics::varied_parameters
  Purpose purpose = purpose::generate;      ///< purpose of the command

  /// True if the options change the emitted files.
  [[nodiscard]] bool changes_files() const {
    return !outputs.empty() || language || !fixed.empty() || !sizes.empty();
  }
};

/// Resolves the syntax of a model and a scene. `scene` may be null: the built-in scene `full`.
/// All errors are reported in one run: E2xx names, E3xx domains, E4xx units, E5xx mechanics, E6xx
/// scene, E9xx limits.
[[nodiscard]] Result<CheckedModel> check(const FileSyntax& model, const FileSyntax* scene,
                                         const SceneOptions& options, const Limits& limits);

}  // namespace elgen
