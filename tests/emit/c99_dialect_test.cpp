// Tests the text that c99_dialect writes: results, unused arguments, calls, literals and parts.
#include "emit/c99/c99_dialect.hpp"

#include "emit/code/definition.hpp"
#include "fixture.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

DefinitionText text_of(const Subject& subject, std::size_t function) {
  const auto dialect = c99_dialect(subject.model, subject.scene, subject.program);
  return function_definition(*dialect, subject.program, subject.program.functions[function],
                             Storage::row_major)
      .whole;
}

}  // namespace

TEST_CASE("an array is written to result, and unused arguments are marked") {
  const DefinitionText gravity = text_of(cart_pole_in_c(), 1);
  CHECK(gravity.signature ==
        "static inline void cart_pole_gravity(const cart_pole_parameters *p, const double q[2],\n"
        "                                     double result[2])");
  CHECK(gravity.body ==
        "  const double sin_theta = cart_pole_sine_of(q[1]);\n"
        "  result[0] = 0.0;\n"
        "  result[1] = -p->g * p->l * p->m * sin_theta;\n");
  CHECK(text_of(cart_pole_in_c(), 3).body ==
        "  (void)p;\n  (void)q;\n  result[0] = 1.0;\n  result[1] = 0.0;\n");
}

TEST_CASE("a number is returned, a struct is filled") {
  CHECK(text_of(cart_pole_in_c(), 2).body == "  (void)q;\n  return 0.5 * p->M * (v[0] * v[0]);\n");
  const DefinitionText forward = text_of(cart_pole_in_c(), 4);
  CHECK(mentions(forward.signature, "cart_pole_forward_dynamics_result *result)"));
  CHECK(mentions(forward.body, "  result->acceleration[0] = u[0] / p->M;\n"));
}

TEST_CASE("float has its own functions and literals") {
  const Subject subject = cart_pole_in_c(ScalarKind::single_precision);
  CHECK(mentions(text_of(subject, 1).body, "const float sin_theta = cart_pole_sine_of(q[1]);"));
  const auto dialect = c99_dialect(subject.model, subject.scene, subject.program);
  CHECK(dialect->constant(rational_constant(cln::cl_RA(-1) / 3)).text == "-0.33333334f");
  CHECK(dialect->sine_cosine_statement("s", "c", {"x"}, true) ==
        "  float s, c;\n  cart_pole_sine_cosine(x, &s, &c);\n");
  CHECK(dialect->sine_cosine_statement("w->s", "w->c", {"x"}, false) ==
        "  cart_pole_sine_cosine(x, &w->s, &w->c);\n");
  CHECK(dialect->square_root({"x"}).text == "sqrtf(x)");
  CHECK(dialect->call(FunctionId::abs, {{"x"}}).text == "fabsf(x)");
  CHECK(dialect->call(FunctionId::min, {{"x"}, {"y"}}).text == "cart_pole_smaller(x, y)");
}

TEST_CASE("sine and cosine of the library are separate calls") {
  Subject subject = cart_pole_in_c();
  subject.scene.numerics.has_library_sines = true;
  CHECK(mentions(text_of(subject, 1).body, "const double sin_theta = sin(q[1]);"));
  CHECK_FALSE(c99_dialect(subject.model, subject.scene, subject.program)->has_sine_cosine_calls());
}

TEST_CASE("temporaries hide no other names, and shared temporaries of parts are members") {
  const Subject subject = cart_pole_in_c();
  const auto dialect = c99_dialect(subject.model, subject.scene, subject.program);
  CHECK(dialect->workspace_member("sin_theta") == "w->sin_theta");
  CHECK(dialect->call(FunctionId::abs, {{"x"}}).text == "fabs(x)");
  CHECK(dialect->temporary_name("sin_theta") == "sin_theta");
  for (const char* name : {"p", "result", "sinf", "cart_pole_bias"}) {
    CHECK(dialect->temporary_name(name) == std::string(name) + "_");
  }
}

TEST_CASE("a scalar function in parts returns its number through an array") {
  const Subject subject = cart_pole_in_c();
  const auto dialect = c99_dialect(subject.model, subject.scene, subject.program);
  CHECK(dialect->body_calling_parts(subject.program.functions[2], 2) ==
        "  double result[1];\n"
        "  cart_pole_kinetic_energy_workspace w;\n"
        "  cart_pole_kinetic_energy_part_1(p, q, v, &w, result);\n"
        "  cart_pole_kinetic_energy_part_2(p, q, v, &w, result);\n"
        "  return result[0];\n");
}
