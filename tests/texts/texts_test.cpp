// Equations in comments, JSON and text agree with the derived equations, for all committed models
// and 50 random models. Every changed entry is detected.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <functional>

#include "elgen/page.hpp"
#include "elgen/pipeline.hpp"
#include "random/generator.hpp"
#include "support/inputs.hpp"
#include "support/systems.hpp"
#include "texts/readers.hpp"

namespace elgen::test {
namespace {

namespace fs = std::filesystem;

const fs::path models = fs::path(ELGEN_SOURCE_DIR) / "models";

/// The path of the model that a scene names.
fs::path model_of(const SourcePointer& scene) {
  const std::string_view text = scene->text;
  const std::size_t key = text.find("\nmodel");
  const std::size_t open = text.find('"', key) + 1;
  return models / "scenes" / text.substr(open, text.find('"', open) - open);
}

/// A derived system and the texts written for it.
struct Written {
  Products products;
  std::string header;
  std::string sidecar;
  std::string page;

  [[nodiscard]] Origin origin() const {
    return {products.checked->model, products.checked->scene, *products.program};
  }
};

Written written(const PipelineSources& inputs) {
  Written result{run_pipeline(inputs, {.goals = {Goal::emit}}), "", "", ""};
  INFO(inputs.model->text);
  INFO(format(result.products.diagnostics));
  REQUIRE(result.products.files);
  for (const auto& [path, text] : result.products.files->files) {
    if (path.ends_with(".json")) result.sidecar = text;
    const bool is_other = path.ends_with("_eigen.hpp") || path.ends_with("_batch.hpp");
    if (!is_other && (path.ends_with(".hpp") || path.ends_with(".h"))) result.header = text;
  }
  const Origin origin = result.origin();
  result.page = text_page(origin.model, origin.scene, origin.program);
  return result;
}

using Reader = void (*)(const std::string& text, WrittenEquations& equations);
/// The first mistake that `read` finds in the text, empty if there is none.
std::string mistake(Reader read, const std::string& text, WrittenEquations& equations) {
  try {
    read(text, equations);
    return "";
  } catch (const Mistake& found) {
    return found.what();
  }
}

void expect_right(const Written& system) {
  WrittenEquations equations(system.origin());
  CHECK(mistake(read_comments, system.header, equations) == "");
  CHECK(mistake(read_sidecar, system.sidecar, equations) == "");
  CHECK(mistake(read_page, system.page, equations) == "");
}

void expect_right(const PipelineSources& inputs) {
  INFO(inputs.model->path << " " << (inputs.scene ? inputs.scene->path : ""));
  expect_right(written(inputs));
}

/// Cart and pole with an array of parameters, constants of every kind, a kink, atan2, a quotient
/// and a Jacobian.
std::string wide() {
  std::string text = test::read_model("cart_pole");
  text.insert(text.find("M = {"), "k = { value = [0.7, 2], size = \"n\" }\nb = \"1/3\"\n");
  return text + R"toml([sizes]
n = 2
[[force]]
on = "x"
value = "-k[1]*dot(x) - 0.7*k[2]*abs(dot(x)) - sqrt(2)*pi*max(k[1], k[2])*dot(x)/3"
[[force]]
on = "theta"
value = "-b*dot(theta)"
[[output]]
name = "sight"
value = ["atan2(x + l*sin(theta), l*cos(theta) + 2*l)", "x/l"]
jacobian = true
)toml";
}

const Written& wide_system() {
  static const Written all = written({make_source("wide.toml", wide()), nullptr});
  return all;
}

/// True if the line contains equations. Called for each line in order.
using Places = std::function<bool(const std::string& line)>;

/// Checks that `read` finds each changed sign, digit or operator. Returns the number of changes.
std::size_t expect_changes_seen(Reader read, const std::string& text,
                                const Places& has_equations_in) {
  WrittenEquations equations(wide_system().origin());
  REQUIRE(mistake(read, text, equations).empty());
  const std::string from = "+-*/123789";
  const std::string to = "-+/*987321";
  std::size_t changes = 0;
  std::string accepted;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    const std::string line = text.substr(start, end - start);
    const bool has_equation = has_equations_in(line);
    for (std::size_t i = line.find_first_not_of(" /"); has_equation && i < line.size(); ++i) {
      const std::size_t kind = from.find(line[i]);
      if (kind == std::string::npos) continue;
      std::string changed = text;
      changed[start + i] = to[kind];
      ++changes;
      if (mistake(read, changed, equations).empty())
        accepted += changed.substr(start, end - start) + "\n";
    }
    start = end + 1;
  }
  INFO(accepted);
  CHECK(accepted.empty());
  return changes;
}

}  // namespace

