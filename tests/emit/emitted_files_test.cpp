// Compares the emitted headers and the sidecar of a small model with golden files. Tests that
// neither the locale nor the folder changes a byte. ELGEN_UPDATE=1 rewrites the golden files.
#include "elgen/emitted_files.hpp"

#include <clocale>
#include <cstdlib>
#include <fstream>
#include <locale>
#include <map>

#include "elgen/artifacts.hpp"
#include "fixture.hpp"
#include "support/shell.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

EmittedFiles emitted(const Subject& subject) {
  const Result<EmittedFiles> files =
      emit(subject.model, subject.scene, subject.program, {subject.program});
  REQUIRE(files);
  return *files;
}

/// A locale with grouped digits and a decimal comma.
class CommaDecimal final : public std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

}  // namespace

TEST_CASE("headers and sidecar equal the golden files, in C++ and in C") {
  Subject wide = cart_pole();
  wide.scene.numerics.inner = InnerScalar::double_double;
  std::map<std::string, std::string> files = emitted(wide).files;
  const std::string in_c99 = "cart_pole/cart_pole.h";
  files[in_c99] = emitted(cart_pole_in_c()).files.at(in_c99);
  for (const auto& [path, text] : files) {
    const std::string name = path.substr(path.find('/') + 1);
    const std::string golden = std::string(ELGEN_SOURCE_DIR) + "/tests/emit/golden/" + name;
    if (std::getenv("ELGEN_UPDATE") != nullptr) std::ofstream(golden, std::ios::binary) << text;
    INFO(golden);
    CHECK(text == read_text(golden));
  }
}

TEST_CASE("the paths are known before the derivation") {
  const EmittedFiles files = emitted(cart_pole());
  const std::vector<Artifact> wanted = requested_artifacts(cart_pole().scene);
  CHECK(files.files.size() == wanted.size());
  for (const Artifact& artifact : wanted) CHECK(files.files.count(artifact.path) == 1);
}

TEST_CASE("a locale with a decimal comma changes no byte") {
  const EmittedFiles before = emitted(cart_pole());
  const std::locale previous = std::locale::global(std::locale(std::locale(), new CommaDecimal));
  std::setlocale(LC_ALL, "de_DE.UTF-8");
  const EmittedFiles after = emitted(cart_pole());
  std::locale::global(previous);
  CHECK(after.files == before.files);
}

TEST_CASE("the folder of the model changes no byte") {
  Subject elsewhere = cart_pole();
  elsewhere.model.source = make_source("cart_pole.toml", "");
  CHECK(emitted(elsewhere).files == emitted(cart_pole()).files);
}

TEST_CASE("the scene changes the stamp and the namespace") {
  Subject subject = cart_pole();
  subject.scene.canonical_text = "fixed g = 9.81";
  subject.scene.emission.name_space = "plant";
  const std::string header = emitted(subject).files.at("cart_pole/cart_pole.hpp");
  CHECK_FALSE(mentions(header, "scene full"));
  CHECK(mentions(header, "namespace plant {"));
}

TEST_CASE("in each language every file begins with our marker and the hash of its text") {
  for (const LanguageRow& row : language_table) {
    Subject subject = cart_pole();
    subject.scene.emission.language = row.id;
    const EmittedFiles files = emitted(subject);
    CHECK(files.files.size() == 3);
    for (const auto& [path, text] : files.files) {
      INFO(row.name << " " << path);
      CHECK(mentions(text.substr(0, 200), generated_marker));
      CHECK(body_hash(text).stated == body_hash(text).actual);
    }
  }
}

TEST_CASE("invalid names and numbers are errors, and then nothing is emitted") {
  Subject subject = cart_pole();
  subject.program.functions[1].name = "constant";
  add_parameter(subject.model, "tiny", cln::expt(cln::cl_RA(10), -400), "m");
  read_parameter(subject, "tiny");
  const Result<EmittedFiles> files =
      emit(subject.model, subject.scene, subject.program, {subject.program});
  REQUIRE_FALSE(files);
  REQUIRE(files.diagnostics.size() == 2);
  CHECK(files.diagnostics[0].code == Code::E701);
  CHECK(files.diagnostics[1].code == Code::E702);
}
