// precision: errors at every point, and conditioning where they are large.
#include "choose/precision.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/random.hpp"
#include "evaluate/running_errors.hpp"
#include "lower/graph/prune.hpp"

namespace elgen {
namespace {

constexpr double right_angle = 1.5707963267948966;

/// Where the coordinates are that sines are taken of; others are of ordinary magnitude, or small
/// where those are tiny.
enum class Neighbourhood : std::uint8_t { right, straight, nearly_equal, tiny };

/// The binary logarithms of magnitudes, and of what one parameter after another is multiplied by.
constexpr int wide = 26;
constexpr int ordinary = 3;
constexpr int ratios[]{40, -40, 15};

constexpr int ordinary_points = 3;
constexpr int wide_points = 5;

/// Of more parameters some are left out.
constexpr std::size_t most_parameters = 10;

class Points {
 public:
  Points(const LeafNames& leaves, std::vector<bool> is_angle)
      : leaves_(leaves), is_angle_(std::move(is_angle)) {}

  ExtremePoints all() {
    for (int i = 0; i < ordinary_points; ++i) points_.push_back(drawn(ordinary));
    for (int i = 0; i < wide_points; ++i) points_.push_back(drawn(wide));
    const std::size_t count = leaves_.parameters.size();
    const std::size_t step = (count + most_parameters - 1) / most_parameters;
    for (std::size_t parameter = 0; parameter < count; parameter += step) {
      for (const int ratio : ratios) add_extremes(parameter, ratio);
    }
    return std::move(points_);
  }

 private:
  Arguments<double> drawn(int magnitudes) {
    Arguments<double> point =
        draw_leaves(leaves_, [&] { return random_.log_uniform(-magnitudes, magnitudes); });
    for (double& p : point.parameters) p = std::abs(p);
    return point;
  }

  void add_extremes(std::size_t parameter, int ratio) {
    for (const Neighbourhood place : {Neighbourhood::right, Neighbourhood::straight,
                                      Neighbourhood::nearly_equal, Neighbourhood::tiny}) {
      Arguments<double> point = drawn(ordinary);
      point.parameters[parameter] = std::ldexp(point.parameters[parameter], ratio);
      add(place, std::move(point));
    }
  }

  void add(Neighbourhood place, Arguments<double> point) {
    const double common = random_.uniform(-3, 3);
    for (std::size_t i = 0; i < point.q.size(); ++i) {
      const double length = random_.log_uniform(-wide, -ordinary);
      if (is_angle_[i]) point.q[i] = angle(place, common);
      if (!is_angle_[i] && place == Neighbourhood::tiny) point.q[i] = length;
    }
    points_.push_back(std::move(point));
  }

  double angle(Neighbourhood place, double common) {
    const double sign = random_.uniform(-1, 1) < 0 ? -1 : 1;
    const double share = sign * random_.uniform(0.5, 1);
    const double turns = std::floor(random_.uniform(-1, 2));
    if (place == Neighbourhood::nearly_equal) return common + share * 1e-3;
    if (place == Neighbourhood::tiny) return share * 1e-8;
    if (place == Neighbourhood::right) return (2 * turns + 1) * right_angle + share * 1e-8;
    return 2 * turns * right_angle + share * 1e-8;
  }

  const LeafNames& leaves_;
  std::vector<bool> is_angle_;
  Random random_{1};
  ExtremePoints points_ = {};
};

/// By coordinate, whether a sine or cosine is taken of it somewhere.
std::vector<bool> angles_of(const Program& program) {
  std::vector<bool> is_angle(program.leaves.q.size());
  for (const Function& function : program.functions) {
    std::vector<std::uint32_t> arguments;
    for (const Instruction& i : function.instructions) {
      if (i.opcode == Opcode::call && is_circular(i.function)) arguments.push_back(i.a);
    }
    const std::vector<bool> needed = needed_for(function, arguments);
    for (std::size_t at = 0; at < needed.size(); ++at) {
      const Instruction& i = function.instructions[at];
      if (needed[at] && i.opcode == Opcode::coordinate) is_angle[i.a] = true;
    }
  }
  return is_angle;
}

/// A value and its error in double: where nothing is lost they tell as much as exact ones do.
struct RoughError {
  double value = std::numeric_limits<double>::quiet_NaN();
  double error = std::numeric_limits<double>::quiet_NaN();
};

/// The rules of running errors (evaluate/running_errors.hpp) in double.
struct RoughRules {
  const Arguments<double>& point;

