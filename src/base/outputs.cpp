// The table of outputs, in the order in which functions are emitted.
//
// Equations are written in q, v, a, u, t with T = T2 + b_T.v + T0 (T2 = 1/2 v.M v), V = V0 + V1.v
// and b = b_T - V1. Where the Lagrangian is given whole, T0 = 0 and V0 = -L(q, 0, t).
#include "elgen/outputs.hpp"

#include <algorithm>
#include <array>

namespace elgen {
namespace {

using Fields = std::vector<FieldRow>;

Fields scalar() { return {{"", Extent::one, Extent::one}}; }
Fields vector() { return {{"", Extent::velocities, Extent::one}}; }
Fields coordinates() { return {{"", Extent::coordinates, Extent::one}}; }
Fields square() { return {{"", Extent::velocities, Extent::velocities}}; }

/// Which arguments a function takes beside parameters, q (and t where t occurs).
struct Takes {
  bool velocity;
  bool acceleration;
  bool input;
};
constexpr Takes takes_q{false, false, false};
constexpr Takes takes_qv{true, false, false};
constexpr Takes takes_qva{true, true, false};
constexpr Takes takes_qvu{true, false, true};
constexpr Takes takes_qvau{true, true, true};

/// What the documentation says of an output.
struct Text {
  std::string_view symbol;
  std::string_view equation;
  std::string_view doc;
  std::string_view unit;
};

OutputRow row(OutputKind kind, std::string_view name, const Takes& takes, Fields fields,
              const Text& text) {
  return {kind,
          name,
          text.symbol,
          takes.velocity,
          takes.acceleration,
          takes.input,
          Requirement::nothing,
          std::move(fields),
          text.equation,
          text.doc,
          text.unit};
}

OutputRow requiring(Requirement requirement, OutputRow output) {
  output.requirement = requirement;
  return output;
}

std::vector<OutputRow> matrices_and_forces() {
  using K = OutputKind;
  return {
      row(K::mass_matrix, "mass_matrix", takes_q, square(),
          {"M", "M = d^2 L/dv^2", "Mass matrix, symmetric.", "mass"}),
      requiring(Requirement::quadratic,
                row(K::coriolis_matrix, "coriolis_matrix", takes_qv, square(),
                    {"C", "C_ij = 1/2 sum_k (dM_ij/dq_k + dM_ik/dq_j - dM_jk/dq_i) v_k",
                     "Coriolis matrix of Christoffel symbols: (sum_k dM/dq_k v_k) - 2 C is skew.",
                     "coriolis"})),
      requiring(Requirement::quadratic,
                row(K::velocity_force, "velocity_force", takes_qv, vector(),
                    {"C v", "C(q, v) v", "Centrifugal and Coriolis forces.", "force"})),
      requiring(Requirement::quadratic,
                row(K::gravity, "gravity", takes_q, vector(),
                    {"g", "g = dV0/dq", "Gradient of the potential energy.", "force"})),
      requiring(Requirement::energies,
                row(K::potential_energy, "potential_energy", takes_q, scalar(),
                    {"V0", "V0 = V(q, v = 0)", "Potential energy at rest.", "energy"})),
      requiring(Requirement::quadratic,
                row(K::drift, "drift", takes_qv, vector(),
                    {"drift", "dM/dt v + (db/dq - (db/dq)^T) v + db/dt - dT0/dq",
                     "Forces of explicit time and of terms linear in the rates.", "force"})),
      row(K::dissipation, "dissipation", takes_qv, vector(),
          {"dD/dv", "dD/dv", "Gradient of the Rayleigh function D.", "force"}),
      row(K::applied_force, "applied_force", takes_qv, vector(),
          {"Q", "Q(q, v) = total generalized force at u = 0",
           "Non-conservative generalized forces without inputs and without D.", "force"}),
      row(K::bias, "bias", takes_qv, vector(),
          {"bias", "bias = C v + drift + g + dD/dv - Q",
           "Everything in the equation of motion that needs neither a nor u.", "force"}),
  };
}

std::vector<OutputRow> energies() {
  using K = OutputKind;
  return {
      row(K::momentum, "momentum", takes_qv, vector(),
          {"p", "p = dL/dv", "Generalized momentum.", "momentum"}),
      requiring(Requirement::energies,
                row(K::kinetic_energy, "kinetic_energy", takes_qv, scalar(),
                    {"T", "T = T2 + b_T.v + T0", "Kinetic energy.", "energy"})),
      requiring(Requirement::energies,
                row(K::total_energy, "total_energy", takes_qv, scalar(),
                    {"T + V", "T + V0 + V1.v", "Kinetic and potential energy.", "energy"})),
      row(K::energy_function, "energy_function", takes_qv, scalar(),
          {"E", "E = v.dL/dv - L",
           "Energy function (Jacobi integral): dE/dt = v.(B u + Q - dD/dv) - dL/dt.", "energy"}),
  };
}

std::vector<OutputRow> dynamics() {
  using K = OutputKind;
  return {
      requiring(
          Requirement::inputs,
          row(K::input_matrix, "input_matrix", takes_q, {{"", Extent::velocities, Extent::inputs}},
              {"B", "B = dQ/du", "Generalized force per unit of each input.", "input"})),
      row(K::inverse_dynamics, "inverse_dynamics", takes_qva, vector(),
          {"tau", "tau = M a + bias", "Generalized force that gives the acceleration a.", "force"}),
      requiring(Requirement::held,
                row(K::reaction, "reaction", takes_qvau, {{"", Extent::held, Extent::one}},
                    {"r", "r = (d/dt dL/dv - dL/dq + dD/dv - Q - B u) of what is locked",
                     "Generalized force, beside the inputs, that holds the locked coordinates.",
                     "held force"})),
      row(K::forward_dynamics, "forward_dynamics", takes_qvu,
          {{"acceleration", Extent::velocities, Extent::one},
           {"relative_pivots", Extent::velocities, Extent::one}},
          {"a", "M a = B u - bias",
           "Acceleration, and the pivots D_i/M_ii of M = L D L^T: near 0 M is singular.",
           "acceleration"}),
      row(K::linearization, "linearization", takes_qvu,
          {{"A", Extent::states, Extent::states}, {"B", Extent::states, Extent::inputs}},
          {"d(dx)/dt", "d(dx)/dt = A dx + B du, x = (q, v)",
           "Linear equations of motion about the state and inputs given.", ""}),
      row(K::inverse_dynamics_derivatives, "inverse_dynamics_derivatives", takes_qva,
          {{"by_position", Extent::velocities, Extent::velocities},
           {"by_velocity", Extent::velocities, Extent::velocities}},
          {"d tau", "d tau = (dtau/dq) dq + (dtau/dv) dv + M da",
           "Derivatives of the inverse dynamics.", ""}),
      row(K::forward_dynamics_derivatives, "forward_dynamics_derivatives", takes_qvu,
          {{"by_position", Extent::velocities, Extent::velocities},
           {"by_velocity", Extent::velocities, Extent::velocities},
           {"by_input", Extent::velocities, Extent::inputs}},
          {"da", "da = (da/dq) dq + (da/dv) dv + (da/du) du",
           "Derivatives of the forward dynamics.", ""}),
      requiring(Requirement::rotations,
                row(K::coordinate_rates, "coordinate_rates", takes_qv, coordinates(),
                    {"dq/dt", "dq/dt = N(q) v",
                     "Rates of the coordinates: of a rotation 1/2 q w, w in the axes of the body.",
                     "coordinate rate"})),
      requiring(Requirement::rotations,
                row(K::normalized, "normalized", takes_q, coordinates(),
                    {"q", "q with every quaternion divided by its length",
                     "Coordinates with their quaternions scaled back to length 1.", "coordinate"})),
      row(K::user_value, "", takes_q, {{"", Extent::user, Extent::one}},
          {"y", "y(q)", "Value of an [[output]].", "user"}),
      row(K::user_jacobian, "_jacobian", takes_q, {{"", Extent::user, Extent::velocities}},
          {"J", "J = dy/dq", "Jacobian of an [[output]].", "user"}),
      row(K::user_bias, "_bias", takes_qv, {{"", Extent::user, Extent::one}},
          {"bias of y", "d^2 y/dt^2 = J a + bias", "Second rate of an [[output]] at a = 0.",
           "user"}),
      row(K::dynamics, "dynamics", takes_qv, {},
          {"dynamics", "", "Every chosen output that takes neither a nor u, computed at once.",
           ""}),
  };
}

std::vector<OutputRow> all_rows() {
  std::vector<OutputRow> table = matrices_and_forces();
  for (const std::vector<OutputRow>& part : {energies(), dynamics()}) {
    table.insert(table.end(), part.begin(), part.end());
  }
  return table;
}

bool is_user_kind(OutputKind kind) {
  return kind == OutputKind::user_value || kind == OutputKind::user_jacobian ||
         kind == OutputKind::user_bias;
}

}  // namespace

std::string_view name_of(Form form) { return form == Form::closed ? "closed" : "recursive"; }

const std::vector<OutputRow>& output_table() {
  static const std::vector<OutputRow> table = all_rows();
  return table;
}

const OutputRow& output_row(OutputKind kind) {
  return output_table()[static_cast<std::size_t>(kind)];
}

const OutputRow* find_output(std::string_view name) {
  for (const OutputRow& output : output_table()) {
    if (output.name == name && !is_user_kind(output.kind)) {
      return &output;
    }
  }
  return nullptr;
}

}  // namespace elgen
