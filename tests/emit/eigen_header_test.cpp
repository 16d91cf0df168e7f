// eigen_header: functions on vectors and matrices; tests/pipeline/languages_test.cpp compiles them.
#include "emit/cpp/cpp_artifacts.hpp"
#include "fixture.hpp"

using namespace elgen;
using elgen::testing::cart_pole;
using elgen::testing::Subject;

namespace {

std::string header_of(const Subject& subject) {
  return eigen_header(emission_input(subject.model, subject.scene, subject.program));
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("functions, structs and the test of the pivots") {
  const std::string text = header_of(cart_pole());
  CHECK(contains(text, "[[nodiscard]] Matrix<Scalar, 2, 2> mass_matrix("));
  CHECK(contains(text, "  Vector<Scalar, 2> acceleration;"));
  CHECK(contains(text, "  return (pivots.array() > tolerance).all();\n"));
  CHECK(contains(text, "Eigen::RowMajor>;"));
}

TEST_CASE("storage decides the order of Eigen's matrices") {
  Subject subject = cart_pole();
  subject.scene.emission.storage = Storage::column_major;
  CHECK(contains(header_of(subject), ": Eigen::ColMajor>;"));
}

TEST_CASE("names of this header are E701") {
  Subject subject = cart_pole();
  CHECK(eigen_check_names(subject.model, subject.scene, subject.program).empty());
  subject.program.functions[0].name = "eigen";
  subject.program.functions[4].name = "matrix";
  CHECK(eigen_check_names(subject.model, subject.scene, subject.program).size() == 2);
}
