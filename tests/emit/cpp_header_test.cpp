// cpp_header: the sections of a header, which the golden header shows completely. Headers for Eigen
// are compiled by tests/pipeline/languages_test.cpp.
#include "emit/text/emission_input.hpp"
#include "fixture.hpp"
#include "support/shell.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

std::string cpp_text(const Subject& subject) {
  return cpp_header(
      emission_input(subject.model, subject.scene, subject.program, {subject.program}));
}

std::string eigen_text(const Subject& subject) {
  return eigen_header(
      emission_input(subject.model, subject.scene, subject.program, {subject.program}));
}

}  // namespace

TEST_CASE("helpers are emitted only if used") {
  Subject subject = cart_pole();
  const std::string with_pivots = cpp_text(subject);
  CHECK(mentions(with_pivots, "bool is_regular("));
  CHECK(mentions(with_pivots, "Scalar digits_left("));
  CHECK_FALSE(mentions(with_pivots, "row of A"));
  CHECK(mentions(with_pivots, "Scalar number_1_3()"));
  CHECK_FALSE(mentions(with_pivots, "sign_of"));
  CHECK_FALSE(mentions(with_pivots, "filled"));
  subject.program = read_program(
      "coordinates x theta\nfunction applied_force\n  0 = velocity x\n  1 = sign 0\n"
      "  result 2 1 = 1 1\n");
  const std::string with_kinks = cpp_text(subject);
  CHECK(mentions(with_kinks, "Scalar sign_of(const Scalar& x)"));
  CHECK_FALSE(mentions(with_kinks, "is_regular"));
  CHECK_FALSE(mentions(with_kinks, "digits_left"));
  CHECK_FALSE(mentions(with_kinks, "number_"));
}

TEST_CASE("the contents list the sections of the header in their order") {
  Subject subject = cart_pole();
  const std::string text = cpp_text(subject);
  CHECK(mentions(
      text,
      "//   constant                 numbers in any Scalar\n"
      "//   namespace detail         sines and cosines\n"
      "//   number_...               constants of the equations\n"
      "//   Parameters               with the values of the model file\n"
      "//   functions                in the order of the table below\n"
      "//   is_regular, digits_left  tests of the pivots of forward_dynamics\n//\n//   function "));
  const std::size_t contents = text.find("// Contents");
  std::size_t before = text.find("\n#define ELGEN_FUNCTION");
  CHECK(contents < before);
  for (const char* const section :
       {"coordinate_count =", "using Coordinates =", "namespace detail {",
        " constant(double value)", "struct SineCosine", "Scalar number_1_3()", "struct Parameters",
        " mass_matrix(", " is_regular(", " digits_left("}) {
    INFO(section);
    const std::size_t at = text.find(section, before);
    CHECK(at != std::string::npos);
    before = at;
  }
  subject.program = read_program(
      "coordinates x theta\nfunction applied_force\n  0 = velocity x\n  1 = sign 0\n"
      "  result 2 1 = 1 1\n");
  CHECK(mentions(cpp_text(subject),
                 "//   constant                 numbers in any Scalar\n"
                 "//   namespace detail         functions that compare the numbers of packs\n"
                 "//   namespace detail         sign, min and max\n"
                 "//   Parameters               with the values of the model file\n"
                 "//   functions                in the order of the table below\n//\n"));
}

TEST_CASE("sine and cosine are in line for float and double, in any order of scalars") {
  Subject subject = cart_pole();
  subject.program = read_program(
      "coordinates x theta\nfunction gravity\n  0 = coordinate theta\n  1 = sin 0\n  2 = cos 0\n"
      "  result 2 1 = 1 2\n");
  const std::string named = cpp_text(subject);
  CHECK(mentions(named, "struct SineCosine<double> : SineCosineInLine<double> {};"));
  CHECK(
      mentions(named, "struct LibrarySineCosine<double> {\n  [[nodiscard]] ELGEN_FUNCTION static"));
  CHECK(mentions(named, "::sincos(angle, &sine, &cosine);"));
  CHECK(mentions(named, "  static constexpr double part_3 = "));
  CHECK(mentions(named, "struct SineCosine<float> : SineCosineInLine<float> {};"));
  CHECK_FALSE(mentions(named, "LibrarySineCosine<float>"));
  CHECK_FALSE(mentions(named, "<long double>"));
  subject.scene.numerics.scalars = {ScalarKind::single_precision, ScalarKind::long_double};
  const std::string others = cpp_text(subject);
  CHECK(mentions(others, "::sincosf(angle, &sine, &cosine);"));
  // Devices do not have long double.
  CHECK(mentions(others, "struct LibrarySineCosine<long double> {\n  [[nodiscard]] static"));
  CHECK(mentions(others, "struct SineCosine<float> : SineCosineInLine<float> {};"));
  CHECK_FALSE(mentions(others, "SineCosineInLine<long double>"));
  CHECK_FALSE(mentions(others, "LibrarySineCosine<double>"));
  CHECK(mentions(others, "struct SineCosine<double> : SineCosineInLine<double> {};"));
  subject.scene.numerics.scalars = {ScalarKind::double_precision};
  subject.scene.numerics.has_library_sines = true;
  CHECK_FALSE(mentions(cpp_text(subject), "Trigonometry"));
  subject.scene.emission.has_batch_header = true;  // packs cannot call the library
  CHECK(mentions(cpp_text(subject), "Trigonometry<double>"));
  CHECK_FALSE(mentions(cpp_text(subject), "SineCosineInLine"));
}