  [[nodiscard]] RoughError constant(const Constant& constant) const {
    const double value = ScalarTraits<double>::from_real(constant.value);
    return {value, std::abs(value)};
  }
  [[nodiscard]] RoughError leaf(Opcode kind, std::uint32_t number) const {
    return {leaf_of(point, kind, number), 0};
  }
  [[nodiscard]] RoughError negate(const RoughError& x) const { return {-x.value, x.error}; }
  [[nodiscard]] RoughError add(const RoughError& x, const RoughError& y) const {
    const double value = x.value + y.value;
    return {value, x.error + y.error + std::abs(value)};
  }
  [[nodiscard]] RoughError subtract(const RoughError& x, const RoughError& y) const {
    return add(x, negate(y));
  }
  [[nodiscard]] RoughError multiply(const RoughError& x, const RoughError& y) const {
    const double value = x.value * y.value;
    return {value, x.error * std::abs(y.value) + y.error * std::abs(x.value) + std::abs(value)};
  }
  [[nodiscard]] RoughError divide(const RoughError& x, const RoughError& y) const {
    const double value = x.value / y.value;
    return {value, (x.error + std::abs(value) * y.error) / std::abs(y.value) + std::abs(value)};
  }
  [[nodiscard]] RoughError square_root(const RoughError& x) const {
    const double value = std::sqrt(x.value);
    return {value, x.error / (value + value) + value};
  }
  /// Slopes of sines are at most 1; of other functions nothing is told.
  [[nodiscard]] RoughError call(FunctionId function, const RoughError& x, const RoughError&) const {
    if (!is_circular(function)) return {};
    const double value = function == FunctionId::sin ? std::sin(x.value) : std::cos(x.value);
    return {value, x.error + std::abs(value)};
  }
};

/// Whether no entry loses anything at a point. Rounding may be mistaken in the last digits of this,
/// never by a factor of two, as long as the errors are small.
bool keeps_all(const Program& program, const Function& function,
               const std::vector<std::uint32_t>& entries, const Arguments<double>& point) {
  const std::vector<RoughError> values = fold<RoughError>(RoughRules{point}, program, function);
  return std::ranges::all_of(entries, [&](std::uint32_t at) {
    return values[at].error <= tolerated_loss / 2 * std::abs(values[at].value);
  });
}

/// Errors of all instructions at one point, and K where it is asked for.
class PointLosses {
 public:
  PointLosses(const Program& program, const Function& function, const Arguments<double>& point)
      : program_(program),
        function_(function),
        values_(fold<Running>(RunningErrorRules{running_leaves(point, Leaves::exact)}, program,
                              function)) {}

  /// 0 where it is negligible, and where there is no value to compare with.
  [[nodiscard]] double of(std::uint32_t at) {
    const Running& x = values_[at];
    if (!x.error.is_defined()) return 0;
    const Real negligible = abs(x.value) * Real(cln::cl_RA(static_cast<long>(tolerated_loss)));
    if (x.error.value() <= negligible.value()) return 0;
    const Real reference = conditioning().reference(at);
    if (!reference.is_defined()) return 0;
    if (cln::zerop(reference.value())) return std::numeric_limits<double>::infinity();
    const double loss = ScalarTraits<double>::from_real((x.error / reference).value());
    return loss <= tolerated_loss ? 0 : loss;
  }

 private:
  const Conditioning& conditioning() {
    if (conditioning_) return *conditioning_;
    return conditioning_.emplace(program_, function_, values_of(values_), rounding<double>(),
                                 Literals::not_binary);
  }

  const Program& program_;
  const Function& function_;
  std::vector<Running> values_;
  std::optional<Conditioning> conditioning_ = {};
};

}  // namespace

ExtremePoints extreme_points(const Program& program) {
  return Points(program.leaves, angles_of(program)).all();
}

std::vector<double> possible_losses(const Program& program, const Function& function,
                                    const ExtremePoints& points) {
  const std::vector<std::uint32_t> entries = entries_of(function);
  std::vector<double> losses(entries.size());
  for (const Arguments<double>& point : points) {
    if (keeps_all(program, function, entries, point)) continue;
    PointLosses at_point(program, function, point);
    for (std::size_t i = 0; i < entries.size(); ++i) {
      losses[i] = std::max(losses[i], at_point.of(entries[i]));
    }
  }
  return losses;
}

bool loses_more(double loss, double other) {
  return loss > std::max(tolerated_loss, similar_losses * other);
}

}  // namespace elgen
