// Compiles every function of every header below generated/ and of a model of this test, with both
// compilers and strict warnings. The exhaustive tests use every scalar type, but skip long headers.
// Values are compared with long double or 50 digits, operation counts with the sidecar.
#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "elgen/emitted_files.hpp"
#include "fixture.hpp"
#include "support/shell.hpp"

using namespace elgen;
using namespace elgen::test;
namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;

struct Header {
  std::string path;  ///< as in #include
  std::string name_space;
  std::string text;
  Json sidecar;
  bool is_exhaustive;  ///< with every scalar type, not only the built-in types
};

std::string namespace_of(const std::string& text) {
  const std::size_t begin = text.find("\nnamespace ") + 11;
  return text.substr(begin, text.find(" {", begin) - begin);
}

void add_folder(std::vector<Header>& headers, const fs::path& folder, bool is_exhaustive) {
  if (!fs::exists(folder)) return;
  std::set<fs::path> sorted;
  for (const auto& entry : fs::directory_iterator(folder)) sorted.insert(entry.path());
  for (const fs::path& path : sorted) {
    const std::string name = path.filename().string();
    const fs::path header = path / (name + ".hpp");
    if (!fs::exists(header)) continue;
    const std::string text = read_text(header);
    headers.push_back({header.string(), namespace_of(text), text,
                       Json::parse(read_text(path / (name + ".equations.json"))), is_exhaustive});
  }
}

/// The scalar types of the functions of `header`. Packs and arrays have no atan2. AutoDiffScalar
/// has neither atan nor the inverse hyperbolic functions.
std::vector<std::string> scalars_of(const Header& header) {
  std::vector<std::string> scalars = {"float", "double", "long double"};
  if (!header.is_exhaustive) return scalars;
  scalars.emplace_back("Decimal");
  if (!mentions(header.text, "atan2(")) scalars.insert(scalars.end(), {"Pack", "Array"});
  if (!mentions(header.text, "atan")) scalars.emplace_back("AutoDiff");
  return scalars;
}

/// A lambda that calls h::`name` and passes open values; std::is_invocable can test its arguments.
std::string lambda(const Header& header, const std::string& name) {
  const char* const given =
      header.sidecar.contains("open_values") ? "p, open_values(p), y..." : "p, y...";
  return fmt::format(
      "[](const auto& p, const auto&... y) -> decltype(h::{0}({1})) {{ return h::{0}({1}); }}",
      name, given);
}

constexpr std::string_view open_values = R"(
template <class Scalar>
auto open_values(const h::Parameters<Scalar>&) {
  return state<Scalar, h::open_value_count>(0.5625);
}
)";

/// Code that appends the entries of `result` to `to`; steps have no entries to compare.
std::string append_statements(const Json& output, const std::string& result) {
  std::string text;
  if (output.contains("entries")) text = fmt::format("    append(to, {});\n", result);
  if (output.contains("fields")) {
    for (const auto& [field, value] : output["fields"].items()) {
      if (!value.contains("entries")) continue;
      text += fmt::format("    append(to, {}.{});\n", result, field);
    }
  }
  return text.empty() ? fmt::format("    (void){};\n", result) : text;
}

