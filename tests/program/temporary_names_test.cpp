#include <fmt/core.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "elgen/program.hpp"
#include "program/read_program.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

std::vector<std::string> names_of(const std::string& text) {
  const Program program = read_program(text);
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

TEST_CASE("sines and cosines of sums of leaves are named after the sums") {
  const std::vector<std::string> names = names_of(angles);
  CHECK(names[7] == "sin_q_1");
  CHECK(names[8] == "cos_q_1_minus_q_2");
  CHECK(names[9] == "sin_q_1_minus_q_2_alpha");
  CHECK(names[10].empty());  // used once, so substituted
  CHECK(names[11] == "cos_t");
  CHECK(names[0].empty());
  CHECK(names[4] == "q_1_minus_q_2");
  CHECK(names[5].empty());
}

TEST_CASE("a sum of leaves too long for a name gets a hash") {
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
  CHECK(names[17].substr(0, 2) == "t_");  // the sum has no readable name either
}

TEST_CASE("a sine and a cosine of one angle have names, because one call computes both") {
  const std::string head =
      "coordinates x y\nfunction bias\n  0 = coordinate x\n  1 = coordinate y\n";
  const auto both =
      names_of(head + "  2 = multiply 0 1\n  3 = sin 2\n  4 = cos 2\n  result 1 2 = 3 4\n");
  CHECK(both[3].substr(0, 2) == "t_");
  CHECK(both[4].substr(0, 2) == "t_");
  const auto one = names_of(head + "  2 = multiply 0 1\n  3 = sin 2\n  result 1 1 = 3\n");
  CHECK(one[3].empty());
}

TEST_CASE("own names are neither derived from the value, nor named intermediates, nor hashes") {
  const Program program = read_program(
      "coordinates x y\nfunction bias\n  0 = coordinate x\n  1 = coordinate y\n"
      "  2 = multiply 0 1\n  3 = sin 2\n  4 = cos 2\n  5 = multiply 3 4  ; t_work\n"
      "  6 = tan 5  ; ~moment_link_y\n  7 = multiply 6 6\n  8 = subtract 0 1\n"
      "  result 1 4 = 5 7 8 8\n");
  const std::vector<std::string> all = temporary_names(program, program.functions[0]);
  CHECK(all[3].starts_with("t_"));
  CHECK(all[6] == "moment_link_y");
  CHECK(all[8] == "x_minus_y");
  const std::vector<std::string> own = context_free_names(program, program.functions[0]);
  CHECK(own == std::vector<std::string>{"", "", "", "", "", "t_work", "", "", ""});
}

TEST_CASE("an own name is kept unless it clashes with another name") {
  const std::string head = "parameters m\ncoordinates bob\nfunction bias\n  0 = coordinate bob\n";
  CHECK(names_of(head + "  1 = tan 0  ; bob_x\n  result 1 1 = 1\n").back() == "bob_x");
  CHECK(names_of(head + "  1 = tan 0  ; bob\n  result 1 1 = 1\n").back() == "bob_");
  CHECK(names_of(head + "  1 = tan 0  ; p\n  result 1 1 = 1\n").back() == "p_");
  CHECK(names_of(head + "  1 = tan 0  ; cos\n  result 1 1 = 1\n").back() == "cos_");
  const auto twice = names_of(head + "  1 = tan 0  ; y\n  2 = exp 0  ; y\n  3 = log 0  ; y\n" +
                              "  result 1 3 = 1 2 3\n");
  CHECK(twice == std::vector<std::string>{"", "y", "y_", "y_2"});
}

TEST_CASE("a value used twice gets a hash of its content, wherever it occurs") {
  const std::string head = "coordinates x y\nfunction bias\n  0 = coordinate x\n";
  const auto alone =
      names_of(head + "  1 = multiply 0 0\n  2 = exp 1\n  3 = multiply 2 2\n  result 1 1 = 3\n");
  const auto among = names_of(head +
                              "  1 = coordinate y\n  2 = tan 1\n  3 = multiply 0 0\n"
                              "  4 = exp 3\n  5 = multiply 4 4\n  result 1 2 = 2 5\n");
  REQUIRE(alone[2].size() == 7);
  CHECK(alone[2].substr(0, 2) == "t_");
  CHECK(among[4] == alone[2]);
  CHECK(among[2].empty());
}

TEST_CASE("negations are substituted, and their operands are computed once") {
  const auto names = names_of(
      "coordinates x\nfunction bias\n  0 = coordinate x\n  1 = exp 0\n  2 = negate 1\n"
      "  result 1 2 = 2 2\n");
  CHECK_FALSE(names[1].empty());
  CHECK(names[2].empty());
}

TEST_CASE("long expressions are split") {
  std::string text = "coordinates x\nfunction bias\n  0 = coordinate x\n";
  for (int i = 1; i <= 30; ++i) text += fmt::format("  {} = exp {}\n", i, i - 1);
  const auto names = names_of(text + "  result 1 1 = 30\n");
  std::set<std::string> distinct(names.begin(), names.end());
  CHECK(distinct.size() == 3);  // "", and a name after every 13 operations
  CHECK_FALSE(names[13].empty());
  CHECK_FALSE(names[26].empty());
}

namespace {

const std::string few =
    "parameters M m l half\ncoordinates x theta\nvelocities x theta\nfunction bias\n"
    "  0 = parameter M\n  1 = parameter m\n  2 = parameter l\n  3 = coordinate x\n"
    "  4 = coordinate theta\n  5 = velocity theta\n  6 = constant 1/2\n  7 = constant 1\n"
    "  8 = cos 4\n";

/// The name of the last instruction, which is used twice.
std::string name_of(const std::string& instructions, int last) {
  return names_of(fmt::format("{}{}  result 1 2 = {} {}\n", few, instructions, last, last)).back();
}

}  // namespace

TEST_CASE("a value of few named operands is named after them") {
  CHECK(name_of("  9 = multiply 1 2\n", 9) == "m_l");
  CHECK(name_of("  9 = multiply 8 1\n  10 = multiply 9 2\n", 10) == "l_m_cos_theta");
  CHECK(name_of("  9 = divide 3 2\n", 9) == "x_over_l");
  CHECK(name_of("  9 = add 0 1\n", 9) == "M_plus_m");
  CHECK(name_of("  9 = subtract 7 8\n", 9) == "one_minus_cos_theta");
  CHECK(name_of("  9 = multiply 4 6\n  10 = sin 9\n", 10) == "sin_half_theta");
  CHECK(name_of("  9 = multiply 5 5\n", 9) == "theta_dot_theta_dot");
}

TEST_CASE("an ambiguous, hiding or long name is replaced by a hash") {
  for (const char* const text : {
           "  9 = subtract 8 3\n",                  // could mean cos(theta - x)
           "  9 = multiply 1 2\n  10 = sin 9\n",    // could mean sin(m + l)
           "  9 = add 0 1\n  10 = multiply 9 2\n",  // could mean M + m*l
           "  9 = multiply 0 0\n",                  // M_M resembles a macro
           "  9 = multiply 1 1\n  10 = multiply 9 9\n  11 = multiply 10 1\n",  // five factors
       }) {
    INFO(text);
    const std::string lines = text;
    const auto last = static_cast<int>(8 + std::ranges::count(lines, '\n'));
    CHECK(name_of(lines, last).starts_with("t_"));
  }
  const auto names = names_of(
      "parameters m l m_l mass matrix\ncoordinates x\nfunction mass_matrix\n  0 = parameter m\n"
      "  1 = parameter l\n  2 = multiply 0 1\n  3 = parameter mass\n  4 = parameter matrix\n"
      "  5 = multiply 3 4\n  result 1 4 = 2 2 5 5\n");
  CHECK(names[2].starts_with("t_"));
  CHECK(names[5].starts_with("t_"));
}

TEST_CASE("two values with the same derived name get hashes") {
  const auto names = names_of(
      "parameters a b a_b c\ncoordinates x\nfunction bias\n  0 = parameter a\n"
      "  1 = parameter a_b\n  2 = parameter c\n  3 = parameter b\n  4 = multiply 0 3\n"
      "  5 = multiply 4 2\n  6 = multiply 1 2\n  result 1 4 = 5 5 6 6\n");
  CHECK(names[5].starts_with("t_"));
  CHECK(names[6].starts_with("t_"));
}

TEST_CASE("names of named intermediates occur in other names, and their operands are parts") {
  const auto names = names_of(
      "parameters m\ncoordinates x y\nfunction bias\n  0 = parameter m\n  1 = coordinate x\n"
      "  2 = coordinate y\n  3 = exp 1\n  4 = tan 3\n  5 = multiply 4 4\n"
      "  6 = add 5 2  ; ~moment_link_y\n  7 = multiply 0 6\n  8 = multiply 0 0  ; ~told\n"
      "  result 1 6 = 6 6 7 7 8 8\n");
  CHECK(names[6] == "moment_link_y");
  CHECK(names[4] == "moment_link_y_part");
  CHECK(names[7] == "m_moment_link_y");
  CHECK(names[8] == "m_m");
}
