// What an emitter with a fault would write: verify sees every one of them.
#include <catch2/catch.hpp>
#include <regex>

#include "elgen/pipeline.hpp"
#include "elgen/toolchain.hpp"
#include "pipeline/pipeline_testing.hpp"

namespace elgen::test {
namespace {

/// One fault: the first match in the header is replaced.
struct Fault {
  const char* what;
  const char* pattern;
  const char* replacement;
};

const std::vector<Fault> faults{
    {"a sign", R"(sin_q1 \* sin_q2 - )", "sin_q1 * sin_q2 + "},
    {"the sign of an entry", R"(\{-t_)", "{t_"},
    {"the 16th digit of a number", R"(9\.81, )", "9.810000000000002, "},
    {"the index of a coordinate", R"(of\(q\[1\]\))", "of(q[0])"},
    {"the index of a rate", R"(\* v\[1\])", "* v[0]"},
    {"a term", R"(p\.m1 \* p\.c1 \+ )", ""},
    {"a factor", R"(p\.m2 \* p\.c2;)", "p.m2;"},
    {"a function", R"(\[sin_q1, cos_q1\])", "[cos_q1, sin_q1]"},
};

std::string with_fault(const std::string& header, const Fault& fault) {
  const std::string changed =
      std::regex_replace(header, std::regex(fault.pattern), fault.replacement,
                         std::regex_constants::format_first_only);
  CHECK(header != changed);
  return changed;
}

/// Whether the code compiles under strict flags, and verify finds nothing wrong with it.
bool passes(const Products& products, const EmittedFiles& files) {
  const auto& [model, scene] = *products.checked;
  const auto compiled = compile(files, model, scene, *products.program, {});
  if (!compiled) return false;
  VerifyOptions options;
  options.samples = 4;
  return holds(verify(model, scene, *products.program, *compiled, options).certificate);
}

}  // namespace

TEST_CASE("verify catches a sign, a digit, an index and a term of the emitted code") {
  Inputs inputs{make_source("model.toml", model_file("two_link_arm"))};
  inputs.scene =
      make_source("given.scene.toml",
                  "format = 1\nmodel = \"model.toml\"\nname = \"given\"\n[outputs]\ngravity = "
                  "true\nbias = true\n"
                  "[parameters]\nfixed = { g = 9.81 }\n[numeric]\nscalar = [\"double\"]\n");
  const Products products = run_pipeline(inputs, {});
  REQUIRE(products.files);
  CHECK(passes(products, *products.files));
  for (const Fault& fault : faults) {
    EmittedFiles files = *products.files;
    for (auto& [path, text] : files.files) {
      if (path.ends_with(".hpp")) text = with_fault(text, fault);
    }
    INFO(fault.what);
    CHECK_FALSE(passes(products, files));
  }
}

}  // namespace elgen::test
