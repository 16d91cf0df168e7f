// Checks models given as text and prints the results as text.
#include "check_testing.hpp"

#include <catch2/catch.hpp>

#include "model_text.hpp"

namespace elgen::test {
namespace {

std::vector<SourcePointer> as_options(const std::vector<std::string>& texts) {
  std::vector<SourcePointer> sources;
  for (const std::string& text : texts) {
    sources.push_back(make_source("command line", text));
  }
  return sources;
}

std::string line_of(const Diagnostic& diagnostic) {
  std::string line(code_row(diagnostic.code).name);
  if (diagnostic.span.source != nullptr) {
    const LineColumn at = line_column(*diagnostic.span.source, diagnostic.span.begin);
    line += " " + std::to_string(at.line) + ":" + std::to_string(at.column);
  }
  line += " " + diagnostic.message;
  return diagnostic.hint.empty() ? line : line + " | " + diagnostic.hint;
}

}  // namespace

Result<CheckedModel> run_check(const std::string& model, const CheckOptions& wanted) {
  const auto syntax = parse_model(make_source("model.toml", model), wanted.limits);
  INFO(format(syntax.diagnostics));
  REQUIRE(syntax);
  std::optional<FileSyntax> scene;
  if (!wanted.scene.empty()) {
    auto scene_syntax = parse_scene(make_source("a.scene.toml", wanted.scene), wanted.limits);
    INFO(format(scene_syntax.diagnostics));
    REQUIRE(scene_syntax);
    scene = std::move(*scene_syntax);
  }
  SceneOptions options;
  options.outputs = as_options(wanted.outputs);
  options.fixed = as_options(wanted.fixed);
  options.sizes = as_options(wanted.sizes);
  options.ranges = as_options(wanted.ranges);
  options.over = as_options(wanted.over);
  options.purpose = wanted.purpose;
  Result<CheckedModel> result = check(*syntax, scene ? &*scene : nullptr, options, wanted.limits);
  // Spans of errors point into the sources, so the sources must outlive this function.
  static std::vector<SourcePointer> alive;
  alive.push_back(syntax->source);
  if (scene) alive.push_back(scene->source);
  for (const auto* list :
       {&options.outputs, &options.fixed, &options.sizes, &options.ranges, &options.over}) {
    alive.insert(alive.end(), list->begin(), list->end());
  }
  return result;
}

std::string messages(const std::string& model, const CheckOptions& wanted) {
  const Result<CheckedModel> result = run_check(model, wanted);
  CHECK(result.value.has_value() != has_errors(result.diagnostics));
  std::string text;
  for (const Diagnostic& diagnostic : result.diagnostics) {
    text += line_of(diagnostic) + "\n";
  }
  return text;
}

CheckedModel checked(const std::string& model, const CheckOptions& wanted) {
  Result<CheckedModel> result = run_check(model, wanted);
  INFO(format(result.diagnostics));
  REQUIRE(result);
  return std::move(*result);
}

std::string block(const std::string& more) {
  return R"(format = 1
[model]
name = "block"
[[coordinate]]
name = "x"
unit = "m"
[parameters]
m = { value = 1, unit = "kg" }
k = { value = 2, unit = "N/m" }
[energy]
T = "1/2*m*dot(x)^2"
)" + more;
}

std::string scene_of_block(const std::string& more) {
  return "format = 1\nmodel = \"block.toml\"\nname = \"fast\"\n" + more;
}

Scene block_scene(const std::string& more) {
  return checked(block(), {.scene = scene_of_block(more)}).scene;
}

std::string block_scene_messages(const std::string& more) {
  return messages(block(), {.scene = scene_of_block(more)});
}

std::string potential_messages(const std::string& potential, const CheckOptions& wanted) {
  return messages(block("V = \"" + potential + "\"\n"), wanted);
}

std::string dump_lines(const std::string& model, const std::string& word,
                       const CheckOptions& wanted) {
  std::string text;
  for (const std::string& line : split_lines(dump(checked(model, wanted).model))) {
    if (line.compare(0, word.size(), word) == 0) text += line + "\n";
  }
  return text;
}

void check_rows(const Rows& rows, const std::function<std::string(const std::string&)>& answer) {
  for (const auto& [input, expected] : rows) {
    INFO(input);
    CHECK(answer(input) == expected);
  }
}

}  // namespace elgen::test
