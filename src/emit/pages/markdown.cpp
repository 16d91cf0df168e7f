// markdown: the page of the sheet under a comment that states what made it.
#include <fmt/format.h>

#include "elgen/drop.hpp"
#include "elgen/render.hpp"
#include "emit/pages/introduction.hpp"
#include "emit/pages/page_artifacts.hpp"
#include "emit/text/stamp.hpp"

namespace elgen {
namespace {

constexpr std::size_t most_entries = 64;

std::string operations(const Program& program) {
  std::string text = "## Operations\n\n```text\n";
  for (const std::string& line : operation_table(program)) text += line + "\n";
  return text + "```\n";
}

std::string dropped(const EmissionInput& input) {
  if (!input.program.reduction) return {};
  return "## Dropped terms\n\n```text\n" + dropped_page(input.model, input.program) + "```\n\n";
}

}  // namespace

std::string markdown(const EmissionInput& input) {
  const std::string stamp =
      fmt::format("<!-- {}\nmodel {} scene {} body {} -->\n\n", input.generated, input.model_hash,
                  input.scene_hash, blank_hash());
  const Sheet page = sheet(input.model, input.scene, input.program, {false, most_entries});
  return stamped(stamp + markdown_page(page) + "\n" + dropped(input) + operations(input.program));
}

}  // namespace elgen
