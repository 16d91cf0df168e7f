// Scene: outputs in the order of the output table, fixed parameters, scalars and emission.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <set>

#include "base/reason.hpp"
#include "base/report.hpp"
#include "check/expressions/parameters.hpp"
#include "check/expressions/values.hpp"
#include "check/names/reserved_names.hpp"
#include "check/scene/scene.hpp"
#include "elgen/scene.hpp"
#include "elgen/step_methods.hpp"
#include "elgen/wording.hpp"
#include "model/requests.hpp"

namespace elgen {
namespace {

bool precedes(const OutputRequest& a, const OutputRequest& b) {
  return std::pair(a.kind, a.user) < std::pair(b.kind, b.user);
}

/// The canonical text of a scene and options; "" if both are absent.
std::string canonical_scene_text(const FileSyntax* scene, const SceneOptions& options) {
  std::string text = scene == nullptr ? "" : dump(*scene);
  for (const auto& [name, list] :
       {std::pair("outputs", &options.outputs), std::pair("fix", &options.fixed),
        std::pair("size", &options.sizes)}) {
    for (const Span& span : option_words(*list)) {
      std::string word(covered_text(span));
      std::erase(word, ' ');
      text += fmt::format("--{} {}\n", name, word);
    }
  }
  if (options.language)
    text += fmt::format("--language {}\n", language_row(*options.language).name);
  return text;
}

class SceneReader {
 public:
  SceneReader(Context& context, const FileSyntax* syntax, const SceneOptions& options, Scene& scene)
      : context_(context),
        model_(context.model),
        syntax_(syntax),
        options_(options),
        scene_(scene) {}

  void read() {
    keep_sources();
    read_header();
    read_fixed();
    read_regressor(context_, syntax_, scene_.specialisation.fixed);
    independent_ = read_independent_velocities(context_, syntax_);
    read_outputs();
    read_numerics();
    scene_.emission = read_emission(context_, syntax_, options_, scene_);
    read_inner_scalar(context_, syntax_, options_, scene_);
    read_batch(context_, syntax_, scene_);
    if (options_.inner != InnerScalar::same) scene_.numerics.inner = options_.inner;
    read_error_bound(context_, syntax_, options_, scene_.numerics);
    scene_.has_options = options_.changes_files();
    scene_.canonical_text = canonical_scene_text(syntax_, options_);
  }

 private:
  void keep_sources() {
    if (syntax_ != nullptr) scene_.source = syntax_->source;
    for (const auto* list : {&options_.outputs, &options_.fixed, &options_.sizes, &options_.values,
                             &options_.starts, &options_.laws, &options_.ranges, &options_.over}) {
      scene_.option_sources.insert(scene_.option_sources.end(), list->begin(), list->end());
    }
  }

  void read_header() {
    scene_.base_name = model_.name;
    scene_.paths = options_.paths;
    if (scene_.paths.model.empty()) scene_.paths.model = file_name(*model_.source);
    if (syntax_ != nullptr && scene_.paths.scene.empty()) {
      scene_.paths.scene = file_name(*syntax_->source);
    }
    if (const EntrySyntax* top = find_entry(syntax_, "")) {
      scene_.name = text_value(*top, "name");
      scene_.doc = text_value(*top, "doc");
      scene_.base_name += "_" + scene_.name;
    }
  }

  void read_outputs() {
    const EntrySyntax* outputs = find_entry(syntax_, "outputs");
    if (!options_.outputs.empty()) {
      for (const Span& word : option_words(options_.outputs)) request_by_name(outputs, word);
      if (options_.step) request_step(*options_.step);
    } else if (outputs != nullptr) {
      for (const KeySyntax& key : outputs->keys) read_output(key);
      request_own_outputs(*outputs);
    } else {
      scene_.outputs = full_scene_requests(model_);
      scene_.omitted_outputs = outputs_omitted_by_full(model_);
      return;
    }
    request_reaction();
    std::ranges::stable_sort(scene_.outputs, precedes);
    check_function_names();
    check_dynamics();
    check_steps(context_, scene_.outputs);
  }

