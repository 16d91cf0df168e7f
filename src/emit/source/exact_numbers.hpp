// exact_numbers: the exact numbers that the doubles of a module approximate, as entries of a
// dictionary.
//
//     0.1                       0.1: (1, 10)
//     1/3*pi                    1.0471975511965976: (1, 3, True)
//     1 and 99999999999999999/10^17, which round to the same double
//                               _number_1 = 1.0, and "_number_1": (99999999999999999, 100000…)
//     1/3, which Python folds into one constant when it loads the module
//                               _number_1 = 3.0, and "_number_1": (3, 1)
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "elgen/model.hpp"
#include "elgen/program.hpp"
#include "elgen/spellings.hpp"

namespace elgen {

/// Several numbers may round to the same double. The number that equals the double keeps the
/// literal; if no number equals the double, the first number keeps the literal. Each other constant
/// gets a name; each other parameter value gets an entry "p.m". If an operation has two constants,
/// the second also gets a name, to prevent constant folding.
class ExactNumbers {
 public:
  /// named_numbers() and dictionary_entries() are empty if `spelling` has no names for numbers.
  ExactNumbers(const Model& model, const Program& program, const SourceSpelling& spelling);

  /// "_number_1": the name of a constant or of its negative; "" if the constant is a literal.
  [[nodiscard]] std::string name_of(const Constant& constant) const;

  /// The names with their doubles.
  [[nodiscard]] const std::vector<std::pair<std::string, double>>& named_numbers() const {
    return named_numbers_;
  }
  [[nodiscard]] const std::vector<std::string>& dictionary_entries() const { return entries_; }

 private:
  struct Number {
    std::string digits = {};   ///< of the magnitude, 60 digits; equal texts mean equal numbers
    std::string text = {};     ///< in its dictionary entry; "" if it is a double
    bool is_constant = false;  ///< loaded by a function
    bool is_folded = false;    ///< the language would fold it with another literal
    std::string name = {};
  };

  /// Adds a number, or replaces the decimal text of an equal known number by a fraction.
  void add(const Constant& constant, bool is_executed);
  void mark_folded_constants(const Program& program);
  void name_numbers(const SourceSpelling& spelling);
  void add_parameter(const std::string& name, const cln::cl_R& value);

  /// double -> the numbers that round to this double. The first number keeps the literal.
  std::map<double, std::vector<Number>> numbers_ = {};
  std::vector<std::pair<std::string, double>> named_numbers_ = {};
  std::vector<std::string> entries_ = {};
};

}  // namespace elgen
