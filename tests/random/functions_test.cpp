// Jets and draws support the functions of the model language. Only the names of the functions come
// from elgen.
#include <catch2/catch.hpp>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "random/generator.hpp"

using namespace elgen::test::random;

namespace {

constexpr double place = 0.375;  ///< every function has a value here
constexpr double other = 2;

struct KnownFunction {
  std::string name;
  std::size_t arity;
  std::optional<double> value;  ///< at `place`; empty if <cmath> lacks the function
};

const std::vector<KnownFunction>& functions() {
  static const std::vector<KnownFunction> all{
#define ELGEN_VALUE_1(name) std::name(place)
#define ELGEN_VALUE_2(name) std::name(place, other)
#define ELGEN_FUNCTION(name, arity) {#name, arity, ELGEN_VALUE_##arity(name)},
#define ELGEN_OWN_FUNCTION(name, arity) {#name, arity, std::nullopt},
#include "elgen/functions.def"
#undef ELGEN_FUNCTION
#undef ELGEN_VALUE_1
#undef ELGEN_VALUE_2
  };
  return all;
}

Jet value_at(const KnownFunction& function, const Jet& x, const Jet& y) {
  return function.arity == 1 ? call(function.name, {x}) : call(function.name, {x, y});
}

/// True if the text calls the function.
bool has_call(const std::string& text, const std::string& function) {
  const std::string called = function + "(";
  for (auto at = text.find(called); at != std::string::npos; at = text.find(called, at + 1)) {
    const bool is_whole = at == 0 || std::isalnum(static_cast<unsigned char>(text[at - 1])) == 0;
    if (is_whole) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("jets support every function and its derivatives") {
  const Number step("1e-20");
  for (const KnownFunction& function : functions()) {
    INFO(function.name);
    const Number x = place;
    const Number y = other;
    const Jet moving = Jet(x) + Jet::infinitesimal(0);
    const Jet result = value_at(function, moving, y);
    if (function.value) {
      CHECK(result.value().convert_to<double>() == Approx(*function.value).epsilon(1e-14));
    }
    const Number difference =
        value_at(function, x + step, y).value() - value_at(function, x - step, y).value();
    CHECK(abs(result.along(0).value() - difference / (2 * step)) < Number("1e-35"));
    if (function.arity == 1 || function.name == "stumpff") continue;  // stumpff: k is a number
    const Number across =
        value_at(function, x, y + step).value() - value_at(function, x, y - step).value();
    const Jet turning = value_at(function, x, Jet(y) + Jet::infinitesimal(0));
    CHECK(abs(turning.along(0).value() - across / (2 * step)) < Number("1e-35"));
  }
}

TEST_CASE("stumpff has the closed forms of sinc, cosc and sinhc") {
  const Number x("0.75");
  const auto stumpff = [&x](int k) { return call("stumpff", {x, k}).value(); };
  CHECK(abs(stumpff(1) - sin(x) / x) < Number("1e-75"));
  CHECK(abs(stumpff(2) - (1 - cos(x)) / (x * x)) < Number("1e-75"));
  CHECK(abs(stumpff(-1) - sinh(x) / x) < Number("1e-75"));
}

// Add a new function to this list if no random model calls it.
TEST_CASE("random models call all functions except these") {
  constexpr std::uint64_t seeds = 300;
  std::string texts;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    const System system = Generator(seed).system();
    texts += text_of(system.model) + text_of(system.scene, system.model);
  }
  std::set<std::string> undrawn;
  for (const KnownFunction& function : functions()) {
    if (!has_call(texts, function.name)) undrawn.insert(function.name);
  }
  CHECK(undrawn == std::set<std::string>{"acos", "asin", "asinh", "atan2", "cosh", "expm1", "hypot",
                                         "log1p", "min", "sinh", "stumpff", "tan"});
}
