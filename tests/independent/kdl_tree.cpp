#include "independent/kdl_tree.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <string>

#include "independent/robot.hpp"

namespace elgen::test {

namespace {

std::string kdl_name(int link) { return link < 0 ? "base" : fmt::format("link{}", link); }

KDL::Vector vector(const Triple& x) { return {x[0], x[1], x[2]}; }

/// Rx(quarter_turns * 90 degrees), exact.
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
  return KDL::Segment(kdl_name(index), turning, KDL::Frame(turned, origin), inertia);
}

}  // namespace

KDL::Tree kdl_tree(const Robot& robot) {
  if (robot.floating) throw std::runtime_error("KDL has no dynamics of a free base");
  KDL::Tree result("base");
  for (int i = 0; i < static_cast<int>(robot.links.size()); ++i) {
    const Link& link = robot.links[static_cast<std::size_t>(i)];
    result.addSegment(segment(link, i), kdl_name(link.parent));
  }
  return result;
}

KDL::Chain kdl_chain(const Robot& robot) {
  const int last = static_cast<int>(robot.links.size()) - 1;
  KDL::Chain chain;
  if (!kdl_tree(robot).getChain("base", kdl_name(last), chain)) {
    throw std::runtime_error("no chain");
  }
  return chain;
}

KDL::Vector kdl_gravity() { return {0.0, 0.0, -gravity_of_earth}; }

}  // namespace elgen::test
