// elgen show: prints the equations of one input on stdout, in notations for readers or for
// programs.
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/reason.hpp"
#include "base/text_table.hpp"
#include "cli/commands.hpp"
#include "cli/files/inputs.hpp"
#include "cli/process/terminal.hpp"
#include "cli/shown_pipeline.hpp"
#include "elgen/analysis_pages.hpp"
#include "elgen/page.hpp"
#include "elgen/pipeline.hpp"
#include "elgen/syntax.hpp"
#include "elgen/wording.hpp"
#include "program/evaluate/subject.hpp"

namespace elgen::cli {
namespace {

struct ShowOptions {
  std::string input = {};
  std::string what = {};        ///< names of outputs, or a word of `subjects`; empty: all outputs
  std::string notation = {};    ///< notation; empty: usual_notation()
  std::string rest_place = {};  ///< "theta=0", or the name of an [[equilibrium]]
  SceneOptions scene = {};
};

/// The page or JSON that `make` makes from the result `found` of an analysis.
template <auto make, auto found>
auto format_result(const Products& products, const PageOptions&) {
  return make(*products.checked, *(products.*found));
}

/// The text of the sidecar, which describes all outputs.
std::string json_of_outputs(const Products& products, const PageOptions&) {
  for (const auto& [path, text] : products.files->files) {
    if (path.ends_with(".json")) return text;
  }
  return {};
}

std::string text_of_outputs(const Products& products, const PageOptions& options) {
  const auto& [model, scene] = *products.checked;
  return text_page(model, scene, products.page_programs->program, options);
}

Page page_of_outputs(const Products& products, const PageOptions& options) {
  const auto& [model, scene] = *products.checked;
  return model_page(model, scene, products.page_programs->program, options);
}

template <const std::string_view& title>
Page page_of_steps(const Products& products, const PageOptions&) {
  const auto& [model, scene] = *products.checked;
  return derivation_page(model, scene, *products.steps, title);
}

constexpr std::string_view all_steps;

template <class T>
using ProductsFormatter = T (*)(const Products& products, const PageOptions& options);

/// A subject of --what. Outputs can be combined with each other; all other subjects are shown
/// alone.
struct SubjectRow {
  std::string_view word;                ///< in --what; "": outputs
  Goal goal;                            ///< the goal that computes the subject
  ProductsFormatter<Page> page;         ///< null: only text exists
  ProductsFormatter<std::string> text;  ///< null: the text is made from the page
  ProductsFormatter<std::string> json;  ///< null: no JSON form
};

constexpr std::array subjects{
    SubjectRow{"", Goal::emit, &page_of_outputs, &text_of_outputs, &json_of_outputs},
    SubjectRow{"lagrangian", Goal::steps, &page_of_steps<energies_title>, nullptr, nullptr},
    SubjectRow{"steps", Goal::steps, &page_of_steps<all_steps>, nullptr, nullptr},
    SubjectRow{"cost", Goal::emit, nullptr,
               [](const Products& all, const PageOptions&) { return cost_page(all.costs); },
               nullptr},
#define ELGEN_ANALYSIS(id, name, source, Found, find, page, json, ...)     \
  SubjectRow{#id, Goal::id, &format_result<&page, &Products::id>, nullptr, \
             &format_result<&json, &Products::id>},
#include "elgen/analyses.def"
};

/// The words of all subjects: "lagrangian, steps, cost, equilibria, modes, symmetries or
/// base_parameters".
std::string subject_words() {
  std::vector<std::string> words = column_words(subjects, &SubjectRow::word);
  words.erase(words.begin());  // outputs have no word
  const std::string last = std::move(words.back());
  words.pop_back();
  return fmt::format("{} or {}", fmt::join(words, ", "), last);
}

/// Names the subjects for an unknown output of the option `what` that is near no output.
void add_subject_hints(const SourceText* what, Diagnostics& diagnostics) {
  for (Diagnostic& diagnostic : diagnostics) {
    const bool is_unknown = diagnostic.code == Code::E601 && diagnostic.span.source == what;
    if (!is_unknown || !diagnostic.hint.empty()) continue;
    diagnostic.hint = suggestion(
        covered_text(diagnostic.span), column_words(subjects, &SubjectRow::word),
        fmt::format("`--what` takes outputs, such as mass_matrix, or {}", subject_words()));
  }
}

Result<const SubjectRow*> find_subject(const ShowOptions& options) {
  for (const SubjectRow& row : subjects) {
    if (row.word.empty()) continue;
    if (options.what == row.word) {
      const bool is_plain = options.notation == "text" || options.notation == "unicode";
      const bool is_printed =
          options.notation == "json" ? row.json != nullptr : row.page != nullptr || is_plain;
      if (is_printed) return &row;
      return Diagnostic{Reason::not_printed_as,
                        {},
                        fmt::format("`{}` is not printed as {}", row.word, options.notation)};
    }
    if (("," + options.what + ",").find(fmt::format(",{},", row.word)) != std::string::npos) {
      return Diagnostic{Reason::shown_alone,
                        {},
                        fmt::format("`{}` cannot be combined with other words", row.word),
                        "show it in a separate command"};
    }
  }
  return &subjects.front();
}

double stage_seconds(const std::vector<StageTime>& times, std::string_view first,
                     std::string_view last) {
  double sum = 0;
  bool counts = false;
  for (const StageTime& time : times) {
    counts = counts || time.stage == first;
    if (counts) sum += time.seconds;
    if (time.stage == last) break;
  }
  return sum;
}

double generation_time(const Products& products) {
  return stage_seconds(products.times, "parse", "emit");
}

/// The values of --size: the sizes in `options`, then the sizes of the scene that `options` do not
/// override.
std::vector<SourcePointer> sizes_of(const PipelineSources& inputs, const PipelineOptions& options) {
  std::vector<SourcePointer> sizes = options.scene.sizes;
  const auto is_given = [&options](const std::string& name) {
    return std::ranges::any_of(options.scene.sizes, [&name](const SourcePointer& option) {
      return option->text.starts_with(name + "=");
    });
  };
  if (inputs.scene != nullptr) {
    const Result<FileSyntax> scene = parse_scene(inputs.scene, options.limits);
    for (const KeySyntax& key : entry_keys(&*scene, "sizes")) {
      if (is_given(key.key)) continue;
      sizes.push_back(make_source("[sizes]", fmt::format("{}={}", key.key, key.value.text)));
    }
  }
  return sizes;
}

/// The products of the model without a scene, at the same sizes: all outputs, no fixed values, no
/// locks.
Products derive_full_model(const PipelineSources& inputs, const PipelineOptions& options) {
  PipelineOptions full = options;
  full.scene = {};
  full.scene.sizes = sizes_of(inputs, options);
  return run_pipeline({inputs.model, nullptr}, full);
}

std::string percentage(double part, double whole) {
  return whole > 0 ? fmt::format("{:.0f} %", 100 * part / whole) : "";
}

/// The columns of an output: its cost in `program`. If `full` is set, also its cost in the full
/// model, and the ratio of the two costs in percent.
std::vector<std::string> cost_columns(const OutputRequest& request, const Program& program,
                                      const Products* full) {
  const auto cost_in = [&request](const std::optional<Program>& of) -> std::optional<std::size_t> {
    const Function* const same = of ? find_function(*of, request.kind, request.user) : nullptr;
    if (same == nullptr) return std::nullopt;
    return cost(count_operations(*same));
  };
  const std::size_t own = *cost_in(program);
  if (full == nullptr) return {std::to_string(own)};
  const std::optional<std::size_t> whole = cost_in(full->program);
  if (!whole) return {std::to_string(own), "-", ""};
  return {std::to_string(own), std::to_string(*whole),
          percentage(static_cast<double>(own), static_cast<double>(*whole))};
}

/// A table with a row for each output: cost of one call; for a scene, also cost in the full model
/// and ratio of the two costs; time from formulate to choose if only this output is derived.
/// Derives the full model, and each output of `products` again. `products` must belong to `inputs`.
std::string cost_table(const PipelineSources& inputs, const PipelineOptions& options,
                       const Products& products) {
  PipelineOptions silent = options;
  silent.dump.reset();
  const bool has_scene = inputs.scene != nullptr || products.checked->scene.has_options;
  const Products whole = has_scene ? derive_full_model(inputs, silent) : Products{};
  const Products* full = has_scene ? &whole : nullptr;
  const std::vector<OutputRequest>& requests = products.checked->scene.outputs;
  TextRows rows{{"output", "cost"}};
  std::vector<TextColumn> columns{{false, 0, 0}, {true, 8}};
  if (full != nullptr) {
    rows[0].insert(rows[0].end(), {"full model", "share"});
    columns.insert(columns.end(), {{true, 10}, {true, 6}});
  }
  rows[0].emplace_back("alone");
  columns.push_back({true, 12});
  for (std::size_t i = 0; i < requests.size(); ++i) {
    if (!has_equations(output_row(requests[i].kind))) continue;  // a step has no equations
    std::vector<std::string>& row = rows.emplace_back(1, requests[i].name);
    const std::vector<std::string> costs = cost_columns(requests[i], *products.program, full);
    row.insert(row.end(), costs.begin(), costs.end());
    row.push_back(fmt::format(
        "{:.1f} ms", 1e3 * stage_seconds(output_stage_times(*products.checked, i, options.limits),
                                         "formulate", "choose")));
  }
  std::string text = fmt::format("{}\n", fmt::join(table_lines(rows, columns), "\n"));
  text += fmt::format("\ngenerated in {:.1f} ms", 1e3 * generation_time(products));
  if (full != nullptr) {
    text += fmt::format(", the full model in {:.1f} ms: {}", 1e3 * generation_time(whole),
                        percentage(generation_time(products), generation_time(whole)));
  }
  return text + "\n";
}

std::string output_text(const Products& products, const SubjectRow& subject,
                        const ShowOptions& wanted) {
  PageOptions options;
  options.shows_zeros = !wanted.what.empty();  // a named output is shown even if it is 0
  if (options.shows_zeros) options.most_entries = SIZE_MAX;
  const bool opens = wanted.what.empty() && products.page_programs && products.page_programs->steps;
  if (opens) options.opening_steps = &*products.page_programs->steps;
  if (wanted.notation == "json") return subject.json(products, options);
  if (subject.text != nullptr && (wanted.notation == "text" || subject.page == nullptr)) {
    return subject.text(products, options);
  }
  const Page shown = subject.page(products, options);
  if (wanted.notation == "text") return text_of(shown);
  if (wanted.notation == "unicode") {
    return screen_page(shown, {screen_of(stdout).columns, Alphabet::unicode});
  }
  if (wanted.notation == "latex") return latex_document(shown);
  return wanted.notation == "mathml" ? html_page(shown) : markdown_page(shown);
}

/// The default notation: json if --format is json; unicode if stdout is a terminal that shows
/// Unicode; otherwise text.
std::string usual_notation(const GlobalOptions& global) {
  if (wants_json(global)) return "json";
  return screen_of(stdout).alphabet == Alphabet::unicode ? "unicode" : "text";
}

/// The error of a notation that other programs make from a notation; otherwise "".
std::string notation_error(const std::string& word) {
  if (word == "html") return "`--as mathml` writes a page of HTML";
  return word == "pdf" || word == "tex" ? "`--as latex` writes a document of LaTeX" : "";
}

ExitCode show(const GlobalOptions& global, const ShowOptions& given) {
  ShowOptions options = given;
  if (options.notation.empty()) options.notation = usual_notation(global);
  const Result<const SubjectRow*> found = find_subject(options);
  if (!found) return report(global, found.diagnostics);
  const SubjectRow& subject = **found;
  const Result<PipelineSources> inputs = read_inputs(options.input, global.limits);
  if (!inputs) return report(global, inputs.diagnostics);
  PipelineOptions pipeline = pipeline_options(global, {subject.goal});
  pipeline.scene = options.scene;
  if (!options.rest_place.empty()) {
    const bool is_place = options.rest_place.find('=') != std::string::npos;
    pipeline.equilibrium_name = is_place ? "" : options.rest_place;
    if (is_place) pipeline.scene.starts = {make_source("--at", options.rest_place)};
  }
  const AnalysisRow* const analysis = find_analysis(subject.goal);
  if (analysis != nullptr && analysis->samples_open_functions)
    pipeline.scene.purpose = purpose::rest;
  if (subject.word.empty() && !options.what.empty()) {
    pipeline.scene.outputs = {make_source("command line", options.what)};
  }
  Products products = run_pipeline_with_progress(options.input, *inputs, pipeline);
  if (!pipeline.scene.outputs.empty())
    add_subject_hints(pipeline.scene.outputs.front().get(), products.diagnostics);
  const ExitCode derived = report_products(global, products);
  print_stage_times(global, products);
  if (derived != ExitCode::success || !global.stop_after.empty()) return derived;
  std::string text = output_text(products, subject, options);
  if (subject.word == "cost") text += "\n" + cost_table(*inputs, pipeline, products);
  return print(global, text);
}

}  // namespace

void add_show(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("show", "print the equations of a model or scene");
  const auto options = std::make_shared<ShowOptions>();
  command->add_option("input", options->input, "NAME.toml, NAME.scene.toml or - (stdin)")
      ->required();
  command
      ->add_option("--what", options->what, "outputs: mass_matrix,gravity,…; or " + subject_words())
      ->type_name("LIST");
  command
      ->add_option("--as", options->notation,
                   "unicode (default on a terminal), text (default otherwise), latex, mathml, "
                   "markdown or json")
      ->check(notation_error)
      ->check(CLI::IsMember({"unicode", "text", "latex", "mathml", "markdown", "json"}));
  command
      ->add_option(
          "--at", options->rest_place,
          "for modes: an equilibrium, theta=0,… or its name (default: all stable equilibria)")
      ->type_name("PLACE");
  add_source_option(*command, "--input", "NAME=VALUE", options->scene.laws,
                    "for equilibria and modes: value of an input (default: 0)");
  add_specialisation_options(*command, options->scene);
  set_action(*command, action, options, &show);
}

}  // namespace elgen::cli
