// Expressions of random models: trees that the generator builds. They are printed into a model file
// and evaluated here, but never parsed.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "random/jet.hpp"

namespace elgen::test::random {

struct Node;
using Expression = std::shared_ptr<const Node>;  ///< null if the model omits it

enum class NodeKind {
  number,  ///< text: the literal
  pi,
  time,
  index,      ///< text: a variable of `for` or `sum`
  name,       ///< text: coordinate, parameter, input, definition or prescribed function
  component,  ///< text: a point; first: the axis
  speed,      ///< v2(text)
  distance,   ///< dist2(text, other)
  turning,    ///< wx(text) or wx(text, other); first: the axis
  rate,       ///< dot(operand)
  sum,        ///< sum(text, first, second, operand)
  negation,
  addition,
  subtraction,
  multiplication,
  division,
  power,  ///< operand ^ (first/second)
  call,   ///< text: the function
};

struct Node {
  NodeKind kind = NodeKind::number;
  std::string text = {};
  std::string element = {};  ///< array index: a number, or a variable of `for` or `sum`
  std::string other = {};
  int first = 0;
  int second = 1;
  std::vector<Expression> operands = {};
};

/// `name[element]`, or `name` if `element` is empty.
[[nodiscard]] std::string indexed(const std::string& name, const std::string& element);

[[nodiscard]] Expression number(const std::string& literal);
[[nodiscard]] Expression number(int value);
[[nodiscard]] Expression name(const std::string& text, const std::string& element = "");
[[nodiscard]] Expression constant_pi();
[[nodiscard]] Expression time();
[[nodiscard]] Expression component(const std::string& point, int axis,
                                   const std::string& element = "");
[[nodiscard]] Expression rate(Expression operand);
[[nodiscard]] Expression turning(const std::string& frame, const std::string& axes, int axis);
[[nodiscard]] Expression call_of(const std::string& function, std::vector<Expression> arguments);
[[nodiscard]] Expression raised(Expression base, int numerator, int denominator = 1);
[[nodiscard]] Expression sum_over(const std::string& variable, int from, int to, Expression body);
[[nodiscard]] Expression made(Node node);

[[nodiscard]] Expression operator+(Expression a, Expression b);
[[nodiscard]] Expression operator-(Expression a, Expression b);
[[nodiscard]] Expression operator*(Expression a, Expression b);
[[nodiscard]] Expression operator/(Expression a, Expression b);
[[nodiscard]] Expression operator-(Expression a);

/// The text in the model language.
[[nodiscard]] std::string printed(const Expression& expression);

/// True if the expression depends on a name, a point or time.
[[nodiscard]] bool has_names(const Expression& expression);

/// Values of names. Infinitesimal 0 is a change of time; its coefficient in a value is the rate.
class Scope {
 public:
  virtual ~Scope() = default;
  /// The value of `name`, or of `name[element]` if `element`, a number, is not empty.
  virtual Jet value_of(const std::string& name, const std::string& element) = 0;
  virtual Jet component_of(const std::string& point, const std::string& element, int axis) = 0;
  virtual int dimension_of(const std::string& point) = 0;
  virtual Jet now() = 0;
  /// The angular velocity of `frame` along the axes of the frame `axes`; "" means the world.
  virtual Vector turning_of(const std::string& frame, const std::string& axes) = 0;

  std::map<std::string, int> indices;  ///< values of the variables of `for` and `sum`
};

inline constexpr unsigned time_infinitesimal = 0;

[[nodiscard]] Jet evaluated(const Expression& expression, Scope& scope);
[[nodiscard]] Vector evaluated(const std::vector<Expression>& expressions, Scope& scope);

}  // namespace elgen::test::random
