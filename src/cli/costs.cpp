// Costs of generation: run again, one output at a time.
#include "cli/costs.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "check/expressions/values.hpp"
#include "evaluate/subject.hpp"

namespace elgen::cli {
namespace {

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

/// The sizes that the scene chose, in the words of --size.
std::vector<SourcePointer> sizes_of(const Inputs& inputs, const PipelineOptions& options) {
  std::vector<SourcePointer> sizes;
  if (inputs.scene != nullptr) {
    const Result<FileSyntax> scene = parse_scene(inputs.scene, options.limits);
    for (const KeySyntax& key : keys_of(&*scene, "sizes")) {
      sizes.push_back(make_source("[sizes]", fmt::format("{}={}", key.key, key.value.text)));
    }
  }
  sizes.insert(sizes.end(), options.scene.sizes.begin(), options.scene.sizes.end());
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

}  // namespace

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

}  // namespace elgen::cli
