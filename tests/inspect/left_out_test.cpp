// E619: one note per reason, where the reason stands in the model.
#include <catch2/catch.hpp>

#include "inspect/checks.hpp"
#include "inspect/found.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

Diagnostics left_out_notes(const std::vector<LeftOut>& left_out) {
  Scene scene;
  scene.left_out = left_out;
  return inspect_left_out({Model{}, scene});
}

}  // namespace

TEST_CASE("nothing is said where nothing is left out") { CHECK(left_out_notes({}).empty()); }

TEST_CASE("one note per reason names the outputs and how they can be had") {
  const SourcePointer source = make_source("a.toml", "name = \"a\" abs(x)");
  const Diagnostics notes = left_out_notes(
      {{LeftOutReason::too_many_entries, {"mass_matrix", "tip"}, {source.get(), 7, 10}},
       {LeftOutReason::kinked_force, {"linearization"}, {source.get(), 11, 17}}});
  CHECK(text_of(notes) ==
        "E619: left out, with more than 4096 entries: `mass_matrix`, `tip`\n"
        "E619: left out, as a force with a kink has no derivatives: `linearization`");
  CHECK(notes[0].hint == "a scene or `--outputs` that names an output gets it");
  CHECK(notes[1].hint == "a smooth stand-in has them: `tanh(x/width)` for `sign(x)`");
  CHECK(covered_text(notes[0].span) == "\"a\"");
  CHECK(covered_text(notes[1].span) == "abs(x)");
}
