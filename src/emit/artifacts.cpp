// artifacts: a row of each kind.
#include "emit/artifacts.hpp"

#include "emit/c99/c99_artifact.hpp"
#include "emit/cpp/cpp_artifacts.hpp"
#include "emit/pages/page_artifacts.hpp"

namespace elgen {
namespace {

constexpr PerArtifact<Writer> writers{{{&cpp_header, &cpp_check_names},
                                       {&eigen_header, &eigen_check_names},
                                       {&c99_header, &c99_check_names},
                                       {&sidecar, nullptr},
                                       {&markdown, nullptr}}};
static_assert(writers.back().text != nullptr, "a kind of file has no writer");

}  // namespace

const Writer& writer_of(ArtifactId id) { return row_of(writers, id); }

}  // namespace elgen
