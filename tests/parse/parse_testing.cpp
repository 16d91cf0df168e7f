// Results of the parser as text.
#include "parse_testing.hpp"

#include <fmt/format.h>

#include <catch2/catch.hpp>

namespace elgen::test {

std::string places(const Diagnostics& diagnostics) {
  std::string result;
  for (const Diagnostic& d : diagnostics) {
    REQUIRE(d.span.source != nullptr);
    const LineColumn place = line_column(*d.span.source, d.span.begin);
    if (!result.empty()) result += '\n';
    result += fmt::format("{} {}:{}", code_row(d.code).name, place.line, place.column);
  }
  return result;
}

std::string expression_answer(std::string_view text, const Limits& limits) {
  const SourcePointer source = make_source("test", std::string(text));
  const auto result = parse_expression(source, limits);
  return result ? dump(*result) : places(result.diagnostics);
}

std::string model_answer(std::string_view text, const Limits& limits) {
  const SourcePointer source = make_source("test", std::string(text));
  const auto result = parse_model(source, limits);
  return result ? dump(*result) : places(result.diagnostics);
}

std::string scene_answer(std::string_view text) {
  const SourcePointer source = make_source("test", std::string(text));
  const auto result = parse_scene(source, {});
  return result ? dump(*result) : places(result.diagnostics);
}

namespace {

/// The first diagnostic, without a source, because the source of a test does not outlive the call.
Diagnostic without_source(const Diagnostics& diagnostics) {
  REQUIRE_FALSE(diagnostics.empty());
  Diagnostic result = diagnostics.front();
  result.span.source = nullptr;
  return result;
}

}  // namespace

Diagnostic first_error(std::string_view model_text) {
  const SourcePointer source = make_source("test", std::string(model_text));
  return without_source(parse_model(source, {}).diagnostics);
}

Diagnostic first_scene_error(std::string_view scene_text) {
  const SourcePointer source = make_source("test", std::string(scene_text));
  return without_source(parse_scene(source, {}).diagnostics);
}

Diagnostic expression_error(std::string_view text) {
  const SourcePointer source = make_source("test", std::string(text));
  return without_source(parse_expression(source, {}).diagnostics);
}

std::string with_potential(std::string_view quoted_text) {
  return fmt::format(
      "format = 1\nmodel.name = \"m\"\n[[coordinate]]\nname = \"x\"\n[energy]\nV = {}\n",
      quoted_text);
}

std::string repeated(std::string_view text, std::size_t count) {
  std::string result;
  for (std::size_t i = 0; i < count; ++i) result += text;
  return result;
}

}  // namespace elgen::test
