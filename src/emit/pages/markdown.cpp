// markdown: the page of a model, after an HTML comment that states its sources and hashes.
#include <fmt/format.h>

#include "elgen/page.hpp"
#include "emit/pages/introduction.hpp"
#include "emit/text/emission_input.hpp"

namespace elgen {
namespace {

constexpr std::size_t most_entries = 64;

std::string operations_section(const Program& program) {
  std::string text = "## Operations\n\n```text\n";
  for (const std::string& line : operation_table(program)) text += line + "\n";
  return text + "```\n";
}

}  // namespace

std::string markdown_page_text(const EmissionInput& input) {
  const std::string stamp =
      fmt::format("<!-- {}\nmodel {} scene {} body {} -->\n\n", input.generated_notice,
                  input.model_hash, input.scene_hash, blank_hash());
  const ReadableDerivation* const opening = input.book.steps ? &*input.book.steps : nullptr;
  const Page page =
      model_page(input.model, input.scene, input.book.program, {false, most_entries, opening});
  return with_body_hash(stamp + markdown_page(page) + "\n" + operations_section(input.program));
}

}  // namespace elgen
