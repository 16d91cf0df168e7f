// player_page: one HTML file that contains the program's functions as a script, the model as JSON,
// and the equations as MathML.
#include <fmt/ranges.h>

#include <string>
#include <vector>

#include "base/fill_template.hpp"
#include "base/reason.hpp"
#include "elgen/emitted_files.hpp"
#include "elgen/page.hpp"
#include "elgen/player.hpp"
#include "emit/interface/code_interface.hpp"
#include "formula/glyphs.hpp"
#include "model/shown_places.hpp"
#include "model/symbols.hpp"
#include "numbers/exact_number.hpp"
#include "run/player/player_controls.hpp"
#include "run/player/player_model.hpp"
#include "run/steps/methods.hpp"

namespace elgen {
namespace {

/// The key by which the page's script finds the function: "places", "mass_matrix".
std::string call_key(const Scene& scene, const Function& function) {
  const bool is_shown = is_user_value(output_row(function.kind));
  return std::string(is_shown ? name_of(scene.page_outputs.at(function.user))
                              : output_row(function.kind).name);
}

TemplateData calls_data(const CheckedModel& checked, const Program& program) {
  const Model& model = checked.model;
  const Scene& scene = checked.scene;
  const LanguageId language = scene.emission.language;
  return repeated_section(program.functions, [&](const Function& function) {
    std::vector<std::string> arguments;
    for (const Opcode argument : arguments_of(model, function, program, language)) {
      arguments.push_back(fmt::format("x.{}", leaf_row(argument).symbol));
    }
    const std::string call = fmt::format("{}({})", name_in_language(language, function.name),
                                         fmt::join(arguments, ", "));
    const bool is_shown = is_user_value(output_row(function.kind));
    return TemplateRow{{"kind", call_key(scene, function)},
                       {"call", is_shown ? fmt::format("listed({})", call) : call}};
  });
}

/// In s: three years. A page shows a longer run at a pace of more than two months per second.
constexpr double longest_time = 1e8;

/// A browser computes about 1e5 steps per second, so more steps would take minutes.
constexpr double most_steps = 1e7;

/// E621 if a browser would need too long for the run.
Diagnostics check_run_length(const SimulationOptions& options) {
  if (options.duration > longest_time) {
    return {{Code::E621,
             {},
             fmt::format("`--time {:g}` is longer than {:g}, the longest run of a page",
                         options.duration, longest_time)}};
  }
  if (!options.step || options.duration / *options.step <= most_steps) return {};
  return {
      {Code::E621,
       {},
       fmt::format("`--step {:g}` makes more than {:g} steps of a page", *options.step, most_steps),
       "without `--step`, `dopri5` adapts its steps"}};
}

/// In bytes; about twelve screens of formulas. `show --what steps` prints what a page omits.
constexpr std::size_t longest_derivation = 60'000;

struct ReadableTexts {
  std::string equations = {};
  std::string derivation = {};            ///< without the equations of motion
  std::vector<std::string> omitted = {};  ///< titles of the omitted sections
};

/// The derivation as HTML. Omits the sections that do not fit after the sections before them.
ReadableTexts make_readable_texts(const Products& read) {
  ReadableTexts result;
  if (!read.steps) return result;
  for (const PageSection& section : derivation_sections(read.checked->model, *read.steps)) {
    const bool is_end = text_of(section.title) == equations_title;
    std::string& text = is_end ? result.equations : result.derivation;
    const std::string more = html_sections({section});
    if (text.size() + more.size() <= longest_derivation) {
      text += more;
    } else {
      result.omitted.push_back(unicode_text(section.title));
    }
  }
  return result;
}

TemplateData derivation_data(const ReadableTexts& texts) {
  const std::string titles = escape_xml(fmt::format("{}", fmt::join(texts.omitted, ", ")));
  const TemplateData omitted = optional_section(!titles.empty(), {"titles", titles});
  return optional_section(!texts.derivation.empty() || !titles.empty(),
                          TemplateRow{{"text", texts.derivation}, {"omitted", omitted}});
}

}  // namespace

Diagnostics check_player_options(const SimulationOptions& options) {
  Diagnostics refused;
  const Result<MethodRow> method = find_method(options);
  if (!method) return method.diagnostics;
  for (const Diagnostic& each : check_run_length(options)) refused.push_back(each);
  if (options.row_interval) {
    refused.push_back(
        {Reason::option_of_runs, {}, "`--every` applies to rows, but a page has none"});
  }
  if (options.input_hold_time) {
    refused.push_back(
        {Reason::option_of_runs, {}, "`--hold` applies to computed runs, not to pages"});
  }
  return refused;
}

PipelineOptions player_pipeline_options(PipelineOptions options) {
  options.scene.purpose = purpose::show_motion;
  return options;
}

Result<std::string> player_page(const Products& run_products, const Products& shown_products,
                                const SimulationOptions& options, const Limits& limits) {
  const Result<CheckedModel> assembled =
      assemble_start(*run_products.checked, exact_value(options.from));
  if (!assembled) return assembled.diagnostics;
  const auto& [model, scene] = *assembled;
  const Program& program = *run_products.program;
  const Result<std::string> functions = emitted_script(model, scene, program);
  if (!functions) return functions.diagnostics;
  const ReadableTexts texts = make_readable_texts(shown_products);
  const std::string title = page_title(model);
  const TemplateData data(
      TemplateRow{{"generated", std::string(generated_marker)},
                  {"title", escape_xml(title)},
                  {"label", html_attribute_text("The motion of " + title)},
                  {"no_places", shown_places(model).empty() ? " hidden" : ""},
                  {"functions", *functions},
                  {"calls", calls_data(*assembled, program)},
                  {"groups", slider_groups(*assembled, program)},
                  {"model", player_model_json(*assembled, program, shown_products, options)},
                  {"equations", texts.equations},
                  {"derivation", derivation_data(texts)}});
  std::string page = fill_template("player/page.html.mustache", data);
  if (page.size() <= limits.page_bytes) return page;
  return Diagnostic{
      Code::E916,
      {},
      fmt::format("the page has {} bytes, more than {}", page.size(), limits.page_bytes),
      "`--limit page_bytes=N` raises the limit"};
}

}  // namespace elgen
