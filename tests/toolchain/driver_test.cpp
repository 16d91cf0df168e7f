// Every emitted header has a driver in its language: C, or C++ with arrays, Eigen vectors or
// batches. A further driver measures times.
#include "toolchain/driver.hpp"

#include <catch2/catch.hpp>

#include "toolchain/sample_model.hpp"

using Catch::Matchers::Contains;
using namespace elgen;
using namespace elgen::test;

namespace {

std::string driver(const elgen::Program& program) {
  return elgen::make_drivers({sample::model(), sample::scene(), program}, BuildFlags::as_written)
      .front()
      .text;
}

std::string driver_text(const elgen::Model& model, const elgen::Scene& scene,
                        const elgen::Program& program = sample::program()) {
  return elgen::cpp_driver({model, scene, program});
}

elgen::Scene batch_scene() {
  elgen::Scene scene = sample::scene();
  scene.emission.has_batch_header = true;
  return scene;
}

/// Batches of the sample's functions. `distance`: the one between the numbers of a state, an
/// expression of `count` and `stride`.
elgen::EmittedFiles batch_files(const std::string& distance) {
  elgen::EmittedFiles files = sample::files(sample::header());
  files.files["sample/sample_batch.hpp"] = R"(#pragma once
#include <cmath>
#include "sample.hpp"
namespace sample::batch {
template <class T>
struct Pack {
  explicit Pack(T number) { native[0] = number; }
  T native[4] = {};
};
template <class T> Pack<T> sin(const Pack<T>& x) { return Pack<T>(std::sin(x.native[0])); }
template <class T> Pack<T> cos(const Pack<T>& x) { return Pack<T>(std::cos(x.native[0])); }
template <class T>
void inverse_dynamics(const Parameters<T>& p, std::size_t count, const T* q, const T* v,
                      const T* a, T* result, std::size_t = 0) {
  for (std::size_t i = 0; i < count; ++i) {
    result[i] = sample::inverse_dynamics<T>(p, {q[i]}, {v[i]}, {a[i]})[0];
  }
}
template <class T>
void forward_dynamics(const Parameters<T>& p, std::size_t count, const T* q, const T* v,
                      const T* u, T* result, std::size_t stride = 0) {
  (void)u;
  if (stride == 0) stride = count;
  for (std::size_t i = 0; i < count; ++i) {
    const auto values = sample::forward_dynamics<T>(p, {q[i]}, {v[i]}, {});
    result[i] = values.acceleration[0];
    result[)" + distance + R"( + i] = values.relative_pivots[0];
  }
}
}  // namespace sample::batch
)";
  return files;
}

std::vector<double> forward_dynamics(const std::string& distance) {
  const auto compiled =
      elgen::compile(batch_files(distance), sample::model(), batch_scene(), sample::program(), {});
  INFO(elgen::format(compiled.diagnostics));
  REQUIRE(compiled);
  REQUIRE(compiled->size() == 2);
  CHECK(compiled->back().types == "batch");
  CHECK(compiled->back().is_in_packs);
  const elgen::Arguments<double> arguments{.parameters = {2, 3, 5}, .q = {7}, .v = {11}, .a = {13}};
  return compiled->back().functions->call("forward_dynamics", arguments);
}

std::string driver(const Scene& scene, const std::vector<TimedVariant>& variants,
                   std::size_t function = 0) {
  Program program = sample::program();
  program.functions.erase(program.functions.begin(),
                          program.functions.begin() + static_cast<std::ptrdiff_t>(function));
  return timing_driver({sample::model(), scene, program}, variants).text;
}

}  // namespace

