// Owning pointers to models and states of MuJoCo.
#pragma once

#include <mujoco/mujoco.h>

#include <memory>
#include <string>

namespace elgen::test {

struct DeleteMujocoModel {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
};
struct DeleteMujocoData {
  void operator()(mjData* data) const { mj_deleteData(data); }
};
using MujocoModel = std::unique_ptr<mjModel, DeleteMujocoModel>;
using MujocoData = std::unique_ptr<mjData, DeleteMujocoData>;

/// Loads MJCF or URDF. Contacts and joint limits are disabled.
[[nodiscard]] MujocoModel load_mujoco(const std::string& text);

}  // namespace elgen::test
