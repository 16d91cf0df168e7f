// The hand-written recursion of the Panda-like arm with the numbers of tests/reference/panda7.json.
#pragma once

#include <stdexcept>

#include "bench/newton_euler_panda.hpp"
#include "independent/robot.hpp"

namespace bench {

/// The hand-written arm with the numbers of `robot`. Throws runtime_error unless `robot` is panda7.
inline Panda<double> panda_of(const elgen::test::Robot& robot) {
  if (robot.name != "panda7") throw std::runtime_error("not the Panda");
  Panda<double> panda{};
  for (std::size_t i = 0; i < 7; ++i) {
    const elgen::test::Link& link = robot.links.at(i);
    const auto& [x, y, z] = link.com;
    const auto& [xx, yy, zz, xy, xz, yz] = link.inertia;
    panda.link[i] = {link.mass, {x, y, z}, {xx, yy, zz, xy, xz, yz}};
  }
  panda.d3 = -robot.links[2].translation[1];
  panda.a4 = robot.links[3].translation[0];
  panda.a5 = robot.links[4].translation[0];
  panda.d5 = robot.links[4].translation[1];
  panda.a7 = robot.links[6].translation[0];
  panda.g = elgen::test::gravity_of_earth;
  return panda;
}

}  // namespace bench
