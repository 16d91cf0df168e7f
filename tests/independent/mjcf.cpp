#include "independent/mjcf.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "independent/robot.hpp"

namespace elgen::test {

namespace {

template <std::size_t Size>
std::string spaced(const std::array<double, Size>& numbers) {
  return fmt::format("{:.17g}", fmt::join(numbers, " "));
}

/// The quaternion of Rx(quarter_turns * 90 degrees); MuJoCo normalises it.
std::string quaternion(int quarter_turns) {
  return quarter_turns == 0 ? "1 0 0 0" : fmt::format("1 {} 0 0", quarter_turns);
}

/// <inertial> of `link`, diagonalised here, because MuJoCo diagonalises inertias to few digits.
std::string inertial(const Link& link) {
  const auto& [xx, yy, zz, xy, xz, yz] = link.inertia;
  const Eigen::Matrix3d inertia{{xx, xy, xz}, {xy, yy, yz}, {xz, yz, zz}};
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(inertia);
  const Eigen::Vector3d moments = solver.eigenvalues();
  Eigen::Matrix3d axes = solver.eigenvectors();
  if (axes.determinant() < 0) axes.col(0) *= -1.0;
  const Eigen::Quaterniond turned(axes);
  return fmt::format("<inertial pos='{}' mass='{:.17g}' quat='{}' diaginertia='{}'/>\n",
                     spaced(link.com), link.mass,
                     spaced(std::array{turned.w(), turned.x(), turned.y(), turned.z()}),
                     spaced(std::array{moments[0], moments[1], moments[2]}));
}

/// The element <body> of the link `index`; it contains the elements of all descendants.
std::string body(const Robot& robot, int index) {
  const Link& link = robot.links[static_cast<std::size_t>(index)];
  const bool is_free = robot.floating && index == 0;
  std::string text = fmt::format(
      "<body pos='{}' quat='{}'>\n{}\n{}", spaced(link.translation), quaternion(link.quarter_turns),
      is_free ? "<freejoint/>" : "<joint type='hinge' axis='0 0 1'/>", inertial(link));
  for (int child = index + 1; child < static_cast<int>(robot.links.size()); ++child) {
    if (robot.links[static_cast<std::size_t>(child)].parent == index) text += body(robot, child);
  }
  return text + "</body>\n";
}

}  // namespace

std::string mjcf(const Robot& robot) {
  std::string text =
      fmt::format("<mujoco>\n<compiler angle='radian'/>\n<option gravity='0 0 {}'/>\n<worldbody>\n",
                  -gravity_of_earth);
  for (int i = 0; i < static_cast<int>(robot.links.size()); ++i) {
    if (robot.links[static_cast<std::size_t>(i)].parent < 0) text += body(robot, i);
  }
  return text + "</worldbody>\n</mujoco>\n";
}

}  // namespace elgen::test
