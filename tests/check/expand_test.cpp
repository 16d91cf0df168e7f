// Expansion of repetitions: the entries of each `for` and the rules for their names.
#include <catch2/catch.hpp>

#include "check_testing.hpp"

namespace elgen::test {
namespace {

std::string model_with_entries(const std::string& entries) {
  return "format = 1\n[model]\nname = \"a\"\n[sizes]\nn = 2\n[parameters]\n"
         "m = { value = 1, unit = \"kg\" }\n[[coordinate]]\nname = \"x\"\nunit = \"m\"\n"
         "[energy]\nT = \"m*dot(x)^2\"\n" +
         entries;
}

TEST_CASE("repetitions make one entry per combination") {
  const std::string grid = model_with_entries(
      "[[point]]\nname = \"p[0]\"\nat = [\"0\", \"0\"]\n"
      "[[point]]\nfor = [\"i in 1..n\", \"j in i..n\"]\nname = \"p[10*i + j]\"\n"
      "at = [\"i*x\", \"j*x\"]\n");
  CHECK(dump_lines(grid, "point") ==
        "point p[0] at [0, 0]\n"
        "point p[11] at [1*x, 1*x]\n"
        "point p[12] at [1*x, 2*x]\n"
        "point p[22] at [2*x, 2*x]\n");
  const Model model = checked(grid).model;
  CHECK(model.points[2].identifier == "p_12");
}

TEST_CASE("entries may refer to earlier and later entries") {
  CHECK(messages(model_with_entries("[[point]]\nname = \"a1\"\nat = [\"x(b1)\", \"0\"]\n"
                                    "[[point]]\nname = \"b1\"\nat = [\"x\", \"0\"]\n"))
            .empty());
}

TEST_CASE("refused names of repetitions") {
  const Rows rows{
      // Both instances have the name `p`.
      {"[[point]]\nfor = \"i in 1..n\"\nname = \"p\"\nat = [\"x\", \"0\"]\n",
       "E203 15:9 `p` is already a point | first at line 15\n"},
      {"[[point]]\nname = \"p[i]\"\nat = [\"x\", \"0\"]\n", "E201 14:11 unknown index `i`\n"},
      {"[[point]]\nfor = \"i in 1..n\"\nname = \"p[i-5]\"\nat = [\"x\", \"0\"]\n",
       "E205 15:9 `p[-4]` has a negative index\n"},
      {"[[point]]\nfor = \"m in 1..n\"\nname = \"p[m]\"\nat = [\"x\", \"0\"]\n",
       "E203 14:8 the running index `m` is also a parameter\n"},
      // The order of the two entries does not matter.
      {"[[point]]\nfor = \"u in 1..n\"\nname = \"p[u]\"\nat = [\"x\", \"0\"]\n"
       "[[input]]\nname = \"u\"\n",
       "E203 14:8 the running index `u` is also an input\n"},
      {"[[input]]\nname = \"u\"\n"
       "[[point]]\nfor = \"u in 1..n\"\nname = \"p[u]\"\nat = [\"x\", \"0\"]\n",
       "E203 16:8 the running index `u` is also an input\n"},
      {"[[point]]\nfor = \"i in 1..m\"\nname = \"p[i]\"\nat = [\"x\", \"0\"]\n",
       "E201 14:16 unknown index `m`\n"},
      {"[define]\nm = \"2\"\n", "E203 14:1 `m` is already a parameter | first at line 7\n"},
      {"[[point]]\nname = \"x_1\"\nat = [\"x\", \"0\"]\n[[input]]\nname = \"x_1\"\n",
       "E203 17:9 `x_1` is already a point | first at line 14\n"},
  };
  check_rows(rows,
             [&](const std::string& entries) { return messages(model_with_entries(entries)); });
}

TEST_CASE("the numbers of entries have limits, tested at the limit and beyond") {
  const std::string points = model_with_entries(
      "[define]\none = \"1\"\n[[point]]\nfor = \"i in 1..n\"\nname = \"p[i]\"\nat = [\"x\", "
      "\"0\"]\n");
  CheckOptions wanted;
  wanted.limits.definitions = 3;
  CHECK(messages(points, wanted).empty());
  wanted.limits.definitions = 2;
  CHECK(messages(points, wanted) == "E907 17:9 more than 2 entries after repetition\n");
  const std::string coordinates =
      "format = 1\n[model]\nname = \"a\"\n[[coordinate]]\nfor = \"i in 1..3\"\nname = \"x[i]\"\n"
      "[energy]\nT = \"sum(i, 1, 3, dot(x[i])^2)\"\n";
  wanted.limits.coordinates = 3;
  CHECK(checked(coordinates, wanted).model.coordinates.size() == 3);
  wanted.limits.coordinates = 2;
  // Errors that follow from the missing coordinate are not reported.
  CHECK(messages(coordinates, wanted) == "E906 6:9 more than 2 coordinates\n");
}

}  // namespace
}  // namespace elgen::test
