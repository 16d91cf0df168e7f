// C++: each function gets the arguments of its row, on arrays and on vectors of Eigen.
#include <catch2/catch.hpp>

#include "toolchain/driver_parts.hpp"
#include "toolchain/sample_model.hpp"

using Catch::Matchers::Contains;

namespace {

std::string driver_text(const elgen::Model& model, const elgen::Scene& scene,
                        const elgen::Program& program = sample::program()) {
  return elgen::cpp_driver({model, scene, program});
}

}  // namespace

TEST_CASE("each function gets the arguments of its row, and t last where t occurs") {
  elgen::Model model = sample::model();
  CHECK_THAT(driver_text(model, sample::scene()), !Contains(", t)"));
  model.uses_time = true;
  const std::string text = driver_text(model, sample::scene());
  CHECK_THAT(text, Contains("1>(a), t)"));
  CHECK_THAT(text, Contains("0>(u), t)"));
}

TEST_CASE("the mass matrix takes v where L is not quadratic") {
  elgen::Model model = sample::model();
  elgen::Program program = sample::program();
  program.functions = {
      {.kind = elgen::OutputKind::mass_matrix, .name = "M", .fields = {{.entries = {0}}}}};
  CHECK_THAT(driver_text(model, sample::scene(), program), !Contains(">(v)"));
  model.quadratic = false;
  CHECK_THAT(driver_text(model, sample::scene(), program), Contains(">(v)"));
}

TEST_CASE("a chosen namespace is used, the file keeps its name") {
  elgen::Scene scene = sample::scene();
  scene.emission.name_space = "plant";
  const std::string text = driver_text(sample::model(), scene);
  CHECK_THAT(text, Contains("#include \"sample/sample.hpp\""));
  CHECK_THAT(text, Contains("namespace emitted = ::plant;"));
}

TEST_CASE("results beyond 4096 entries are taken by reference") {
  elgen::Program program = sample::program();
  program.functions[0].fields[0].entries.assign(4096, 0);
  CHECK_THAT(driver_text(sample::model(), sample::scene(), program),
             !Contains("inverse_dynamics(result,"));
  program.functions[0].fields[0].entries.push_back(0);
  CHECK_THAT(driver_text(sample::model(), sample::scene(), program),
             Contains("inverse_dynamics(result,"));
  program.functions[1].fields[1].entries.assign(4097, 0);
  CHECK_THAT(driver_text(sample::model(), sample::scene(), program),
             Contains("emitted::ForwardDynamics<Scalar> result{};"));
}

TEST_CASE("column-major results come out row by row") {
  elgen::Scene scene = sample::scene();
  scene.emission.storage = elgen::Storage::column_major;
  CHECK_THAT(driver_text(sample::model(), scene), Contains("stored[j * rows + i]"));
}

TEST_CASE("the driver of the Eigen header passes its vectors, and takes its matrices") {
  elgen::Program program = sample::program();
  program.functions[0].fields = {{.rows = 50, .columns = 100}};
  program.functions[0].fields[0].entries.assign(5000, 0);
  const std::string text = elgen::eigen_driver({sample::model(), sample::scene(), program});
  CHECK_THAT(text, Contains("#include \"sample/sample_eigen.hpp\""));
  CHECK_THAT(text, Contains("namespace emitted = ::sample::eigen;"));
  CHECK_THAT(text, Contains("::sample::Parameters<Scalar> parameters_from"));
  CHECK_THAT(text, Contains("Eigen::Matrix<Scalar, N, 1> from_flat"));
  CHECK_THAT(text, Contains("emitted::Matrix<Scalar, 50, 100> result{};"));
}