std::string prologue(const Header& header, std::size_t index) {
  const std::string text = fmt::format(R"(
namespace header_{0} {{
namespace h = ::{1};
template <class Scalar>
auto arguments() {{
  return Arguments<h::Parameters<Scalar>, h::Coordinates<Scalar>, h::Velocities<Scalar>,
                   h::Inputs<Scalar>, Scalar>{{
      {{}}, state<Scalar, h::coordinate_count>(0.375), state<Scalar, h::velocity_count>(0.8125),
      state<Scalar, h::velocity_count>(-1.0625), state<Scalar, h::input_count>(1.5625),
      made<Scalar>(0.6875)}};
}}
)",
                                       index, header.name_space);
  return header.sidecar.contains("open_values") ? text + std::string(open_values) : text;
}

std::string values_function(const Header& header) {
  std::string text =
      "template <class Scalar>\nstd::vector<Reference> values() {\n"
      "  std::vector<Reference> to;\n  const auto x = arguments<Scalar>();\n";
  for (const auto& [name, output] : header.sidecar["outputs"].items()) {
    text += fmt::format("  {{\n    const auto result = call({}, x);\n{}  }}\n",
                        lambda(header, name), append_statements(output, "result"));
  }
  return text + "  return to;\n}\n";
}

std::string checks(const Header& header) {
  std::string text = fmt::format("void check() {{\n  const auto reference = values<{}>();\n",
                                 header.is_exhaustive ? "Reference" : "long double");
  for (const std::string& scalar : scalars_of(header)) {
    text += fmt::format("  compare(\"{0} in {1}\", values<{1}>(), reference, epsilon<{1}>());\n",
                        header.name_space, scalar);
  }
  text += "  const auto x = arguments<Counted>();\n";
  for (const auto& [name, output] : header.sidecar["outputs"].items()) {
    const Json& n = output["operations"];
    text += fmt::format(
        "  counts = {{}};\n  (void)call({}, x);\n"
        "  compare_counts(\"{}::{}\", {{{}, {}, {}, {}, {}, {}}});\n",
        lambda(header, name), header.name_space, name, n["add"].get<int>(), n["mul"].get<int>(),
        n["div"].get<int>(), n["sqrt"].get<int>(), n["sincos"].get<int>(), n["other"].get<int>());
  }
  return text + "}\n}\n";
}

std::string driver(const std::vector<Header>& headers) {
  std::string text;
  for (const Header& header : headers) text += fmt::format("#include \"{}\"\n", header.path);
  text += "#include \"compiled_support.hpp\"\nusing namespace compiled;\nnamespace {\n";
  std::string calls;
  for (std::size_t i = 0; i < headers.size(); ++i) {
    text += prologue(headers[i], i) + values_function(headers[i]) + checks(headers[i]);
    calls += fmt::format("  header_{}::check();\n", i);
  }
  return text + "}\nint main() {\n" + calls + "  return failures == 0 ? 0 : 1;\n}\n";
}

std::vector<Header> all_headers(const fs::path& folder, bool is_exhaustive) {
  Subject subject = cart_pole();
  subject.scene.emission.name_space = "own_cart_pole";  // generated/ also has a cart_pole
  const Result<EmittedFiles> files =
      emit(subject.model, subject.scene, subject.program, {subject.program});
  REQUIRE(files);
  for (const auto& [path, text] : files->files) {
    write_text(folder / "own" / path, text);
  }
  std::vector<Header> headers;
  add_folder(headers, folder / "own", true);
  add_folder(headers, fs::path(ELGEN_SOURCE_DIR) / "generated", is_exhaustive);
  return headers;
}

/// Groups of at most `most_text` bytes, so that a driver needs at most about a gigabyte to compile.
/// Longer headers are skipped here; other tests compile all headers with the built-in types.
std::vector<std::vector<Header>> header_groups(const std::vector<Header>& headers) {
  constexpr std::size_t most_text =
      100'000;  // bytes; 20 kB of equations in eight scalar types need 300 MB
  std::vector<std::vector<Header>> groups;
  std::size_t size = most_text;
  for (const Header& header : headers) {
    if (header.text.size() > most_text) continue;
    size += header.text.size();
    if (size > most_text) {
      groups.emplace_back();
      size = header.text.size();
    }
    groups.back().push_back(header);
  }
  return groups;
}

/// Compiles and runs a driver; ccache, if installed, skips unchanged headers.
void compile_and_run(const std::string& compiler, const fs::path& folder,
                     const std::vector<Header>& headers) {
  write_text(folder / "driver.cpp", driver(headers));
  const std::string command = fmt::format(
      "$(command -v ccache) {0} -std=c++17 -O0 -Wall -Wextra -Wpedantic -Wconversion "
      "-Wsign-conversion -Wshadow -Wdouble-promotion -Wfloat-equal -Werror "
      "-isystem /usr/include/eigen3 -I{1}/tests/emit -c driver.cpp -o driver.o && "
      "{0} driver.o -o driver && ./driver",
      compiler, ELGEN_SOURCE_DIR);
  CHECK(failure_of(shell(command, folder)) == "");
}

void check_headers(const std::string& compiler, bool is_exhaustive) {
  INFO(compiler);
  // ccache compares paths, so the folder must be the same in every run.
  const fs::path folder = fs::path(ELGEN_BINARY).parent_path() / "compiled_headers" / compiler;
  fs::remove_all(folder);
  fs::create_directories(folder);
  REQUIRE(shell("command -v " + compiler, folder).status == 0);
  const std::vector<Header> headers = all_headers(folder, is_exhaustive);
  if (is_exhaustive) {
    for (const auto& group : header_groups(headers)) compile_and_run(compiler, folder, group);
  } else {
    compile_and_run(compiler, folder, headers);
  }
}

}  // namespace

TEST_CASE("g++ compiles every header, values and counts agree") { check_headers("g++", false); }

TEST_CASE("clang++ compiles every header, values and counts agree") {
  check_headers("clang++", false);
}

TEST_CASE("g++ compiles every header with every scalar type", "[.][exhaustive]") {
  check_headers("g++", true);
}

TEST_CASE("clang++ compiles every header with every scalar type", "[.][exhaustive]") {
  check_headers("clang++", true);
}
