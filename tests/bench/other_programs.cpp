#include "other_programs.hpp"

#include <algorithm>
#include <memory>

#ifdef WITH_KDL
#include <kdl/chaindynparam.hpp>
#include <kdl/chainidsolver_recursive_newton_euler.hpp>

#include "independent/kdl_tree.hpp"
#endif
#ifdef WITH_MUJOCO
#include "independent/mjcf.hpp"
#include "independent/mujoco_model.hpp"
#endif

namespace bench {

namespace {

using elgen::test::Robot;

#ifdef WITH_KDL
struct KdlArm {
  explicit KdlArm(const Robot& robot) : chain(elgen::test::kdl_chain(robot)) {}

  void set(const double* at_q, const double* at_v, const double* at_a) {
    std::copy_n(at_q, size, q.data.data());
    std::copy_n(at_v, size, v.data.data());
    std::copy_n(at_a, size, a.data.data());
  }

  KDL::Chain chain;
  unsigned size = chain.getNrOfJoints();
  KDL::ChainDynParam parts{chain, elgen::test::kdl_gravity()};
  KDL::ChainIdSolver_RNE solver{chain, elgen::test::kdl_gravity()};
  KDL::JntSpaceInertiaMatrix mass{static_cast<int>(size)};
  KDL::JntArray q{size}, v{size}, a{size}, rest{size}, result{size};
  KDL::Wrenches no_loads{chain.getNrOfSegments(), KDL::Wrench::Zero()};
};

OtherProgram kdl_program(const Robot& robot) {
  const auto arm = std::make_shared<KdlArm>(robot);
  return {"KDL",
          [arm](const double* q, const double* v, const double* a) {
            arm->set(q, v, a);
            arm->parts.JntToMass(arm->q, arm->mass);
          },
          [arm](const double* q, const double* v, const double* a) {
            arm->set(q, v, a);
            arm->solver.CartToJnt(arm->q, arm->v, arm->rest, arm->no_loads, arm->result);
          },
          [arm](const double* q, const double* v, const double* a) {
            arm->set(q, v, a);
            arm->solver.CartToJnt(arm->q, arm->v, arm->a, arm->no_loads, arm->result);
          }};
}
#endif

#ifdef WITH_MUJOCO
struct MujocoArm {
  explicit MujocoArm(const Robot& robot)
      : model(elgen::test::load_mujoco(elgen::test::mjcf(robot))), data(mj_makeData(model.get())) {}

  /// What M and the forces are made of, and no more.
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

  elgen::test::MujocoModel model;
  elgen::test::MujocoData data;
  std::vector<double> result = std::vector<double>(static_cast<std::size_t>(model->nv * model->nv));
};

OtherProgram mujoco_program(const Robot& robot) {
  const auto arm = std::make_shared<MujocoArm>(robot);
  return {"MuJoCo",
          [arm](const double* q, const double* v, const double* a) {
            arm->set(q, v, a);
            mj_crb(arm->model.get(), arm->data.get());
            mj_fullM(arm->model.get(), arm->result.data(), arm->data->qM);
          },
          [arm](const double* q, const double* v, const double* a) {
            arm->set(q, v, a);
            arm->forces(0);
          },
          [arm](const double* q, const double* v, const double* a) {
            arm->set(q, v, a);
            arm->forces(1);
          }};
}
#endif

}  // namespace

std::vector<OtherProgram> other_programs([[maybe_unused]] const Robot& robot) {
  std::vector<OtherProgram> programs;
#ifdef WITH_KDL
  programs.push_back(kdl_program(robot));
#endif
#ifdef WITH_MUJOCO
  programs.push_back(mujoco_program(robot));
#endif
  return programs;
}

}  // namespace bench
