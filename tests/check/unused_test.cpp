// Names that are declared and never used.
#include <catch2/catch.hpp>

#include "check_testing.hpp"

namespace elgen::test {
namespace {

std::string notes_of(const std::string& rest) {
  return messages(
      "format = 1\n[model]\nname = \"a\"\n[[coordinate]]\nname = \"x\"\n"
      "unit = \"m\"\n[energy]\nT = \"1/2*m*dot(x)^2\"\n[parameters]\n"
      "m = { value = 1, unit = \"kg\" }\n" +
      rest);
}

TEST_CASE("what stands in some expression is used") {
  CHECK(notes_of("").empty());
  CHECK(notes_of("[[input]]\nname = \"u\"\nunit = \"N\"\non = \"x\"\n").empty());
  CHECK(notes_of("[[input]]\nname = \"u\"\nunit = \"N\"\n[[force]]\non = \"x\"\n"
                 "value = \"2*u\"\n")
            .empty());
}

TEST_CASE("one used element of an array is enough") {
  const std::string array = "k = { value = 1, size = 2, unit = \"N\" }\n";
  CHECK(notes_of(array + "[[force]]\non = \"x\"\nvalue = \"k[2]\"\n").empty());
  CHECK(notes_of(array) == "E522 11:1 parameter `k` is used nowhere\n");
}

TEST_CASE("an input without `on` that no force names acts on nothing") {
  CHECK(notes_of("[[input]]\nname = \"u\"\nunit = \"N\"\n") ==
        "E522 12:8 input `u` acts on nothing | give it `on`, or name it in a force\n");
}

}  // namespace
}  // namespace elgen::test
