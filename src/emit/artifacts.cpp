// artifacts: a row of each kind.
#include "artifacts.hpp"

#include <fmt/format.h>

#include "markdown.hpp"
#include "sidecar.hpp"

namespace elgen {
namespace {

constexpr PerArtifact<Writer> writers{{{&cpp_header, &cpp_check_names},
                                       {&eigen_header, &eigen_check_names},
                                       {&c99_header, &c99_check_names},
                                       {&sidecar, nullptr},
                                       {&markdown, nullptr}}};
static_assert(writers.back().text != nullptr, "a kind of file has no writer");

}  // namespace

const Writer& writer_of(ArtifactId id) { return writers[static_cast<std::size_t>(id)]; }

Diagnostic taken_name(const std::string& name, const char* what, const Span& span) {
  return {Code::E701, span,
          fmt::format("`{}` cannot name a {}: the emitted code has that name", name, what)};
}

Span span_of(const Scene& scene, const Function& function) {
  const OutputRequest* request = find_request(scene, function.name);
  return request == nullptr ? Span{} : request->span;
}

}  // namespace elgen
