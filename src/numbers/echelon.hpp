// Echelon: Gaussian elimination of linear equations over any field of numbers. Columns are
// eliminated from left to right. The field chooses the pivots and decides which numbers are 0.
//
//     2x + 4y + 6z                  x + 2y
//      x + 2y + 4z   -- reduced ->           z     rank 2, kernel (-2, 1, 0)
//
// Rows hold their nonzero entries in column order. No rows are exchanged.
#pragma once

#include <cln/float.h>
#include <cln/rational.h>
#include <cln/real.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace elgen {

enum class EchelonForm : std::uint8_t {
  upper,    ///< Gauss: eliminates the pivot's column from all rows without a pivot
  reduced,  ///< Gauss-Jordan: scales the pivot to 1 and eliminates its column from all other rows
};

/// A row without a pivot whose entry in the current column is not 0.
template <class Number>
struct PivotCandidate {
  std::size_t row = 0;
  std::size_t length = 0;         ///< number of nonzero entries of the row
  const Number* entry = nullptr;  ///< entry of the row in the current column
};

/// An entry of a row; Echelon drops entries that are 0.
template <class Number>
struct EchelonEntry {
  std::size_t column = 0;
  Number value = {};
};

/// Entries in column order.
template <class Number>
using EchelonRow = std::vector<EchelonEntry<Number>>;

template <class Number>
[[nodiscard]] std::vector<EchelonRow<Number>> echelon_rows(const std::vector<Number>& matrix,
                                                           std::size_t columns) {
  std::vector<EchelonRow<Number>> rows;
  for (std::size_t k = 0; k < matrix.size(); ++k) {
    if (k % columns == 0) rows.emplace_back();
    rows.back().push_back({k % columns, matrix[k]});
  }
  return rows;
}

/// The entry of a row in a column; null if the row has no entry in this column.
template <class Number>
[[nodiscard]] const Number* find_row_entry(const EchelonRow<Number>& row, std::size_t column) {
  const auto at = std::ranges::lower_bound(row, column, {}, &EchelonEntry<Number>::column);
  return at != row.end() && at->column == column ? &at->value : nullptr;
}

/// row - factor * other; entries that become 0 are kept.
template <class Field, class Number = typename Field::Number>
[[nodiscard]] EchelonRow<Number> subtract_multiple(Field& field, EchelonRow<Number> row,
                                                   const Number& factor,
                                                   const EchelonRow<Number>& other) {
  EchelonRow<Number> result;
  auto own = row.begin();
  for (const EchelonEntry<Number>& subtracted : other) {
    for (; own != row.end() && own->column < subtracted.column; ++own) {
      result.push_back(std::move(*own));
    }
    const bool is_own = own != row.end() && own->column == subtracted.column;
    const Number before = is_own ? std::move(own->value) : field.integer(0);
    if (is_own) ++own;
    result.push_back({subtracted.column, field.subtract_product(before, factor, subtracted.value)});
  }
  for (; own != row.end(); ++own) result.push_back(std::move(*own));
  return result;
}

/// A Field provides
///
///     Number, form                                     `form` is an EchelonForm
///     integer(i), negate(x), multiply(x, y), divide(x, y)
///     subtract_product(x, factor, y)                   x - factor y
///     is_zero(x)                                       if true, the entry x is dropped
///     is_defined(x)                                    if false, the elimination stops
///     best_pivot(candidates, column)                   the pivot; null: the column has none
///
/// Cost: at most rows x columns x rank operations.
template <class Field>
class Echelon {
 public:
  using Number = typename Field::Number;
  using Entry = EchelonEntry<Number>;
  using Row = EchelonRow<Number>;
  struct Pivot {
    std::size_t row = 0;
    std::size_t column = 0;
    Number value = {};  ///< the pivot before its row is scaled
  };

  /// Eliminates the first `unknowns` columns; the later columns are right-hand sides. Keeps a
  /// reference to `field`.
  Echelon(Field& field, std::vector<Row> rows, std::size_t unknowns)
      : field_(field), rows_(std::move(rows)), unknowns_(unknowns), is_used_(rows_.size()) {
    for (Row& row : rows_) drop_zeros(row);
    for (std::size_t column = 0; is_defined_ && column < unknowns; ++column)
      eliminate_column(column);
  }

  /// The same elimination for a row-major matrix with `columns` columns.
  Echelon(Field& field, const std::vector<Number>& matrix, std::size_t columns,
          std::size_t unknowns)
      : Echelon(field, echelon_rows(matrix, columns), unknowns) {}

  /// True if every number during the elimination was defined; otherwise no other result is valid.
  [[nodiscard]] bool is_defined() const { return is_defined_; }

  [[nodiscard]] std::size_t rank() const { return pivots_.size(); }

  /// The pivots in the order of their columns.
  [[nodiscard]] const std::vector<Pivot>& pivots() const { return pivots_; }

  /// The row of a pivot without the pivot itself.
  [[nodiscard]] const Row& row_without_pivot(const Pivot& pivot) const { return rows_[pivot.row]; }

