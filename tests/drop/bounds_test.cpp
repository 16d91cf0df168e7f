// Bounds over the ranges of a model.
#include "drop/bounds.hpp"

#include <catch2/catch.hpp>

#include "support/models.hpp"

using namespace elgen;
using namespace elgen::test;
using cln::cl_RA;

namespace {

const std::string declarations_with_ranges = R"toml([[coordinate]]
name = "x"
range = [-3, 1]
rate_range = [-2, 5]
[[coordinate]]
name = "y"
[parameters]
m = 2
k = { value = 3, min = 1, max = 4 }
n = -5
[energy]
T = "1/2*m*(dot(x)^2 + dot(y)^2)"
[[expect]]
potential_energy = ")toml";

/// A form of the model language and its model.
struct Sample {
  explicit Sample(const std::string& expression)
      : model(checked_model(model_text("line", declarations_with_ranges + expression + "\"\n"))
                  .model),
        form(closed_form(forms, model, {}, model.expectations[0].entries[0]).value()) {}

  Model model;
  ClosedForms forms;
  Fraction form;

  [[nodiscard]] std::optional<Enclosure> bound() const {
    return RangeBounds(forms.algebra, model).of(form);
  }
  [[nodiscard]] std::string missing() const {
    RangeBounds bounds(forms.algebra, model);
    CHECK_FALSE(bounds.of(form));
    return bounds.missing().message;
  }
};

bool lies_in(const std::string& expression, const cl_RA& low, const cl_RA& high) {
  const auto bound = Sample(expression).bound();
  return bound && bound->low == low && bound->high == high;
}

}  // namespace

TEST_CASE("leaves lie in their ranges") {
  CHECK(lies_in("x", -3, 1));
  CHECK(lies_in("dot(x)", -2, 5));
  CHECK(lies_in("m", 2, 2));
  CHECK(lies_in("k", 1, 4));
  CHECK(lies_in("n*k", -20, -5));
  CHECK(lies_in("m*x^2", 0, 18));
  CHECK(lies_in("x - dot(x)", -8, 3));
}

TEST_CASE("sines and cosines are at most 1") {
  CHECK(lies_in("m*x*cos(y)", -6, 6));
  CHECK(lies_in("cos(y)^2", 0, 1));
  CHECK(lies_in("k + m*sin(x + y)", -1, 6));
}

TEST_CASE("denominators need a bound from below") {
  CHECK(lies_in("x/k", -3, 1));
  CHECK(lies_in("1/(m + k)", cl_RA(1) / 6, cl_RA(1) / 3));
  CHECK(lies_in("1/(m + cos(y))", cl_RA(1) / 3, 1));
  CHECK(Sample("1/(1 + cos(y))").missing() == "a denominator may be 0 within the declared ranges");
  CHECK(Sample("1/x").missing() == "a denominator may be 0 within the declared ranges");
}

TEST_CASE("roots and bounded functions") {
  const auto root = Sample("sqrt(m + k)").bound();
  REQUIRE(root);
  CHECK(root->high * root->high >= 6);
  CHECK(root->high < cl_RA(5) / 2);
  CHECK(lies_in("tanh(x/m)", -1, 1));
  CHECK(lies_in("atan(x)", cl_RA(-11) / 7, cl_RA(11) / 7));
  CHECK(lies_in("acos(x/9)", cl_RA(-22) / 7, cl_RA(22) / 7));
  CHECK(Sample("exp(x)").missing() == "`drop_below` has no bound of `exp`");
}

TEST_CASE("what has no range is named") {
  CHECK(Sample("y*m").missing() == "`drop_below` needs the `range` of `y`");
  CHECK(Sample("dot(y)").missing() == "`drop_below` needs the `rate_range` of `y`");
}

TEST_CASE("conjugate exponentials are one term") {
  const Sample sample("m + k*cos(y)^2 + x*sin(y)");
  CHECK(terms_of(sample.forms.algebra, sample.form).size() == 4);
  RangeBounds bounds(sample.forms.algebra, sample.model);
  const auto terms = bounds.of_terms(sample.form);
  REQUIRE(terms);
  CHECK(terms->largest == 3);
  CHECK(terms->together == 9);
}
