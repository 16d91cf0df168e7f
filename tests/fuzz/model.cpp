// Model files: parsed, printed, checked.
#include "elgen/scene.hpp"
#include "elgen/syntax.hpp"
#include "fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace elgen;
  const Limits limits = test::small_limits();
  const SourcePointer source = test::source_of(data, size, "model.toml");
  const auto syntax = parse_model(source, limits);
  test::require_answer(syntax);
  if (!syntax) return 0;
  static_cast<void>(dump(*syntax));
  test::require_answer(check(*syntax, nullptr, {}, limits));
  return 0;
}
