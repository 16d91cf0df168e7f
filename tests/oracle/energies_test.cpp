#include "oracle/energies.hpp"

#include <catch2/catch.hpp>

#include "oracle/mechanics.hpp"
#include "oracle/samples.hpp"

using namespace elgen;
using namespace elgen::oracle;
using namespace elgen::test;
using cln::cl_R;

namespace {

struct Found {
  cl_R T;
  cl_R V;
  cl_R L;
  cl_R terms_of_V;
};

/// At x = 2, y = 3, dx/dt = 5, dy/dt = 7.
Found energies_of(const ModelBuilder& b) {
  const Motion motion{{}, {2, 3}, {5, 7}, {0, 0}, {}, 0};
  Evaluation at(b.model, motion);
  return {kinetic_energy(at).real(), potential_energy(at).real(), lagrangian(at).real(),
          potential_magnitude(at).real()};
}

ModelBuilder plane() {
  ModelBuilder b;
  b.coordinate("x").coordinate("y");
  return b;
}

Body body_at(ModelBuilder& b, const std::vector<std::string>& com, const std::string& mass) {
  Body body;
  body.com = b.padded(com);
  body.mass = b.expression(mass);
  return body;
}

}  // namespace

TEST_CASE("written energies and point masses add up, a point without a mass adds nothing") {
  ModelBuilder b = plane();
  b.T("x_d").V("y").point("P", {"x*y", "y"}, "2").point("Q", {"x", "0"}).gravity({"0", "-10"});
  const Found e = energies_of(b);
  CHECK(e.T == 5 + (15 + 14) * (15 + 14) + 49);
  CHECK(e.V == 3 + 2 * 10 * 3);
  CHECK(e.L == e.T - e.V);
}

TEST_CASE("terms of V have magnitudes where they cancel: sums as written, and each weight") {
  ModelBuilder b = plane();
  b.V("6*x - 4*y").point("P", {"x", "y"}, "2").point("Q", {"x", "-y"}, "2");
  b.gravity({"0", "-10"});
  const Found e = energies_of(b);
  CHECK(e.V == 0);
  CHECK(e.terms_of_V == 12 + 12 + 60 + 60);
  CHECK(energies_of(plane().V("-x*y")).terms_of_V == 6);
  CHECK(energies_of(plane()).terms_of_V == 0);
}

TEST_CASE("a body: 1/2 m v^2 + 1/2 w.I w with all products of inertia") {
  ModelBuilder b = plane();
  Body body = body_at(b, {"x", "y", "0"}, "2");
  for (const char* entry : {"1", "2", "3", "4", "5", "6"}) {
    body.inertia.push_back(b.expression(entry));
  }
  body.spin = {b.expression("x_d"), b.expression("y_d"), b.expression("1")};
  b.model.bodies = {body};
  // w = (5, 7, 1): w.I w = 25 + 98 + 3 + 2 (4*35 + 5*5 + 6*7)
  CHECK(energies_of(b).T == 25 + 49 + (25 + 98 + 3 + 2 * (140 + 25 + 42)) / 2);
}

TEST_CASE("an armature adds 1/2 J v^2") {
  ModelBuilder b = plane();
  b.model.coordinates[1].armature = b.expression("4");
  CHECK(energies_of(b).T == 2 * 49);
}

TEST_CASE("a Lagrangian given whole is L") {
  ModelBuilder b = plane();
  b.L("x*y_d - y");
  CHECK(energies_of(b).L == 14 - 3);
}
