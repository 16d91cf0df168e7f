// Long functions are cut into parts that share a workspace: what a part reads another one has
// written, once, and the parts are called in their order.
#include <catch2/catch.hpp>

#include "written.hpp"

namespace elgen {
namespace {

using test::Written;

Written arm(const std::string& language) {
  const std::string path = std::string(ELGEN_SOURCE_DIR) + "/models/panda7.toml";
  const std::string scene =
      "format = 1\nmodel = \"panda7.toml\"\nname = \"cut\"\n[outputs]\n"
      "forward_dynamics_derivatives = true\n[emit]\nlanguage = \"" +
      language + "\"\n";
  return test::written(
      {make_source("panda7.toml", test::read_text(path)), make_source("cut.scene.toml", scene)});
}

const Written& arm_in_cpp() {
  static const Written all = arm("c++17");
  return all;
}

const Written& arm_in_c99() {
  static const Written all = arm("c99");
  return all;
}

/// A header to be changed.
struct Draft {
  const Written& all;
  std::string ending;
  std::string text = test::file_of(all, ending)->text;

  [[nodiscard]] std::size_t find(const std::string& part, std::size_t from = 0) const {
    const std::size_t at = text.find(part, from);
    REQUIRE(at != std::string::npos);
    return at;
  }
  /// The line that holds the next `part` behind `anchor`, with its end; it is taken out.
  std::string take_line(const std::string& anchor, const std::string& part) {
    const std::size_t at = find(part, find(anchor));
    const std::size_t begin = text.rfind('\n', at) + 1;
    const std::size_t size = text.find('\n', at) + 1 - begin;
    const std::string line = text.substr(begin, size);
    text.erase(begin, size);
    return line;
  }
  void insert_line(const std::string& anchor, const std::string& line) {
    text.insert(text.find('\n', find("{\n", find(anchor))) + 1, line);
  }
  void replace(const std::string& anchor, const std::string& from, const std::string& to) {
    text.replace(find(from, find(anchor)), from.size(), to);
  }
  /// The message of the only error.
  [[nodiscard]] std::string refusal() const {
    std::vector<SourcePointer> sources;
    const Diagnostics found = test::read_changed(all, ending, text, sources);
    REQUIRE(found.size() == 1);
    INFO(format(found));
    CHECK(found.front().span.source != nullptr);
    return found.front().message;
  }
};

const std::string first_part = "_part_1(";
const std::string second_part = "_part_2(";

}  // namespace

TEST_CASE("a function in parts is read back") {
  CHECK(arm_in_cpp().files.size() == 3);
  CHECK(Draft{arm_in_cpp(), "cut.hpp"}.find("detail::forward_dynamics_derivatives_part_2(") > 0);
  CHECK(Draft{arm_in_c99(), "cut.h"}.find("_part_2(") > 0);
}

TEST_CASE("a statement in the part of another one is refused") {
  for (Draft draft : {Draft{arm_in_cpp(), "cut.hpp"}, Draft{arm_in_c99(), "cut.h"}}) {
    const std::string access = draft.ending == "cut.h" ? "w->" : "w.";
    const std::string line = draft.take_line(first_part, "  " + access);
    draft.insert_line(second_part, line);
    CHECK_THAT(draft.refusal(), Catch::Contains(" instead of ") || Catch::Contains("no value yet"));
  }
}

TEST_CASE("a shared value that no part has written is refused") {
  Draft draft{arm_in_cpp(), "cut.hpp"};
  (void)draft.take_line(first_part, "  w.");
  CHECK_THAT(draft.refusal(), Catch::Contains(" instead of ") || Catch::Contains("no value yet"));
}

TEST_CASE("a shared value that is written twice is refused") {
  Draft draft{arm_in_cpp(), "cut.hpp"};
  const std::string line = draft.take_line(first_part, "  w.");
  draft.insert_line(first_part, line + line);
  CHECK_FALSE(draft.refusal().empty());
}

TEST_CASE("a sine and a cosine that parts share are compared") {
  const std::string pair = "std::tie(w.sin_q2, w.cos_q2) = detail::SineCosine<Scalar>::of(q[1]);";
  const auto refusal_of = [&](const std::string& other) {
    Draft draft{arm_in_cpp(), "cut.hpp"};
    draft.replace(first_part, pair, other);
    return draft.refusal();
  };
  CHECK_THAT(refusal_of("std::tie(w.sin_q2, w.cos_q2) = detail::SineCosine<Scalar>::of(q[2]);"),
             Catch::Contains("`q[2]` instead of `q[1]`"));
  CHECK_THAT(refusal_of("std::tie(w.sin_q2, w.sin_q2) = detail::SineCosine<Scalar>::of(q[1]);"),
             Catch::Contains("is written twice"));
  CHECK_THAT(refusal_of("std::tie(w.sin_q2, w.other) = detail::SineCosine<Scalar>::of(q[1]);"),
             Catch::Contains("is not declared here"));
  // Each has a value then, though not its own.
  CHECK_FALSE(
      refusal_of("std::tie(w.cos_q2, w.sin_q2) = detail::SineCosine<Scalar>::of(q[1]);").empty());
}

TEST_CASE("the workspace declares what is shared, each once") {
  Draft missing{arm_in_cpp(), "cut.hpp"};
  (void)missing.take_line("Workspace {", "Scalar ");
  CHECK_THAT(missing.refusal(), Catch::Contains("is not declared here"));
  Draft twice{arm_in_cpp(), "cut.hpp"};
  const std::string line = twice.take_line("Workspace {", "Scalar ");
  twice.insert_line("struct ForwardDynamicsDerivativesWorkspace", line + line);
  CHECK_THAT(twice.refusal(), Catch::Contains("is declared twice"));
}

TEST_CASE("parts are called one after another, all of them") {
  for (Draft draft : {Draft{arm_in_cpp(), "cut.hpp"}, Draft{arm_in_c99(), "cut.h"}}) {
    Draft fewer = draft;
    const std::string line = fewer.take_line(" w;", second_part);
    CHECK_THAT(fewer.refusal(), Catch::Contains("instead of"));
    Draft swapped = draft;
    swapped.replace(" w;", "_part_1(", "_part_2(");
    CHECK_THAT(swapped.refusal(), Catch::Contains("_part_1`"));
    Draft repeated = draft;
    repeated.replace(" w;", line, line + line);
    CHECK_FALSE(repeated.refusal().empty());
  }
}

TEST_CASE("an entry in a part is compared") {
  Draft cpp_draft{arm_in_cpp(), "cut.hpp"};
  cpp_draft.replace(second_part, "result.by_position[", "result.by_velocity[");
  CHECK_FALSE(cpp_draft.refusal().empty());
  Draft c_draft{arm_in_c99(), "cut.h"};
  c_draft.replace(second_part, "result->by_position[", "result->by_velocity[");
  CHECK_FALSE(c_draft.refusal().empty());
}

}  // namespace elgen
