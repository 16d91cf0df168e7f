// scaled_length: written out instruction by instruction, with those of the function that are the
// same.
#include "choose/scaled_length.hpp"

#include <algorithm>
#include <utility>

#include "elgen/model.hpp"
#include "lower/graph/prune.hpp"
#include "lower/network/instructions.hpp"

namespace elgen {
namespace {

class Scaling {
 public:
  explicit Scaling(Function& function) : function_(function), instructions_(function) {}

  void scale(Field& field) {
    for (std::size_t i = 0; i < field.entries.size();) {
      const Opcode opcode = function_.instructions[field.entries[i]].opcode;
      if (opcode == Opcode::coordinate) {
        ++i;
        continue;
      }
      const std::vector<std::uint32_t> unit = unit_quaternion(static_cast<std::uint32_t>(i));
      std::copy(unit.begin(), unit.end(), field.entries.begin() + static_cast<std::ptrdiff_t>(i));
      i += quaternion_size;
    }
  }

 private:
  std::uint32_t sum(const std::vector<std::uint32_t>& terms) {
    std::uint32_t result = terms[0];
    for (std::size_t i = 1; i < terms.size(); ++i)
      result = instructions_.add(Opcode::add, result, terms[i]);
    return result;
  }

  /// Its scalar part is coordinate `first`.
  std::vector<std::uint32_t> unit_quaternion(std::uint32_t first) {
    std::vector<std::uint32_t> values;
    std::vector<std::uint32_t> magnitudes;
    for (std::uint32_t i = 0; i < quaternion_size; ++i) {
      values.push_back(instructions_.add(Opcode::coordinate, first + i));
      magnitudes.push_back(instructions_.add(
          {.opcode = Opcode::call, .function = FunctionId::abs, .a = values.back()}));
    }
    const std::uint32_t size = sum(magnitudes);
    std::vector<std::uint32_t> squares;
    for (std::uint32_t& value : values) {
      value = instructions_.add(Opcode::divide, value, size);
      squares.push_back(instructions_.add(Opcode::multiply, value, value));
    }
    const std::uint32_t length = instructions_.add(Opcode::square_root, sum(squares));
    for (std::uint32_t& value : values) value = instructions_.add(Opcode::divide, value, length);
    return values;
  }

  Function& function_;
  Instructions instructions_;
};

}  // namespace

Function with_scaled_lengths(Function function, const std::string& name) {
  for (Field& field : function.fields) {
    const bool is_normalized = function.kind == OutputKind::normalized || field.name == name;
    if (is_normalized) Scaling(function).scale(field);
  }
  return pruned(function);
}

}  // namespace elgen
