// No page of any model contains text that no book prints: names of the generator, formulas that are
// not simplified, macros that pandoc or GitHub lack, units as typed.
#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

#include "elgen/analysis_pages.hpp"
#include "pipeline/pipeline_testing.hpp"
#include "support/inputs.hpp"

namespace elgen::test {
namespace {

namespace fs = std::filesystem;

/// Texts that no page may contain.
constexpr std::array forbidden{std::to_array<std::string_view>({
    // macros that pandoc or GitHub lack
    "\\operatorname",
    "\\thinspace",
    // names instead of formulas
    "numerator",
    "denominator",
    // a rate is printed as d/dt
    "d/(d t)",
    "d/d t",
    "{d t}",
    "{d} t",
    // half angles, and functions of numbers
    "sin\\left( \\frac{1}{2}",
    "cos\\left( \\frac{1}{2}",
    "sin^{2}\\left( \\frac{1}{2}",
    "cos^{2}\\left( \\frac{1}{2}",
    "sin(½",
    "cos(½",
    "sin²(½",
    "cos²(½",
    "sin(π/6)",
    "\\sin \\frac{\\pi}{6}",
    "1 + \\sinh^{2}",
    "1 + sinh²",
    // units as typed
    "m/s^2",
    "kg*m",
    "N*m",
    "\\textasciicircum{}2",
    // the model's name of an output, or a repetition of the heading
    "(`bias`)",
    "Bias: bias",
})};

bool is_hex(char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); }

/// True for t_4f2a, t_{\mathrm{4f2a}}, t_{12345}: names of definitions in code.
bool has_hash_name(const std::string& text) {
  for (std::size_t at = text.find("t_"); at != std::string::npos; at = text.find("t_", at + 1)) {
    if (at > 0 && std::isalpha(static_cast<unsigned char>(text[at - 1])) != 0) continue;
    std::string_view rest = std::string_view(text).substr(at + 2);
    for (const std::string_view open : {"{", "\\mathrm{"}) {
      if (rest.starts_with(open)) rest.remove_prefix(open.size());
    }
    const auto digits = std::ranges::find_if_not(rest, is_hex) - rest.begin();
    if (digits >= 4) return true;
  }
  return false;
}

/// True if a bracket that ends with a rate is multiplied by the same rate, as in "φ̇) φ̇)".
bool has_doubled_rate(const std::string& text) {
  for (std::size_t at = text.find(") "); at != std::string::npos; at = text.find(") ", at + 1)) {
    const std::size_t begin = text.find_last_of(" (", at) + 1;
    const std::string factor = text.substr(begin, at - begin);
    const bool is_rate = mentions(factor, "\u0307") || mentions(factor, "\\dot{");
    if (is_rate && text.compare(at + 2, factor.size() + 1, factor + ")") == 0) return true;
  }
  return false;
}

/// True for "2 \frac{1}{a}": the number should be in the numerator.
bool has_number_beside_fraction(const std::string& text) {
  const std::string fraction = " \\frac{1}{";
  for (std::size_t at = text.find(fraction); at != std::string::npos;
       at = text.find(fraction, at + 1)) {
    const std::size_t last = at == 0 ? at : text.find_last_not_of("0123456789", at - 1);
    const std::size_t begin = last == std::string::npos ? 0 : last + 1;
    const bool stands_alone = begin == 0 || text[begin - 1] == ' ' || text[begin - 1] == '(';
    if (begin < at && stands_alone) return true;
  }
  return false;
}

/// All forbidden texts on a page.
std::vector<std::string> found_on(const std::string& page) {
  std::vector<std::string> found;
  for (const std::string_view text : forbidden) {
    const std::size_t at = page.find(text);
    if (at == std::string::npos) continue;
    const std::size_t begin = page.rfind('\n', at) + 1;
    found.push_back(std::string(text) + " in: " + page.substr(begin, page.find('\n', at) - begin));
  }
  if (has_hash_name(page)) found.emplace_back("the name of a definition");
  if (has_doubled_rate(page)) found.emplace_back("a rate twice");
  if (has_number_beside_fraction(page)) found.emplace_back("a number beside a fraction");
  return found;
}

std::string unicode_page(const Page& page) { return screen_page(page, {80, Alphabet::unicode}); }

void check_words(const Page& page) {
  for (const auto printed : {markdown_page, latex_document, html_page, unicode_page}) {
    CHECK(found_on(printed(page)) == std::vector<std::string>{});
  }
}

Products products_for(const SourcePointer& model, Goal goal) {
  return run_pipeline({model, nullptr}, {.goals = {goal}});
}

}  // namespace

TEST_CASE("no page of any model contains text that no book prints") {
  for (const fs::path& path : model_paths()) {
    INFO(path);
    const SourcePointer model = source_of(path);
    const Products typeset = products_for(model, Goal::typeset);
    REQUIRE(typeset.page_programs);
    PageOptions options;
    if (typeset.page_programs->steps) options.opening_steps = &*typeset.page_programs->steps;
    check_words(model_page(typeset.checked->model, typeset.checked->scene,
                           typeset.page_programs->program, options));
    const Products derived = products_for(model, Goal::steps);
    REQUIRE(derived.steps);
    check_words(derivation_page(derived.checked->model, derived.checked->scene, *derived.steps));
  }
}

TEST_CASE("no page of an analysis contains text that no book prints") {
  for (const char* const name : {"double_pendulum", "rotating_hoop", "elastic_pendulum"}) {
    INFO(name);
    const SourcePointer model = make_source("model.toml", model_file(name));
    const auto check_analysis = [&model](Goal goal, auto member, auto page) {
      INFO(name_of(goal));
      const Products products = products_for(model, goal);
      REQUIRE(products.*member);
      check_words(page(*products.checked, *(products.*member)));
    };
#define ELGEN_ANALYSIS(id, name, source, Found, find, page, ...) \
  check_analysis(Goal::id, &Products::id, &page);
#include "elgen/analyses.def"
  }
}

TEST_CASE("text that no book prints is found") {
  for (const char* const text :
       {"t_4f2a0", "t_{\\mathrm{da04d}}", "t_{71571}", "(ψ̇ + φ̇) φ̇)",
        "(a + \\dot{\\varphi}) \\dot{\\varphi})", "2 \\frac{1}{a} x", "c = (3 \\frac{1}{a})"}) {
    INFO(text);
    CHECK(found_on(text).size() == 1);
  }
  for (const char* const text : {"t_{1}", "\\theta_2 \\frac{1}{a}", "x^{2} \\frac{1}{2}",
                                 "(a + \\dot{x}) \\dot{y}", "(a + b) b)", "\\frac{1}{2} x"}) {
    INFO(text);
    CHECK(found_on(text).empty());
  }
}

}  // namespace elgen::test
