// Matrices against the textbook route, and the laws they obey.
#include "derive/outputs/matrices.hpp"

#include <catch2/catch.hpp>

#include "derived.hpp"

using namespace elgen;
using namespace elgen::test;

TEST_CASE("mass matrices of every system") {
  for (const auto& [name, text] : systems()) {
    INFO(name);
    Derived s(text);
    const Vector mass = mass_matrix(s.derivation);
    for (std::size_t i = 0; i < s.size(); ++i) {
      for (std::size_t j = 0; j < s.size(); ++j) {
        CHECK(s.agree(mass[i * s.size() + j], s.textbook.mass(i, j)));
        CHECK(mass[i * s.size() + j].is_equal(mass[j * s.size() + i]));
      }
    }
  }
}

TEST_CASE("a mass matrix of a quadratic L holds no rate") {
  Derived s(everything_text());
  for (const GiNaC::ex& entry : mass_matrix(s.derivation)) {
    CHECK_FALSE(dependence(s.derivation.definitions, entry).has_any(Opcode::velocity));
  }
}

TEST_CASE("Coriolis matrices are Christoffel's") {
  for (const auto& [name, text] : systems()) {
    INFO(name);
    Derived s(text);
    if (!s.source.quadratic) continue;
    const Vector coriolis = coriolis_matrix(s.derivation);
    for (std::size_t i = 0; i < s.size(); ++i) {
      for (std::size_t j = 0; j < s.size(); ++j) {
        CHECK(s.agree(coriolis[i * s.size() + j], s.textbook.coriolis(i, j)));
      }
    }
  }
}

TEST_CASE("input matrices are the slopes of the forces") {
  Derived s(everything_text());
  const Vector matrix = input_matrix(s.derivation);
  REQUIRE(matrix.size() == 4);
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 2; ++j) {
      CHECK(s.agree(matrix[i * 2 + j], Textbook::by(s.textbook.force(i), s.source.symbols.u[j])));
    }
  }
}

TEST_CASE("Jacobians and second rates of declared outputs") {
  Derived s(everything_text());
  const Terms& values = s.source.outputs.front().values;
  const Vector slopes = jacobian(s.derivation, values);
  const Vector rates = second_rate(s.derivation, values);
  for (std::size_t k = 0; k < values.size(); ++k) {
    const GiNaC::ex value = s.textbook.out(values[k]);
    for (std::size_t j = 0; j < s.size(); ++j) {
      CHECK(s.agree(slopes[k * s.size() + j], Textbook::by(value, s.source.symbols.q[j])));
    }
    CHECK(s.agree(rates[k], s.textbook.coasting(s.textbook.rate(s.textbook.rate(value)))));
  }
}
