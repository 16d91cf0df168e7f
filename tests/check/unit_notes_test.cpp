// Notes on units: values that name nothing are in the unit of their key.
#include <catch2/catch.hpp>

#include "check_testing.hpp"

namespace elgen::test {
namespace {

const std::string post =
    "[[point]]\nname = \"p\"\nat = [\"x\", AT]\nmass = MASS\n[gravity]\nvector = [0, G]\n";

std::string post_of(const std::string& at, const std::string& mass, const std::string& gravity) {
  std::string text = post;
  const auto put = [&](const std::string& word, const std::string& value) {
    text.replace(text.find(word), word.size(), value);
  };
  put("AT", at);
  put("MASS", mass);
  put("G]", gravity + "]");
  return text;
}

TEST_CASE("a value that names nothing is in the unit of its key") {
  CHECK(messages(block(post_of("0.5", "0.1", "-9.81"))) ==
        "E405 14:12 `0.5` names nothing, so it is in m, the SI unit of its key; the same goes for "
        "2 other values\n");
  CHECK(messages(block(post_of("0", "\"1/3 + sqrt(2)*pi\"", "0"))) ==
        "E405 15:9 `1/3 + sqrt(2)*pi` names nothing, so it is in kg, the SI unit of its key\n");
  CHECK(messages(block(post_of("0", "\"m\"", "0"))).empty());
  CHECK(messages(block(post_of("\"x + 0.5*sin(x/x)\"", "\"m\"", "0"))) ==
        "E401 14:17 `0.5*sin(x/x)` is in 1, but the sum is in m | `0.5` has no unit in an "
        "expression: give it a name and a unit in `[parameters]`\n");
  CHECK(messages(block(post_of("\"0.5*sin(x/x)\"", "\"m\"", "0"))) ==
        "E403 14:13 `0.5*sin(x/x)` is in 1, but a position is in m | `0.5` has no unit in an "
        "expression: give it a name and a unit in `[parameters]`\n");
}

}  // namespace
}  // namespace elgen::test
