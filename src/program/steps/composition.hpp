// Composition: a function that is made of calls of others, each copied with its leaves replaced.
// Operations that then give 0, add 0, or multiply or divide by 1 are left out.
//
//     a(q, u) = q*u   called at   q + h v   ->   0 = q   1 = h   2 = v   3 = multiply 1 2
//                                                4 = add 0 3   5 = u   6 = multiply 4 5
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "elgen/model.hpp"
#include "elgen/program.hpp"
#include "program/network/instructions.hpp"

namespace elgen {

/// Numbers of instructions.
using Places = std::vector<std::uint32_t>;

/// The arguments q, v, t and, where the callee takes it, a of a call. Parameters and u are the
/// caller's.
struct CallPoint {
  Places q = {};
  Places v = {};
  std::uint32_t t = 0;
  std::uint32_t number = 1;  ///< of the call: part of the names from the second on
  Places a = {};
};

class Composition {
 public:
  /// Instructions are added to `function`, constants to `program`.
  Composition(Program& program, Function& function)
      : program_(program), function_(function), instructions_(function) {}

  [[nodiscard]] std::uint32_t leaf(Opcode kind, std::uint32_t number = 0);
  /// All `count` leaves of a kind.
  [[nodiscard]] Places leaves(Opcode kind, std::size_t count);
  [[nodiscard]] std::uint32_t number(const cln::cl_RA& value);
  [[nodiscard]] std::uint32_t add(Opcode opcode, std::uint32_t a, std::uint32_t b = 0);

  /// f(x), or f(x, y).
  [[nodiscard]] std::uint32_t applied(FunctionId function, std::uint32_t x, std::uint32_t y);

  /// The same of entries: x + y, x - y.
  [[nodiscard]] Places add(Opcode opcode, const Places& x, const Places& y);
  /// x + c y
  [[nodiscard]] Places moved(const Places& x, std::uint32_t c, const Places& y);

  /// The entries of a field of `callee`, a function of `from`, at a point. `is_inner`: of its
  /// operations.
  [[nodiscard]] Places call(const Program& from, const Function& callee, const Field& field,
                            const CallPoint& at, bool is_inner = false);

  using Body = std::function<Places(Composition&, const Places&)>;
  /// The values that `body` makes of each of the columns. Columns that have few zeros are the
  /// repetitions of the function, which compute with these, and nothing is added behind them; all
  /// others are composed one by one: those that take at most half of the operations so, or all
  /// where few are left.
  ///
  ///     r -> r/d   of   (0 = q), (1 = v)   ->   3 = divide 0 2   4 = divide 1 2
  [[nodiscard]] std::vector<Places> repeat(const std::vector<Places>& columns, const Body& body);

  /// Calls values "theta_2" that are computed and have no name yet.
  void name(const Places& values, Opcode kind, std::uint32_t number);
  /// Calls a value so, likewise.
  void name(std::uint32_t value, const std::string& name);
  /// Calls them "reduced_theta", likewise.
  void name(const Places& values, const std::string& prefix);

 private:
  [[nodiscard]] std::uint32_t leaf_at(const Instruction& leaf, const CallPoint& at);
  [[nodiscard]] std::optional<std::uint32_t> trivial(const Instruction& instruction);
  [[nodiscard]] bool is_zero(std::uint32_t place) const;
  [[nodiscard]] bool is_one(std::uint32_t place) const;
  [[nodiscard]] std::uint32_t add(const Instruction& instruction);
  /// The columns for which the body takes more than two thirds of so many instructions; none where
  /// they are few.
  [[nodiscard]] std::vector<std::size_t> long_columns(const std::vector<Places>& columns,
                                                      const Body& body, std::size_t length) const;

  Program& program_;
  Function& function_;
  Instructions instructions_;
};

/// A symmetric matrix M of values of a composition, as L D L^T, and what it is solved for.
///
///     W_ij = M_ij - sum_{k<j} L_jk W_ik,   D_j = W_jj,   L_ij = W_ij / D_j
///     z = L^-1 r,   x = L^-T D^-1 z
///
/// n^3/6 operations without those on zeros. Where frames branch the last row goes first, so that
/// zeros stay (derive/lagrangian/symmetric_solve.hpp has the same on formulas).
class Factorised {
 public:
  /// `mass`: n x n, row-major. `order`: its rows as they are eliminated. Without pivoting: M is
  /// positive definite.
  Factorised(Composition& compose, Places order, const Places& mass);

  /// x with M x = r.
  [[nodiscard]] Places solve(const Places& r) const {
    return substituted(compose_, reduced(compose_, r));
  }

  /// The same of each column r (Composition::repeat).
  [[nodiscard]] std::vector<Places> solve_columns(const std::vector<Places>& columns) const;

 private:
  [[nodiscard]] Places reduced(Composition& compose, const Places& r) const;
  [[nodiscard]] Places substituted(Composition& compose, const Places& z) const;

  Composition& compose_;
  Places order_;
  std::vector<Places> lower_ = {};  ///< L below its diagonal, by order
  Places reciprocals_ = {};         ///< 1 / D
};

/// The velocities of a model in that order.
[[nodiscard]] Places order_of_elimination(const Model& model);

}  // namespace elgen
