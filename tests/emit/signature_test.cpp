// signature: lines within their width.
#include "emit/text/signature.hpp"

#include <catch2/catch.hpp>

using elgen::signature;

TEST_CASE("a short signature is one line") {
  CHECK(signature("void f", {"const A&", "const B& b"}, " noexcept") ==
        "void f(const A&, const B& b) noexcept");
}

TEST_CASE("long signatures break between arguments, below the first one where there is room") {
  const std::vector<std::string> arguments = {std::string(32, 'A'), std::string(32, 'B')};
  const std::string start = "[[nodiscard]] Forces<Scalar> gravity";
  CHECK(signature(start, arguments, " noexcept") == start + "(" + arguments[0] + ",\n" +
                                                        std::string(start.size() + 1, ' ') +
                                                        arguments[1] + ") noexcept");
  const std::string wide(70, 'x');
  CHECK(signature(wide, arguments, "") ==
        wide + "(\n    " + arguments[0] + ", " + arguments[1] + ")");
}
