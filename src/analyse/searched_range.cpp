// An angle is in its range if the angle plus an integer number of whole turns is in the interval.
#include "analyse/searched_range.hpp"

#include "numbers/exact_number.hpp"

namespace elgen {

using cln::cl_R;

const Real& whole_turn() {
  static const Real value = Real(cln::cl_RA(2)) * acos(Real(cln::cl_RA(-1)));
  return value;
}

Real wrap_above(const Real& angle, const Real& lowest) {
  const Real turns = (lowest - angle) / whole_turn() - Real(power_of_ten(-root_digits));
  return angle + Real(cln::ceiling1(turns.value())) * whole_turn();
}

const Interval* searched_range(const Coordinate& coordinate, SearchKind kind) {
  // [-3.14, 3.14] counts as a whole turn: users type pi with three digits or more.
  static const cl_R turn = cln::cl_RA(628) / 100;
  if (!coordinate.range || (kind != SearchKind::range && kind != SearchKind::turn)) return nullptr;
  const cl_R length = coordinate.range->high - coordinate.range->low;
  return kind == SearchKind::turn && length >= turn ? nullptr : &*coordinate.range;
}

bool is_in_range(const Coordinate& coordinate, SearchKind kind, const Real& highest,
                 const Real& width) {
  const Interval* const range = searched_range(coordinate, kind);
  if (range == nullptr) return true;
  const Real low(range->low);
  const Real high(range->high);
  const Real value = kind == SearchKind::turn ? wrap_above(highest, low) : highest;
  const Real lowest = value - width;
  return (low <= value || is_near(value, low, root_digits)) &&
         (lowest <= high || is_near(lowest, high, root_digits));
}

}  // namespace elgen
