// Tests the text of batch_header. packs_test.cpp compiles and runs such headers.
#include "emit/text/emission_input.hpp"
#include "fixture.hpp"
#include "support/shell.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

std::string batch_text(const Subject& subject) {
  return batch_header(
      emission_input(subject.model, subject.scene, subject.program, {subject.program}));
}

}  // namespace

TEST_CASE("a function loads its arguments and stores its fields in order") {
  const std::string text = batch_text(cart_pole());
  CHECK(mentions(text,
                 "void forward_dynamics(const Parameters<T>& p, std::size_t count, const T* q, "
                 "const T* v, const T* u,\n"
                 "                      T* result, std::size_t stride = 0) {\n"
                 "  using Scalar = Pack<T>;\n"
                 "  const auto constants = detail::repeated<Scalar>(p);\n"
                 "  detail::for_each_pack<Scalar>(count, stride, [&](const auto& at) {\n"
                 "    const auto values = ::cart_pole::forward_dynamics<Scalar>(\n"
                 "        constants,\n"
                 "        detail::loaded<Coordinates<Scalar>>(q, at),\n"
                 "        detail::loaded<Velocities<Scalar>>(v, at),\n"
                 "        detail::loaded<Inputs<Scalar>>(u, at));\n"
                 "    detail::store(values.acceleration, at, result);\n"
                 "    detail::store(values.relative_pivots, at, result + 2 * at.stride);\n"
                 "  });\n"));
  CHECK(mentions(text,
                 "__global__ void forward_dynamics(Parameters<T> constants, std::size_t count, "
                 "const T* q, const T* v,\n"
                 "                                 const T* u, T* result, std::size_t stride = 0) "
                 "{\n"
                 "  using Scalar = T;\n"));
  CHECK(mentions(text,
                 "    const detail::Place at{state, stride == 0 ? count : stride};\n"
                 "    const auto values = ::cart_pole::forward_dynamics<Scalar>(\n"));
  CHECK(text.find("namespace cart_pole::kernel {") < text.find("gnu::vector_size"));
  CHECK(text.find("#error") > text.find("#else"));
  CHECK(mentions(text, "  result.l = p.l;\n"));
  CHECK(mentions(text, "Pack<T, N> sqrt("));
  CHECK_FALSE(mentions(text, "Pack<T, N> exp("));
  CHECK_FALSE(mentions(text, "atan2"));
}

TEST_CASE("the scalars have polynomials of the requested accuracy") {
  Subject subject = cart_pole();
  CHECK(mentions(batch_text(subject), "using Table = ::cart_pole::detail::Trigonometry<T>;"));
  subject.scene.numerics.scalars = {ScalarKind::single_precision};
  subject.scene.numerics.trigonometry_error = cln::cl_RA(1) / 1000;
  const std::string text = batch_text(subject);
  CHECK(mentions(text, "  static constexpr float domain = 1000.0F;\n"));
  CHECK(mentions(text, "  static constexpr float cosine_4 = 0.040"));
  CHECK(mentions(text, "using Table = Trigonometry<T>;"));
  CHECK_FALSE(mentions(text, "Trigonometry<double>"));
  CHECK(mentions(text, "off by at most 0.001 for angles up to 1000;"));
}

TEST_CASE("a function that compares numbers takes packs, whose numbers it compares") {
  Subject subject = cart_pole();
  subject.program = read_program(
      "coordinates x theta\nfunction gravity\n  0 = coordinate x\n  1 = sign 0\n  2 = exp 0\n"
      "  3 = atan2 0 2\n  result 2 1 = 1 3\n");
  const std::string text = batch_text(subject);
  CHECK(mentions(text, "  using Scalar = Pack<T>;\n"));
  CHECK(mentions(text, "  T operator[](std::size_t i) const noexcept { return native[i]; }\n"));
  CHECK_FALSE(mentions(batch_text(cart_pole()), "operator[]"));
  CHECK(mentions(text, "Pack<T, N> exp("));
  CHECK(mentions(text, "Pack<T, N> atan2("));
}

TEST_CASE("names of the header of batches are E701") {
  Subject subject = cart_pole();
  CHECK(batch_check_names(subject.model, subject.scene, subject.program).empty());
  subject.program.functions[0].name = "batch";
  subject.program.functions[4].name = "pack";
  subject.program.functions[2].name = "kernel";
  CHECK(batch_check_names(subject.model, subject.scene, subject.program).size() == 3);
}
