// coupling_of: chains of mimics, whose ratios multiply.
#include <catch2/catch.hpp>

#include "urdf/urdf_testing.hpp"

namespace elgen::test {

using Catch::Contains;

namespace {

std::string hinge(const std::string& name, const std::string& child, const std::string& inside) {
  return "<joint name=\"" + name + "\" type=\"revolute\"><parent link=\"base\"/><child link=\"" +
         child + "\"/><axis xyz=\"0 0 1\"/>" + inside + "</joint>\n";
}

/// The finger `k` mimics `b`, which mimics `a`.
std::string mimic_chain(const std::string& of_k, const std::string& of_b) {
  return imported(with_arm("<link name=\"l\"/><link name=\"f\"/>" +
                           hinge("k", "f", "<mimic joint=\"b\" " + of_k + "/>") +
                           hinge("b", "l", "<mimic joint=\"a\" " + of_b + "/>") +
                           hinge("a", "arm", "")));
}

}  // namespace

TEST_CASE("the ratios of a chain of mimics multiply, its offsets come with them") {
  const std::string model =
      mimic_chain("multiplier=\"2\" offset=\"0.1\"", "multiplier=\"3\" offset=\"0.2\"");
  CHECK_THAT(model, Contains("\"ratio_k*ratio_b*a + ratio_k*offset_b + offset_k\"]]"));
  CHECK_THAT(model, Contains("\"ratio_b*a + offset_b\"]]"));
  CHECK(model.find("ratio_b ") == model.rfind("ratio_b "));
  CHECK(after(model, "#     f    ") == "k, revolute like b");
}

TEST_CASE("signs of a chain stay signs") {
  CHECK_THAT(mimic_chain("multiplier=\"-1\"", "multiplier=\"-1\""),
             Contains("rotate = [[\"z\", \"a\"]]"));
  CHECK_THAT(mimic_chain("multiplier=\"2\"", "multiplier=\"-1\""), Contains("\"-ratio_k*a\"]]"));
  CHECK_THAT(mimic_chain("multiplier=\"-1\"", "multiplier=\"2\""), Contains("\"-ratio_b*a\"]]"));
}

TEST_CASE("a chain brakes the coordinate at its end") {
  const std::string model = imported(
      with_arm("<link name=\"l\"/><link name=\"f\"/>" +
               hinge("k", "f", "<mimic joint=\"b\" multiplier=\"2\"/><dynamics damping=\"0.5\"/>") +
               hinge("b", "l", "<mimic joint=\"a\" multiplier=\"3\"/>") + hinge("a", "arm", "")));
  CHECK_THAT(model, Contains("1/2*damping_k*(ratio_k*ratio_b*dot(a))^2"));
}

}  // namespace elgen::test
