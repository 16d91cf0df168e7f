// Tests exact_numbers: a fraction for each number that is no double, one entry for each number, and
// names for numbers that share their nearest double.
#include "emit/source/exact_numbers.hpp"

#include "fixture.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

using Texts = std::vector<std::string>;

ExactNumbers numbers_of(const std::string& constants, const cln::cl_R& m,
                        LanguageId language = LanguageId::python) {
  Model model;
  add_parameter(model, "m", m, "1");
  const Program program =
      read_program("parameters m\nfunction gravity\n" + constants + "  result 3 1 = 0 1 2\n");
  return {model, program, source_spelling(language)};
}

}  // namespace

TEST_CASE("fractions are pairs of integers, and doubles need no entry") {
  const ExactNumbers exact = numbers_of(
      "  0 = parameter m\n  1 = constant 1380649/100000000000000000000000000000\n"
      "  2 = constant 30000000000000000000000000\n",
      cln::cl_RA(1) / 4);
  CHECK(exact.dictionary_entries() ==
        Texts{"1.380649e-23: (1380649, 100000000000000000000000000000)",
              "3e+25: (30000000000000000000000000, 1)"});
  CHECK(exact.named_numbers().empty());
}

TEST_CASE(
    "if two numbers have the same double, the exact one keeps the literal and the other has a "
    "name") {
  const ExactNumbers exact = numbers_of(
      "  0 = parameter m\n  1 = constant -99999999999999999999/100000000000000000000\n"
      "  2 = constant 1/3\n",
      1);
  CHECK(exact.dictionary_entries() ==
        Texts{"0.3333333333333333: (1, 3)",
              "\"_number_1\": (99999999999999999999, 100000000000000000000)"});
  REQUIRE(exact.named_numbers().size() == 1);
  CHECK(exact.named_numbers().front() == std::pair<std::string, double>{"_number_1", 1.0});
  const cln::cl_RA near = 1 - 1 / power_of_ten(20);
  CHECK(exact.name_of(rational_constant(near)) == "_number_1");
  CHECK(exact.name_of(rational_constant(-near)) == "_number_1");
  CHECK(exact.name_of(rational_constant(1)).empty());
  CHECK(exact.name_of(rational_constant(cln::cl_RA(1) / 3)).empty());
}

TEST_CASE(
    "a parameter value that shares its double with a constant is identified by the parameter") {
  const ExactNumbers exact =
      numbers_of("  0 = parameter m\n  1 = constant 1/3\n  2 = constant 2\n",
                 cln::cl_RA(cln::cl_I("33333333333333333333")) / power_of_ten(20));
  CHECK(exact.dictionary_entries() ==
        Texts{"0.3333333333333333: (1, 3)",
              "\"p.m\": (33333333333333333333, 100000000000000000000)"});
}

TEST_CASE("two forms of one number have one entry") {
  const ExactNumbers exact = numbers_of(
      "  0 = parameter m\n  1 = constant 2/9*sin(1/2*pi)+2/3*cos(1/2*pi)\n"
      "  2 = constant 2/9\n",
      1);
  CHECK(exact.dictionary_entries() == Texts{"0.2222222222222222: (2, 9)"});
}

TEST_CASE("if Python would fold two literals, the second has a name") {
  const std::string three = "  0 = parameter m\n  1 = constant 1\n  2 = constant 3\n";
  const ExactNumbers divided = numbers_of(three + "  3 = divide 1 2\n", 1);
  CHECK(divided.dictionary_entries() == Texts{"\"_number_1\": (3, 1)"});
  CHECK(divided.name_of(rational_constant(3)) == "_number_1");
  CHECK(divided.name_of(rational_constant(1)).empty());
  const ExactNumbers negative =
      numbers_of("  0 = parameter m\n  1 = constant 2/3\n  2 = negate 1\n  3 = multiply 1 2\n", 1);
  CHECK(negative.dictionary_entries() ==
        Texts{"0.6666666666666666: (2, 3)", "\"_number_1\": (2, 3)"});
  CHECK(numbers_of(three + "  3 = multiply 0 2\n", 1).dictionary_entries().empty());
}

TEST_CASE("languages without names have no exact numbers") {
  CHECK(numbers_of("  0 = parameter m\n  1 = constant 1/3\n  2 = constant 2\n", 1,
                   LanguageId::javascript)
            .dictionary_entries()
            .empty());
}
