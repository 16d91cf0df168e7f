// Tests that a reserved function name is E701 at the position of the name in the scene, and that a
// parameter or constant beyond the range of a requested scalar is E702.
#include "emit/text/emission_checks.hpp"

#include "elgen/emitted_files.hpp"
#include "fixture.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

Diagnostics range_diagnostics(const Subject& subject) {
  return check_scalar_range(subject.model, subject.scene, subject.program);
}

}  // namespace

TEST_CASE("usual values fit everywhere") {
  Subject subject = cart_pole();
  subject.scene.numerics.scalars = {ScalarKind::single_precision, ScalarKind::double_precision,
                                    ScalarKind::long_double};
  CHECK(range_diagnostics(subject).empty());
}

TEST_CASE("a value must be in the range of the requested scalars") {
  Subject subject = cart_pole();
  add_parameter(subject.model, "tiny", power_of_ten(-50), "m");
  read_parameter(subject, "tiny");
  CHECK(range_diagnostics(subject).empty());
  subject.scene.numerics.scalars = {ScalarKind::single_precision};
  const Diagnostics diagnostics = range_diagnostics(subject);
  REQUIRE(diagnostics.size() == 1);
  CHECK(diagnostics[0].code == Code::E702);
  CHECK(diagnostics[0].message == "`1e-50`, the value of `tiny`, vanishes in float");
  CHECK(literals_fit(subject.model, subject.program, ScalarKind::double_precision));
  CHECK_FALSE(literals_fit(subject.model, subject.program, ScalarKind::single_precision));
}

TEST_CASE("overflow, subnormals, constants") {
  Subject subject = cart_pole();
  add_parameter(subject.model, "huge", -power_of_ten(309), "m");
  add_parameter(subject.model, "subnormal", power_of_ten(-310), "m");
  read_parameter(subject, "huge");
  read_parameter(subject, "subnormal");
  load_constant(subject, rational_constant(power_of_ten(400)));
  const Diagnostics diagnostics = range_diagnostics(subject);
  REQUIRE(diagnostics.size() == 3);
  CHECK(diagnostics[0].message == "`-1e309`, the value of `huge`, overflows in double");
  CHECK(diagnostics[1].message == "`1e-310`, the value of `subnormal`, vanishes in double");
  CHECK(diagnostics[2].message == "`1e400`, a constant of the equations, overflows in double");
}

TEST_CASE("unused parameters are not checked") {
  Subject subject = cart_pole();
  add_parameter(subject.model, "tiny", power_of_ten(-400), "m");
  CHECK(range_diagnostics(subject).empty());
}

TEST_CASE("a refused function name is reported at its position in the scene, if it has one") {
  Function function;
  function.name = "detail";
  Scene scene;
  CHECK(reserved_name_error(scene, function).span.source == nullptr);
  const SourcePointer source = make_source("a.scene.toml", "detail = true");
  OutputRequest request;
  request.name = "detail";
  request.span = {source.get(), 0, 6};
  scene.outputs.push_back(request);
  const Diagnostic found = reserved_name_error(scene, function);
  CHECK(found.code == Code::E701);
  CHECK(found.span.source == source.get());
  CHECK(found.message == "`detail` cannot name a function: the emitted code uses this name");
}
