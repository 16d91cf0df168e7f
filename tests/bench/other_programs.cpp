#include "other_programs.hpp"

#include <algorithm>
#include <memory>

#include "independent/robot.hpp"
#ifdef WITH_KDL
#include <kdl/chaindynparam.hpp>
#include <kdl/chainidsolver_recursive_newton_euler.hpp>

#include "independent/kdl_tree.hpp"
#endif
#ifdef WITH_MUJOCO
#include "independent/mjcf.hpp"
#include "independent/mujoco_model.hpp"
#include "support/shell.hpp"
#endif

namespace bench {

namespace {

namespace test = elgen::test;

bool is_urdf(const std::filesystem::path& path) { return path.extension() == ".urdf"; }

#ifdef WITH_KDL
struct KdlRobot {
  explicit KdlRobot(const test::Robot& robot) : chain(test::kdl_chain(robot)) {}

  void set(const double* at_q, const double* at_v, const double* at_a) {
    std::copy_n(at_q, size, q.data.data());
    std::copy_n(at_v, size, v.data.data());
    std::copy_n(at_a, size, a.data.data());
  }

  KDL::Chain chain;
  unsigned size = chain.getNrOfJoints();
  KDL::ChainDynParam parts{chain, test::kdl_gravity()};
  KDL::ChainIdSolver_RNE solver{chain, test::kdl_gravity()};
  KDL::JntSpaceInertiaMatrix mass{static_cast<int>(size)};
  KDL::JntArray q{size}, v{size}, a{size}, rest{size}, result{size};
  KDL::Wrenches no_loads{chain.getNrOfSegments(), KDL::Wrench::Zero()};
};

OtherProgram kdl_program(const std::filesystem::path& description) {
  const auto robot = std::make_shared<KdlRobot>(test::read_robot(description));
  return {"KDL",
          [robot](const double* q, const double* v, const double* a) {
            robot->set(q, v, a);
            robot->parts.JntToMass(robot->q, robot->mass);
          },
          [robot](const double* q, const double* v, const double* a) {
            robot->set(q, v, a);
            robot->solver.CartToJnt(robot->q, robot->v, robot->rest, robot->no_loads,
                                    robot->result);
          },
          [robot](const double* q, const double* v, const double* a) {
            robot->set(q, v, a);
            robot->solver.CartToJnt(robot->q, robot->v, robot->a, robot->no_loads, robot->result);
          }};
}
#endif

#ifdef WITH_MUJOCO
struct MujocoRobot {
  explicit MujocoRobot(const std::string& text)
      : model(test::load_mujoco(text)), data(mj_makeData(model.get())) {}

  /// Sets the state and computes only the kinematics that M and the forces need.
  void set(const double* q, const double* v, const double* a) {
    std::copy_n(q, model->nq, data->qpos);
    std::copy_n(v, model->nv, data->qvel);
    std::copy_n(a, model->nv, data->qacc);
    mj_kinematics(model.get(), data.get());
    mj_comPos(model.get(), data.get());
  }

  void forces(int with_acceleration) {
    mj_comVel(model.get(), data.get());
    mj_rne(model.get(), data.get(), with_acceleration, result.data());
  }

  test::MujocoModel model;
  test::MujocoData data;
  std::vector<double> result = std::vector<double>(static_cast<std::size_t>(model->nv * model->nv));
};

OtherProgram mujoco_program(const std::filesystem::path& description) {
  const auto robot = std::make_shared<MujocoRobot>(is_urdf(description)
                                                       ? test::read_text(description)
                                                       : test::mjcf(test::read_robot(description)));
  return {"MuJoCo",
          [robot](const double* q, const double* v, const double* a) {
            robot->set(q, v, a);
            mj_crb(robot->model.get(), robot->data.get());
            mj_fullM(robot->model.get(), robot->result.data(), robot->data->qM);
          },
          [robot](const double* q, const double* v, const double* a) {
            robot->set(q, v, a);
            robot->forces(0);
          },
          [robot](const double* q, const double* v, const double* a) {
            robot->set(q, v, a);
            robot->forces(1);
          }};
}
#endif

}  // namespace

std::vector<OtherProgram> other_programs(const std::filesystem::path& description) {
  std::vector<OtherProgram> programs;
#ifdef WITH_KDL
  if (!is_urdf(description)) programs.push_back(kdl_program(description));
#endif
#ifdef WITH_MUJOCO
  programs.push_back(mujoco_program(description));
#endif
  return programs;
}

}  // namespace bench
