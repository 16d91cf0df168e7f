// SPDX-License-Identifier: 0BSD
// Plans a force that swings the pole up in 2 s with the minimal integral of u^2, by Hermite-Simpson
// collocation. On each interval of length h with midpoint m and f = dx/dt:
//   x_j - x_i = h/6 (f_i + 4 f_m + f_j),   x_m = (x_i + x_j)/2 + h/8 (f_i - f_j).
// (Kelly, An introduction to trajectory optimization, SIAM Review 59, 2017, section 4.) Ipopt gets
// df/dx and df/du from elgen's code; `plan --check` first compares them with differences.
#include <IpIpoptApplication.hpp>
#include <IpSolveStatistics.hpp>
#include <cstdio>
#include <sstream>

#include "cart_pole_plan/cart_pole_plan_eigen.hpp"

namespace plant = cart_pole_plan;
using Eigen::Map, Eigen::Matrix, Eigen::Matrix4d, Ipopt::SmartPtr, plant::unbounded;
constexpr int intervals = 100, points = 2 * intervals + 1, blocks = 6 * intervals;
constexpr double h = 2.0 / intervals;
using State = Matrix<double, 4, 1>;                // x, theta and their rates
using Plan = Matrix<double, 5, points>;            // column: state and force at a point
using Defects = Matrix<double, 4, 2 * intervals>;  // (x_i x_m x_j) S + (f_i f_m f_j) R
const Matrix<double, 3, 2> S{{-1, -0.5}, {0, 1}, {1, -0.5}};
const Matrix<double, 3, 2> R{{-h / 6, -h / 8}, {-4 * h / 6, 0}, {-h / 6, h / 8}};
const State hanging{0, 3.141592653589793, 0, 0}, upright{0, 0, 0, 0};
const plant::Parameters<double> cart;
State rate(const State& s, double u) {
  const auto a = plant::forward_dynamics(cart, {s[0], s[1]}, {s[2], s[3]}, {u}).acceleration;
  return {s[2], s[3], a[0], a[1]};
}

struct SwingUp : Ipopt::TNLP {
  Plan low, high, plan = Plan::Zero(), weights = Plan::Zero();
  SwingUp() {
    const auto rail = plant::coordinate_ranges[0], force = plant::input_limits[0];
    low.colwise() = Matrix<double, 5, 1>{rail.low, -unbounded, -unbounded, -unbounded, force.low};
    high.colwise() = Matrix<double, 5, 1>{rail.high, unbounded, unbounded, unbounded, force.high};
    low.col(0).head<4>() = high.col(0).head<4>() = hanging;
    low.rightCols<1>().topRows<4>() = high.rightCols<1>().topRows<4>() = upright;
    plan.row(1).setLinSpaced(hanging[1], upright[1]);
    for (int i = 0; i < points - 1; i += 2) weights.row(4).segment<3>(i) -= R.col(0);
  }
  bool get_nlp_info(int& n, int& m, int& nonzeros, int& hessian, IndexStyleEnum& style) final {
    n = Plan::SizeAtCompileTime, m = Defects::SizeAtCompileTime;
    nonzeros = 20 * blocks, hessian = 0, style = C_STYLE;
    return true;
  }
  bool get_bounds_info(int, double* from, double* to, int, double* least, double* most) final {
    Map<Plan>{from} = low, Map<Plan>{to} = high;
    Map<Defects>{least} = Map<Defects>{most} = Defects::Zero();
    return true;
  }
  bool get_starting_point(int, bool, double* z, bool, double*, double*, int, bool, double*) final {
    Map<Plan>{z} = plan;
    return true;
  }
  bool eval_f(int, const double* z, bool, double& cost) final {
    cost = Map<const Plan>(z).cwiseAbs2().cwiseProduct(weights).sum();
    return true;
  }
  bool eval_grad_f(int, const double* z, bool, double* slope) final {
    Map<Plan>{slope} = 2 * Map<const Plan>(z).cwiseProduct(weights);
    return true;
  }
  bool eval_g(int, const double* z, bool, int, double* defects) final {
    const Map<const Plan> p(z);
    Matrix<double, 4, points> f;
    for (int i = 0; i < points; ++i) f.col(i) = rate(p.col(i).head<4>(), p(4, i));
    for (int i = 0; i < points - 1; i += 2) {
      Map<Defects>(defects).middleCols<2>(i) = p.block<4, 3>(0, i) * S + f.middleCols<3>(i) * R;
    }
    return true;
  }
  bool eval_jac_g(int, const double* z, bool, int, int, int* rows, int* columns, double* J) final {
    for (int block = 0; block < blocks; ++block) {  // derivatives of a defect column at one point
      const int defect = block / 3, rule = defect % 2, k = block % 3, point = defect - rule + k;
      for (int i = 0; J == nullptr && i < 20; ++i) {
        *rows++ = 4 * defect + i % 4, *columns++ = 5 * point + i / 4;
      }
      if (J == nullptr) continue;
      const Matrix<double, 5, 1> p = Map<const Plan>(z).col(point);
      const auto f = plant::eigen::linearization(cart, p.head<2>(), p.segment<2>(2), p.tail<1>());
      Map<Matrix4d>(J + 20 * block) = S(k, rule) * Matrix4d::Identity() + R(k, rule) * f.A;
      Map<State>(J + 20 * block + 16) = R(k, rule) * f.B;
    }
    return true;
  }
  void finalize_solution(Ipopt::SolverReturn, int, const double* z, const double*, const double*,
                         int, const double*, const double*, double, const Ipopt::IpoptData*,
                         Ipopt::IpoptCalculatedQuantities*) final {
    plan = Map<const Plan>(z);
  }
};

