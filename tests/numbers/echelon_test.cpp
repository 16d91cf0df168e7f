// Tests elimination: examples by hand, product rules of rank and determinant, singular systems, and
// several number types.
#include "numbers/echelon.hpp"

#include <cln/integer.h>
#include <cln/rational.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "elgen/real.hpp"
#include "numbers/exact_number.hpp"
#include "numbers/random.hpp"
#include "support/matrices.hpp"

using namespace elgen;
using namespace elgen::test;
using cln::cl_R;
using cln::cl_RA;

namespace {

using Exact = LargestPivot<cl_RA>;
using ReducedExact = LargestPivot<cl_RA, EchelonForm::reduced>;
using Rationals = std::vector<cl_RA>;

/// A random row-major matrix of the integers -3 ... 3. Singular minors are frequent.
Rationals random_matrix(Random& random, std::size_t rows, std::size_t columns) {
  Rationals matrix;
  for (std::size_t k = 0; k < rows * columns; ++k) {
    matrix.emplace_back(static_cast<int>(random.next() % 7) - 3);
  }
  return matrix;
}

template <class Field>
std::size_t rank_of(const Rationals& matrix, std::size_t columns) {
  Field field;
  return Echelon<Field>(field, matrix, columns, columns).rank();
}

cl_RA determinant_of(const Rationals& matrix, std::size_t n) {
  Exact field;
  return Echelon<Exact>(field, matrix, n, n).determinant();
}

bool is_zero_matrix(const Rationals& matrix) {
  return std::ranges::all_of(matrix, [](const cl_RA& x) { return cln::zerop(x); });
}

/// Checks that the kernel has columns - rank vectors x, and that A x = 0 for each x.
template <class Field>
void check_kernel(const Rationals& matrix, std::size_t columns) {
  Field field;
  const Echelon<Field> echelon(field, matrix, columns, columns);
  const auto kernel = echelon.kernel();
  CHECK(kernel.size() + echelon.rank() == columns);
  for (const Rationals& x : kernel) CHECK(is_zero_matrix(product(matrix, x, columns)));
}

/// The Hilbert matrix with row i scaled by 10^(20 i), and the right side for which all unknowns are
/// 1.
std::vector<Real> scaled_hilbert(int n) {
  std::vector<Real> matrix;
  for (int i = 0; i < n; ++i) {
    cl_RA sum = 0;
    for (int k = 0; k <= n; ++k) {
      const cl_RA entry = k == n ? sum : power_of_ten(20 * i) / (i + k + 1);
      sum = sum + entry;
      matrix.emplace_back(entry);
    }
  }
  return matrix;
}

}  // namespace

TEST_CASE("rank, kernel and pivots of an example") {
  const Rationals matrix{2, 4, 6, 1, 2, 4};
  ReducedExact field;
  const Echelon<ReducedExact> echelon(field, matrix, 3, 3);
  REQUIRE(echelon.rank() == 2);
  CHECK(echelon.pivots()[0].column == 0);
  CHECK(echelon.pivots()[1].column == 2);
  REQUIRE(echelon.row_without_pivot(echelon.pivots()[0]).size() == 1);
  CHECK(echelon.row_without_pivot(echelon.pivots()[0])[0].column == 1);
  CHECK(echelon.row_without_pivot(echelon.pivots()[0])[0].value == 2);
  CHECK(echelon.kernel() == std::vector<Rationals>{{-2, 1, 0}});
  check_kernel<Exact>(matrix, 3);
}

TEST_CASE("determinants: Vandermonde's, and a changed sign for exchanged rows") {
  const Rationals vandermonde{1, 2, 4, 1, 3, 9, 1, 5, 25};
  CHECK(determinant_of(vandermonde, 3) == (3 - 2) * (5 - 2) * (5 - 3));
  const Rationals exchanged{1, 3, 9, 1, 2, 4, 1, 5, 25};
  CHECK(determinant_of(exchanged, 3) == -6);
  const Rationals turned{0, 1, 0, 0, 0, 1, 1, 0, 0};
  CHECK(determinant_of(turned, 3) == 1);
  CHECK(determinant_of({0, 1, 1, 0}, 2) == -1);
  CHECK(determinant_of({1, 2, 2, 4}, 2) == 0);
}

TEST_CASE("solutions are exact, free unknowns are 0, and a contradiction has no solution") {
  Exact field;
  const Echelon<Exact> regular(field, {2, 1, 5, 1, 3, 10}, 3, 2);
  CHECK(regular.solution() == Rationals{1, 3});
  const Echelon<Exact> flat(field, {0, 1, 7, 0, 2, 14}, 3, 2);
  CHECK(flat.rank() == 1);
  CHECK(flat.solution() == Rationals{0, 7});
  const Echelon<Exact> contradictory(field, {1, 1, 1, 1, 1, 3}, 3, 2);
  CHECK(contradictory.contradictions() == Rationals{2});
  CHECK_FALSE(contradictory.solution());
}

