// A name that the emitted code needs is refused where the scene asks for it.
#include "emit/text/taken_name.hpp"

#include <catch2/catch.hpp>

namespace elgen {

TEST_CASE("a function's name is refused at its place in the scene, or nowhere") {
  Function function;
  function.name = "detail";
  Scene scene;
  CHECK(taken_name(scene, function).span.source == nullptr);
  const SourcePointer source = make_source("a.scene.toml", "detail = true");
  OutputRequest request;
  request.name = "detail";
  request.span = {source.get(), 0, 6};
  scene.outputs.push_back(request);
  const Diagnostic found = taken_name(scene, function);
  CHECK(found.code == Code::E701);
  CHECK(found.span.source == source.get());
  CHECK(found.message == "`detail` cannot name a function: the emitted code has that name");
}

}  // namespace elgen
