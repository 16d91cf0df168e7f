// The arm with seven joints. Written with frames or imported from URDF it has the same equations,
// and no more operations than a handwritten recursion. Quantities that a scene does not need cost
// nothing.
#include <catch2/catch.hpp>
#include <map>
#include <random>

#include "elgen/evaluate.hpp"
#include "elgen/urdf.hpp"
#include "pipeline/pipeline_testing.hpp"

namespace elgen::test {
namespace {

std::string frames_text() { return model_file("panda7"); }

std::string imported_text() {
  const std::string path = std::string(ELGEN_SOURCE_DIR) + "/tests/urdf/robots/panda_like.urdf";
  const Result<ImportedModel> model = import_urdf(make_source(path, read_text(path)), {});
  REQUIRE(model);
  return model.value->text;
}

std::size_t operations_of(const std::string& text, const std::string& output) {
  return operations(derived(inputs_of(text), output).program->functions.front());
}

/// Reproducible rational numbers between -3 and 3.
std::vector<Real> random_numbers(std::size_t count, std::mt19937& generator) {
  std::vector<Real> numbers;
  for (std::size_t i = 0; i < count; ++i) {
    const auto thousandths = static_cast<long>(generator() % 6001) - 3000;
    numbers.emplace_back(cln::cl_RA(thousandths) / 1000);
  }
  return numbers;
}

Arguments<Real> state_of(const Products& products, std::mt19937 generator) {
  Arguments<Real> state;
  for (const Parameter& parameter : products.checked->model.parameters) {
    state.parameters.emplace_back(parameter.value);
  }
  state.q = random_numbers(7, generator);
  state.v = random_numbers(7, generator);
  state.a = random_numbers(7, generator);
  state.u = random_numbers(7, generator);
  return state;
}

/// The model text with inertias declared about the origins of the frames.
std::string about_origins(std::string text) {
  const std::string before = "\ninertia = ";
  for (std::size_t at = text.find(before); at != std::string::npos;
       at = text.find(before, at + before.size() + 30)) {
    text.insert(at, "\ninertia_about = \"origin\"");
  }
  return text;
}

}  // namespace

TEST_CASE("frames and URDF give equal entries at 64 random states, to 50 digits") {
  const std::string outputs = "mass_matrix,bias,inverse_dynamics";
  const Products frames = derived(inputs_of(frames_text()), outputs);
  const Products imported = derived(inputs_of(imported_text()), outputs);
  const cln::cl_R tolerance = cln::expt(cln::cl_R(10), -50);
  for (unsigned seed = 0; seed < 64; ++seed) {
    const Arguments<Real> here = state_of(frames, std::mt19937(seed));
    const Arguments<Real> there = state_of(imported, std::mt19937(seed));
    for (std::size_t f = 0; f < 3; ++f) {
      INFO(frames.program->functions[f].name << " at seed " << seed);
      const auto x = evaluate(*frames.program, frames.program->functions[f], here);
      const auto y = evaluate(*imported.program, imported.program->functions[f], there);
      REQUIRE(x.size() == y.size());
      for (std::size_t i = 0; i < x.size(); ++i) {
        CHECK(cln::abs((x[i] - y[i]).value()) <= tolerance);
      }
    }
  }
}

TEST_CASE("operations of the arm with inertias about the origins of its frames") {
  // The limits are counts of customised recursions with composite inertias and symbolic parameters.
  const std::map<std::string, std::size_t> most{
      {"inverse_dynamics", 800}, {"mass_matrix", 420},
      {"gravity", 250},          {"forward_dynamics", 1400},
      {"coriolis_matrix", 2500}, {"inverse_dynamics_derivatives", 4000}};
  const std::string text = about_origins(frames_text());
  for (const auto& [output, limit] : most) {
    INFO(output);
    CHECK(operations_of(text, output) <= limit);
  }
}

TEST_CASE("operations of the arm with inertias about the centres of its links") {
  // Shifting an inertia to the origin of its frame costs about 15 operations per link.
  const std::map<std::string, std::size_t> most{
      {"inverse_dynamics", 800}, {"mass_matrix", 470},
      {"gravity", 250},          {"forward_dynamics", 1420},
      {"coriolis_matrix", 2500}, {"inverse_dynamics_derivatives", 4000}};
  for (const auto& [output, limit] : most) {
    INFO(output);
    CHECK(operations_of(frames_text(), output) <= limit);
  }
}

TEST_CASE("gravity alone has no velocity arguments") {
  const Products products = derived(inputs_of(frames_text()), "gravity", {Goal::self_check});
  CHECK(operations(products.program->functions.front()) <= 250);
  CHECK_FALSE(mentions(dump(*products.program), "velocity"));
  for (const auto& [path, text] : products.files->files) {
    if (path.substr(path.rfind('.')) != ".hpp") continue;
    const std::size_t body = text.find("gravity(");
    REQUIRE(body != std::string::npos);
    CHECK(text.find("Velocities<Scalar>&", body) == std::string::npos);
  }
}

TEST_CASE("fixed parameters save a fifth of the inverse dynamics") {
  PipelineOptions options;
  options.scene.outputs = {make_source("--outputs", "inverse_dynamics")};
  options.goals = {Goal::choose};
  const auto costs = [&options] {
    return operations(derived(inputs_of(frames_text()), options).program->functions.front());
  };
  const std::size_t symbolic = costs();
  options.scene.fixed.push_back(make_source("--fix", "all"));
  const std::size_t fixed = costs();
  INFO(symbolic << " operations, " << fixed << " with numbers");
  CHECK(fixed <= symbolic * 80 / 100);
}

}  // namespace elgen::test
