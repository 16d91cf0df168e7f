// URDF files: a successful import gives a model file without errors.
#include "elgen/urdf.hpp"

#include "elgen/scene.hpp"
#include "elgen/syntax.hpp"
#include "fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace elgen;
  const Limits limits = test::small_limits();
  const SourcePointer source = test::source_of(data, size, "robot.urdf");
  const auto imported = import_urdf(source, limits);
  test::require_answer(imported);
  if (!imported) return 0;
  const Limits large;  // an imported model may be longer than its robot
  const SourcePointer model = make_source("imported.toml", imported->text);
  const auto syntax = parse_model(model, large);
  test::require(static_cast<bool>(syntax),
                "an imported model is read\n" + format(syntax.diagnostics) + imported->text);
  const auto checked = check(*syntax, nullptr, {}, large);
  test::require(static_cast<bool>(checked),
                "an imported model is right\n" + format(checked.diagnostics) + imported->text);
  return 0;
}
