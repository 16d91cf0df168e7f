// Composition: builds a function from calls of other functions. A call copies the instructions of
// the callee and replaces its leaves. Operations that then give 0, add 0, or multiply or divide by
// 1 are omitted.
//
//     a(q, u) = q*u   called at   q + h v   ->   0 = q   1 = h   2 = v   3 = multiply 1 2
//                                                4 = add 0 3   5 = u   6 = multiply 4 5
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "elgen/model.hpp"
#include "elgen/program.hpp"
#include "program/network/instructions.hpp"

namespace elgen {

/// Indices of instructions.
using InstructionIndices = std::vector<std::uint32_t>;

/// The arguments q, v, t of a call, and a if the callee needs it. Parameters and u are passed on
/// from the caller.
struct CallPoint {
  InstructionIndices q = {};
  InstructionIndices v = {};
  std::uint32_t t = 0;
  std::uint32_t number = 1;  ///< of the call; from 2 on, it is a suffix of names
  InstructionIndices a = {};
};

class Composition {
 public:
  /// Adds instructions to `function` and constants to `program`.
  Composition(Program& program, Function& function)
      : program_(program), function_(function), instructions_(function) {}

  [[nodiscard]] std::uint32_t add_leaf(Opcode kind, std::uint32_t number = 0);
  /// All `count` leaves of a kind.
  [[nodiscard]] InstructionIndices add_leaves(Opcode kind, std::size_t count);
  [[nodiscard]] std::uint32_t add_number(const cln::cl_RA& value);
  [[nodiscard]] std::uint32_t add(Opcode opcode, std::uint32_t a, std::uint32_t b = 0);
  /// The instruction, whose operands are values of this composition.
  [[nodiscard]] std::uint32_t add(const Instruction& instruction);

  /// f(x), or f(x, y).
  [[nodiscard]] std::uint32_t add_call(FunctionId function, std::uint32_t x, std::uint32_t y);

  /// Entry by entry: x + y, x - y.
  [[nodiscard]] InstructionIndices add(Opcode opcode, const InstructionIndices& x,
                                       const InstructionIndices& y);
  /// x + c y
  [[nodiscard]] InstructionIndices add_scaled(const InstructionIndices& x, std::uint32_t c,
                                              const InstructionIndices& y);

  /// The entries of a field of `callee`, a function of `from`, at a point. `is_inner` marks the
  /// copied operations, see Instruction::is_inner.
  [[nodiscard]] InstructionIndices inline_call(const Program& from, const Function& callee,
                                               const Field& field, const CallPoint& at,
                                               bool is_inner = false);

  using Body = std::function<InstructionIndices(Composition&, const InstructionIndices&)>;
  /// Applies `body` to each column. Columns with few zeros become the repetitions of the function
  /// (Function::repeated), and no instruction may follow them. A column that needs at most two
  /// thirds of the operations of a repetition is composed without repetition. If fewer than 16
  /// columns remain, all columns are composed without repetition.
  ///
  ///     r -> r/d   of   (0 = q), (1 = v)   ->   3 = divide 0 2   4 = divide 1 2
  [[nodiscard]] std::vector<InstructionIndices> repeat_for_columns(
      const std::vector<InstructionIndices>& columns, const Body& body);

  /// Names values "theta_2", if they are computed (not leaves or constants) and have no name yet.
  void set_name(const InstructionIndices& values, Opcode kind, std::uint32_t number);
  /// Names a value `name`, if it is computed and has no name yet.
  void name(std::uint32_t value, const std::string& name);
  /// Names computed values without a name: "reduced_theta" for the prefix "reduced_".
  void name(const InstructionIndices& values, const std::string& prefix);

 private:
  [[nodiscard]] std::uint32_t substitute_leaf(const Instruction& leaf, const CallPoint& at);
  [[nodiscard]] std::optional<std::uint32_t> simplified_value(const Instruction& instruction);
  [[nodiscard]] bool is_zero(std::uint32_t place) const;
  [[nodiscard]] bool is_one(std::uint32_t place) const;
  /// The columns for which `body` needs more than two thirds of `length` instructions; none if
  /// there are fewer than 16 of these columns.
  [[nodiscard]] std::vector<std::size_t> columns_to_repeat(
      const std::vector<InstructionIndices>& columns, const Body& body, std::size_t length) const;

