// Emission: words of the choice table become enumerators. Incompatible keys are reported at their
// place in the file. The accuracy of batches must be attainable in the scalars.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/reason.hpp"
#include "check/expressions/values.hpp"
#include "check/names/reserved_names.hpp"
#include "check/scene/scene.hpp"
#include "elgen/wording.hpp"
#include "numbers/exact_number.hpp"

namespace elgen {

namespace {

LanguageId language_or_default(std::string_view name) {
  const auto* const row = std::ranges::find(language_table, name, &LanguageRow::name);
  return row == language_table.end() ? default_language : row->id;
}

constexpr const char* language_hint = "omit the key, or write `language = \"c++17\"`";

/// True if `numerics` requests one scalar, and code in `language` can have this scalar.
bool takes_scalars(const LanguageRow& language, const Numerics& numerics) {
  if (numerics.scalars.size() != 1) return false;
  const ScalarKind scalar = numerics.scalars.front();
  return scalar == ScalarKind::double_precision ||
         (scalar == ScalarKind::single_precision && !language.is_interpreted);
}

/// Reports E611 for keys that affect only compiled code, if the language is interpreted.
void report_compiled_keys(const FileSyntax* syntax, const LanguageRow& language, Report& report) {
  const std::string name = quote_text(language.name);
  const auto refuse = [&](const char* section, const char* key, const std::string& why) {
    const KeySyntax* const found = find_key(syntax, section, key);
    if (found == nullptr) return;
    report.add(Code::E611, found->key_span,
               fmt::format("{} is for compiled code, but `language` is {}", quote_text(key), name),
               why + "; omit the key");
  };
  refuse("emit", "storage", "the language has its own matrices");
  refuse("emit", "namespace", "the base name of the scene is the name of the module");
  refuse("numeric", "trigonometry", "the code uses the sines of the library");
}

void check_combinations(const FileSyntax* syntax, const Emission& emission, const Scene& scene,
                        Report& report) {
  const LanguageRow& language = language_row(emission.language);
  const std::string name = quote_text(language.name);
  const KeySyntax* scalar = find_key(syntax, "numeric", "scalar");
  const bool is_for_one = language.scalars == LanguageScalars::one;
  if (scalar != nullptr && is_for_one && !takes_scalars(language, scene.numerics)) {
    report.add(Code::E610, scalar->value.span,
               fmt::format("code in {} has one scalar, {}", name,
                           language.is_interpreted ? "`double`" : "`float` or `double`"),
               "write `scalar = [\"double\"]`");
  }
  if (language.is_interpreted) report_compiled_keys(syntax, language, report);
  if (emission.has_eigen_header && !language.has_more_headers) {
    report.add(Code::E611, find_key(syntax, "emit", "eigen")->key_span,
               "`eigen` needs C++, but `language` is " + name, language_hint);
  }
}

bool list_contains(const KeySyntax& key, std::string_view word) {
  return std::ranges::count(key.value.items, word, &ValueSyntax::text) > 0;
}

/// Reads the kinds of files to write. E112 if `header` is missing: code is always written.
void read_files(const KeySyntax& key, Emission& emission, Report& report) {
  emission.has_sidecar = list_contains(key, "equations");
  emission.has_page = list_contains(key, "page");
  if (list_contains(key, "header")) return;
  report.add(Reason::no_header, key.value.span, "`files` has no `header`, which is always written");
}

bool has_scalar(const Scene& scene, ScalarKind kind) {
  return std::ranges::count(scene.numerics.scalars, kind) > 0;
}

class BatchReader {
 public:
  BatchReader(Context& context, const FileSyntax* syntax, Scene& scene)
      : context_(context), syntax_(syntax), scene_(scene) {}

  void read() {
    const KeySyntax* batch = find_key(syntax_, "emit", "batch");
    scene_.emission.has_batch_header = is_flag_set(batch);
    scene_.numerics.has_library_sines = language_row(scene_.emission.language).is_interpreted;
    if (scene_.emission.has_batch_header) check_scalars(*batch);
    const KeySyntax* trigonometry = find_key(syntax_, "numeric", "trigonometry");
    if (trigonometry != nullptr && !scene_.numerics.has_library_sines) read_sines(*trigonometry);
  }

 private:
  void report_batch_error(const Span& span, std::string message, std::string hint = {}) {
    context_.report.add(Code::E625, span, std::move(message), std::move(hint));
  }

  void check_scalars(const KeySyntax& batch) {
    const LanguageRow& language = language_row(scene_.emission.language);
    if (!language.has_more_headers) {
      context_.report.add(Code::E611, batch.key_span,
                          "`batch` needs C++, but `language` is " + quote_text(language.name),
                          language_hint);
    } else if (has_scalar(scene_, ScalarKind::long_double)) {
      report_batch_error(find_key(syntax_, "numeric", "scalar")->value.span,
                         "packs have elements of type `float` or `double`");
    }
  }

  void read_sines(const KeySyntax& trigonometry) {
    const KeySyntax* scalar = trigonometry.value.find("scalar");
    scene_.numerics.has_library_sines = scalar != nullptr && scalar->value.text == "library";
    const KeySyntax* key = trigonometry.value.find("max_error");
    if (key == nullptr) return;
    if (scene_.emission.has_batch_header || !scene_.numerics.has_library_sines)
      return read_accuracy(*key);
    report_batch_error(key->key_span, "`max_error` does not apply to sines of the library",
                       "omit it, or add `[emit] batch = true`: it bounds the sines of batches");
  }

