// Draws random constants and functions.
#include "random/draw.hpp"

#include <stdexcept>

namespace elgen::test::random {

namespace {

class NoNames : public Scope {
  Jet value_of(const std::string& name, const std::string& /*element*/) override {
    throw std::logic_error(name + " in a constant");
  }
  Jet component_of(const std::string& point, const std::string& /*element*/,
                   int /*axis*/) override {
    throw std::logic_error(point + " in a constant");
  }
  int dimension_of(const std::string& /*point*/) override { return 0; }
  Jet now() override { throw std::logic_error("time in a constant"); }
  Vector turning_of(const std::string& frame, const std::string& /*axes*/) override {
    throw std::logic_error(frame + " in a constant");
  }
};

}  // namespace

Number value_of(const Expression& constant) {
  NoNames scope;
  return evaluated(constant, scope).value();
}

Number Draw::dyadic(int reach) {
  const int sixty_fourths = 1 + below(64 * reach);
  return Number(chance(50) ? sixty_fourths : -sixty_fourths) / 64;
}

Expression Draw::rational() {
  static const std::vector<std::string> decimals{"2",   "3",    "0.5",  "0.25", "1.5", "0.3",
                                                 "0.7", "1.25", "0.75", "1.1",  "4",   "0.9"};
  if (chance(20)) return number(1 + below(7)) / number(2 + below(7));
  return number(one_of(decimals));
}

/// A simple irrational number.
Expression Draw::elementary() {
  const Expression small = number(1 + below(3));
  switch (below(9)) {
    case 0:
      return constant_pi();
    case 1:
      return call_of("cos", {small});
    case 2:
      return call_of("sin", {small});
    case 3:
      return call_of("exp", {chance(50) ? small : -small});
    case 4:
      return call_of("log", {number(2 + below(3))});
    case 5:
      return call_of("atan", {number(2 + below(3))});
    case 6:
      return call_of("cos", {rational()});
    default:
      return call_of("sqrt", {number(chance(50) ? 2 : 3)});
  }
}

/// elementary(), or a sum, product, quotient or function of elementary() and rational().
Expression Draw::irrational() {
  const auto part = [&] { return chance(60) ? elementary() : rational(); };
  switch (below(9)) {
    case 0:
      return part() + elementary();
    case 1:
      return part() - elementary();
    case 2:
      return elementary() - part();
    case 3:
      return -elementary();
    case 4:
      return part() * elementary();
    case 5:
      return elementary() / part();
    case 6:
      return call_of(chance(50) ? "cos" : "exp", {-(part() + elementary() / number(4))});
    case 7:
      return constant_pi() / number(2 + below(5));
    default:
      return elementary();
  }
}

Expression Draw::constant() {
  while (true) {
    const Expression drawn = irrational_ && chance(60) ? irrational() : rational();
    const Expression result = chance(20) ? -drawn : drawn;
    const Number size = abs(value_of(result));
    // Rejects sums that cancel, like 2 - 2, and numbers much larger than the numbers of states.
    if (size > Number("0.01") && size < 40) return result;
  }
}

Expression Draw::positive() {
  while (true) {
    const Expression drawn = irrational_ && chance(60) ? irrational() : rational();
    const Number value = value_of(drawn);
    if (value > Number("0.1") && value < 10) return drawn;
    if (value < Number("-0.1") && value > -10) return -drawn;
  }
}

Expression Draw::function_of(const std::vector<Expression>& arguments) {
  const Expression x = one_of(arguments);
  switch (below(12)) {
    case 0:
      return x;
    case 1:
      return raised(x, 2 + below(2));
    case 2:
      return call_of("sin", {constant() * x});
    case 3:
      return call_of("cos", {x + constant()});
    case 4:
      return x * one_of(arguments);
    case 5:
      return call_of("exp", {-raised(x, 2)});
    case 6:
      return call_of("sqrt", {number(1) + raised(x, 2)});
    case 7:
      return call_of("cos", {x - one_of(arguments)});
    case 8:
      return call_of("tanh", {x});
    case 9:
      return number(1) / (number(2) + call_of("sin", {x}));
    case 10:
      return call_of("atan", {x});
    default:
      return call_of(chance(50) ? "sin" : "cos", {x});
  }
}

}  // namespace elgen::test::random
