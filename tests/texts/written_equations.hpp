// WrittenEquations: printed equations in the model language, compared by value with the Program's
// equations at a few states inside the declared ranges.
//
//     -m*l*sin(theta)   against entry 1 of gravity, with 64 digits
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "elgen/evaluate.hpp"
#include "elgen/model.hpp"
#include "elgen/scene.hpp"
#include "elgen/syntax.hpp"

namespace elgen::test {

/// The system that the texts describe.
struct Origin {
  const Model& model;
  const Scene& scene;
  const Program& program;
};

class WrittenEquations {
 public:
  explicit WrittenEquations(const Origin& origin);

  [[nodiscard]] const Origin& origin() const { return origin_; }

  /// Starts the equations of functions[index], and forgets all definitions.
  void start(std::size_t index);

  /// Forgets all shared parts and the values of all texts.
  void clear_parts();

  // These functions return the mistake in an equation, empty if there is none.
  /// "force_link7_3 = m7*…": a part in leaves and earlier parts, which all functions may use.
  [[nodiscard]] std::string part(const std::string& name, const std::string& text);
  /// "t_1 = m*l": a named instruction that later equations may use.
  [[nodiscard]] std::string definition(const std::string& name, const std::string& text);
  [[nodiscard]] std::string entry(std::uint32_t instruction, const std::string& text);
  [[nodiscard]] std::string number(const cln::cl_R& value, const std::string& text);
  /// Compares `text` with `derived`, relative to the largest terms `largest`: one value per state.
  [[nodiscard]] std::string values(const std::vector<Real>& derived,
                                   const std::vector<Real>& largest, const std::string& text);

  /// The states at which equations are compared.
  [[nodiscard]] const std::vector<Arguments<Real>>& states() const { return states_; }

  [[nodiscard]] const Function& function() const { return origin_.program.functions[index_]; }

 private:
  /// The values of a text at all states, and the definitions that it uses.
  struct Evaluated {
    std::string problem = {};
    std::vector<Real> values = {};
    std::set<std::string> used = {};
  };
  /// A function of the program, evaluated when its first equation is read.
  struct Known {
    bool is_evaluated = false;
    std::vector<std::vector<Real>> instructions = {};  ///< [state][instruction]
    std::vector<Real> largest = {};
    std::unordered_map<std::string, std::uint32_t> named = {};
    std::unordered_map<std::string, Evaluated> texts = {};
  };

  struct Rules;

  const Evaluated& evaluated(const std::string& text);
  [[nodiscard]] std::string compare(std::uint32_t instruction, const std::string& text);
  [[nodiscard]] Real value(const ExpressionSyntax& e, Evaluated& result) const;
  [[nodiscard]] Real named(const std::string& name, Evaluated& result) const;

  Origin origin_;
  std::vector<Arguments<Real>> states_;
  std::vector<std::unordered_map<std::string, Real>> leaves_ = {};  ///< one map per state
  std::vector<std::unordered_map<std::string, Real>> parts_ = {};   ///< one map per state
  std::vector<Known> known_;
  std::set<std::string> defined_ = {};
  std::size_t index_ = 0;
  std::size_t state_ = 0;
};

}  // namespace elgen::test
