// trigonometry_first: angles and their pairs of calls, then all else as it stood.
#include "choose/trigonometry_first.hpp"

#include <array>
#include <map>
#include <optional>

#include "lower/graph/prune.hpp"

namespace elgen {
namespace {

using Places = std::vector<std::uint32_t>;
using SineAndCosine = std::array<std::optional<std::uint32_t>, 2>;

bool is_sine(const Instruction& i) {
  return i.opcode == Opcode::call && i.function == FunctionId::sin;
}

bool is_cosine(const Instruction& i) {
  return i.opcode == Opcode::call && i.function == FunctionId::cos;
}

class Order {
 public:
  explicit Order(const Function& function) : function_(function), placed_(size(), false) {
    Places calls;
    for (std::uint32_t at = 0; at < size(); ++at) {
      const Instruction& i = function.instructions[at];
      if (!is_sine(i) && !is_cosine(i)) continue;
      calls.push_back(at);
      of_angle_[i.a][is_sine(i) ? 0 : 1] = at;
    }
    const std::vector<bool> needed = needed_for(function, calls);
    for (std::uint32_t at = 0; at < size(); ++at) {
      if (needed[at]) place(at);
    }
    for (std::uint32_t at = 0; at < size(); ++at) place(at);
  }

  /// Old numbers in their new order.
  Places places = {};

 private:
  [[nodiscard]] std::size_t size() const { return function_.instructions.size(); }

  void place(std::uint32_t at) {
    const Instruction& i = function_.instructions[at];
    if (!is_sine(i) && !is_cosine(i)) return place_alone(at);
    for (const std::optional<std::uint32_t>& call : of_angle_.at(i.a)) {
      if (call) place_alone(*call);
    }
  }

  void place_alone(std::uint32_t at) {
    if (!placed_[at]) places.push_back(at);
    placed_[at] = true;
  }

  const Function& function_;
  std::vector<bool> placed_;
  std::map<std::uint32_t, SineAndCosine> of_angle_ = {};
};

}  // namespace

Function trigonometry_first(const Function& function) {
  return reordered(function, Order(function).places);
}

}  // namespace elgen
