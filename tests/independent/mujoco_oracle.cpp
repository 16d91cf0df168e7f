#include <algorithm>
#include <memory>
#include <stdexcept>

#include "independent/mjcf.hpp"
#include "independent/mujoco_model.hpp"
#include "independent/oracle.hpp"
#include "independent/robot.hpp"
#include "support/shell.hpp"

namespace elgen::test {

namespace {

std::vector<double> numbers(const mjtNum* first, int size) { return {first, first + size}; }

class MujocoOracle {
 public:
  explicit MujocoOracle(MujocoModel model)
      : model_(std::move(model)), data_(mj_makeData(model_.get())) {}

  [[nodiscard]] Dynamics at(const State& state) const {
    const int size = model_->nv;
    if (static_cast<int>(state.v.size()) != size) throw std::runtime_error("wrong size of state");
    std::copy(state.q.begin(), state.q.end(), data_->qpos);
    std::copy(state.v.begin(), state.v.end(), data_->qvel);
    mj_forward(model_.get(), data_.get());
    Dynamics result{
        std::vector<double>(state.v.size() * state.v.size()), numbers(data_->qfrc_bias, size), {}};
    mj_fullM(model_.get(), result.mass_matrix.data(), data_->qM);
    // MuJoCo counts joint dampers as passive forces, not as bias.
    for (std::size_t i = 0; i < state.v.size(); ++i) result.bias[i] -= data_->qfrc_passive[i];
    std::copy(state.a.begin(), state.a.end(), data_->qacc);
    mj_inverse(model_.get(), data_.get());
    result.torque = numbers(data_->qfrc_inverse, size);
    return result;
  }

 private:
  MujocoModel model_;
  MujocoData data_;
};

}  // namespace

Oracle mujoco_oracle(const std::filesystem::path& description, bool floating) {
  const std::string text = description.extension() == ".urdf"
                               ? read_text(description)
                               : mjcf(read_robot(description, floating));
  return [solver = std::make_shared<const MujocoOracle>(load_mujoco(text))](const State& state) {
    return solver->at(state);
  };
}

}  // namespace elgen::test