  Program& program_;
  Function& function_;
  InstructionBuilder instructions_;
};

/// A symmetric matrix M of values of a composition, as L D L^T, and solutions of M x = r.
///
///     W_ij = M_ij - sum_{k<j} L_jk W_ik,   D_j = W_jj,   L_ij = W_ij / D_j
///     z = L^-1 r,   x = L^-T D^-1 z
///
/// Cost: n^3/6 operations, minus operations on zeros. If frames branch, the last row is eliminated
/// first, so that zeros stay zero. derive/lagrangian/symmetric_solve.hpp does the same for
/// formulas.
class MassFactorisation {
 public:
  /// `mass`: n x n, row-major. `order`: its rows in the order of elimination. No pivoting, because
  /// M is positive definite.
  MassFactorisation(Composition& compose, InstructionIndices order, const InstructionIndices& mass);

  /// x with M x = r.
  [[nodiscard]] InstructionIndices solve(const InstructionIndices& r) const {
    return solve(compose_, r);
  }
  /// As above, by operations that are added to `compose`, which may be a copy of the composition.
  [[nodiscard]] InstructionIndices solve(Composition& compose, const InstructionIndices& r) const {
    return back_substitute(compose, forward_substitute(compose, r));
  }

  /// x with M x = r for every column r, by Composition::repeat_for_columns().
  [[nodiscard]] std::vector<InstructionIndices> solve_columns(
      const std::vector<InstructionIndices>& columns) const;

 private:
  [[nodiscard]] InstructionIndices forward_substitute(Composition& compose,
                                                      const InstructionIndices& r) const;
  [[nodiscard]] InstructionIndices back_substitute(Composition& compose,
                                                   const InstructionIndices& z) const;

  Composition& compose_;
  InstructionIndices order_;
  std::vector<InstructionIndices> lower_ = {};  ///< L below its diagonal, rows in order_
  InstructionIndices reciprocals_ = {};         ///< 1 / D
};

/// A matrix of values, row-major.
struct ValueMatrix {
  InstructionIndices entries = {};
  std::size_t columns = 0;
};

/// A call of the parts of derivatives of accelerations (elgen/compose.hpp) at a point: first of M
/// and the forces, then of the other parts, at the resulting accelerations.
class AccelerationParts {
 public:
  /// `parts`: a function of `from`. All arguments except `at` must outlive this object.
  AccelerationParts(Composition& compose, const Program& from, const Function& parts, CallPoint at);

  [[nodiscard]] const MassFactorisation& mass() const { return mass_; }
  [[nodiscard]] const InstructionIndices& accelerations() const { return at_.a; }
  /// The values of the parts with these names; parts that do not exist are omitted.
  [[nodiscard]] std::vector<ValueMatrix> call(const std::vector<std::string_view>& names) const;

 private:
  Composition& compose_;
  const Program& from_;
  const Function& parts_;
  CallPoint at_;
  std::vector<ValueMatrix> dynamics_;  ///< M, B u - bias
  MassFactorisation mass_;
};

/// N(q) e_j for each velocity. `calls` needs coordinate_rates for rotations.
[[nodiscard]] std::vector<InstructionIndices> coordinate_directions(Composition& compose,
                                                                    const Model& model,
                                                                    const Program& calls,
                                                                    const InstructionIndices& q);

/// The tangent in the components of velocities, with rotation vectors, of a tangent `dq` at a
/// position with the coordinate_directions() `moves`.
[[nodiscard]] InstructionIndices velocity_tangents(Composition& compose, const Model& model,
                                                   const std::vector<InstructionIndices>& moves,
                                                   const InstructionIndices& dq);

/// The velocities of a model in the order of elimination.
[[nodiscard]] InstructionIndices elimination_order(const Model& model);

}  // namespace elgen