  /// Nonzero entries of the first right-hand side in rows without a pivot. Such a row states the
  /// contradiction 0 = entry.
  [[nodiscard]] std::vector<Number> contradictions() const {
    std::vector<Number> result;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const Number* const right = find_row_entry(rows_[i], unknowns_);
      if (!is_used_[i] && right != nullptr) result.push_back(*right);
    }
    return result;
  }

  /// A solution of A x = b with all free unknowns 0; b is the first right-hand side. None if the
  /// equations contradict each other.
  [[nodiscard]] std::optional<std::vector<Number>> solution() const {
    if (!contradictions().empty()) return std::nullopt;
    return back_substitute(unknowns_);
  }

  /// A basis of the null space A x = 0, with one vector per free unknown. Each vector is 1 at its
  /// own free unknown, and 0 at all other free unknowns and at all later unknowns.
  [[nodiscard]] std::vector<std::vector<Number>> kernel() const {
    std::vector<bool> is_free(unknowns_, true);
    for (const Pivot& pivot : pivots_) is_free[pivot.column] = false;
    std::vector<std::vector<Number>> basis;
    for (std::size_t u = 0; u < unknowns_; ++u) {
      if (!is_free[u]) continue;
      std::vector<Number>& x = basis.emplace_back(back_substitute(u));
      for (Number& number : x) number = field_.negate(number);
      x[u] = field_.integer(1);
    }
    return basis;
  }

  /// The determinant of a square matrix.
  [[nodiscard]] Number determinant() const {
    if (rank() < unknowns_) return field_.integer(0);
    Number product = field_.integer(1);
    bool is_odd = false;
    for (std::size_t k = 0; k < rank(); ++k) {
      product = field_.multiply(product, pivots_[k].value);
      for (std::size_t i = 0; i < k; ++i) is_odd = is_odd != (pivots_[i].row > pivots_[k].row);
    }
    return is_odd ? field_.negate(product) : product;
  }

 private:
  void check_defined(const Number& value) { is_defined_ = is_defined_ && field_.is_defined(value); }

  void drop_zeros(Row& row) {
    for (const Entry& entry : row) check_defined(entry.value);
    std::erase_if(row, [this](const Entry& entry) { return field_.is_zero(entry.value); });
  }

  void eliminate_column(std::size_t column) {
    std::vector<PivotCandidate<Number>> candidates;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const Number* const entry = is_used_[i] ? nullptr : find_row_entry(rows_[i], column);
      if (entry != nullptr) candidates.push_back({i, rows_[i].size(), entry});
    }
    if (candidates.empty()) return;
    const PivotCandidate<Number>* const best = field_.best_pivot(candidates, column);
    if (best == nullptr) return;
    const Pivot pivot{best->row, column, *best->entry};
    pivots_.push_back(pivot);
    is_used_[pivot.row] = true;
    normalize_pivot_row(rows_[pivot.row], pivot);
    for (std::size_t i = 0; i < rows_.size() && is_defined_; ++i) {
      const bool is_reached = Field::form == EchelonForm::reduced ? i != pivot.row : !is_used_[i];
      if (is_reached) eliminate_entry(rows_[i], pivot);
    }
  }

  /// Removes the pivot from its row; in the reduced form, also divides the row by the pivot.
  void normalize_pivot_row(Row& row, const Pivot& pivot) {
    std::erase_if(row, [&](const Entry& entry) { return entry.column == pivot.column; });
    if constexpr (Field::form == EchelonForm::reduced) {
      for (Entry& entry : row) entry.value = field_.divide(entry.value, pivot.value);
      drop_zeros(row);
    }
  }

  /// Subtracts the multiple of the pivot's row that eliminates the entry in the pivot's column.
  void eliminate_entry(Row& row, const Pivot& pivot) {
    const auto at = std::ranges::lower_bound(row, pivot.column, {}, &Entry::column);
    if (at == row.end() || at->column != pivot.column) return;
    Number factor = std::move(at->value);
    row.erase(at);
    if constexpr (Field::form == EchelonForm::upper) factor = field_.divide(factor, pivot.value);
    row = subtract_multiple(field_, std::move(row), factor, row_without_pivot(pivot));
    drop_zeros(row);
  }

  /// Back substitution: solves A x = column `right`, with all free unknowns 0.
  std::vector<Number> back_substitute(std::size_t right) const {
    std::vector<Number> x(unknowns_, field_.integer(0));
    for (auto pivot = pivots_.rbegin(); pivot != pivots_.rend(); ++pivot) {
      const Number* const own = find_row_entry(row_without_pivot(*pivot), right);
      Number sum = own == nullptr ? field_.integer(0) : *own;
      for (const Entry& entry : row_without_pivot(*pivot)) {
        if (entry.column >= unknowns_ || field_.is_zero(x[entry.column])) continue;
        sum = field_.subtract_product(sum, entry.value, x[entry.column]);
      }
      const bool is_one = Field::form == EchelonForm::reduced;
      x[pivot->column] = is_one ? sum : field_.divide(sum, pivot->value);
    }
    return x;
  }

  Field& field_;
  std::vector<Row> rows_;
  std::size_t unknowns_;
  std::vector<bool> is_used_;
  bool is_defined_ = true;
  std::vector<Pivot> pivots_ = {};
};

