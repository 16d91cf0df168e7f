// SPDX-License-Identifier: 0BSD
// The gain K of u = -K x that minimises the integral of x'Q x + u'R u for dx/dt = A x + B u.
// K = R^-1 B'S, and S solves the continuous-time algebraic Riccati equation
//     A'S + S A - S B R^-1 B'S + Q = 0
// with A - B K stable. S = Y X^-1 from the eigenvectors (X; Y) of the Hamiltonian matrix
// [A, -B R^-1 B'; -Q, -A'] for eigenvalues with Re < 0 (Potter, Matrix quadratic solutions, 1966).
#pragma once

#include <Eigen/Eigenvalues>
#include <stdexcept>

inline Eigen::MatrixXd lqr(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B,
                           const Eigen::MatrixXd& Q, const Eigen::MatrixXd& R) {
  using Eigen::MatrixXd;
  const Eigen::Index n = A.rows();
  const MatrixXd gain_of_S = Eigen::FullPivLU<MatrixXd>(R).solve(B.transpose());
  MatrixXd hamiltonian(2 * n, 2 * n);
  hamiltonian << A, -B * gain_of_S, -Q, -A.transpose();
  const Eigen::EigenSolver<MatrixXd> modes(hamiltonian);
  MatrixXd stable(2 * n, 0);
  for (Eigen::Index i = 0; i < 2 * n; ++i) {
    if (modes.eigenvalues()[i].real() >= 0) continue;
    stable.conservativeResize(Eigen::NoChange, stable.cols() + 1);
    stable.rightCols(1) = modes.pseudoEigenvectors().col(i);  // Re and Im of complex pairs
  }
  const Eigen::FullPivLU<MatrixXd> X(stable.topRows(n).transpose());
  if (stable.cols() != n || !X.isInvertible()) throw std::domain_error("lqr: no stable solution");
  return gain_of_S * X.solve(stable.bottomRows(n).transpose()).transpose();
}