int main(int argc, char**) {
  const SmartPtr<SwingUp> problem = new SwingUp;
  const SmartPtr<Ipopt::IpoptApplication> ipopt = new Ipopt::IpoptApplication;
  std::istringstream options(
      std::string("hessian_approximation limited-memory bound_relax_factor 0 sb yes print_level ") +
      (argc > 1 ? "4 derivative_test first-order derivative_test_tol 1e-6" : "0"));
  ipopt->Initialize(options);
  const auto status = ipopt->OptimizeTNLP(SmartPtr<Ipopt::TNLP>(GetRawPtr(problem)));
  const Plan& plan = problem->plan;
  Defects defects;
  problem->eval_g(0, plan.data(), true, 0, defects.data());
  const double miss = std::max({defects.cwiseAbs().maxCoeff(), (problem->low - plan).maxCoeff(),
                                (plan - problem->high).maxCoeff()});
  State s = hanging;
  for (int i = 0; i < points - 1; i += 2) {
    const State a = rate(s, plan(4, i)), b = rate(s + h / 2 * a, plan(4, i + 1));
    const State c = rate(s + h / 2 * b, plan(4, i + 1)), d = rate(s + h * c, plan(4, i + 2));
    s += h / 6 * (a + 2 * b + 2 * c + d);
  }
  const double distance = (s - plan.rightCols<1>().topRows<4>()).cwiseAbs().maxCoeff();
  const auto run = ipopt->Statistics();
  std::printf("integral of u^2 %.3f N^2 s, at most %.2f N, after %d iterations\n",
              run->FinalObjective(), plan.row(4).cwiseAbs().maxCoeff(), run->IterationCount());
  std::printf("constraints are met to %.1e, a run by rk4 ends %.1e away\n", miss, distance);
  const bool is_solved = status == Ipopt::Solve_Succeeded && miss < 1e-8 && distance < 1e-2;
  std::fprintf(stderr, "%ssolved in %.2f s\n", is_solved ? "" : "not ", run->TotalWallclockTime());
  return is_solved ? 0 : 1;
}
