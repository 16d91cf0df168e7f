// Parameters: exact values, arrays, and values that contradict the declaration.
#include <catch2/catch.hpp>

#include "check_testing.hpp"

namespace elgen::test {
namespace {

std::string model_with_parameters(const std::string& parameters) {
  return "format = 1\n[model]\nname = \"a\"\n[sizes]\nn = 3\n[[coordinate]]\nname = \"x\"\n"
         "unit = \"m\"\n[energy]\nT = \"dot(x)^2*0\"\nV = \"0\"\n[parameters]\n" +
         parameters;
}

TEST_CASE("values are exact, and an array has one number for all elements or a list") {
  CHECK(dump_lines(model_with_parameters("a = { value = 0.1, unit = \"kg\" }\n"), "parameter") ==
        "parameter a = 1/10 [kg]\n");
  CHECK(dump_lines(model_with_parameters("a = { value = \"1/3\", size = \"n-1\", unit = \"1\" }\n"),
                   "parameter") == "parameter a[1] = 1/3 [1]\nparameter a[2] = 1/3 [1]\n");
  CHECK(dump_lines(model_with_parameters(
                       "a = { value = [1, \"2/3\", 3e0], size = \"n\", unit = \"m\" }\n"),
                   "parameter") ==
        "parameter a[1] = 1 [m]\nparameter a[2] = 2/3 [m]\nparameter a[3] = 3 [m]\n");
  CHECK(dump_lines(model_with_parameters("a = 5\n"), "parameter") == "parameter a = 5\n");
}

TEST_CASE("declarations keep their keys") {
  const Model model =
      checked(model_with_parameters("a = { value = 2, size = \"n\", unit = \"kg*m\", min = 1, "
                                    "max = 3, assume = \"positive\", doc = \"a doc\", "
                                    "latex = \"\\\\alpha\" }\nb = { value = 1, unit = \"1\" }\n"))
          .model;
  REQUIRE(model.parameter_arrays.size() == 2);
  const ParameterArray& a = model.parameter_arrays[0];
  CHECK(a.is_array);
  CHECK(a.count == 3);
  CHECK(a.unit_text == "kg*m");
  CHECK(a.doc == "a doc");
  CHECK(a.latex == "\\alpha");
  REQUIRE(a.range);
  CHECK(a.range->low == 1);
  CHECK(a.range->high == 3);
  CHECK(model.parameter_arrays[1].first == 3);
  CHECK_FALSE(model.parameter_arrays[1].is_array);
  CHECK(model.parameters[2].identifier == "a_3");
  CHECK(model.parameters[2].element == 2);
  CHECK(model.parameters[2].assumption == Assumption::positive);
}

TEST_CASE("refused values") {
  const Rows rows{
      {"a = { value = [1, 2], size = \"n\", unit = \"m\" }\n",
       "E104 13:15 2 values, but `a` has size 3\n"},
      {"a = { value = [1, 2], unit = \"m\" }\n", "E104 13:15 2 values, but `a` has no `size`\n"},
      {"a = { value = 1, size = \"n-3\", unit = \"m\" }\n",
       "E209 13:26 the size is 0, so there is no element\n"},
      {"a = { value = 1, size = \"k\", unit = \"m\" }\n", "E201 13:26 unknown index `k`\n"},
      {"a = { value = \"b\", unit = \"m\" }\n", "E201 13:16 unknown name `b`\n"},
      {"a = { value = \"2*x\", unit = \"m\" }\n",
       "E319 13:16 `2*x` is not a constant number | a formula of other names stands in "
       "`[define]`\n"},
      {"a = { value = 1, unit = \"m\", min = 3, max = 2 }\n",
       "E518 13:15 `1` is outside `min` or `max` of `a`\n"
       "E112 13:45 `2` is below `min`\n"},
      {"a = { value = 1, unit = \"lb\" }\n",
       "E402 13:26 unknown unit `lb` | 1 lb is 0.45359237 kg: write `value = \"0.45359237*1\", "
       "unit = \"kg\"`\n"},
  };
  check_rows(rows, [&](const std::string& parameters) {
    return messages(model_with_parameters(parameters));
  });
}

TEST_CASE("a value outside its range is a warning") {
  for (const char* says :
       {"value = 1, min = 2", "value = 3, max = 2", "value = 3, min = 1, max = 2"}) {
    const std::string text =
        model_with_parameters("a = { unit = \"m\", " + std::string(says) + " }\n");
    CHECK(messages(text).substr(0, 4) == "E518");
    CHECK(run_check(text));
  }
}

TEST_CASE("a value that contradicts its assumption is an error") {
  const auto assuming = [](const std::string& value, const std::string& assumption) {
    return messages(model_with_parameters("a = { value = " + value +
                                          ", unit = \"m\", size = \"n\", assume = \"" + assumption +
                                          "\" }\n"));
  };
  CHECK(assuming("0", "positive") ==
        "E112 13:15 `0` is not positive, which `assume` of `a` rules out\n");
  CHECK(assuming("[1, -1, 2]", "nonnegative") ==
        "E112 13:19 `-1` is negative, which `assume` of `a` rules out\n");
  CHECK(assuming("0", "nonnegative").empty());
  CHECK(assuming("1", "positive").empty());
}

TEST_CASE("a fixed value is checked against the declaration, too") {
  const std::string model = model_with_parameters(
      "a = { value = 1, unit = \"m\", assume = \"positive\", min = 1 }\nb = { value = 2, unit = "
      "\"m\", min = 1 }\n");
  const auto fixing = [&](const std::string& option) {
    return messages(model, {.fixed = {option}});
  };
  CHECK(fixing("a=-1") ==
        "E112 1:3 `-1` is not positive, which `assume` of `a` rules out\n"
        "E518 1:3 `-1` is outside `min` or `max` of `a`\n");
  CHECK(fixing("b=1/2") == "E518 1:3 `1/2` is outside `min` or `max` of `b`\n");
  CHECK(fixing("a=2,b").empty());
}

TEST_CASE("an array with more elements than the limit is refused before it is expanded") {
  CHECK(
      messages(model_with_parameters("a = { value = 1, size = \"1000000000\", unit = \"m\" }\n")) ==
      "E907 13:26 1000000000 elements, but the limit is 20000\n");
}

}  // namespace

TEST_CASE("an array with a refused name is one error, and its elements are still read") {
  for (const std::string name : {"int", "pi", "I", "t", "x"}) {
    INFO(name);
    const std::string text = messages(model_with_parameters(
        name + " = { value = 1, size = \"n\", unit = \"m\", min = 0, max = 3 }\n"));
    CHECK(text.find("E20") == 0);
    CHECK(text.find('\n') == text.size() - 1);
  }
}

}  // namespace elgen::test
