// taken_name: one message for every language.
#include "emit/text/taken_name.hpp"

#include <fmt/format.h>

namespace elgen {

Diagnostic taken_name(const std::string& name, const char* what, const Span& span) {
  return {Code::E701, span,
          fmt::format("`{}` cannot name a {}: the emitted code has that name", name, what)};
}

Diagnostic taken_name(const Scene& scene, const Function& function) {
  const OutputRequest* request = find_request(scene, function.name);
  return taken_name(function.name, "function", request == nullptr ? Span{} : request->span);
}

}  // namespace elgen
