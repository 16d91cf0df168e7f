// A robot as a KDL::Tree; chains are also given to the solvers that KDL has for chains alone.
#include <fmt/format.h>

#include <kdl/chaindynparam.hpp>
#include <kdl/chainidsolver_recursive_newton_euler.hpp>
#include <kdl/tree.hpp>
#include <kdl/treeidsolver_recursive_newton_euler.hpp>
#include <memory>
#include <stdexcept>

#include "independent/robot.hpp"

namespace elgen::test {

namespace {

KDL::Vector vector(const Triple& x) { return {x[0], x[1], x[2]}; }

const KDL::Vector& weight() {
  static const KDL::Vector vector(0.0, 0.0, -gravity_of_earth);
  return vector;
}

std::string link_name(int index) { return index < 0 ? "base" : fmt::format("link{}", index); }

/// Rx of an exact right angle.
KDL::Rotation about_x(int quarter_turns) {
  const double sine = quarter_turns;
  const double cosine = quarter_turns == 0 ? 1.0 : 0.0;
  return {1.0, 0.0, 0.0, 0.0, cosine, -sine, 0.0, sine, cosine};
}

KDL::Segment segment(const Link& link, int index) {
  const KDL::Rotation turned = about_x(link.quarter_turns);
  const KDL::Vector origin = vector(link.translation);
  const std::string joint = fmt::format("joint{}", index);
  const auto& [xx, yy, zz, xy, xz, yz] = link.inertia;
  const KDL::Joint turning(joint, origin, turned.UnitZ(), KDL::Joint::RotAxis);
  const KDL::RigidBodyInertia inertia(link.mass, vector(link.com),
                                      KDL::RotationalInertia(xx, yy, zz, xy, xz, yz));
  return KDL::Segment(link_name(index), turning, KDL::Frame(turned, origin), inertia);
}

KDL::Tree tree(const Robot& robot) {
  if (robot.floating) throw std::runtime_error("KDL has no dynamics of a free base");
  KDL::Tree result("base");
  for (int i = 0; i < static_cast<int>(robot.links.size()); ++i) {
    const Link& link = robot.links[static_cast<std::size_t>(i)];
    result.addSegment(segment(link, i), link_name(link.parent));
  }
  return result;
}

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

/// By ChainDynParam and ChainIdSolver_RNE.
class ChainOracle {
 public:
  explicit ChainOracle(const Robot& robot) {
    if (!tree(robot).getChain("base", link_name(static_cast<int>(robot.links.size()) - 1),
                              chain_)) {
      throw std::runtime_error("no chain");
    }
  }

  [[nodiscard]] Dynamics at(const State& state) const {
    KDL::ChainDynParam parts(chain_, weight());
    KDL::ChainIdSolver_RNE solver(chain_, weight());
    const unsigned size = chain_.getNrOfJoints();
    const KDL::JntArray q = joints(state.q);
    const KDL::JntArray v = joints(state.v);
    KDL::JntSpaceInertiaMatrix mass(size);
    KDL::JntArray velocity_force(size), gravity(size), bias(size), torque(size);
    demand(parts.JntToMass(q, mass));
    demand(parts.JntToCoriolis(q, v, velocity_force));
    demand(parts.JntToGravity(q, gravity));
    KDL::Add(velocity_force, gravity, bias);
    const KDL::Wrenches no_loads(chain_.getNrOfSegments(), KDL::Wrench::Zero());
    demand(solver.CartToJnt(q, v, joints(state.a), no_loads, torque));
    // Symmetric, so that Eigen's order of columns does not matter.
    return {
        {mass.data.data(), mass.data.data() + mass.data.size()}, numbers(bias), numbers(torque)};
  }

 private:
  KDL::Chain chain_;
};

/// By TreeIdSolver_RNE alone: the columns of M are what unit accelerations take at rest.
class TreeOracle {
 public:
  explicit TreeOracle(const Robot& robot) : tree_(tree(robot)) {}

  [[nodiscard]] Dynamics at(const State& state) const {
    const std::size_t size = state.v.size();
    const std::vector<double> rest(size, 0.0);
    Dynamics result{{}, torque({state.q, state.v, rest}, weight()), torque(state, weight())};
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

Oracle kdl_oracle(const Robot& robot) {
  return is_chain(robot) ? oracle_of<ChainOracle>(robot) : oracle_of<TreeOracle>(robot);
}

}  // namespace elgen::test
