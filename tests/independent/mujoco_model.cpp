#include "independent/mujoco_model.hpp"

#include <array>
#include <cstring>
#include <stdexcept>

namespace elgen::test {

namespace {

struct DeleteFiles {
  void operator()(mjVFS* files) const {
    mj_deleteVFS(files);
    delete files;
  }
};
}  // namespace

/// Loads `text` from a file of MuJoCo's virtual file system, because MuJoCo reads only files.
MujocoModel load_mujoco(const std::string& text) {
  const std::unique_ptr<mjVFS, DeleteFiles> files(new mjVFS);
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), "robot.xml", static_cast<int>(text.size()));
  std::memcpy(files->filedata[0], text.data(), text.size());
  std::array<char, 1000> error{};
  MujocoModel model(mj_loadXML("robot.xml", files.get(), error.data(), error.size()));
  if (!model) throw std::runtime_error(error.data());
  model->opt.disableflags |= mjDSBL_CONSTRAINT;
  return model;
}

}  // namespace elgen::test
