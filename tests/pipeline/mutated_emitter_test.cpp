// Code as a faulty emitter would write it: verify detects every fault.
#include <catch2/catch.hpp>
#include <regex>

#include "elgen/toolchain.hpp"
#include "pipeline/pipeline_testing.hpp"

namespace elgen::test {
namespace {

/// A fault replaces the first match of `pattern` after the CUDA kernels, which are not compiled.
struct Fault {
  const char* what;
  const char* pattern;
  const char* replacement;
};

const std::vector<Fault> faults_of_batches{
    {"a stride", R"(result \+ 2 \* at\.stride)", "result + 1 * at.stride"},
    {"a stride that is given", R"(if \(stride == 0\) stride)", "stride"},
    {"the default stride", R"(stride == 0\) stride = count)", "stride == 0) stride = 1"},
    {"the stride of loads", R"(from \+ k \* at\.stride)", "from + k * at.first"},
    {"the stride of stores", R"(to \+ k \* at\.stride)", "to + k * at.first"},
    {"the last states", R"(if \(first < count\))", "if (first > count)"},
    {"the last digit of a coefficient", R"(0\.008152992341703497)", "0.008152992341703499"},
    {"a domain", R"(domain = 1e\+05)", "domain = 10"},
    {"a parameter", R"(result\.m = p\.m)", "result.m = p.M"},
    {"an argument", R"(<Velocities<Scalar>>\(v, at\))", "<Velocities<Scalar>>(q, at)"},
};

/// Faults in the code of a step, for C99 and for C++ with Eigen.
const std::vector<Fault> faults_of_steps{
    {"an entry", R"((result(?:->|\.)coordinates[\[(]1[\])] = ))", "$1-"},
    {"the length of a step", R"(\+ h \* )", "- h * "},
    {"an index", R"(= q\[1\] )", "= q[0] "},
};

const std::vector<Fault> faults_of_declarations{
    {"the value of a parameter", R"(Scalar M = constant<Scalar>\(1\.0\))",
     "Scalar M = constant<Scalar>(2.0)"},
    {"the order of parameters", R"((  Scalar M = .*\n)(  Scalar m = .*\n))", "$2$1"},
    {"a limit", R"(-20\.0, 20\.0)", "-20.0, 20.5"},
    {"the sign of a range", R"(-2\.0, 2\.0)", "2.0, 2.0"},
};

const std::vector<Fault> faults{
    {"a sign", R"(sin_q1 \* sin_q2 - )", "sin_q1 * sin_q2 + "},
    {"the sign of an entry", R"(\{-t_)", "{t_"},
    {"the 16th digit of a number", R"(9\.81, )", "9.810000000000002, "},
    {"the index of a coordinate", R"(\(q\[0\], q\[1\]\))", "(q[0], q[0])"},
    {"an angle of a group", R"(= angles\[1\])", "= angles[0]"},
    {"the index of a rate", R"(\* v\[1\])", "* v[0]"},
    {"a term", R"(p\.m1 \* p\.c1 \+ )", ""},
    {"a factor", R"(p\.m2 \* p\.c2;)", "p.m2;"},
    {"a function", R"(\[sin_q1, cos_q1\])", "[cos_q1, sin_q1]"},
};

const std::vector<Fault> faults_of_python{
    {"a sign", R"(sin_q1 \* sin_q2 - )", "sin_q1 * sin_q2 + "},
    {"the sign of an entry", R"(\[-t_)", "[t_"},
    {"the 16th digit of a number", R"(\[9\.81 \*)", "[9.810000000000002 *"},
    {"the index of a coordinate", R"(cos\(q_1\))", "cos(q_0)"},
    {"the index of a rate", R"(\* v_1)", "* v_0"},
    {"the order of unpacked entries", R"(\(v_0, v_1\) = v)", "(v_1, v_0) = v"},
    {"a term", R"(p\.m1 \* p\.c1 \+ )", ""},
    {"a parameter", R"(p\.c2)", "p.c1"},
    {"the value of a parameter", R"(m1: float = 1\.2)", "m1: float = 1.3"},
    {"the order of parameters", R"((    m1: .*\n)(    m2: .*\n))", "$2$1"},
    {"the order of fields", R"((    acceleration: .*\n)(    relative_pivots: .*\n))", "$2$1"},
    {"a limit", R"(-40\.0, 40\.0)", "-40.0, 40.5"},
    {"a name that is nowhere", R"(sin_q2 = sin)", "sin_q3 = sin"},
};

std::string with_fault(const std::string& header, const Fault& fault) {
  const std::size_t kernels = header.rfind("::kernel\n");
  const std::size_t start = kernels == std::string::npos ? 0 : kernels;
  const std::string changed =
      header.substr(0, start) + std::regex_replace(header.substr(start), std::regex(fault.pattern),
                                                   fault.replacement,
                                                   std::regex_constants::format_first_only);
  CHECK(header != changed);
  return changed;
}

/// True if the code compiles under strict flags and verify finds no fault.
bool passes(const Products& products, const EmittedFiles& files,
            const std::vector<BuildFlags>& builds = {BuildFlags::as_written}) {
  const auto& [model, scene] = *products.checked;
  const auto compiled = compile(files, model, scene, *products.program,
                                {.builds = builds, .reads_declared_numbers = true});
  if (!compiled) return false;
  VerifyOptions options;
  options.samples = 4;
  return holds(verify(model, scene, *products.program, *compiled, options).certificate);
}

/// The files, with `fault` in each file whose name ends in `ending`.
EmittedFiles files_with(const Products& products, const std::string& ending, const Fault& fault) {
  EmittedFiles files = *products.files;
  for (auto& [path, text] : files.files) {
    if (path.ends_with(ending)) text = with_fault(text, fault);
  }
  return files;
}

Products products_in_packs() {
  return run_pipeline(inputs_of(model_file("cart_pole"),
                                "[outputs]\nforward_dynamics = true\n[emit]\nbatch = true\n"
                                "[numeric]\ntrigonometry = { max_error = 1e-6 }\n"),
                      {});
}

/// Checks that the code passes without faults, and fails with each fault in files with `ending`.
void expect_all_caught(const Products& products, const std::string& ending,
                       const std::vector<Fault>& list) {
  REQUIRE(products.files);
  CHECK(passes(products, *products.files));
  for (const Fault& fault : list) {
    INFO(fault.what);
    CHECK_FALSE(passes(products, files_with(products, ending, fault)));
  }
}

}  // namespace

TEST_CASE("verify catches a sign, a digit, an index and a term of the emitted code") {
  const PipelineSources inputs =
      inputs_of(model_file("two_link_arm"),
                "[outputs]\ngravity = true\nbias = true\n"
                "[parameters]\nfixed = { g = 9.81 }\n[numeric]\nscalar = [\"double\"]\n");
  expect_all_caught(run_pipeline(inputs, {}), ".hpp", faults);
}

TEST_CASE("verify catches a sign, a digit, an order and a default of a Python module") {
  const PipelineSources inputs =
      inputs_of(model_file("two_link_arm"),
                "[outputs]\ngravity = true\nbias = true\nforward_dynamics = true\n"
                "[parameters]\nfixed = { g = 9.81 }\n[emit]\nlanguage = \"python\"\n");
  expect_all_caught(run_pipeline(inputs, {}), ".py", faults_of_python);
}

TEST_CASE("verify catches a stride, a digit, a domain and an argument of a batch") {
  expect_all_caught(products_in_packs(), "_batch.hpp", faults_of_batches);
}

TEST_CASE("verify catches an entry, a step length and an index of a step in C and with Eigen") {
  const auto stepped = [](const std::string& emission) {
    return run_pipeline(inputs_of(model_file("two_body_plane"),
                                  "[outputs]\nstep = { method = \"verlet\" }\n[emit]\n" + emission),
                        {});
  };
  expect_all_caught(stepped("language = \"c99\"\n"), ".h", faults_of_steps);
  expect_all_caught(stepped("eigen = true\n"), "_eigen.hpp", faults_of_steps);
}

TEST_CASE("verify catches faults in packs as wide as this machine's registers") {
  const Products products = products_in_packs();
  REQUIRE(products.files);
  const std::vector<BuildFlags> builds{BuildFlags::as_written, BuildFlags::native,
                                       BuildFlags::user_flags};
  CHECK(passes(products, *products.files, builds));
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx") == 0) return;
  // Portable code uses registers of 16 bytes only, so it does not show this fault.
  const EmittedFiles files = files_with(
      products, "_batch.hpp",
      {"a sign", R"(\(quadrant & 2\) << 62)", "(quadrant & 2) << (sizeof(Native) > 16 ? 61 : 62)"});
  CHECK(passes(products, files));
  CHECK_FALSE(passes(products, files, builds));
#endif
}

TEST_CASE("verify catches a wrong value, limit and order that the header declares") {
  expect_all_caught(run_pipeline(inputs_of(model_file("cart_pole")), {}), "cart_pole.hpp",
                    faults_of_declarations);
}

}  // namespace elgen::test