TEST_CASE("every emitted header has a driver in its language") {
  elgen::Scene scene = sample::scene();
  const auto names = [&scene](BuildFlags build) {
    std::string text;
    for (const elgen::Driver& driver :
         elgen::make_drivers({sample::model(), scene, sample::program()}, build)) {
      text += driver.name + "[" + driver.types + "] ";
    }
    return text;
  };
  CHECK(names(BuildFlags::as_written) == "cpp[] ");
  scene.emission.has_eigen_header = true;
  CHECK(names(BuildFlags::as_written) == "cpp[] eigen[Eigen] ");
  scene.emission.has_batch_header = true;
  CHECK(names(BuildFlags::as_written) == "cpp[] eigen[Eigen] batch[batch] ");
  CHECK(names(BuildFlags::native) == names(BuildFlags::as_written));
  CHECK(names(BuildFlags::user_flags) == "cpp[] batch[batch] ");
  scene.emission.has_eigen_header = false;
  scene.numerics.inner = elgen::InnerScalar::single_precision;
  CHECK(names(BuildFlags::user_flags) == "cpp[] batch[batch] wide[wide] wide_batch[wide, batch] ");
  scene.emission = {};
  scene.numerics.inner = elgen::InnerScalar::same;
  scene.emission.language = elgen::LanguageId::c99;
  scene.numerics.scalars = {elgen::ScalarKind::double_precision};
  CHECK(names(BuildFlags::as_written) == "c99[] ");
}

TEST_CASE("a build is a single source file, in which Eigen may be missing") {
  elgen::Scene scene = batch_scene();
  scene.emission.has_eigen_header = true;
  const Program program = sample::program();
  const auto units =
      make_driver_units({sample::model(), scene, program}, BuildFlags::native, "// more\n");
  REQUIRE(units.size() == 1);
  CHECK(units.front().drivers.size() == 3);
  const SourceFile& source = units.front().source;
  CHECK(source.file == "driver_1_1.cpp");
  CHECK(source.required_header == "Eigen/Core");
  CHECK_THAT(source.text, Contains("#if __has_include(<Eigen/Core>)\n#include \"sample/sample_"));
  CHECK_THAT(source.text, Contains("elgen_driver_cpp_double_0"));
  CHECK_THAT(source.text, Contains("elgen_driver_eigen_double_1"));
  CHECK_THAT(source.text, Contains("elgen_driver_batch_double_1"));
  CHECK_THAT(source.text, Catch::Matchers::EndsWith("// more\n"));
}

TEST_CASE("for a long program every header is compiled separately, the sines with the first") {
  Program program = sample::program();
  program.functions[1].instructions.resize(5000, program.functions[0].instructions.front());
  const auto units_in = [&program](BuildFlags build) {
    return make_driver_units({sample::model(), batch_scene(), program}, build, "// more\n");
  };
  const auto units = units_in(BuildFlags::as_written);
  REQUIRE(units.size() == 2);
  CHECK(units.back().source.file == "driver_0_2.cpp");
  CHECK_THAT(units.front().source.text, Contains("// more"));
  CHECK_THAT(units.back().source.text, !Contains("// more"));
  CHECK(units_in(BuildFlags::user_flags).size() == 1);
}

TEST_CASE("in the build with users' flags, batches have only their sines and cosines") {
  const Program program = sample::program();
  const auto units =
      make_driver_units({sample::model(), batch_scene(), program}, BuildFlags::user_flags, "");
  REQUIRE(units.size() == 1);
  const std::string& text = units.front().source.text;
  CHECK_THAT(text, Contains("elgen_driver_batch_double_2"));
  CHECK_THAT(text, !Contains("elgen_driver_batch_double_1"));
  CHECK_THAT(text, Contains("elgen_driver_cpp_double_1"));
}

TEST_CASE("parameters are assigned to the members of the emitted struct") {
  const std::string text = driver(sample::program());
  CHECK_THAT(text, Contains("result.m = values[0];"));
  CHECK_THAT(text, Contains("result.l[0] = values[1];"));
  CHECK_THAT(text, Contains("result.l[1] = values[2];"));
}