TEST_CASE("A kernel = 0, and the rank of a product is at most the rank of each factor") {
  Random random(1);
  for (int turn = 0; turn < 60; ++turn) {
    const std::size_t rows = 1 + random.next() % 5;
    const std::size_t inner = 1 + random.next() % 5;
    const std::size_t columns = 1 + random.next() % 5;
    const Rationals a = random_matrix(random, rows, inner);
    const Rationals b = random_matrix(random, inner, columns);
    const Rationals both = product(a, b, inner);
    check_kernel<Exact>(both, columns);
    check_kernel<ReducedExact>(both, columns);
    const std::size_t rank = rank_of<Exact>(both, columns);
    CHECK(rank == rank_of<ReducedExact>(both, columns));
    CHECK(rank <= rank_of<Exact>(a, inner));
    CHECK(rank <= rank_of<Exact>(b, columns));
  }
}

TEST_CASE("det A B = det A det B") {
  Random random(2);
  for (std::size_t n = 1; n < 6; ++n) {
    const Rationals a = random_matrix(random, n, n);
    const Rationals b = random_matrix(random, n, n);
    CHECK(determinant_of(product(a, b, n), n) == determinant_of(a, n) * determinant_of(b, n));
  }
}

TEST_CASE("an empty matrix has rank 0 and determinant 1, and its solution is empty") {
  Exact field;
  const Echelon<Exact> echelon(field, Rationals{}, 0, 0);
  CHECK(echelon.rank() == 0);
  CHECK(echelon.determinant() == 1);
  CHECK(echelon.kernel().empty());
  REQUIRE(echelon.solution());
  CHECK(echelon.solution()->empty());
  const Echelon<Exact> without_rows(field, Rationals{}, 2, 2);
  CHECK(without_rows.kernel() == std::vector<Rationals>{{1, 0}, {0, 1}});
}

TEST_CASE("64 digits solve an ill-conditioned system whose rows have scales from 1 to 1e140") {
  constexpr int n = 8;
  LargestPivot<Real> field;
  const Echelon<LargestPivot<Real>> echelon(field, scaled_hilbert(n), n + 1, n);
  REQUIRE(echelon.is_defined());
  REQUIRE(echelon.rank() == n);
  // The Hilbert matrix has condition number 1.5e10, so 53 of 64 digits are correct. The order of
  // elimination follows from the scales of the rows and may cost a few more digits.
  const auto solution = echelon.solution();
  REQUIRE(solution);
  for (const Real& x : *solution) CHECK(is_near(x, Real(1), 45));
}

TEST_CASE("an undefined number ends an elimination") {
  LargestPivot<Real> field;
  const std::vector<Real> matrix{Real(1), Real(2), Real::undefined(), Real(4)};
  CHECK_FALSE(Echelon<LargestPivot<Real>>(field, matrix, 2, 2).is_defined());
}

TEST_CASE("a pivot within the rounding error counts as 0, relative to the scale of its row") {
  const cl_R tiny = power_of_ten(-60);
  const std::vector<cl_R> matrix{1, 2, 1, 2 + tiny};
  LargestPivot<cl_R> exact;
  CHECK(Echelon<LargestPivot<cl_R>>(exact, matrix, 2, 2).rank() == 2);
  LargestPivot<cl_R> rounded(power_of_ten(-50));
  const Echelon<LargestPivot<cl_R>> echelon(rounded, matrix, 2, 2);
  CHECK(echelon.rank() == 1);
  CHECK(echelon.kernel() == std::vector<std::vector<cl_R>>{{-2, 1}});
  LargestPivot<cl_R> scaled(power_of_ten(-50), 0, {1, tiny});
  CHECK(Echelon<LargestPivot<cl_R>>(scaled, matrix, 2, 2).pivots()[0].row == 1);
}

TEST_CASE("doubles below the smallest permitted pivot leave a column free") {
  using Doubles = LargestPivot<double, EchelonForm::reduced>;
  Doubles field(1e-6);
  const Echelon<Doubles> echelon(field, std::vector<double>{1e-9, 2, 1e-9, 3}, 2, 2);
  REQUIRE(echelon.rank() == 1);
  CHECK(echelon.pivots()[0].row == 1);
  CHECK(echelon.pivots()[0].column == 1);
  CHECK(echelon.pivots()[0].value == 3);
  CHECK(echelon.kernel()[0][1] == Approx(-1e-9 / 3));
}

TEST_CASE("diagonal pivots are the entries of D in L D L^T, in order") {
  DiagonalPivot<cl_R> field;
  const std::vector<cl_R> matrix{4, 2, 2, 2, 5, 3, 2, 3, 1};
  const Echelon<DiagonalPivot<cl_R>> echelon(field, matrix, 3, 3);
  REQUIRE(echelon.rank() == 3);
  CHECK(echelon.pivots()[0].value == 4);
  CHECK(echelon.pivots()[1].value == 4);
  CHECK(echelon.pivots()[2].value == -1);
  const std::vector<cl_R> exchanged{0, 1, 1, 0};
  CHECK(Echelon<DiagonalPivot<cl_R>>(field, exchanged, 2, 2).rank() == 0);
}

TEST_CASE("diagonal elimination in double has a pivot in each row, infinite after a 0") {
  DiagonalPivot<double> field;
  const std::vector<double> matrix{0, 1, 1, 0};
  const Echelon<DiagonalPivot<double>> echelon(field, matrix, 2, 2);
  REQUIRE(echelon.rank() == 2);
  CHECK(echelon.pivots()[0].value == 0);
  CHECK_FALSE(std::isfinite(echelon.pivots()[1].value));
}
