// Scene files, parsed and checked with a model that has an array, a rotation, frames and forces.
#include "elgen/scene.hpp"

#include "elgen/syntax.hpp"
#include "fuzz.hpp"

namespace elgen::test {
namespace {

constexpr const char* model_text = R"toml(
format = 1
[model]
name = "rig"
[sizes]
n = 2
[[coordinate]]
name = "x"
unit = "m"
[[coordinate]]
name = "q[i]"
for = "i in 1..n"
unit = "rad"
[[coordinate]]
name = "R"
kind = "rotation"
[parameters]
m = { value = 1, unit = "kg", min = 0.5, max = 2 }
J = { value = 0.1, unit = "kg*m^2", assume = "positive" }
g = { value = 9.81, unit = "m/s^2" }
h = { value = 1, unit = "m" }
b = { value = 1, unit = "N*s/m" }
[[input]]
name = "u"
unit = "N"
[[frame]]
name = "platform"
parent = "world"
translate = ["x", "0", "0"]
rotation = "R"
[[body]]
name = "load"
frame = "platform"
mass = "m"
com = ["0", "0", "-h"]
inertia = ["J", "J", "J", "0", "0", "0"]
[energy]
T = "1/2*J*sum(i, 1, n, dot(q[i])^2)"
V = "m*g*x"
[[force]]
on = "x"
value = "u - b*dot(x)"
)toml";

const FileSyntax& rig() {
  static const SourcePointer source = make_source("rig.toml", model_text);
  static const auto syntax = parse_model(source, Limits{});
  require(static_cast<bool>(syntax), "the model itself is read");
  return *syntax;
}

}  // namespace
}  // namespace elgen::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace elgen;
  const Limits limits = test::small_limits();
  const SourcePointer source = test::source_of(data, size, "rig.scene.toml");
  const auto scene = parse_scene(source, limits);
  test::require_answer(scene);
  if (!scene) return 0;
  static_cast<void>(dump(*scene));
  test::require_answer(check(test::rig(), &*scene, {}, limits));
  return 0;
}
