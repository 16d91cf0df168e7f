// Systems for the tests of verification: each a model with a hand-written program.
#pragma once

#include <catch2/catch.hpp>
#include <string>

#include "elgen/outputs.hpp"
#include "oracle/samples.hpp"
#include "program/evaluate/subject.hpp"
#include "program/read_program.hpp"

namespace elgen::test {

struct System {
  Model model = {};
  Scene scene = {};
  Program program = {};

  [[nodiscard]] SystemUnderTest subject() const { return {model, scene, program}; }
};

/// The system with the program `text`. Every function becomes a requested output.
inline System system_of(Model model, const std::string& text) {
  System system{std::move(model), {}, read_program(text)};
  system.model.name = system.scene.base_name = "sample";
  for (Parameter& parameter : system.model.parameters) {
    parameter.array = static_cast<std::uint32_t>(system.model.parameter_arrays.size());
    system.model.parameter_arrays.push_back({.name = parameter.name, .first = parameter.array});
  }
  for (const Function& function : system.program.functions) {
    OutputRequest output;
    output.kind = function.kind;
    output.user = function.user;
    output.step = function.step;
    output.name = function.name;
    system.scene.outputs.push_back(output);
  }
  return system;
}

/// Cart and pole measured from the upward vertical, damped by D = 1/2 c v_x^2, driven by u on the
/// cart. The output `tip` is the position of the bob.
inline Model cart_pole_model() {
  ModelBuilder builder = cart_pole();
  builder.parameter("c", "0.3").D("c*x_d^2/2").output({"x + l*sin(th)", "l*cos(th)"});
  builder.model.outputs.front().name = "tip";
  builder.model.outputs.front().has_jacobian = true;
  return builder.model;
}

namespace instructions {

// 0 M  1 m  2 l  3 g  4 c  5 x  6 th  7 s  8 cos  9 k = m l  10 M + m  11 k cos  12 k l
inline const std::string common =
    "  0 = parameter M\n  1 = parameter m\n  2 = parameter l\n  3 = parameter g\n"
    "  4 = parameter c\n  5 = coordinate x\n  6 = coordinate th\n  7 = sin 6\n  8 = cos 6\n"
    "  9 = multiply 1 2\n  10 = add 0 1\n  11 = multiply 9 8\n  12 = multiply 9 2\n";
// 13 v1  14 v2  15 k s  16 k s v2  17 0  18 -k s v2  19 -k s v2^2  20 c v1  22 -k g s  23 bias_1
inline const std::string rates =
    common +
    "  13 = velocity x\n  14 = velocity th\n  15 = multiply 9 7\n  16 = multiply 15 14\n"
    "  17 = constant 0\n  18 = negate 16\n  19 = multiply 18 14\n  20 = multiply 4 13\n"
    "  21 = multiply 15 3\n  22 = negate 21\n  23 = add 19 20\n";
inline const std::string gravity = common +
                                   "  13 = multiply 9 7\n  14 = multiply 13 3\n"
                                   "  15 = negate 14\n  16 = constant 0\n";
// 24 (M + m) v1  25 k cos v2  26 p1  27 k cos v1  28 k l v2  29 p2  32 p.v  34 T  35 V  36 T + V
inline const std::string momentum =
    rates +
    "  24 = multiply 10 13\n  25 = multiply 11 14\n  26 = add 24 25\n  27 = multiply 11 13\n"
    "  28 = multiply 12 14\n  29 = add 27 28\n  30 = multiply 26 13\n  31 = multiply 29 14\n"
    "  32 = add 30 31\n  33 = constant 1/2\n  34 = multiply 33 32\n  35 = multiply 11 3\n"
    "  36 = add 34 35\n";
// M = L D L^T: 25 r1  26 L  28 D2  29 L r1  30 r2 - L r1  31 a2  32 r1/D1  33 L a2  34 a1  36 d2
inline const std::string solve =
    rates +
    "  24 = input u\n  25 = subtract 24 23\n  26 = divide 11 10\n  27 = multiply 26 11\n"
    "  28 = subtract 12 27\n  29 = multiply 26 25\n  30 = subtract 21 29\n  31 = divide 30 28\n"
    "  32 = divide 25 10\n  33 = multiply 26 31\n  34 = subtract 32 33\n  35 = constant 1\n"
    "  36 = divide 28 12\n";

}  // namespace instructions

/// One function in a program's text.
inline std::string function_text(const std::string& name, const std::string& body,
                                 const std::string& results) {
  return "function " + name + "\n" + body + results;
}

/// The energies and forces of cart_pole_model, with s = sin(th), c = cos(th), k = m l.
inline std::string cart_pole_forces() {
  using namespace instructions;
  return function_text("mass_matrix", common, "  result 2 2 = 10 11 11 12\n") +
         function_text("coriolis_matrix", rates, "  result 2 2 = 17 18 17 17\n") +
         function_text("velocity_force", rates, "  result 2 1 = 19 17\n") +
         function_text("gravity", gravity, "  result 2 1 = 16 15\n") +
         function_text("potential_energy", common + "  13 = multiply 11 3\n",
                       "  result 1 1 = 13\n") +
         function_text("drift", common + "  13 = constant 0\n", "  result 2 1 = 13 13\n") +
         function_text("dissipation", rates, "  result 2 1 = 20 17\n") +
         function_text("bias", rates, "  result 2 1 = 23 22\n") +
         function_text("momentum", momentum, "  result 2 1 = 26 29\n") +
         function_text("kinetic_energy", momentum, "  result 1 1 = 34\n") +
         function_text("total_energy", momentum, "  result 1 1 = 36\n") +
         function_text("energy_function", momentum, "  result 1 1 = 36\n") +
         function_text("input_matrix", common + "  13 = constant 0\n  14 = constant 1\n",
                       "  result 2 1 = 14 13\n");
}

/// The dynamics and outputs of cart_pole_model.
inline std::string cart_pole_motion() {
  using namespace instructions;
  return function_text("inverse_dynamics",
                       rates +
                           "  24 = acceleration x\n  25 = acceleration th\n  26 = multiply 10 24\n"
                           "  27 = multiply 11 25\n  28 = add 26 27\n  29 = add 28 23\n"
                           "  30 = multiply 11 24\n  31 = multiply 12 25\n  32 = add 30 31\n"
                           "  33 = add 32 22\n",
                       "  result 2 1 = 29 33\n") +
         function_text(
             "forward_dynamics", solve,
             "  result acceleration 2 1 = 34 31\n  result relative_pivots 2 1 = 35 36\n") +
         function_text("tip = user_value 0",
                       common + "  13 = multiply 2 7\n  14 = add 5 13\n  15 = multiply 2 8\n",
                       "  result 2 1 = 14 15\n") +
         function_text("tip_jacobian = user_jacobian 0",
                       common +
                           "  13 = constant 1\n  14 = constant 0\n  15 = multiply 2 8\n"
                           "  16 = multiply 2 7\n  17 = negate 16\n",
                       "  result 2 2 = 13 15 14 17\n") +
         function_text("tip_bias = user_bias 0",
                       common +
                           "  13 = velocity th\n  14 = multiply 13 13\n  15 = multiply 2 14\n"
                           "  16 = multiply 15 7\n  17 = negate 16\n  18 = multiply 15 8\n"
                           "  19 = negate 18\n",
                       "  result 2 1 = 17 19\n") +
         function_text("dynamics", rates,
                       "  result mass_matrix 2 2 = 10 11 11 12\n  result bias 2 1 = 23 22\n");
}

/// All outputs of cart_pole_model.
inline std::string cart_pole_program() {
  const std::string leaves =
      "parameters M m l g c\n"
      "coordinates x th\n"
      "inputs u\n";
  return leaves + cart_pole_forces() + cart_pole_motion();
}

inline System cart_pole_system() { return system_of(cart_pole_model(), cart_pole_program()); }

/// The cart and pole with one mistake in the text of its program.
inline System with_mistake(const std::string& function, const std::string& from,
                           const std::string& to) {
  const std::string text = cart_pole_program();
  const std::size_t start = text.find("function " + function);
  REQUIRE(start != std::string::npos);
  return system_of(cart_pole_model(),
                   text.substr(0, start) + replaced(text.substr(start), from, to));
}

/// The cart and pole. The program computes (V + 1e9) - 1e9 instead of V; the readable form is V.
inline System badly_rounded() {
  const auto with_results = [](const std::string& body, const std::string& results) {
    return system_of(
        cart_pole_model(),
        "parameters M m l g c\ncoordinates x th\ninputs u\n" +
            function_text("potential_energy",
                          instructions::common + "  13 = multiply 11 3\n" + body, results));
  };
  System system =
      with_results("  14 = constant 1000000000\n  15 = add 13 14\n  16 = subtract 15 14\n",
                   "  result 1 1 = 16\n");
  system.program.functions.front().form = Form::closed;
  system.program.readable = with_results("", "  result 1 1 = 13\n").program.functions;
  return system;
}

/// A driven, damped oscillator, and the derivatives of its dynamics m a + c v + k x = u.
inline std::string oscillator_program() {
  // 0 m  1 c  2 k  3 0  4 1  5 1/m  6 k/m  7 -k/m  8 c/m  9 -c/m
  const std::string body =
      "  0 = parameter m\n  1 = parameter c\n  2 = parameter k\n  3 = constant 0\n"
      "  4 = constant 1\n  5 = divide 4 0\n  6 = multiply 2 5\n  7 = negate 6\n"
      "  8 = multiply 1 5\n  9 = negate 8\n";
  return "parameters m c k\ncoordinates x\ninputs u\n" +
         function_text("linearization", body, "  result A 2 2 = 3 4 7 9\n  result B 2 1 = 3 5\n") +
         function_text("inverse_dynamics_derivatives", body,
                       "  result by_position 1 1 = 2\n  result by_velocity 1 1 = 1\n") +
         function_text("forward_dynamics_derivatives", body,
                       "  result by_position 1 1 = 7\n  result by_velocity 1 1 = 9\n"
                       "  result by_input 1 1 = 5\n");
}

/// n masses m on a line without forces: M = m 1. The program has a = 0 with pivots 1.
inline System masses_in_a_row(int n) {
  ModelBuilder b;
  b.parameter("m", "3");
  std::string squares;
  std::string coordinates;
  std::string zeros;
  std::string ones;
  for (int i = 1; i <= n; ++i) {
    const std::string name = "x" + std::to_string(i);
    b.coordinate(name, "m");
    squares += (i == 1 ? "m*" : " + m*") + name + "_d^2";
    coordinates += " " + name;
    zeros += " 0";
    ones += " 1";
  }
  b.T("(" + squares + ")/2");
  const std::string rows = std::to_string(n) + " 1 =";
  return system_of(b.model,
                   "parameters m\ncoordinates" + coordinates + "\n" +
                       function_text("forward_dynamics", "  0 = constant 0\n  1 = constant 1\n",
                                     "  result acceleration " + rows + zeros +
                                         "\n  result relative_pivots " + rows + ones + "\n"));
}

/// The inverse dynamics m a of masses_in_a_row(n), or m + a if `is_wrong`.
inline Program forces_of_masses(int n, bool is_wrong = false) {
  std::string coordinates;
  std::string body = "  0 = parameter m\n";
  std::string forces;
  for (int i = 1; i <= n; ++i) {
    const std::string name = " x" + std::to_string(i);
    coordinates += name;
    body += "  " + std::to_string(2 * i - 1) + " = acceleration" + name + "\n  " +
            std::to_string(2 * i) + (is_wrong ? " = add 0 " : " = multiply 0 ") +
            std::to_string(2 * i - 1) + "\n";
    forces += " " + std::to_string(2 * i);
  }
  return read_program("parameters m\ncoordinates" + coordinates + "\n" +
                      function_text("inverse_dynamics", body,
                                    "  result " + std::to_string(n) + " 1 =" + forces + "\n"));
}

inline Model oscillator_model() {
  ModelBuilder b;
  b.coordinate("x", "m").input("u", 0).parameter("m", "2").parameter("c", "0.3");
  b.parameter("k", "5").T("m*x_d^2/2").V("k*x^2/2").D("c*x_d^2/2");
  return b.model;
}

}  // namespace elgen::test
