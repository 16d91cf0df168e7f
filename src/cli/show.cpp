// elgen show: the equations of one input, on stdout, in a notation for people or for programs.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "check/expressions/values.hpp"
#include "cli/commands.hpp"
#include "cli/files/inputs.hpp"
#include "cli/process/terminal.hpp"
#include "cli/shown_pipeline.hpp"
#include "elgen/pipeline.hpp"
#include "elgen/render.hpp"
#include "program/evaluate/subject.hpp"

namespace elgen::cli {
namespace {

struct ShowOptions {
  std::string input = {};
  std::string what = {};  ///< outputs, or one of the words below; empty: all outputs
  std::string as = {};    ///< empty: as --format says
  std::string at = {};    ///< "theta=0", or the name of an [[equilibrium]]
  SceneOptions scene = {};
};

/// Written from the `parts` that the stages of an analysis made.
template <auto write, auto... parts>
auto made(const Products& products, const PageOptions&) {
  return write(*products.checked, *(products.*parts)...);
}

/// The sidecar, which has all outputs.
std::string json_of_outputs(const Products& products, const PageOptions&) {
  for (const auto& [path, text] : products.files->files) {
    if (path.ends_with(".json")) return text;
  }
  return {};
}

template <class T>
using Shown = T (*)(const Products& products, const PageOptions& options);

/// A subject that --what may ask for beside outputs; each stands alone.
struct SubjectRow {
  std::string_view word;  ///< "": outputs
  Goal goal;              ///< the stage whose product is shown
  Shown<std::string> text;
  Shown<Sheet> sheet;       ///< null: text alone
  Shown<std::string> json;  ///< null: none
  bool is_of_rest = false;  ///< states of rest and motions about them
};

constexpr std::array subjects{
    SubjectRow{"", Goal::emit,
               [](const Products& all, const PageOptions& options) {
                 const auto& [model, scene] = *all.checked;
                 return text_page(model, scene, all.book->program, options);
               },
               [](const Products& all, const PageOptions& options) {
                 const auto& [model, scene] = *all.checked;
                 return sheet(model, scene, all.book->program, options);
               },
               &json_of_outputs},
    SubjectRow{"lagrangian", Goal::steps,
               [](const Products& all, const PageOptions&) {
                 return steps_text(all.checked->model, *all.steps, energies_title);
               },
               [](const Products& all, const PageOptions&) {
                 const auto& [model, scene] = *all.checked;
                 return steps_sheet(model, scene, *all.steps, energies_title);
               },
               nullptr},
    SubjectRow{"steps", Goal::steps,
               [](const Products& all, const PageOptions&) {
                 return steps_text(all.checked->model, *all.steps);
               },
               [](const Products& all, const PageOptions&) {
                 return steps_sheet(all.checked->model, all.checked->scene, *all.steps);
               },
               nullptr},
    SubjectRow{"cost", Goal::emit,
               [](const Products& all, const PageOptions&) { return cost_page(all.costs); },
               nullptr, nullptr},
    SubjectRow{"equilibria", Goal::equilibria, &made<&equilibria_text, &Products::equilibria>,
               &made<&equilibria_sheet, &Products::equilibria>,
               &made<&equilibria_json, &Products::equilibria>, true},
    SubjectRow{"modes", Goal::modes, &made<&modes_text, &Products::equilibria, &Products::motions>,
               &made<&modes_sheet, &Products::equilibria, &Products::motions>,
               &made<&modes_json, &Products::equilibria, &Products::motions>, true},
    SubjectRow{"symmetries", Goal::symmetries, &made<&symmetries_text, &Products::symmetries>,
               &made<&symmetries_sheet, &Products::symmetries>,
               &made<&symmetries_json, &Products::symmetries>}};

Result<const SubjectRow*> subject_of(const ShowOptions& options) {
  for (const SubjectRow& row : subjects) {
    if (row.word.empty()) continue;
    if (options.what == row.word) {
      const bool is_plain = options.as == "text" || options.as == "unicode";
      const bool is_printed =
          options.as == "json" ? row.json != nullptr : row.sheet != nullptr || is_plain;
      if (is_printed) return &row;
      return Diagnostic{
          Code::E913, {}, fmt::format("`{}` is not printed as {}", row.word, options.as)};
    }
    if (("," + options.what + ",").find(fmt::format(",{},", row.word)) != std::string::npos) {
      return Diagnostic{Code::E913,
                        {},
                        fmt::format("`{}` stands alone", row.word),
                        "show it in a command of its own"};
    }
  }
  return &subjects.front();
}

double seconds(const std::vector<StageTime>& times, std::string_view first, std::string_view last) {
  double sum = 0;
  bool counts = false;
  for (const StageTime& time : times) {
    counts = counts || time.stage == first;
    if (counts) sum += time.seconds;
    if (time.stage == last) break;
  }
  return sum;
}

double generation(const Products& products) { return seconds(products.times, "parse", "emit"); }

/// The sizes that options and the scene chose, in the words of --size; those of options win.
std::vector<SourcePointer> sizes_of(const Inputs& inputs, const PipelineOptions& options) {
  std::vector<SourcePointer> sizes = options.scene.sizes;
  const auto is_given = [&options](const std::string& name) {
    return std::ranges::any_of(options.scene.sizes, [&name](const SourcePointer& option) {
      return option->text.starts_with(name + "=");
    });
  };
  if (inputs.scene != nullptr) {
    const Result<FileSyntax> scene = parse_scene(inputs.scene, options.limits);
    for (const KeySyntax& key : keys_of(&*scene, "sizes")) {
      if (is_given(key.key)) continue;
      sizes.push_back(make_source("[sizes]", fmt::format("{}={}", key.key, key.value.text)));
    }
  }
  return sizes;
}

/// The built-in scene at the same sizes: every output, nothing fixed, nothing locked.
Products full_model(const Inputs& inputs, const PipelineOptions& options) {
  PipelineOptions full = options;
  full.scene = {};
  full.scene.sizes = sizes_of(inputs, options);
  return run_pipeline({inputs.model, nullptr}, full);
}

std::string percentage(double part, double whole) {
  return whole > 0 ? fmt::format("{:.0f} %", 100 * part / whole) : "";
}

/// The columns of the cost in the scene and in the full model.
std::string compared(const OutputRequest& request, const Program& program, const Products* full) {
  const std::size_t own =
      cost(count_operations(*find_function(program, request.kind, request.user)));
  if (full == nullptr) return fmt::format("{:>8}", own);
  const Function* same =
      full->program ? find_function(*full->program, request.kind, request.user) : nullptr;
  if (same == nullptr) return fmt::format("{:>8}  {:>10}  {:>6}", own, "-", "");
  const std::size_t whole = cost(count_operations(*same));
  return fmt::format("{:>8}  {:>10}  {:>6}", own, whole,
                     percentage(static_cast<double>(own), static_cast<double>(whole)));
}

/// A table: for every output the cost of one call, that of the same output of the full model, and
/// the time to derive the output alone (formulate to choose). `products` are those of `inputs`;
/// every output is derived once more, and the full model where there is a scene.
std::string generation_costs(const Inputs& inputs, const PipelineOptions& options,
                             const Products& products) {
  PipelineOptions silent = options;
  silent.dump.reset();
  const bool has_scene = inputs.scene != nullptr || products.checked->scene.has_options;
  const Products whole = has_scene ? full_model(inputs, silent) : Products{};
  const Products* full = has_scene ? &whole : nullptr;
  std::size_t width = std::string_view("output").size();
  const std::vector<OutputRequest>& requests = products.checked->scene.outputs;
  for (const OutputRequest& request : requests) width = std::max(width, request.name.size());
  std::string text = fmt::format(
      "{:<{}}  {:>8}{}  {:>12}\n", "output", width, "cost",
      full == nullptr ? "" : fmt::format("  {:>10}  {:>6}", "full model", "share"), "alone");
  for (std::size_t i = 0; i < requests.size(); ++i) {
    if (!has_equations(output_row(requests[i].kind))) continue;  // made of the others
    text += fmt::format(
        "{:<{}}  {}  {:>9.1f} ms\n", requests[i].name, width,
        compared(requests[i], *products.program, full),
        1e3 * seconds(times_alone(*products.checked, i, options.limits), "formulate", "choose"));
  }
  text += fmt::format("\ngenerated in {:.1f} ms", 1e3 * generation(products));
  if (full != nullptr) {
    text += fmt::format(", the full model in {:.1f} ms: {}", 1e3 * generation(whole),
                        percentage(generation(products), generation(whole)));
  }
  return text + "\n";
}

std::string page(const Products& products, const SubjectRow& subject, const ShowOptions& wanted) {
  PageOptions options;
  options.zeros = !wanted.what.empty();  // what is asked for by name is shown
  if (options.zeros) options.most_entries = SIZE_MAX;
  const bool opens = wanted.what.empty() && products.book && products.book->steps;
  if (opens) options.opening = &*products.book->steps;
  if (wanted.as == "json") return subject.json(products, options);
  const bool is_screen = wanted.as == "unicode" && subject.sheet != nullptr;
  if (wanted.as == "text" || (wanted.as == "unicode" && !is_screen)) {
    return subject.text(products, options);
  }
  const Sheet shown = subject.sheet(products, options);
  if (is_screen) return screen_page(shown, {screen_of(stdout).columns, Alphabet::unicode});
  if (wanted.as == "latex") return latex_document(shown);
  return wanted.as == "mathml" ? html_page(shown) : markdown_page(shown);
}

/// Pipes get what programs read.
std::string usual_notation(const GlobalOptions& global) {
  if (wants_json(global)) return "json";
  return screen_of(stdout).alphabet == Alphabet::unicode ? "unicode" : "text";
}

ExitCode show(const GlobalOptions& global, const ShowOptions& given) {
  ShowOptions options = given;
  if (options.as.empty()) options.as = usual_notation(global);
  const Result<const SubjectRow*> found = subject_of(options);
  if (!found) return report(global, found.diagnostics);
  const SubjectRow& subject = **found;
  const Result<Inputs> inputs = read_inputs(options.input, global.limits);
  if (!inputs) return report(global, inputs.diagnostics);
  PipelineOptions pipeline = pipeline_options(global, {subject.goal});
  pipeline.scene = options.scene;
  if (!options.at.empty()) {
    const bool is_place = options.at.find('=') != std::string::npos;
    pipeline.about = is_place ? "" : options.at;
    if (is_place) pipeline.scene.starts = {make_source("--at", options.at)};
  }
  // States of rest are those of one potential: what a model leaves open is its sample.
  pipeline.scene.close_functions = subject.is_of_rest;
  if (subject.word.empty() && !options.what.empty()) {
    pipeline.scene.outputs = {make_source("command line", options.what)};
  }
  const Products products = run_shown(options.input, *inputs, pipeline);
  const ExitCode derived = report_products(global, products);
  tell_times(global, products);
  if (derived != ExitCode::success || !global.stop_after.empty()) return derived;
  std::string text = page(products, subject, options);
  if (subject.word == "cost") text += "\n" + generation_costs(*inputs, pipeline, products);
  return print(global, text);
}

}  // namespace

void add_show(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("show", "print the equations of a model or scene");
  const auto options = std::make_shared<ShowOptions>();
  command->add_option("input", options->input, "NAME.toml, NAME.scene.toml or - (stdin)")
      ->required();
  command
      ->add_option("--what", options->what,
                   "outputs: mass_matrix,gravity,…; or lagrangian, steps, cost, equilibria, modes "
                   "or symmetries")
      ->type_name("LIST");
  command
      ->add_option("--as", options->as,
                   "unicode (on a terminal), text (elsewhere), latex, mathml, markdown or json")
      ->check(CLI::IsMember({"unicode", "text", "latex", "mathml", "markdown", "json"}));
  command
      ->add_option("--at", options->at,
                   "for modes: theta=0,…, or an [[equilibrium]]; else all that are stable")
      ->type_name("PLACE");
  add_sources(*command, "--input", "NAME=VALUE", options->scene.laws,
              "for equilibria and modes: inputs that are not 0");
  add_specialisation(*command, options->scene);
  set_action(*command, action, options, &show);
}

}  // namespace elgen::cli
