// A list of maps, and one way to apply them: nothing below asks which convention it has.
#include "verify/foreign/conventions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "elgen/outputs.hpp"
#include "elgen/real.hpp"

namespace elgen {
namespace {

using cln::cl_R;
using Eigen::MatrixXi;
using Numbers = std::vector<cl_R>;

/// Pairs of more than eight coordinates take the oracle minutes.
constexpr std::size_t most_conventions = 300;
constexpr std::size_t most_coordinates = 16;
constexpr Eigen::Index most_permuted = 3;

Convention identity(const Model& model) {
  // Components of a quaternion mean nothing one by one.
  const bool is_small = model.rotations.empty() && model.coordinates.size() <= most_coordinates;
  const auto n = is_small ? static_cast<Eigen::Index>(model.coordinates.size()) : 0;
  const auto inputs = static_cast<Eigen::Index>(model.inputs.size());
  return {"", MatrixXi::Identity(n, n), MatrixXi::Identity(n, n), Eigen::VectorXi::Zero(n),
          MatrixXi::Identity(inputs, inputs)};
}

/// `b`, then `a`.
Convention both(const Convention& a, const Convention& b) {
  return {a.name + ", " + b.name, a.S * b.S, b.inverse * a.inverse,
          a.S * b.half_turns + a.half_turns, a.U * b.U};
}

/// For each coordinate and input the choices of its direction and its zero.
std::vector<std::vector<Convention>> choices(const Model& model) {
  const Convention same = identity(model);
  std::vector<std::vector<Convention>> all;
  for (Eigen::Index i = 0; i < same.S.rows(); ++i) {
    const Coordinate& coordinate = model.coordinates[static_cast<std::size_t>(i)];
    Convention mirror = same;
    mirror.name = fmt::format("its `{0}` is `-{0}`", coordinate.name);
    mirror.S(i, i) = mirror.inverse(i, i) = -1;
    Convention turn = same;
    turn.name = fmt::format("its `{0}` is `{0} + pi`", coordinate.name);
    turn.half_turns(i) = 1;
    Convention opposite = both(turn, mirror);
    opposite.name = fmt::format("its `{0}` is `pi - {0}`", coordinate.name);
    all.push_back({mirror});
    if (is_angle(coordinate)) all.back() = {mirror, turn, opposite};
  }
  for (Eigen::Index i = 0; i < same.U.rows(); ++i) {
    Convention reversed = same;
    reversed.name =
        fmt::format("its `{0}` is `-{0}`", model.inputs[static_cast<std::size_t>(i)].name);
    reversed.U(i, i) = -1;
    all.push_back({reversed});
  }
  return all;
}

/// Each angle from the one before, where ours are from one direction, and the other way round.
void add_relative_angles(const Model& model, std::vector<Convention>& all) {
  Convention relative = identity(model);
  relative.name = "each of its angles is ours less the one before";
  std::vector<Eigen::Index> angles;
  for (Eigen::Index i = 0; i < relative.S.rows(); ++i) {
    if (!is_angle(model.coordinates[static_cast<std::size_t>(i)])) continue;
    if (!angles.empty()) relative.S(i, angles.back()) = -1;
    for (const Eigen::Index before : angles) relative.inverse(i, before) = 1;
    angles.push_back(i);
  }
  if (angles.size() < 2) return;
  all.push_back(relative);
  std::swap(relative.S, relative.inverse);
  relative.name = "each of its angles is the sum of ours up to it";
  all.push_back(relative);
}

void add_orders(const Model& model, std::vector<Convention>& all) {
  const Convention same = identity(model);
  if (same.S.rows() > most_permuted) return;
  std::vector<Eigen::Index> order(static_cast<std::size_t>(same.S.rows()));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  while (std::ranges::next_permutation(order).found) {
    Convention permuted = same;
    permuted.name = "the order of its coordinates is";
    for (std::size_t i = 0; i < order.size(); ++i) {
      permuted.S.row(static_cast<Eigen::Index>(i)) = same.S.row(order[i]);
      const std::string& name = model.coordinates[static_cast<std::size_t>(order[i])].name;
      permuted.name += fmt::format("{} `{}`", i == 0 ? "" : ",", name);
    }
    permuted.inverse = permuted.S.transpose();
    all.push_back(permuted);
  }
}

/// The map times each block of rows of X that has its size; the empty map leaves X as it is.
Numbers times(const MatrixXi& map, const Numbers& x, std::size_t columns = 1) {
  const auto n = static_cast<std::size_t>(map.rows());
  if (n == 0) return x;
  Numbers y(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    const std::size_t row = i / columns;
    for (std::size_t j = 0; j < n; ++j) {
      const int factor = map(static_cast<Eigen::Index>(row % n), static_cast<Eigen::Index>(j));
      if (factor == 0) continue;
      y[i] = y[i] + factor * x[(row - row % n + j) * columns + i % columns];
    }
  }
  return y;
}

/// x + sign pi c.
Numbers turned(const Convention& convention, Numbers x, int sign) {
  const cl_R pi = (Real(4) * atan(Real(1))).value();
  for (Eigen::Index i = 0; i < convention.half_turns.rows(); ++i) {
    cl_R& angle = x[static_cast<std::size_t>(i)];
    if (convention.half_turns(i) != 0) angle = angle + sign * convention.half_turns(i) * pi;
  }
  return x;
}

Numbers transposed(const Numbers& x, std::size_t columns) {
  const std::size_t rows = x.size() / columns;
  Numbers y(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) y[i % columns * rows + i / columns] = x[i];
  return y;
}

/// The map of rows or columns; entries that follow coordinates change as velocities do, or as
/// forces.
MatrixXi map_of(const Convention& convention, Extent extent, bool as_velocities) {
  if (extent == Extent::inputs) return convention.U;
  const bool is_of_coordinates =
      extent == Extent::coordinates || extent == Extent::velocities || extent == Extent::states;
  if (!is_of_coordinates) return {};
  return as_velocities ? convention.S : convention.inverse.transpose();
}

}  // namespace

std::vector<Convention> conventions(const Model& model) {
  const auto single = choices(model);
  std::vector<Convention> all;
  for (const auto& some : single) all.insert(all.end(), some.begin(), some.end());
  add_relative_angles(model, all);
  add_orders(model, all);
  for (std::size_t i = 0; i < single.size() && all.size() < most_conventions; ++i) {
    for (std::size_t j = i + 1; j < single.size(); ++j) {
      for (const Convention& a : single[i]) {
        for (const Convention& b : single[j]) all.push_back(both(a, b));
      }
    }
  }
  return all;
}

State our_state(const Convention& convention, State theirs) {
  theirs.q = times(convention.inverse, turned(convention, theirs.q, -1));
  theirs.v = times(convention.inverse, theirs.v);
  theirs.a = times(convention.inverse, theirs.a);
  theirs.momenta = times(convention.S.transpose(), theirs.momenta);
  theirs.u = times(convention.U, theirs.u);
  return theirs;
}

std::vector<cl_R> their_values(const Convention& convention, OutputKind output,
                               const ForeignField& field, const std::vector<cl_R>& ours) {
  const FieldRow& row = *field.row;
  const bool is_rate = output_row(output).solves || row.unit == UnitRule::row ||
                       row.unit == UnitRule::row_per_second;
  Numbers values = times(map_of(convention, row.rows, is_rate), ours, field.columns);
  const bool is_place = row.rows == Extent::coordinates && row.unit == UnitRule::row;
  if (is_place) values = turned(convention, values, 1);
  const MatrixXi of_columns = map_of(convention, row.columns, false);
  values = times(of_columns, transposed(values, field.columns), field.rows);
  return transposed(values, field.rows);
}

}  // namespace elgen
