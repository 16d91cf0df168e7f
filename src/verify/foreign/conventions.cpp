// Lists the conventions, and applies their maps to states and to values of fields.
#include "verify/foreign/conventions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "elgen/outputs.hpp"
#include "elgen/real.hpp"
#include "model/requests.hpp"

namespace elgen {
namespace {

using cln::cl_R;
using RealNumbers = std::vector<cl_R>;

/// Each convention costs one evaluation by the oracle per state. All pairs of more than eight
/// coordinates would take minutes.
constexpr std::size_t most_conventions = 300;
constexpr std::size_t most_coordinates = 16;
constexpr std::size_t max_permuted_coordinates = 3;

IntegerMatrix identity_matrix(std::size_t size) {
  IntegerMatrix result{size, std::vector<int>(size * size)};
  for (std::size_t i = 0; i < size; ++i) result.at(i, i) = 1;
  return result;
}

IntegerMatrix compose_permutations(const IntegerMatrix& a, const IntegerMatrix& b) {
  IntegerMatrix result{a.size, std::vector<int>(a.entries.size())};
  for (std::size_t i = 0; i < a.size; ++i) {
    for (std::size_t j = 0; j < a.size; ++j) {
      for (std::size_t k = 0; k < a.size; ++k) result.at(i, j) += a.at(i, k) * b.at(k, j);
    }
  }
  return result;
}

IntegerMatrix transpose(const IntegerMatrix& a) {
  IntegerMatrix result = a;
  for (std::size_t i = 0; i < a.size; ++i) {
    for (std::size_t j = 0; j < a.size; ++j) result.at(i, j) = a.at(j, i);
  }
  return result;
}

Convention identity_convention(const Model& model) {
  // For rotations no map is tried, because a single component of a quaternion has no meaning.
  const bool is_small = model.rotations.empty() && model.coordinates.size() <= most_coordinates;
  const std::size_t n = is_small ? model.coordinates.size() : 0;
  return {"", identity_matrix(n), identity_matrix(n), std::vector<int>(n),
          identity_matrix(model.inputs.size())};
}

/// The convention that applies `b` first, then `a`.
Convention compose_conventions(const Convention& a, const Convention& b) {
  std::vector<int> half_turns = a.half_turns;
  for (std::size_t i = 0; i < half_turns.size(); ++i) {
    for (std::size_t j = 0; j < half_turns.size(); ++j) {
      half_turns[i] += a.S.at(i, j) * b.half_turns[j];
    }
  }
  return {a.name + ", " + b.name, compose_permutations(a.S, b.S),
          compose_permutations(b.S_inverse, a.S_inverse), half_turns,
          compose_permutations(a.U, b.U)};
}

/// For each coordinate and input, the conventions with another sign or, for angles, another zero.
std::vector<std::vector<Convention>> single_change_conventions(const Model& model) {
  const Convention same = identity_convention(model);
  std::vector<std::vector<Convention>> all;
  for (std::size_t i = 0; i < same.S.size; ++i) {
    const Coordinate& coordinate = model.coordinates[i];
    Convention mirror = same;
    mirror.name = fmt::format("its `{0}` is `-{0}`", coordinate.name);
    mirror.S.at(i, i) = mirror.S_inverse.at(i, i) = -1;
    Convention turn = same;
    turn.name = fmt::format("its `{0}` is `{0} + pi`", coordinate.name);
    turn.half_turns[i] = 1;
    Convention opposite = compose_conventions(turn, mirror);
    opposite.name = fmt::format("its `{0}` is `pi - {0}`", coordinate.name);
    all.push_back({mirror});
    if (is_angle(coordinate)) all.back() = {mirror, turn, opposite};
  }
  for (std::size_t i = 0; i < same.U.size; ++i) {
    Convention reversed = same;
    reversed.name = fmt::format("its `{0}` is `-{0}`", model.inputs[i].name);
    reversed.U.at(i, i) = -1;
    all.push_back({reversed});
  }
  return all;
}

/// Adds two conventions: each angle relative to the previous angle; each angle absolute, the sum of
/// our angles up to this angle.
void add_relative_angles(const Model& model, std::vector<Convention>& all) {
  Convention relative = identity_convention(model);
  relative.name = "each of its angles is relative to the previous angle";
  std::vector<std::size_t> angles;
  for (std::size_t i = 0; i < relative.S.size; ++i) {
    if (!is_angle(model.coordinates[i])) continue;
    if (!angles.empty()) relative.S.at(i, angles.back()) = -1;
    for (const std::size_t before : angles) relative.S_inverse.at(i, before) = 1;
    angles.push_back(i);
  }
  if (angles.size() < 2) return;
  all.push_back(relative);
  std::swap(relative.S, relative.S_inverse);
  relative.name = "each of its angles is absolute, the sum of our angles up to it";
  all.push_back(relative);
}

void add_permutations(const Model& model, std::vector<Convention>& all) {
  const Convention same = identity_convention(model);
  if (same.S.size > max_permuted_coordinates) return;
  std::vector<std::size_t> order(same.S.size);
  std::iota(order.begin(), order.end(), std::size_t{0});
  while (std::ranges::next_permutation(order).found) {
    Convention permuted = same;
    permuted.name = "its order of coordinates is";
    for (std::size_t i = 0; i < order.size(); ++i) {
      for (std::size_t j = 0; j < order.size(); ++j) permuted.S.at(i, j) = same.S.at(order[i], j);
      permuted.name += fmt::format("{} `{}`", i == 0 ? "" : ",", model.coordinates[order[i]].name);
    }
    permuted.S_inverse = transpose(permuted.S);
    all.push_back(permuted);
  }
}

/// Multiplies each block of map.size consecutive rows of x by the map. An empty map does not change
/// x.
RealNumbers apply_map(const IntegerMatrix& map, const RealNumbers& x, std::size_t columns = 1) {
  const std::size_t n = map.size;
  if (n == 0) return x;
  RealNumbers y(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    const std::size_t row = i / columns;
    for (std::size_t j = 0; j < n; ++j) {
      const int factor = map.at(row % n, j);
      if (factor == 0) continue;
      y[i] = y[i] + factor * x[(row - row % n + j) * columns + i % columns];
    }
  }
  return y;
}

/// x + sign pi c, c the half turns of the convention.
RealNumbers add_half_turns(const Convention& convention, RealNumbers x, int sign) {
  const cl_R pi = (Real(4) * atan(Real(1))).value();
  for (std::size_t i = 0; i < convention.half_turns.size(); ++i) {
    const int turns = sign * convention.half_turns[i];
    if (turns != 0) x[i] = x[i] + turns * pi;
  }
  return x;
}

RealNumbers transpose(const RealNumbers& x, std::size_t columns) {
  const std::size_t rows = x.size() / columns;
  RealNumbers y(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) y[i % columns * rows + i / columns] = x[i];
  return y;
}

/// The map of rows or columns that belong to leaves of the kind `leaf`; empty if `leaf` has no map.
/// Rows along coordinates transform as velocities (S) or as forces (S^-T).
IntegerMatrix leaf_map(const Convention& convention, std::optional<Opcode> leaf,
                       bool as_velocities) {
  if (leaf == Opcode::input) return convention.U;
  if (leaf != Opcode::coordinate && leaf != Opcode::velocity) return {};
  return as_velocities ? convention.S : transpose(convention.S_inverse);
}

}  // namespace

std::vector<Convention> candidate_conventions(const Model& model) {
  const auto single = single_change_conventions(model);
  std::vector<Convention> all;
  for (const auto& some : single) all.insert(all.end(), some.begin(), some.end());
  add_relative_angles(model, all);
  add_permutations(model, all);
  for (std::size_t i = 0; i < single.size() && all.size() < most_conventions; ++i) {
    for (std::size_t j = i + 1; j < single.size(); ++j) {
      for (const Convention& a : single[i]) {
        for (const Convention& b : single[j]) all.push_back(compose_conventions(a, b));
      }
    }
  }
  return all;
}

State to_our_state(const Convention& convention, State theirs) {
  theirs.q = apply_map(convention.S_inverse, add_half_turns(convention, theirs.q, -1));
  theirs.v = apply_map(convention.S_inverse, theirs.v);
  theirs.a = apply_map(convention.S_inverse, theirs.a);
  theirs.momenta = apply_map(transpose(convention.S), theirs.momenta);
  theirs.u = apply_map(convention.U, theirs.u);
  return theirs;
}

std::vector<cl_R> to_their_values(const Model& model, const Convention& convention,
                                  const OutputRequest& output, const ForeignField& field,
                                  const std::vector<cl_R>& ours) {
  const FieldRow& row = *field.row;
  const auto leaf_along = [&](Extent extent) -> std::optional<Opcode> {
    const std::optional<FieldLine> first = line_at(model, extent, 0, output.user);
    return first && row.unit != UnitRule::number ? first->leaf : std::nullopt;
  };
  const bool is_rate = output_row(output.kind).solves_mass_matrix || row.unit == UnitRule::row ||
                       row.unit == UnitRule::row_per_second;
  RealNumbers values =
      apply_map(leaf_map(convention, leaf_along(row.rows), is_rate), ours, field.columns);
  const bool is_place = leaf_along(row.rows) == Opcode::coordinate && row.unit == UnitRule::row;
  if (is_place) values = add_half_turns(convention, values, 1);
  const IntegerMatrix of_columns = leaf_map(convention, leaf_along(row.columns), false);
  values = apply_map(of_columns, transpose(values, field.columns), field.rows);
  return transpose(values, field.rows);
}

}  // namespace elgen
