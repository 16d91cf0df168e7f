// one_per_kind: many notes as one line, errors and warnings as they are.
#include "cli/note_kinds.hpp"

#include <catch2/catch.hpp>

#include "support/shell.hpp"

namespace elgen::test {

namespace {

std::string listed(const Diagnostics& diagnostics) {
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics) text += diagnostic.message + "\n";
  return text;
}

}  // namespace

TEST_CASE("what is not imported is told once for each kind, with its count") {
  const SourcePointer source = make_source("r.urdf", "a\nb\nc\nd\ne\nf\n");
  const auto at = [&](std::uint32_t line) { return Span{source.get(), 2 * line, 2 * line + 1}; };
  const Diagnostics kept = cli::one_per_kind({{Code::E815, at(0), "a is not imported"},
                                              {Code::E815, at(1), "b is not imported"},
                                              {Code::E816, at(2), "x moves"},
                                              {Code::E815, at(3), "b is not imported"},
                                              {Code::E816, at(4), "y moves"},
                                              {Code::E817, at(4), "warned"},
                                              {Code::E817, at(5), "warned"}});
  CHECK(listed(kept) ==
        "a is not imported\n"
        "b is not imported, 2 times, from line 2 on\n"
        "x moves, and so for 1 other, from line 3 on\n"
        "warned\nwarned\n");
  CHECK(kept[0].span.source == source.get());
  CHECK(kept[1].span.source == nullptr);
}

TEST_CASE("option -v and programs get every note at its place") {
  const Workspace workspace;
  write_text(workspace.path() / "r.urdf",
             "<robot name=\"r\"><link name=\"a\"><inertial><mass value=\"1\"/><inertia ixx=\"1\" "
             "iyy=\"1\" izz=\"1\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>\n"
             "<gazebo/>\n<gazebo/></robot>\n");
  const auto said = [&](const std::string& options) {
    return shell("elgen import -o r.toml --force " + options + " r.urdf", workspace.path()).errors;
  };
  const std::string note = "note[E815]: `<gazebo>` in `<robot>` is not imported";
  CHECK(mentions(said(""), "elgen: " + note + ", 2 times, from line 2 on\n"));
  CHECK(mentions(said(""), "-v lists every note with its place\n"));
  CHECK(mentions(said("-v"), "r.urdf:2:2: " + note + "\n"));
  CHECK(mentions(said("-v"), "r.urdf:3:2: " + note + "\n"));
  CHECK(mentions(said("--format github"), "file=r.urdf,line=3"));
  CHECK(said("-q").empty());
}

}  // namespace elgen::test
