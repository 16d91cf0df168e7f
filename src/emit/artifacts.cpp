// artifacts: a row of each kind.
#include "emit/artifacts.hpp"

#include "emit/c99/c99_artifact.hpp"
#include "emit/cpp/cpp_artifacts.hpp"
#include "emit/pages/page_artifacts.hpp"

namespace elgen {
namespace {

constexpr PerArtifact<Writer> writers{.cpp = {&cpp_header, &cpp_check_names},
                                      .eigen = {&eigen_header, &eigen_check_names},
                                      .batch = {&batch_header, &batch_check_names},
                                      .c99 = {&c99_header, &c99_check_names},
                                      .sidecar = {&sidecar, nullptr},
                                      .page = {&markdown, nullptr}};

}  // namespace

const Writer& writer_of(ArtifactId id) { return writers[id]; }

}  // namespace elgen