TEST_CASE("parameters that no function reads are not assigned") {
  elgen::Program program = sample::program();
  program.functions.front().instructions.erase(program.functions.front().instructions.begin());
  const std::string text = driver(program);
  CHECK_THAT(text, !Contains("result.m"));
  CHECK_THAT(text, Contains("result.l[0] = values[1];"));
}

TEST_CASE("each function gets the arguments of its row, and t last if t occurs") {
  elgen::Model model = sample::model();
  CHECK_THAT(driver_text(model, sample::scene()), !Contains(", t)"));
  model.uses_time = true;
  const std::string text = driver_text(model, sample::scene());
  CHECK_THAT(text, Contains("1>(a), t)"));
  CHECK_THAT(text, Contains("0>(u), t)"));
}

TEST_CASE("the mass matrix takes v if L is not quadratic") {
  elgen::Model model = sample::model();
  elgen::Program program = sample::program();
  program.functions = {
      {.kind = elgen::OutputKind::mass_matrix, .name = "M", .fields = {{.entries = {0}}}}};
  CHECK_THAT(driver_text(model, sample::scene(), program), !Contains(">(v)"));
  model.is_quadratic = false;
  CHECK_THAT(driver_text(model, sample::scene(), program), Contains(">(v)"));
}

TEST_CASE("a chosen namespace is used, and the file keeps its name") {
  elgen::Scene scene = sample::scene();
  scene.emission.name_space = "plant";
  const std::string text = driver_text(sample::model(), scene);
  CHECK_THAT(text, Contains("#include \"sample/sample.hpp\""));
  CHECK_THAT(text, Contains("namespace emitted = ::plant;"));
}