  /// Requests the functions of each [[output]] of the scene, except those of `[outputs]`.
  void request_own_outputs(const EntrySyntax& outputs) {
    for (const OutputRequest& request : full_scene_requests(model_)) {
      if (!output_row(request.kind).is_user_output || outputs.find(request.name) != nullptr)
        continue;
      const Span& span = model_.outputs[request.user].span;
      if (is_of_scene(model_, span)) add_request(request.name, span);
    }
  }

  /// The scene's entry for the step `name`, a standard or a new name; null if absent.
  const KeySyntax* find_step_key(const EntrySyntax* outputs, const std::string& name) const {
    if (outputs == nullptr) return nullptr;
    const bool is_standard = find_request(model_, name).has_value();
    const auto found = std::ranges::find_if(outputs->keys, [&](const KeySyntax& key) {
      const OutputRow* const row = find_output(key.key);
      if (row == nullptr || !row->is_step) return false;
      const KeySyntax* const rename = key.value.find("rename");
      return is_standard ? key.key == name : rename != nullptr && rename->value.text == name;
    });
    return found == outputs->keys.end() ? nullptr : &*found;
  }

  /// Adds an output that an option names. The method of a step comes from the scene.
  void request_by_name(const EntrySyntax* outputs, const Span& word) {
    const std::string name(covered_text(word));
    if (find_request(scene_, name) != nullptr) return;
    const KeySyntax* const key = find_step_key(outputs, name);
    OutputRequest* const output = add_request(key == nullptr ? name : key->key, word);
    if (output == nullptr) return;
    read_options(model_, key == nullptr ? ValueSyntax() : key->value, *output, context_.report);
    output->name = name;
  }

  /// Adds the step with which a run integrates.
  void request_step(const StepSpec& chosen) {
    OutputRequest* const step = add_request(std::string(output_row(OutputKind::step).name), {});
    if (step != nullptr) step->step = chosen;
  }

  /// Adds the output `reaction` if a lock has `reaction = true`.
  void request_reaction() {
    if (!reaction_row_velocities(model_).empty()) {
      add_request(std::string(output_row(OutputKind::reaction).name),
                  model_.reduction.locks.front().span);
    }
  }

  /// Reports E603 for `dynamics` if the scene requests no output that `dynamics` repeats.
  void check_dynamics() {
    const auto is_member = [](const OutputRequest& output) {
      return is_in_dynamics(output.kind, output.argument_kinds);
    };
    if (std::ranges::any_of(scene_.outputs, is_member)) return;
    for (const OutputRequest& output : scene_.outputs) {
      if (output_row(output.kind).is_summary) {
        context_.report.add(
            Reason::empty_dynamics, output.span,
            "`dynamics` returns the requested outputs that take neither a nor u, but "
            "the scene requests none");
      }
    }
  }

  OutputRequest* add_request(const std::string& name, const Span& span) {
    auto found = require_request(model_, name, span, context_.report, independent_);
    if (!found) return nullptr;
    for (OutputRequest& other : scene_.outputs) {
      if (!precedes(other, *found) && !precedes(*found, other)) return &other;
    }
    if (options_.purpose.keeps_pivots) found->omits_pivots = false;
    scene_.outputs.push_back(std::move(*found));
    return &scene_.outputs.back();
  }

  static std::optional<Form> read_output_form(const KeySyntax* key) {
    if (key == nullptr) return std::nullopt;
    return key->value.text == name_of(Form::closed) ? Form::closed : Form::recursive;
  }

  void read_output(const KeySyntax& key) {
    if (key.value.kind == ValueKind::boolean && !key.value.boolean) {
      (void)require_request(model_, key.key, key.key_span, context_.report, independent_);
      return;
    }
    OutputRequest* output = add_request(key.key, key.key_span);
    const KeySyntax* rename = key.value.find("rename");
    if (output != nullptr) {
      output->form = read_output_form(key.value.find("form"));
      read_options(model_, key.value, *output, context_.report);
    }
    if (output != nullptr && rename != nullptr) {
      output->name = rename->value.text;
      output->span = rename->value.span;
      (void)check_name(output->name, output->span, context_.report);
    }
  }

