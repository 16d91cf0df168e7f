#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <stdexcept>

#include "independent/mjcf.hpp"
#include "independent/oracle.hpp"
#include "independent/robot.hpp"
#include "support/shell.hpp"

namespace elgen::test {

namespace {

struct DeleteModel {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
};
struct DeleteData {
  void operator()(mjData* data) const { mj_deleteData(data); }
};
struct DeleteFiles {
  void operator()(mjVFS* files) const {
    mj_deleteVFS(files);
    delete files;
  }
};
using Model = std::unique_ptr<mjModel, DeleteModel>;
using Data = std::unique_ptr<mjData, DeleteData>;

/// MuJoCo reads files: the text becomes one that is nowhere on the disk.
Model load(const std::string& text) {
  const std::unique_ptr<mjVFS, DeleteFiles> files(new mjVFS);
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), "robot.xml", static_cast<int>(text.size()));
  std::memcpy(files->filedata[0], text.data(), text.size());
  std::array<char, 1000> error{};
  Model model(mj_loadXML("robot.xml", files.get(), error.data(), error.size()));
  if (!model) throw std::runtime_error(error.data());
  // Neither contacts nor stops: only what moves the links themselves.
  model->opt.disableflags |= mjDSBL_CONSTRAINT;
  return model;
}

std::vector<double> numbers(const mjtNum* first, int size) { return {first, first + size}; }

class MujocoOracle {
 public:
  explicit MujocoOracle(Model model) : model_(std::move(model)), data_(mj_makeData(model_.get())) {}

  [[nodiscard]] Dynamics at(const State& state) const {
    const int size = model_->nv;
    if (static_cast<int>(state.v.size()) != size) throw std::runtime_error("wrong size of state");
    std::copy(state.q.begin(), state.q.end(), data_->qpos);
    std::copy(state.v.begin(), state.v.end(), data_->qvel);
    mj_forward(model_.get(), data_.get());
    Dynamics result{
        std::vector<double>(state.v.size() * state.v.size()), numbers(data_->qfrc_bias, size), {}};
    mj_fullM(model_.get(), result.mass_matrix.data(), data_->qM);
    // Dampers are passive forces here.
    for (std::size_t i = 0; i < state.v.size(); ++i) result.bias[i] -= data_->qfrc_passive[i];
    std::copy(state.a.begin(), state.a.end(), data_->qacc);
    mj_inverse(model_.get(), data_.get());
    result.torque = numbers(data_->qfrc_inverse, size);
    return result;
  }

 private:
  Model model_;
  Data data_;
};

Oracle oracle_of(const std::string& text) {
  return [solver = std::make_shared<const MujocoOracle>(load(text))](const State& state) {
    return solver->at(state);
  };
}

}  // namespace

Oracle mujoco_oracle(const Robot& robot) { return oracle_of(mjcf(robot)); }

Oracle mujoco_oracle(const std::filesystem::path& urdf) { return oracle_of(read_text(urdf)); }

}  // namespace elgen::test
