// languages: what a target language gives to emit(), for every row of languages.def.
#pragma once

#include <string>

#include "elgen/languages.hpp"
#include "emission_input.hpp"

namespace elgen {

/// E701 for parameters, functions and namespaces whose name the emitted code needs.
#define ELGEN_LANGUAGE(id, name, ending, scalars)                                    \
  [[nodiscard]] Diagnostics id##_check_names(const Model& model, const Scene& scene, \
                                             const Program& program);                \
  [[nodiscard]] std::string id##_header(const EmissionInput& input);
#include "elgen/languages.def"
#undef ELGEN_LANGUAGE

/// The two of one language.
struct Language {
  Diagnostics (*check_names)(const Model& model, const Scene& scene, const Program& program);
  std::string (*header)(const EmissionInput& input);  ///< the text with its body hash
};
[[nodiscard]] const Language& language(LanguageId id);

/// E701 at the span of what wants the name.
[[nodiscard]] Diagnostic taken_name(const std::string& name, const char* what, const Span& span);

/// Where the scene asks for a function; nowhere for the scene `full`.
[[nodiscard]] Span span_of(const Scene& scene, const Function& function);

}  // namespace elgen
