// Tests that a name of the emitted code is refused only if the name would collide.
#include "emit/cpp/cpp_names.hpp"
#include "emit/text/emission_input.hpp"
#include "fixture.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

Diagnostics name_diagnostics(const Subject& subject) {
  return cpp_check_names(subject.model, subject.scene, subject.program);
}

}  // namespace

TEST_CASE("a usual model has no colliding names") { CHECK(name_diagnostics(cart_pole()).empty()); }

TEST_CASE("members of Parameters may not hide names that their defaults use") {
  for (const char* name : {"Scalar", "Parameters", "constant", "detail", "std"}) {
    Subject subject = cart_pole();
    subject.model.parameter_arrays[2].name = name;
    INFO(name);
    CHECK(name_diagnostics(subject).size() == 1);
    subject.program.functions.clear();  // unused parameters are no members
    CHECK(name_diagnostics(subject).empty());
  }
}

TEST_CASE("functions may not have another name of the header") {
  for (const char* name :
       {"constant", "coordinate_count", "is_regular", "digits_left", "number_pi", "std"}) {
    Subject subject = cart_pole();
    subject.program.functions[0].name = name;
    const Diagnostics diagnostics = name_diagnostics(subject);
    INFO(name);
    REQUIRE(diagnostics.size() == 1);
    CHECK(diagnostics[0].code == Code::E701);
    CHECK(mentions(diagnostics[0].message, name));
  }
}

TEST_CASE("structs may not have another name of the header") {
  Subject subject = cart_pole();
  subject.program.functions[4].name = "parameters";
  CHECK(name_diagnostics(subject).size() == 1);
  subject.program.functions[4].name = "dynamics_";
  CHECK(name_diagnostics(subject).size() == 1);
}

TEST_CASE("names declared by the C library cannot be namespaces") {
  const auto refused = [](const char* name) {
    Subject subject = cart_pole();
    subject.scene.emission.name_space = name;
    return name_diagnostics(subject).size();
  };
  for (const char* name :
       {"std",           "random",   "abs",    "system", "yn",       "roundf",
        "remainderl",    "clock_t",  "main",   "read",   "link",     "pipe",
        "time",          "signal",   "socket", "poll",   "index",    "environ",
        "clock_gettime", "sem_post", "tm",     "wcslen", "vfprintf", "localtime_r",
        "csinf",         "group"}) {
    INFO(name);
    CHECK(refused(name) == 1);
  }
  for (const char* name : {"cart_pole", "a", "pendulum", "surf", "f", "zzz", "linkf", "string",
                           "timer", "signals", "clock_pendulum", "island", "semaphore"}) {
    INFO(name);
    CHECK(refused(name) == 0);
  }
}

TEST_CASE("without parameters there is no struct and no argument for them") {
  Subject subject = cart_pole_in_c();
  subject.program = read_program(
      "coordinates x theta\nfunction gravity\n  0 = coordinate x\n  result 2 1 = 0 0\n");
  const std::string text =
      c99_header(emission_input(subject.model, subject.scene, subject.program, {subject.program}));
  CHECK_FALSE(mentions(text, "_parameters"));
  CHECK(mentions(text, "gravity(const double q[2], "));
}

TEST_CASE("names of the header and of other functions' helpers are E701") {
  for (const char* name : {"parameters", "is_regular", "digits_left", "forward_dynamics_result",
                           "gravity_part_2", "gravity_workspace"}) {
    Subject subject = cart_pole_in_c();
    subject.program.functions[0].name = name;
    INFO(name);
    CHECK(c99_check_names(subject.model, subject.scene, subject.program).size() == 1);
  }
  const Subject subject = cart_pole_in_c();
  CHECK(c99_check_names(subject.model, subject.scene, subject.program).empty());
}
