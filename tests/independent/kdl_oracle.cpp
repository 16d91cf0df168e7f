// Chains use KDL's solvers for chains; branched robots use KDL's solver for trees.
#include <kdl/chaindynparam.hpp>
#include <kdl/chainidsolver_recursive_newton_euler.hpp>
#include <kdl/treeidsolver_recursive_newton_euler.hpp>
#include <memory>
#include <stdexcept>

#include "independent/kdl_tree.hpp"
#include "independent/robot.hpp"

namespace elgen::test {

namespace {

KDL::JntArray joints(const std::vector<double>& values) {
  KDL::JntArray result(static_cast<unsigned>(values.size()));
  for (unsigned i = 0; i < values.size(); ++i) result(i) = values[i];
  return result;
}

std::vector<double> numbers(const KDL::JntArray& values) {
  return {values.data.data(), values.data.data() + values.rows()};
}

void demand(int status) {
  if (status != KDL::SolverI::E_NOERROR) throw std::runtime_error("KDL refuses the state");
}

/// Uses ChainDynParam and ChainIdSolver_RNE.
class ChainOracle {
 public:
  explicit ChainOracle(const Robot& robot) : chain_(kdl_chain(robot)) {}

  [[nodiscard]] Dynamics at(const State& state) const {
    KDL::ChainDynParam parts(chain_, kdl_gravity());
    KDL::ChainIdSolver_RNE solver(chain_, kdl_gravity());
    const unsigned size = chain_.getNrOfJoints();
    const KDL::JntArray q = joints(state.q);
    const KDL::JntArray v = joints(state.v);
    KDL::JntSpaceInertiaMatrix mass(static_cast<int>(size));
    KDL::JntArray velocity_force(size), gravity(size), bias(size), torque(size);
    demand(parts.JntToMass(q, mass));
    demand(parts.JntToCoriolis(q, v, velocity_force));
    demand(parts.JntToGravity(q, gravity));
    KDL::Add(velocity_force, gravity, bias);
    const KDL::Wrenches no_loads(chain_.getNrOfSegments(), KDL::Wrench::Zero());
    demand(solver.CartToJnt(q, v, joints(state.a), no_loads, torque));
    // M is symmetric, so Eigen's column-major order does not matter.
    return {
        {mass.data.data(), mass.data.data() + mass.data.size()}, numbers(bias), numbers(torque)};
  }

 private:
  KDL::Chain chain_;
};

/// Uses TreeIdSolver_RNE only. Column i of M is the torque for a unit acceleration i at rest
/// without gravity.
class TreeOracle {
 public:
  explicit TreeOracle(const Robot& robot) : tree_(kdl_tree(robot)) {}

  [[nodiscard]] Dynamics at(const State& state) const {
    const std::size_t size = state.v.size();
    const std::vector<double> rest(size, 0.0);
    Dynamics result{
        {}, torque({state.q, state.v, rest}, kdl_gravity()), torque(state, kdl_gravity())};
    for (std::size_t i = 0; i < size; ++i) {
      std::vector<double> unit = rest;
      unit[i] = 1.0;
      const std::vector<double> column = torque({state.q, rest, unit}, KDL::Vector::Zero());
      result.mass_matrix.insert(result.mass_matrix.end(), column.begin(), column.end());
    }
    return result;
  }

 private:
  [[nodiscard]] std::vector<double> torque(const State& state, const KDL::Vector& gravity) const {
    KDL::TreeIdSolver_RNE solver(tree_, gravity);
    KDL::JntArray result(tree_.getNrOfJoints());
    demand(solver.CartToJnt(joints(state.q), joints(state.v), joints(state.a), {}, result));
    return numbers(result);
  }

  KDL::Tree tree_;
};

template <class Solver>
Oracle oracle_of(const Robot& robot) {
  return [solver = std::make_shared<const Solver>(robot)](const State& state) {
    return solver->at(state);
  };
}

}  // namespace

Oracle kdl_oracle(const std::filesystem::path& description, bool floating) {
  const Robot robot = read_robot(description, floating);
  return is_chain(robot) ? oracle_of<ChainOracle>(robot) : oracle_of<TreeOracle>(robot);
}

}  // namespace elgen::test