TEST_CASE("the texts of all committed models contain the derived equations") {
  for (const fs::path& path : files_in(models, ".toml")) {
    expect_right({test::source_of(path), nullptr});
  }
}

TEST_CASE("the texts of all committed scenes contain the derived equations") {
  for (const fs::path& path : files_in(models / "scenes", ".scene.toml")) {
    const SourcePointer scene = test::source_of(path);
    expect_right({test::source_of(model_of(scene)), scene});
  }
}

TEST_CASE("the texts of random models contain the derived equations") {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const random::System system = random::Generator(seed).system();
    PipelineSources inputs{make_source("model.toml", text_of(system.model)), nullptr};
    if (system.scene.is_present) {
      inputs.scene = make_source("scene.toml", text_of(system.scene, system.model));
    }
    expect_right(inputs);
  }
}

TEST_CASE("every changed sign, digit and operator of a comment is detected") {
  // The listing follows the heading and the equation, each with a blank line after it.
  const auto in_listing = [blanks = 0](const std::string& line) mutable {
    if (!line.starts_with("///")) blanks = 0;
    if (line == "///") ++blanks;
    return blanks > 1;
  };
  CHECK(expect_changes_seen(read_comments, wide_system().header, in_listing) > 300);
}

TEST_CASE("every changed sign, digit and operator of a JSON entry is detected") {
  const auto in_strings = [](const std::string& line) {
    return mentions(line, "\"entries\"") || !mentions(line, "\":");
  };
  CHECK(expect_changes_seen(read_sidecar, wide_system().sidecar, in_strings) > 300);
}

TEST_CASE("every changed sign, digit and operator of a text page is detected") {
  const auto has_entry = [](const std::string& line) {
    return line.starts_with("  ") && mentions(line, "] = ");
  };
  CHECK(expect_changes_seen(read_page, wide_system().page, has_entry) > 300);
}

TEST_CASE("incomplete comments, JSON and pages are refused") {
  WrittenEquations equations(wide_system().origin());
  struct Change {
    Reader read;
    const std::string& text;
    std::string anchor, from, to, said;
  };
  const std::string& header = wide_system().header;
  const std::string& json = wide_system().sidecar;
  const std::string& page = wide_system().page;
  const std::string row = "///     [ m*l*cos(theta), m*l^2          ]\n";
  for (const Change& change : std::vector<Change>{
           {read_comments, header, "symmetric.", row, "", "entry 2 is missing"},
           {read_comments, header, "symmetric.", row, row + row, "one entry too many"},
           {read_comments, header, "symmetric.", row, "///     nothing\n", "no equation"},
           {read_comments, header, "Jacobian of", "[0, 0] =", "[0] =", "[0] instead of [0, 0]"},
           {read_comments, header, "Acceleration, and", "///     acceleration:\n", "", "too many"},
           {read_sidecar, json, "\"mass_matrix\"", "\"M + m\", ", "", "a list of 4"},
           {read_sidecar, json, "\"mass_matrix\"", "\"M + m\"", "\"M + mm\"", "no name of"},
           {read_sidecar, json, "\"coriolis_matrix\"", "[2, 2]", "[2, 3]", "instead of [2,2]"},
           {read_sidecar, json, "\"gravity\"", "\"mul\": 3", "\"mul\": 4", "4 instead of 3"},
           {read_sidecar, json, "\"name\": \"g\"", "9.81", "9.82", "`9.82` is not 9.81"},
           {read_sidecar, json, "\"name\": \"theta\"", "theta", "phi", "instead of"},
           {read_sidecar, json, "\"gravity\"", "\"gravity\"", "\"weight\"", "is missing"},
           {read_page, page, "\nmass_matrix\n", "[1,2]", "[2,1]", "is missing"},
           {read_page, page, "\ngravity\n", "gravity\n", "weight\n", "is missing"},
           {read_page, page, "\nkinetic_energy\n", "\n\n", "\n  more = 1\n\n", "too many"}}) {
    std::string text = change.text;
    const std::size_t at = text.find(change.from, text.find(change.anchor));
    INFO(change.from << " -> " << change.to);
    REQUIRE(at != std::string::npos);
    text.replace(at, change.from.size(), change.to);
    CHECK_THAT(mistake(change.read, text, equations), Catch::Contains(change.said));
  }
}

}  // namespace elgen::test
