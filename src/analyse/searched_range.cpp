// A range of an angle holds its values and those a whole number of turns on.
#include "analyse/searched_range.hpp"

#include "numbers/exact_number.hpp"

namespace elgen {

using cln::cl_R;

const Real& whole_turn() {
  static const Real value = Real(cln::cl_RA(2)) * acos(Real(cln::cl_RA(-1)));
  return value;
}

const Interval* searched_range(const Coordinate& coordinate, SearchKind kind) {
  // A range is a turn where pi is typed in three digits or more: [-3.14, 3.14].
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
  Real value = highest;
  if (kind == SearchKind::turn) {
    // the first place that is not below the range
    const Real turns((low - highest) / whole_turn());
    value = highest +
            Real(cln::ceiling1((turns - Real(power_of_ten(-root_digits))).value())) * whole_turn();
  }
  const Real lowest = value - width;
  return (low <= value || is_near(value, low, root_digits)) &&
         (lowest <= high || is_near(lowest, high, root_digits));
}

}  // namespace elgen
