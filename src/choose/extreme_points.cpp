// extreme_points: states and parameters at the extremes, for forms that are chosen for accuracy.
#include <cmath>

#include "choose/points.hpp"
#include "numbers/random.hpp"

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
constexpr Neighbourhood neighbourhoods[]{Neighbourhood::right, Neighbourhood::straight,
                                         Neighbourhood::nearly_equal, Neighbourhood::tiny};

/// Distances. A square of the first is lost in a sum of double precision beside 1.
constexpr double from_right_angles = 1e-8;
constexpr double between_angles = 1e-3;

/// Of more parameters some are left out.
constexpr std::size_t most_parameters = 10;

class DrawnExtremes {
 public:
  DrawnExtremes(const LeafNames& leaves, std::vector<bool> is_angle)
      : leaves_(leaves), is_angle_(std::move(is_angle)) {}

  ComparisonPoints all() {
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
    for (const Neighbourhood place : neighbourhoods) {
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
    const double away = share * from_right_angles;
    if (place == Neighbourhood::nearly_equal) return common + share * between_angles;
    if (place == Neighbourhood::tiny) return away;
    if (place == Neighbourhood::right) return (2 * turns + 1) * right_angle + away;
    return 2 * turns * right_angle + away;
  }

  const LeafNames& leaves_;
  std::vector<bool> is_angle_;
  Random random_{1};
  ComparisonPoints points_ = {};
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

}  // namespace

ComparisonPoints extreme_points(const Program& program) {
  return DrawnExtremes(program.leaves, angles_of(program)).all();
}

}  // namespace elgen
