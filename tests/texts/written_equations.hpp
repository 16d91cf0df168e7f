// WrittenEquations: equations in the model language, as people read them, compared by value with
// the Program's at a few states inside the declared ranges.
//
//     -m*l*sin(theta)   against entry 1 of gravity, in 64 digits
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

namespace elgen::texts {

/// The system that the texts are about.
struct Origin {
  const Model& model;
  const Scene& scene;
  const Program& program;
};

class WrittenEquations {
 public:
  explicit WrittenEquations(const Origin& origin);

  [[nodiscard]] const Origin& origin() const { return origin_; }

  /// From now on equations are those of functions[index], and no definition is known.
  void start(std::size_t index);

  /// No part is known from now on, nor the value of any text.
  void forget_parts();

  // The mistake in an equation; empty where there is none.
  /// "force_link7_3 = m7*…", over leaves and earlier parts: all functions may use it.
  [[nodiscard]] std::string part(const std::string& name, const std::string& text);
  /// "t_1 = m*l": a named instruction, which later equations may use.
  [[nodiscard]] std::string definition(const std::string& name, const std::string& text);
  [[nodiscard]] std::string entry(std::uint32_t instruction, const std::string& text);
  [[nodiscard]] std::string number(const cln::cl_R& value, const std::string& text);
  /// Of a text that has these values, one for each of the states(), whose terms are so large.
  [[nodiscard]] std::string values(const std::vector<Real>& derived,
                                   const std::vector<Real>& largest, const std::string& text);

  /// Where equations are compared.
  [[nodiscard]] const std::vector<Arguments<Real>>& states() const { return states_; }

  [[nodiscard]] const Function& function() const { return origin_.program.functions[index_]; }

 private:
  /// Values of a text at all states, and the definitions in it.
  struct Evaluated {
    std::string problem = {};
    std::vector<Real> values = {};
    std::set<std::string> used = {};
  };
  /// A function of the program, evaluated when an equation of it is met.
  struct Known {
    bool is_evaluated = false;
    std::vector<std::vector<Real>> instructions = {};  ///< by state
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
  std::vector<std::unordered_map<std::string, Real>> leaves_ = {};  ///< by state
  std::vector<std::unordered_map<std::string, Real>> parts_ = {};   ///< likewise
  std::vector<Known> known_;
  std::set<std::string> defined_ = {};
  std::size_t index_ = 0;
  std::size_t state_ = 0;
};

}  // namespace elgen::texts
