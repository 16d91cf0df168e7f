// artifacts: every kind of file is written, with our mark, at a path with its ending.
#include "emit/artifacts.hpp"

#include "fixture.hpp"

using namespace elgen;
using elgen::testing::cart_pole;
using elgen::testing::Subject;

TEST_CASE("each language makes its header, a sidecar and a page, all with our mark") {
  for (const LanguageRow& row : language_table) {
    Subject subject = cart_pole();
    subject.scene.emission.language = row.id;
    INFO(row.name);
    const EmissionInput input = emission_input(subject.model, subject.scene, subject.program);
    const std::vector<Artifact> wanted = artifacts_of(subject.scene);
    CHECK(wanted.size() == 3);
    for (const Artifact& artifact : wanted) {
      const Writer& writer = writer_of(artifact.id);
      CHECK(writer.text(input).substr(0, 200).find(generated_marker) != std::string::npos);
      if (writer.check_names == nullptr) continue;
      CHECK(writer.check_names(subject.model, subject.scene, subject.program).empty());
    }
  }
}
