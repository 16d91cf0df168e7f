// precision: errors at every point, and conditioning where they are large.
#include "choose/precision.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/exact_number.hpp"
#include "base/random.hpp"
#include "evaluate/rough_errors.hpp"
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

/// The magnitudes of all entries, in the order of the fields; those of a field are alike where the
/// scale is that.
void spread(const Function& function, Scale scale, std::vector<double>& magnitudes) {
  if (scale == Scale::entry) return;
  auto begin = magnitudes.begin();
  for (const Field& field : function.fields) {
    const auto end = begin + static_cast<std::ptrdiff_t>(field.entries.size());
    double largest = 0;
    for (auto at = begin; at != end; ++at) largest = std::max(largest, std::isnan(*at) ? 0 : *at);
    std::fill(begin, end, largest);
    begin = end;
  }
}

/// Whether no entry loses anything at a point. Rounding may be mistaken in the last digits of this,
/// never by a factor of two, as long as the errors are small.
bool keeps_all(const Program& program, const Function& function,
               const std::vector<std::uint32_t>& entries, const Arguments<double>& point,
               Scale scale) {
  const std::vector<RoughError> values = fold<RoughError>(RoughRules{point}, program, function);
  std::vector<double> magnitudes;
  for (const std::uint32_t at : entries) magnitudes.push_back(std::abs(values[at].value));
  spread(function, scale, magnitudes);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (!(values[entries[i]].error <= tolerated_loss / 2 * magnitudes[i])) return false;
  }
  return true;
}

/// Errors of all instructions at one point, and K where it is asked for.
class PointLosses {
 public:
  PointLosses(const Program& program, const Function& function, const Arguments<double>& point)
      : program_(program),
        function_(function),
        values_(fold<Running>(RunningErrorRules{running_leaves(point, Leaves::exact)}, program,
                              function)) {}

  /// |x|; not a number where there is none.
  [[nodiscard]] double magnitude(std::uint32_t at) const {
    const Real& x = values_[at].value;
    return x.is_defined() ? std::abs(ScalarTraits<double>::from_real(x.value()))
                          : std::numeric_limits<double>::quiet_NaN();
  }

  /// 0 where it is negligible, and where there is no value to compare with. `beside` is a magnitude
  /// that counts where it is the larger one.
  [[nodiscard]] double of(std::uint32_t at, double beside) {
    const Running& x = values_[at];
    if (!x.error.is_defined()) return 0;
    const bool is_small = std::isfinite(beside) && magnitude(at) < beside;
    const Real scale = is_small ? Real(exact_value(beside)) : abs(x.value);
    const Real negligible = scale * Real(cln::cl_RA(static_cast<long>(tolerated_loss)));
    if (x.error.value() <= negligible.value()) return 0;
    const Real reference = scale + conditioning().of(at);
    if (!reference.is_defined()) return 0;
    if (cln::zerop(reference.value())) return std::numeric_limits<double>::infinity();
    const double loss = ScalarTraits<double>::from_real((x.error / reference).value());
    return loss <= tolerated_loss ? 0 : loss;
  }

 private:
  const Conditioning& conditioning() {
    if (conditioning_) return *conditioning_;
    return conditioning_.emplace(program_, function_, values_of(values_));
  }

  const Program& program_;
  const Function& function_;
  std::vector<Running> values_;
  std::optional<Conditioning> conditioning_ = {};
};

}  // namespace

ComparisonPoints extreme_points(const Program& program) {
  return DrawnExtremes(program.leaves, angles_of(program)).all();
}

std::vector<double> possible_losses(const Program& program, const Function& function,
                                    const ComparisonPoints& points, Scale scale) {
  const std::vector<std::uint32_t> entries = entries_of(function);
  std::vector<double> losses(entries.size());
  for (const Arguments<double>& point : points) {
    if (keeps_all(program, function, entries, point, scale)) continue;
    PointLosses at_point(program, function, point);
    std::vector<double> magnitudes;
    for (const std::uint32_t at : entries) magnitudes.push_back(at_point.magnitude(at));
    spread(function, scale, magnitudes);
    for (std::size_t i = 0; i < entries.size(); ++i) {
      losses[i] = std::max(losses[i], at_point.of(entries[i], magnitudes[i]));
    }
  }
  return losses;
}

Magnitudes magnitudes_of(const Program& program, const Function& function,
                         const ComparisonPoints& points, Scale scale) {
  Magnitudes magnitudes;
  for (const Arguments<double>& point : points) {
    const PointLosses at_point(program, function, point);
    magnitudes.emplace_back();
    for (const std::uint32_t at : entries_of(function)) {
      magnitudes.back().push_back(at_point.magnitude(at));
    }
    spread(function, scale, magnitudes.back());
  }
  return magnitudes;
}

double possible_loss(const Program& program, const Function& function,
                     const ComparisonPoints& points, const std::vector<double>& beside) {
  const std::vector<std::uint32_t> entries = entries_of(function);
  double loss = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (keeps_all(program, function, entries, points[i], Scale::entry)) continue;
    PointLosses at_point(program, function, points[i]);
    loss = std::max(loss, at_point.of(entries.front(), beside.empty() ? 0 : beside[i]));
  }
  return loss;
}

bool loses_more(double loss, double other, double tolerated) {
  return loss > std::max(tolerated, similar_losses * other);
}

}  // namespace elgen
