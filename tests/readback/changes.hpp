// One change of a written file, and that it is refused.
#pragma once

#include <catch2/catch.hpp>

#include "systems.hpp"
#include "written.hpp"

namespace elgen::test {

inline const Written& cpp() {
  static const Written all = written(wide_text());
  return all;
}

inline const Written& eigen() {
  static const Written all =
      written(wide_text(), "[emit]\nstorage = \"column-major\"\neigen = true\n");
  return all;
}

inline const Written& c99() {
  static const Written all =
      written(wide_text(), "[emit]\nlanguage = \"c99\"\n[numeric]\nscalar = [\"float\"]\n");
  return all;
}

/// One change: of `from` where it first stands behind `anchor`.
struct Change {
  const Written& all;
  std::string ending;
  std::string anchor;
  std::string from;
  std::string to;
  std::string said;  ///< a part of the message
};

inline std::string changed(const Change& change) {
  std::string text = file_of(change.all, change.ending)->text;
  const std::size_t start = text.find(change.anchor);
  REQUIRE(start != std::string::npos);
  const std::size_t at = text.find(change.from, start);
  REQUIRE(at != std::string::npos);
  return text.replace(at, change.from.size(), change.to);
}

/// Refused with one error, at a line of the file that was changed.
inline void expect_refused(const Change& change) {
  INFO(change.ending << ": `" << change.from << "` -> `" << change.to << "`");
  std::vector<SourcePointer> sources;
  const Diagnostics found = read_changed(change.all, change.ending, changed(change), sources);
  REQUIRE(found.size() == 1);
  CHECK(found.front().code == Code::E915);
  REQUIRE(found.front().span.source != nullptr);
  CHECK(found.front().span.source->path.ends_with(change.ending));
  INFO(format(found));
  CHECK_THAT(found.front().message, Catch::Contains(change.said));
}

}  // namespace elgen::test
