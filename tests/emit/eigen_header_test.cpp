// eigen_header: functions on vectors and matrices; tests/pipeline/languages_test.cpp compiles them.
#include "emit/cpp/cpp_artifacts.hpp"
#include "fixture.hpp"
#include "support/shell.hpp"

using namespace elgen;
using elgen::test::mentions;
using elgen::testing::cart_pole;
using elgen::testing::Subject;

namespace {

std::string eigen_text(const Subject& subject) {
  return eigen_header(emission_input(subject.model, subject.scene, subject.program));
}

}  // namespace

TEST_CASE("functions, structs and the test of the pivots") {
  const std::string text = eigen_text(cart_pole());
  CHECK(mentions(text, "[[nodiscard]] Matrix<Scalar, 2, 2> mass_matrix("));
  CHECK(mentions(text, "  Vector<Scalar, 2> acceleration;"));
  CHECK(mentions(text, "  return (pivots.array() > tolerance).all();\n"));
  CHECK(mentions(text, "Eigen::RowMajor>;"));
}

TEST_CASE("storage decides the order of Eigen's matrices") {
  Subject subject = cart_pole();
  subject.scene.emission.storage = Storage::column_major;
  CHECK(mentions(eigen_text(subject), ": Eigen::ColMajor>;"));
}

TEST_CASE("names of this header are E701") {
  Subject subject = cart_pole();
  CHECK(eigen_check_names(subject.model, subject.scene, subject.program).empty());
  subject.program.functions[0].name = "eigen";
  subject.program.functions[4].name = "matrix";
  CHECK(eigen_check_names(subject.model, subject.scene, subject.program).size() == 2);
}
