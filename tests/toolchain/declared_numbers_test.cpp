// Compiles headers and compares the numbers declared in them with the numbers of the model.
#include <algorithm>
#include <catch2/catch.hpp>

#include "elgen/toolchain.hpp"
#include "toolchain/sample_model.hpp"

using namespace elgen;
using namespace elgen::test;
using Names = std::vector<std::string>;

namespace {

const CompileOptions declaring{.limits = {.seconds = 600}, .reads_declared_numbers = true};

Model sample_model() {
  Model model = sample::model();
  model.coordinates.front().range = Interval{cln::cl_RA(-2), cln::cl_RA(3) / 10};
  for (int i = 0; i < 3; ++i) model.parameters[i].value = cln::cl_RA(i + 1) / 3;
  return model;
}

std::string declaring_header() {
  std::string text = sample::header();
  const auto replace = [&text](const std::string& written, const std::string& other) {
    text = replaced(text, written, other);
  };
  replace("Scalar m; std::array<Scalar, 2> l;",
          "Scalar m = Scalar(1) / 3; std::array<Scalar, 2> l = {Scalar(2) / 3, 1};");
  replace("namespace sample {\n", R"(#include <limits>
namespace sample {
struct Interval { double low; double high; };
inline constexpr double unbounded = std::numeric_limits<double>::infinity();
inline constexpr std::size_t parameter_count = 3;
inline constexpr std::array<const char*, 1> coordinate_names{{"x"}}, coordinate_units{{""}};
inline constexpr std::array<const char*, 0> input_names{}, input_units{};
inline constexpr std::array<Interval, 1> coordinate_ranges{{{-2.0, 0.3}}};
inline constexpr std::array<Interval, 1> rate_ranges{{{-unbounded, unbounded}}};
inline constexpr std::array<Interval, 0> input_limits{};
inline constexpr std::array<double, 1> start_coordinates{{0.0}};
inline constexpr std::array<double, 1> start_rates{{0.0}};
)");
  return text;
}

/// The names of the numbers that differ from the model's after `from` is replaced by `to` in the
/// header.
Names differing(const std::string& from = "", const std::string& to = "") {
  std::string text = declaring_header();
  if (!from.empty()) text = replaced(text, from, to);
  const auto compiled =
      compile(sample::files(text), sample_model(), sample::scene(), sample::program(), declaring);
  INFO(format(compiled.diagnostics));
  REQUIRE(compiled);
  Names names;
  for (const DeclaredNumber& number : compiled->front().declared) {
    if (number.declared != number.model_value) names.push_back(number.name);
  }
  return names;
}

}  // namespace

TEST_CASE("headers that declare the numbers of the model have no differences") {
  CHECK(differing().empty());
}

TEST_CASE("a different value, range, bound or count is named") {
  CHECK(differing("Scalar(2) / 3, 1}", "Scalar(2) / 3, 2}") ==
        Names{"l[1] (double)", "l[1] (float)"});
  CHECK(differing("0.3}", "0.30000000000000004}") == Names{"coordinate_ranges[0].high"});
  CHECK(differing("unbounded}}}", "1e300}}}") == Names{"rate_ranges[0].high"});
  CHECK(differing("parameter_count = 3", "parameter_count = 2") == Names{"parameter_count"});
}

TEST_CASE("exchanged parameters are detected by their positions") {
  const std::string m = "Scalar m = Scalar(1) / 3;";
  const std::string l = " std::array<Scalar, 2> l = {Scalar(2) / 3, 1};";
  const Names names = differing(m + l, l + m);
  CHECK(names.size() == 6);
  CHECK(names.front() == "the place of m (double)");
}

TEST_CASE("a C header declares its values in a macro") {
  EmittedFiles files;
  files.files["sample/sample.h"] = R"(#pragma once
enum { SAMPLE_COORDINATE_COUNT = 1, SAMPLE_VELOCITY_COUNT = 1, SAMPLE_INPUT_COUNT = 0,
       SAMPLE_PARAMETER_COUNT = 3 };
typedef struct sample_parameters { float m; float l[2]; } sample_parameters;
typedef struct sample_interval { double low, high; } sample_interval;
static const char *const sample_coordinate_names[1] = {"x"};
static const char *const sample_coordinate_units[1] = {""};
static const sample_interval sample_coordinate_ranges[1] = {{-2.0, 0.3}};
static const double sample_start_coordinates[1] = {0.0};
static const sample_interval sample_rate_ranges[1] = {{-__builtin_huge_val(), __builtin_huge_val()}};
static const double sample_start_rates[1] = {0.0};
#define SAMPLE_DEFAULT_PARAMETERS {1.0F / 3.0F, {2.0F / 3.0F, 1.0F}}
)" + sample::c_functions("float");
  Scene scene = sample::scene();
  scene.emission.language = LanguageId::c99;
  scene.numerics.scalars = {ScalarKind::single_precision};
  const auto compiled = compile(files, sample_model(), scene, sample::program(), declaring);
  INFO(format(compiled.diagnostics));
  REQUIRE(compiled);
  const std::vector<DeclaredNumber>& numbers = compiled->front().declared;
  CHECK(numbers.size() == 4 + 6 + 1 + 12);  // counts, parameters, size, tables
  CHECK(std::ranges::all_of(
      numbers, [](const DeclaredNumber& number) { return number.declared == number.model_value; }));
}
