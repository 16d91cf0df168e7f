// languages: the functions of each row of languages.def, in its order.
#include "languages.hpp"

#include <fmt/format.h>

#include <array>

namespace elgen {
namespace {

constexpr std::array languages{
#define ELGEN_LANGUAGE(id, name, ending, scalars) Language{&id##_check_names, &id##_header},
#include "elgen/languages.def"
#undef ELGEN_LANGUAGE
};

}  // namespace

const Language& language(LanguageId id) { return languages[static_cast<std::size_t>(id)]; }

Diagnostic taken_name(const std::string& name, const char* what, const Span& span) {
  return {Code::E701, span,
          fmt::format("`{}` cannot name a {}: the emitted code has that name", name, what)};
}

Span span_of(const Scene& scene, const Function& function) {
  for (const OutputRequest& request : scene.outputs) {
    if (request.name == function.name) return request.span;
  }
  return {};
}

}  // namespace elgen
