// Model files: parsed, printed, checked.
#include "elgen/scene.hpp"
#include "elgen/syntax.hpp"
#include "fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace elgen;
  const Limits limits = fuzzing::small_limits();
  const SourcePointer source = fuzzing::source_of(data, size, "model.toml");
  const auto syntax = parse_model(source, limits);
  fuzzing::require_answer(syntax);
  if (!syntax) return 0;
  static_cast<void>(dump(*syntax));
  fuzzing::require_answer(check(*syntax, nullptr, {}, limits));
  return 0;
}