  void check_function_names() {
    std::set<std::string> used_names;
    // Standard names come first, so the error is at the renamed output, whatever the order in the
    // file.
    for (const bool renamed : {false, true}) {
      for (const OutputRequest& output : scene_.outputs) {
        const bool is_renamed = output.name != standard_name(output);
        if (is_renamed == renamed && !used_names.insert(output.name).second) {
          context_.report.add(Code::E609, output.span,
                              "another output is already called " + quote_text(output.name));
        }
      }
    }
  }

  void read_fixed() {
    const KeySyntax* fixed = find_key(syntax_, "parameters", "fixed");
    if (fixed != nullptr && fixed->value.kind == ValueKind::text) {
      fix_parameters_named(fixed->value.text, fixed->value.span, nullptr);
    } else if (fixed != nullptr) {
      for (const ValueSyntax& name : fixed->value.items) {
        fix_parameters_named(name.text, name.span, nullptr);
      }
      for (const KeySyntax& key : fixed->value.entries) {
        fix_parameters_named(key.key, key.key_span, &key.value);
      }
    }
    constexpr KeyType type = KeyType::boolean_or_expression;
    for (const KeySyntax& key : parse_option_keys(context_, options_.fixed, type)) {
      const bool has_value = key.value.kind == ValueKind::expression;
      fix_parameters_named(key.key, key.key_span, has_value ? &key.value : nullptr);
    }
  }

  /// Fixes the parameters that `name` denotes. NAME denotes all elements, NAME[i] one element, and
  /// "all" every parameter. Without `value`, a parameter is fixed at its value in the model.
  void fix_parameters_named(const std::string& name, const Span& span, const ValueSyntax* value) {
    const bool fixes_all = name == "all" && value == nullptr;
    std::vector<std::uint32_t> targets(model_.parameters.size());
    std::iota(targets.begin(), targets.end(), 0U);
    if (!fixes_all) {
      const char* const hint = name == "all" ? "`all` fixes every parameter at its own value" : "";
      targets = find_parameters(context_, name, span, hint);
    }
    if (targets.empty()) return;
    std::optional<FixedValue> own;
    if (value != nullptr) own = ValueReader(context_).read_exact_constant(*value);
    for (const std::uint32_t target : targets) {
      if (own) check_parameter_value(context_, target, own->number, value->expression.span);
      if (own) set_cyclic_momentum(context_.model, target, own->number);
      const Parameter& parameter = model_.parameters[target];
      scene_.specialisation.fixed[target] =
          own.value_or(FixedValue{parameter.value, parameter.exact_expression});
    }
  }

  void read_numerics() {
    if (const auto form = read_output_form(find_key(syntax_, "numeric", "form"))) {
      for (OutputRequest& output : scene_.outputs) output.form = output.form.value_or(*form);
    }
    if (const KeySyntax* prefer = find_key(syntax_, "numeric", "prefer")) {
      const bool is_speed = prefer->value.text == "speed";
      scene_.numerics.prefer = is_speed ? Preference::speed : Preference::balanced;
    }
    const KeySyntax* scalars = find_key(syntax_, "numeric", "scalar");
    if (scalars == nullptr) return;
    scene_.numerics.scalars.clear();
    for (const ScalarRow& row : scalar_table) {
      const auto& items = scalars->value.items;
      const bool is_named = std::ranges::count(items, row.name, &ValueSyntax::text) > 0;
      if (is_named) scene_.numerics.scalars.push_back(row.kind);
    }
  }

  [[nodiscard]] std::string standard_name(const OutputRequest& output) const {
    return make_request(model_, output.kind, output.user).name;
  }

  Context& context_;
  const Model& model_;
  const FileSyntax* syntax_;
  const SceneOptions& options_;
  Scene& scene_;
  std::vector<std::uint32_t> independent_ = {};
};

}  // namespace

void read_scene(Context& context, const FileSyntax* syntax, const SceneOptions& options,
                Scene& scene) {
  SceneReader(context, syntax, options, scene).read();
}

}  // namespace elgen
