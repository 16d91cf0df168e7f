#include <fmt/core.h>

#include <catch2/catch.hpp>
#include <set>

#include "elgen/program.hpp"
#include "program/read_program.hpp"

using namespace elgen;

namespace {

std::vector<std::string> names_of(const std::string& text) {
  const Program program = testing::read_program(text);
  return temporary_names(program, program.functions.at(0));
}

const std::string angles =
    "parameters alpha\n"
    "coordinates q[1] q[2]\n"
    "time\n"
    "function bias\n"
    "  0 = coordinate q[1]\n"
    "  1 = coordinate q[2]\n"
    "  2 = parameter alpha\n"
    "  3 = time\n"
    "  4 = subtract 0 1\n"
    "  5 = add 4 2\n"
    "  6 = multiply 2 3\n"
    "  7 = sin 0\n"
    "  8 = cos 4\n"
    "  9 = sin 5\n"
    "  10 = cos 6\n"
    "  11 = cos 3\n"
    "  result 1 5 = 7 8 9 10 11\n";

}  // namespace

TEST_CASE("sines and cosines of sums of leaves are named after them") {
  const std::vector<std::string> names = names_of(angles);
  CHECK(names[7] == "sin_q_1");
  CHECK(names[8] == "cos_q_1_minus_q_2");
  CHECK(names[9] == "sin_q_1_minus_q_2_alpha");
  CHECK(names[10].empty());  // used once: written out
  CHECK(names[11] == "cos_t");
  CHECK(names[0].empty());
  CHECK(names[4] == "sum_q_1_minus_q_2");
  CHECK(names[5].empty());
}

TEST_CASE("a sum of leaves too long to spell has a hash") {
  std::string coordinates = "coordinates";
  std::string sums;
  for (int i = 1; i <= 9; ++i) coordinates += fmt::format(" angle{}", i);
  for (int i = 0; i < 9; ++i) sums += fmt::format("  {} = coordinate angle{}\n", i, i + 1);
  for (int i = 9; i < 17; ++i) {
    sums += fmt::format("  {} = add {} {}\n", i, i == 9 ? 0 : i - 1, i - 8);
  }
  const auto names = names_of(coordinates + "\nfunction bias\n" + sums +
                              "  17 = sin 16\n  18 = cos 16\n  result 1 2 = 17 18\n");
  CHECK(names[16].substr(0, 2) == "t_");
  CHECK(names[17].substr(0, 2) == "t_");  // no sum to be named after
}

TEST_CASE("a sine and a cosine of one angle have names, for one call computes both") {
  const std::string head =
      "coordinates x y\nfunction bias\n  0 = coordinate x\n  1 = coordinate y\n";
  const auto both =
      names_of(head + "  2 = multiply 0 1\n  3 = sin 2\n  4 = cos 2\n  result 1 2 = 3 4\n");
  CHECK(both[3].substr(0, 2) == "t_");
  CHECK(both[4].substr(0, 2) == "t_");
  const auto one = names_of(head + "  2 = multiply 0 1\n  3 = sin 2\n  result 1 1 = 3\n");
  CHECK(one[3].empty());
}

TEST_CASE("told names are those that are no hash, however they begin") {
  const Program program = testing::read_program(
      "coordinates x y\nfunction bias\n  0 = coordinate x\n  1 = coordinate y\n"
      "  2 = multiply 0 1\n  3 = sin 2\n  4 = cos 2\n  5 = multiply 3 4  ; t_work\n"
      "  result 1 1 = 5\n");
  const std::vector<std::string> told = told_names(program, program.functions[0]);
  CHECK(temporary_names(program, program.functions[0])[3].starts_with("t_"));
  CHECK(told[3].empty());
  CHECK(told[5] == "t_work");
}

TEST_CASE("a name of its own is kept unless something else is called so") {
  const std::string head = "parameters m\ncoordinates bob\nfunction bias\n  0 = coordinate bob\n";
  CHECK(names_of(head + "  1 = tan 0  ; bob_x\n  result 1 1 = 1\n").back() == "bob_x");
  CHECK(names_of(head + "  1 = tan 0  ; bob\n  result 1 1 = 1\n").back() == "bob_");
  CHECK(names_of(head + "  1 = tan 0  ; p\n  result 1 1 = 1\n").back() == "p_");
  CHECK(names_of(head + "  1 = tan 0  ; cos\n  result 1 1 = 1\n").back() == "cos_");
  const auto twice = names_of(head + "  1 = tan 0  ; y\n  2 = exp 0  ; y\n  3 = log 0  ; y\n" +
                              "  result 1 3 = 1 2 3\n");
  CHECK(twice == std::vector<std::string>{"", "y", "y_", "y_2"});
}

TEST_CASE("what is used twice has a hash of its content, the same wherever it stands") {
  const std::string head = "coordinates x y\nfunction bias\n  0 = coordinate x\n";
  const auto alone = names_of(head + "  1 = exp 0\n  2 = multiply 1 1\n  result 1 1 = 2\n");
  const auto among = names_of(head +
                              "  1 = coordinate y\n  2 = tan 1\n  3 = exp 0\n"
                              "  4 = multiply 3 3\n  result 1 2 = 2 4\n");
  REQUIRE(alone[1].size() == 7);
  CHECK(alone[1].substr(0, 2) == "t_");
  CHECK(among[3] == alone[1]);
  CHECK(among[2].empty());
}

TEST_CASE("negations are written out, and what they negate is computed once") {
  const auto names = names_of(
      "coordinates x\nfunction bias\n  0 = coordinate x\n  1 = exp 0\n  2 = negate 1\n"
      "  result 1 2 = 2 2\n");
  CHECK_FALSE(names[1].empty());
  CHECK(names[2].empty());
}

TEST_CASE("long expressions are broken up") {
  std::string text = "coordinates x\nfunction bias\n  0 = coordinate x\n";
  for (int i = 1; i <= 30; ++i) text += fmt::format("  {} = exp {}\n", i, i - 1);
  const auto names = names_of(text + "  result 1 1 = 30\n");
  std::set<std::string> distinct(names.begin(), names.end());
  CHECK(distinct.size() == 3);  // "", and one name after every 13 operations
  CHECK_FALSE(names[13].empty());
  CHECK_FALSE(names[26].empty());
}