/// The operations of a field, for types with arithmetic operators.
template <class T>
struct FieldOperations {
  using Number = T;
  [[nodiscard]] static T integer(int value) { return T(value); }
  [[nodiscard]] static T negate(const T& x) { return -x; }
  [[nodiscard]] static T add(const T& x, const T& y) { return x + y; }
  [[nodiscard]] static T multiply(const T& x, const T& y) { return x * y; }
  [[nodiscard]] static T divide(const T& x, const T& y) { return x / y; }
  [[nodiscard]] static T subtract_product(const T& x, const T& factor, const T& y) {
    return x - factor * y;
  }
  [[nodiscard]] static bool is_defined(const T& x) {
    if constexpr (std::is_floating_point_v<T>) return !std::isnan(x);
    if constexpr (requires { x.is_defined(); }) return x.is_defined();
    return true;
  }
  /// True if x is exactly 0; false if the type cannot show this.
  [[nodiscard]] static bool is_zero(const T& x) {
    if constexpr (std::is_floating_point_v<T>) return x == 0;
    if constexpr (std::is_base_of_v<cln::cl_R, T>) return cln::zerop(x);
    if constexpr (requires { cln::zerop(x.value()); }) {
      return x.is_defined() && cln::zerop(x.value());
    }
    return false;
  }
};

/// For ordered numbers: takes the largest entry of a column as pivot.
template <class T, EchelonForm Form = EchelonForm::upper>
class LargestPivot : public FieldOperations<T> {
 public:
  using Candidates = std::vector<PivotCandidate<T>>;
  static constexpr EchelonForm form = Form;

  /// Pivots smaller than `least_pivot` and entries smaller than `least_entry` are rounding errors
  /// and count as 0. If `scales` has a scale for each row, pivots are compared relative to the
  /// scale of their row.
  explicit LargestPivot(T least_pivot = T(0), T least_entry = T(0), std::vector<T> scales = {})
      : least_pivot_(std::move(least_pivot)),
        least_entry_(std::move(least_entry)),
        has_noise_(!FieldOperations<T>::is_zero(least_entry_)),
        scales_(std::move(scales)) {}

  [[nodiscard]] bool is_zero(const T& x) const {
    using std::abs;
    return FieldOperations<T>::is_zero(x) || (has_noise_ && abs(x) < least_entry_);
  }

  [[nodiscard]] const PivotCandidate<T>* best_pivot(const Candidates& candidates,
                                                    std::size_t) const {
    const PivotCandidate<T>* largest = nullptr;
    T most(0);
    for (const PivotCandidate<T>& candidate : candidates) {
      const T share = relative_size(candidate);
      if (share < least_pivot_ || (largest != nullptr && !(most < share))) continue;
      largest = &candidate;
      most = share;
    }
    return largest;
  }

 private:
  [[nodiscard]] T relative_size(const PivotCandidate<T>& candidate) const {
    using std::abs;
    const T size = abs(*candidate.entry);
    return scales_.empty() ? size : size / scales_[candidate.row];
  }

  T least_pivot_;
  T least_entry_;
  bool has_noise_;
  std::vector<T> scales_;
};

/// Solves A x = b with A n x n, row-major; none if A is singular.
template <class T>
[[nodiscard]] std::optional<std::vector<T>> solve_linear(const std::vector<T>& matrix,
                                                         const std::vector<T>& right_side) {
  const std::size_t n = right_side.size();
  std::vector<T> both;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < n; ++k) both.push_back(matrix[i * n + k]);
    both.push_back(right_side[i]);
  }
  LargestPivot<T> field;
  const Echelon<LargestPivot<T>> echelon(field, both, n + 1, n);
  if (!echelon.is_defined() || echelon.rank() < n) return std::nullopt;
  return echelon.solution();
}

/// Takes every pivot from the diagonal, whatever its size, and therefore computes D of L D L^T.
/// Floating types may divide by 0, so every row of a square matrix has its pivot.
template <class T>
struct DiagonalPivot : FieldOperations<T> {
  static constexpr EchelonForm form = EchelonForm::upper;

  [[nodiscard]] static bool is_zero(const T& x) {
    return !std::is_floating_point_v<T> && FieldOperations<T>::is_zero(x);
  }
  [[nodiscard]] static bool is_defined(const T& x) {
    return std::is_floating_point_v<T> || FieldOperations<T>::is_defined(x);
  }
  [[nodiscard]] static const PivotCandidate<T>* best_pivot(
      const std::vector<PivotCandidate<T>>& candidates, std::size_t column) {
    const auto own = std::ranges::find(candidates, column, &PivotCandidate<T>::row);
    return own == candidates.end() ? nullptr : &*own;
  }
};

}  // namespace elgen