TEST_CASE("results of more than 4096 entries are passed by reference") {
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

TEST_CASE("column-major results are returned row by row") {
  elgen::Scene scene = sample::scene();
  scene.emission.storage = elgen::Storage::column_major;
  CHECK_THAT(driver_text(sample::model(), scene), Contains("stored[j * rows + i]"));
}

TEST_CASE("the driver of the Eigen header passes vectors and returns matrices") {
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

TEST_CASE("a C driver calls prefixed functions, only for the scene's scalar") {
  elgen::Scene scene = sample::scene();
  scene.emission.language = elgen::LanguageId::c99;
  scene.numerics.scalars = {elgen::ScalarKind::single_precision};
  const std::string text = elgen::c99_driver({sample::model(), scene, sample::program()});
  CHECK_THAT(text, Contains("#include \"sample/sample.h\""));
  CHECK_THAT(text, Contains("sample_inverse_dynamics(&p, q, v, a, result);"));
  CHECK_THAT(text, Contains("sample_forward_dynamics(&p, q, v, u, &result);"));
  CHECK_THAT(text, Contains("elgen_driver_c99_float_0"));
  CHECK_THAT(text, !Contains("elgen_driver_c99_double_0"));
}

TEST_CASE("a batch gives the results of single states, at every position") {
  CHECK(forward_dynamics("stride") == std::vector<double>{32, 2});
}

TEST_CASE("a stride that is not the given one gives a different result") {
  CHECK(forward_dynamics("(stride - 1)") != std::vector<double>{32, 2});
  CHECK(forward_dynamics("count") != std::vector<double>{32, 2});
}

TEST_CASE("packs with accelerations in float have a batch of as many states, in double alone") {
  elgen::Scene scene = batch_scene();
  scene.numerics.scalars = {elgen::ScalarKind::double_precision};
  const std::string text = elgen::wide_batch_driver({sample::model(), scene, sample::program()});
  CHECK_THAT(text,
             Contains("states = 5 * sizeof(emitted::batch::Pack<float>) / sizeof(float) / 2;"));
  CHECK_THAT(text, Contains("emitted::batch::wide::forward_dynamics<Scalar>(p, states<Scalar>"));
  CHECK_THAT(text, Contains("elgen_driver_wide_batch_double_0"));
  CHECK_THAT(text, !Contains("elgen_driver_wide_batch_double_2"));
}

TEST_CASE("functions without a batch have no driver") {
  elgen::Program program = sample::program();
  program.functions[0].fields[0].entries.assign(4097, 0);
  const std::string text = elgen::batch_driver({sample::model(), batch_scene(), program});
  CHECK_THAT(text, !Contains("elgen_driver_batch_double_0"));
  CHECK_THAT(text, Contains("elgen_driver_batch_double_1"));
}

TEST_CASE("without packs, a state is gathered from all arrays and its fields are scattered") {
  const std::string text = driver(sample::scene(), {{ScalarKind::single_precision, false}}, 1);
  CHECK_THAT(text, Contains("#include \"sample/sample.hpp\""));
  CHECK_THAT(text, Contains("gathered<emitted::Coordinates<Scalar>>(q, i, count)"));
  CHECK_THAT(text, Contains("scatter(values.acceleration, i, count, result + 0 * count);"));
  CHECK_THAT(text, Contains("scatter(values.relative_pivots, i, count, result + 1 * count);"));
  CHECK_THAT(text, Contains("void elgen_timed_0(std::size_t count, const float* parameters"));
  CHECK_THAT(text, !Contains("batch"));
}

TEST_CASE("with packs, the batch header gathers and scatters") {
  Scene scene = sample::scene();
  scene.emission.has_batch_header = true;
  const std::string text = driver(scene, {{}, {ScalarKind::double_precision, true}});
  CHECK_THAT(text, Contains("#include \"sample/sample_batch.hpp\""));
  CHECK_THAT(text,
             Contains("emitted::batch::inverse_dynamics<Scalar>(model_parameters<Scalar>(), count, "
                      "q, v, a, result);"));
  CHECK_THAT(
      text,
      Contains("in_packs<double>(count, parameters, f, q, v, momenta, reference, a, multipliers, "
               "u, t, h, E, result);"));
}

TEST_CASE("a step is called in loops, with the time if the model depends on it") {
  Program program{sample::program().leaves};
  program.functions.push_back({.kind = OutputKind::step, .name = "advance"});
  Model model = sample::model();
  const std::string text = step_driver({model, batch_scene(), program}).text;
  CHECK_THAT(text, Contains("#include \"sample/sample_batch.hpp\""));
  CHECK_THAT(text, Contains("emitted::advance<double>(p, q, v, u, h);"));
  CHECK_THAT(text, Contains("emitted::batch::advance<double>(model_parameters<double>(), count, "
                            "q, v, u, h, to);"));
  CHECK_THAT(text, !Contains("double& time"));
  model.uses_time = true;
  const std::string timed = step_driver({model, batch_scene(), program}).text;
  CHECK_THAT(timed, Contains("emitted::advance<double>(p, q, v, u, t, h);"));
  CHECK_THAT(timed, Contains("for (double& time : times) time = start"));
  Scene mixed = batch_scene();
  mixed.numerics.inner = InnerScalar::single_precision;
  const std::string in_float = step_driver({model, mixed, program}).text;
  CHECK_THAT(in_float, Contains("emitted::wide::advance<double>(p, q, v, u, t, h);"));
  CHECK_THAT(in_float,
             Contains("emitted::batch::wide::advance<double>(model_parameters<double>()"));
}

TEST_CASE("in a call for each state its numbers are adjacent") {
  Scene scene = sample::scene();
  scene.emission.has_batch_header = true;
  const std::string text = driver(scene, {{ScalarKind::single_precision, true, true}});
  CHECK_THAT(text, Contains("emitted::batch::inverse_dynamics<Scalar>(p,\n        1,\n        "
                            "gathered<emitted::Coordinates<Scalar>>(q, i, count).data(),"));
  CHECK_THAT(text,
             Contains("one_per_call<float>(count, parameters, f, q, v, momenta, reference, a, "
                      "multipliers, u, t, h, E, result);"));
}