  void read_accuracy(const KeySyntax& key) {
    const auto wanted = ValueReader(context_).read_constant(key.value);
    if (!wanted) return;
    const std::vector<ScalarKind> scalars = scene_.numerics.computed_scalars();
    const bool has_float = std::ranges::count(scalars, ScalarKind::single_precision) > 0;
    const ScalarKind coarsest =
        has_float ? ScalarKind::single_precision : ScalarKind::double_precision;
    const bool has_batch = scene_.emission.has_batch_header;
    const cln::cl_RA least =
        has_batch ? trigonometry_error(scene_.numerics, coarsest) : least_lone_sine_error(coarsest);
    if (!is_rational(*wanted) || *wanted >= 1 || *wanted < least) {
      const std::string_view of_batch = has_float ? "2^-23 = 1.2e-7" : "2^-52 = 2.3e-16";
      const std::string_view of_lone_sines = has_float ? "2.2e-7" : "4e-16";
      return report_batch_error(
          key.value.span,
          fmt::format("`max_error`{} is at least {}, and below 1", has_float ? " in float" : "",
                      has_batch ? of_batch : of_lone_sines),
          has_batch ? "" : "only batches have sines that are more accurate than this");
    }
    scene_.numerics.trigonometry_error = cln::rational(*wanted);
  }

  Context& context_;
  const FileSyntax* syntax_;
  Scene& scene_;
};

}  // namespace

std::string_view name_of(Storage storage) {
  return storage == Storage::row_major ? "row-major" : "column-major";
}

Emission read_emission(Context& context, const FileSyntax* syntax, const SceneOptions& options,
                       const Scene& scene) {
  Emission emission;
  emission.name_space = scene.base_name;
  emission.name_space_span = context.model.name_span;
  if (const KeySyntax* key = find_key(syntax, "emit", "namespace")) {
    emission.name_space = key->value.text;
    emission.name_space_span = key->value.span;
    (void)check_name(key->value.text, key->value.span, context.report);
  }
  if (const KeySyntax* key = find_key(syntax, "emit", "language")) {
    emission.language = language_or_default(key->value.text);
  }
  emission.language = options.language.value_or(emission.language);
  if (const KeySyntax* key = find_key(syntax, "emit", "storage")) {
    const bool is_column_major = key->value.text == name_of(Storage::column_major);
    emission.storage = is_column_major ? Storage::column_major : Storage::row_major;
  }
  emission.has_eigen_header = is_flag_set(find_key(syntax, "emit", "eigen"));
  if (const KeySyntax* key = find_key(syntax, "emit", "files")) {
    read_files(*key, emission, context.report);
  }
  check_combinations(syntax, emission, scene, context.report);
  return emission;
}

cln::cl_RA least_lone_sine_error(ScalarKind scalar) {
  const bool is_single = scalar == ScalarKind::single_precision;
  return (is_single ? 22 : 4) * cln::expt(cln::cl_RA(10), is_single ? -8 : -16);
}

cln::cl_RA trigonometry_error(const Numerics& numerics, ScalarKind scalar) {
  const bool is_single = scalar == ScalarKind::single_precision;
  return numerics.trigonometry_error.value_or(cln::expt(cln::cl_RA(2), is_single ? -23 : -52));
}

void read_batch(Context& context, const FileSyntax* syntax, Scene& scene) {
  BatchReader(context, syntax, scene).read();
}

namespace {

/// Why an output does not support accelerations in float; "" if it does.
std::string inner_scalar_obstacle(const OutputRequest& output) {
  const OutputRow& row = output_row(output.kind);
  if (output.kind == OutputKind::projected) return "";
  if (!row.is_step || row.differentiates) return quote_text(output.name) + " is no `step`";
  const bool asks = !output.step || output.step->method != StepMethod::midpoint;
  return asks ? ""
              : quote_text(step_method_row(StepMethod::midpoint).name) + " calls no accelerations";
}

}  // namespace

void read_inner_scalar(Context& context, const FileSyntax* syntax, const SceneOptions& options,
                       Scene& scene) {
  const KeySyntax* const inner = find_key(syntax, "numeric", "inner");
  if (inner == nullptr) return;
  const auto* const row =
      std::ranges::find(inner_scalar_table, inner->value.text, &InnerScalarRow::name);
  if (row == inner_scalar_table.end() || row->kind == InnerScalar::same) return;
  const bool is_for_step = row->kind == InnerScalar::single_precision;
  if (is_for_step && !options.outputs.empty()) return;
  scene.numerics.inner = row->kind;
  const LanguageRow& language = language_row(scene.emission.language);
  if (!language.has_more_headers) {
    return context.report.add(Code::E611, inner->key_span,
                              "`inner` needs C++, but `language` is " + quote_text(language.name),
                              language_hint);
  }
  const auto refuse = [&](const Span& span, const std::string& others) {
    context.report.add(Code::E628, span, others + ", but `inner` is " + quote_text(row->name));
  };
  if (scene.numerics.scalars != std::vector{ScalarKind::double_precision}) {
    refuse(find_key(syntax, "numeric", "scalar")->value.span, "`scalar` is not `double` alone");
  }
  const auto other = std::ranges::find_if(scene.outputs, [](const OutputRequest& output) {
    return !inner_scalar_obstacle(output).empty();
  });
  if (is_for_step && other != scene.outputs.end())
    refuse(other->span, inner_scalar_obstacle(*other));
  for (const std::string_view header : {"eigen", "batch"}) {
    const KeySyntax* const key = find_key(syntax, "emit", header);
    const bool is_supported = is_for_step && header == "batch";
    if (is_flag_set(key) && !is_supported)
      refuse(key->key_span, quote_text(header) + " computes in its own scalars");
  }
}

}  // namespace elgen
