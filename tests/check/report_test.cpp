// Report: repeats kept once.
#include "check/names/report.hpp"

#include <catch2/catch.hpp>

namespace elgen {
namespace {

TEST_CASE("one mistake met many times is one message") {
  const SourcePointer source = make_source("m.toml", "abc");
  Report report;
  report.add(Code::E207, {source.get(), 0, 1}, "`x[i]` is `x[4]`");
  report.add(Code::E207, {source.get(), 0, 1}, "`x[i]` is `x[5]`");
  report.add(Code::E207, {source.get(), 1, 2}, "`x[i]` is `x[5]`");
  report.add(Code::E208, {source.get(), 0, 1}, "`x[i]` is `x[5]`");
  CHECK(report.errors() == 3);
  CHECK(report.sorted().size() == 3);
  CHECK(report.sorted().front().message == "`x[i]` is `x[4]`");
}

TEST_CASE("warnings and notes are no errors") {
  Report report;
  report.add(Code::E518, {}, "a");
  report.add(Code::E520, {}, "b");
  CHECK(report.errors() == 0);
  CHECK(report.sorted().size() == 2);
}

TEST_CASE("suggestions end after a hundred errors") {
  const SourcePointer source = make_source("m.toml", std::string(200, 'a'));
  Report report;
  for (std::uint32_t i = 0; i < 100; ++i) {
    CHECK(report.wants_suggestion());
    report.add(Code::E201, {source.get(), i, i + 1}, "a");
  }
  CHECK_FALSE(report.wants_suggestion());
}

}  // namespace
}  // namespace elgen
