// Templates are found by their paths, and name others of their folder.
#include "elgen/templates.hpp"

#include <catch2/catch.hpp>
#include <stdexcept>

namespace elgen {

TEST_CASE("a template that is not there is empty, or a mistake of elgen") {
  CHECK(template_at("cpp/kinked.hpp.mustache") == embedded_template("cpp/kinked.hpp.mustache"));
  CHECK(embedded_template("cpp/none.mustache").empty());
  CHECK_THROWS_AS(template_at("cpp/none.mustache"), std::logic_error);
}

TEST_CASE("a template names others of its folder and language") {
  CHECK(template_beside("cpp/header.hpp.mustache", "kinked") == "cpp/kinked.hpp.mustache");
  CHECK(template_beside("c99/header.h.mustache", "function") == "c99/function.h.mustache");
}

}  // namespace elgen