TEST_CASE("headers of functions with several angles compute these together") {
  Subject subject = cart_pole();
  CHECK_FALSE(mentions(cpp_text(subject), "Angles"));
  subject.program = read_program(
      "coordinates x theta\nfunction gravity\n  0 = coordinate x\n  1 = coordinate theta\n"
      "  2 = sin 0\n  3 = cos 1\n  result 2 1 = 2 3\n");
  const std::string text = cpp_text(subject);
  CHECK(mentions(text, "class Angles<float, Count> : public AnglesInVectors<float, Count> {"));
  CHECK(mentions(text, "class Angles<double, Count> : public AnglesInVectors<double, Count> {"));
  CHECK_FALSE(mentions(text, "\n\n\n"));
  subject.scene.numerics.has_library_sines = true;
  CHECK(mentions(cpp_text(subject), "\nsines_of(const Numbers&... angles) {\n"));
  CHECK_FALSE(mentions(cpp_text(subject), "AnglesInVectors"));
}

TEST_CASE("a constant is emitted as one function, however often it occurs") {
  Subject subject = cart_pole();
  load_constant(subject, rational_constant(cln::cl_RA(1) / 3));
  load_constant(subject, rational_constant(cln::cl_RA(1) / 3));
  const std::string text = cpp_text(subject);
  const std::string name = "number_1_3() noexcept";
  CHECK(text.find(name) == text.rfind(name));
}

TEST_CASE("no line is longer than 100 columns, none ends with a space, no blank line is doubled") {
  const std::string text = cpp_text(cart_pole());
  for (const std::string& line : split_lines(text)) {
    INFO(line);
    CHECK(line.size() <= 100);
    CHECK((line.empty() || line.back() != ' '));
  }
  CHECK_FALSE(mentions(text, "\n\n\n"));
}

TEST_CASE("names, units and bounds are declared, with empty arrays if there are no inputs") {
  Subject subject = cart_pole();
  subject.model.velocities[1].rate_range = Interval{0, power_of_ten(400)};
  const std::string text = cpp_text(subject);
  for (const char* const declared :
       {"coordinate_names{{\"x\", \"theta\"}};", "coordinate_units{{\"m\", \"rad\"}};",
        "coordinate_ranges{{{-2.0, 2.0}, {-unbounded, unbounded}}};", "{0.0, unbounded}",
        "input_limits{{{-20.0, 20.0}}};"}) {
    INFO(declared);
    CHECK(mentions(text, declared));
  }
  subject.program = read_program(
      "coordinates x theta\nfunction gravity\n  0 = coordinate x\n  result 2 1 = 0 0\n");
  subject.model.inputs.clear();
  CHECK(mentions(cpp_text(subject), "input_names{};"));
  CHECK(mentions(cpp_text(subject), "input_limits{};"));
}

TEST_CASE("parameters have defaults and documentation, and arrays of equal values are filled") {
  Subject subject = cart_pole();
  subject.model.parameter_arrays[0].range = Interval{0, 10};
  add_parameter_array(subject.model, "k", {1, 2});
  read_parameter(subject, "k[1]");
  const std::string text = cpp_text(subject);
  CHECK(mentions(text, "  Scalar M = constant<Scalar>(1.0);"));
  CHECK(mentions(text, "///< cart mass [kg] in [0, 10]\n"));
  CHECK(mentions(text, "///< [m/s^2]\n"));
  CHECK(mentions(text, "  std::array<Scalar, 2> k = {{\n"));
  CHECK_FALSE(mentions(text, "filled"));
  add_parameter_array(subject.model, "c", {3, 3, 3});
  read_parameter(subject, "c[1]");
  CHECK(mentions(cpp_text(subject),
                 "std::array<Scalar, 3> c = detail::filled<3>(constant<Scalar>(3.0));"));
}

TEST_CASE("Eigen: functions, structs and is_regular") {
  const std::string text = eigen_text(cart_pole());
  CHECK(mentions(text, "[[nodiscard]] Matrix<Scalar, 2, 2> mass_matrix("));
  CHECK(mentions(text, "  Vector<Scalar, 2> acceleration;"));
  CHECK(mentions(text, "  return (pivots.array() > tolerance).all();\n"));
  CHECK(mentions(text, "Eigen::RowMajor>;"));
}

TEST_CASE("Eigen: storage sets the order of Eigen's matrices") {
  Subject subject = cart_pole();
  subject.scene.emission.storage = Storage::column_major;
  CHECK(mentions(eigen_text(subject), ": Eigen::ColMajor>;"));
}

TEST_CASE("Eigen: names of the header are E701") {
  Subject subject = cart_pole();
  CHECK(eigen_check_names(subject.model, subject.scene, subject.program).empty());
  subject.program.functions[0].name = "eigen";
  subject.program.functions[4].name = "matrix";
  CHECK(eigen_check_names(subject.model, subject.scene, subject.program).size() == 2);
}
