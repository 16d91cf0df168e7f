#include "independent/robot.hpp"

#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace elgen::test {

namespace {

using Json = nlohmann::json;

/// The link in a row of "joints": alpha in degrees, translation, mass, centre of mass, inertia.
Link read_link(const Json& row, int parent) {
  const int degrees = row.at(0).get<int>();
  if (degrees % 90 != 0) throw std::runtime_error("only right angles between axes");
  return {parent,
          degrees / 90,
          row.at(1).get<Triple>(),
          row.at(2).get<double>(),
          row.at(3).get<Triple>(),
          row.at(4).get<std::array<double, 6>>()};
}

/// q_i = 0.3 + 0.1 i, v_i = -0.2 + 0.15 i, a_i = 0.5 - 0.1 i, as "check" in the JSON describes.
State reference_state(std::size_t size) {
  State state;
  for (std::size_t i = 0; i < size; ++i) {
    const auto index = static_cast<double>(i);
    state.q.push_back(0.3 + 0.1 * index);
    state.v.push_back(-0.2 + 0.15 * index);
    state.a.push_back(0.5 - 0.1 * index);
  }
  return state;
}

}  // namespace

Robot read_robot(const std::filesystem::path& path, bool floating) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot read " + path.string());
  const Json json = Json::parse(file);
  Robot robot{path.stem().string(), floating};
  const Json& joints = json.at("joints");
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const int before = static_cast<int>(i) - 1;
    const int parent = json.contains("parents") ? json["parents"].at(i).get<int>() : before;
    if (parent > before) throw std::runtime_error("a parent comes before its children");
    robot.links.push_back(read_link(joints[i], parent));
  }
  if (json.contains("check")) {
    const Json& check = json["check"];
    robot.reference = {reference_state(joints.size()), check.at("tau"), check.at("M_row0"),
                       check.at("g")};
  }
  return robot;
}

bool is_chain(const Robot& robot) {
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    if (robot.links[i].parent != static_cast<int>(i) - 1) return false;
  }
  return true;
}

}  // namespace elgen::test
