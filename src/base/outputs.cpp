// The table of outputs, in the order in which functions are emitted.
//
// Equations are written in q, v, a, u, t with T = T2 + b_T.v + T0 (T2 = 1/2 v.M v), V = V0 + V1.v
// and b = b_T - V1. Where the Lagrangian is given whole, T0 = 0 and V0 = -L(q, 0, t). With
// rotations dq/dt = N(q) v, and [w]x is the cross product on the velocities of each rotation, 0
// elsewhere: d/dt dL/dv + [w]x dL/dv - N^T dL/dq is what forces are equal to.
#include "elgen/outputs.hpp"

#include <algorithm>
#include <array>

namespace elgen {
namespace {

using K = OutputKind;
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
  Notation symbol;
  Notation equation;
  std::string_view doc;
  UnitRule unit;
};

OutputRow row(OutputKind kind, std::string_view name, const Takes& takes, Fields fields,
              const Text& text) {
  return {kind,
          name,
          text.symbol,
          takes.velocity,
          takes.acceleration,
          takes.input,
          std::move(fields),
          text.equation,
          text.doc,
          text.unit};
}

OutputRow requiring(Requirement requirement, OutputRow output) {
  output.requirement = requirement;
  return output;
}

OutputRow turning(const Notation& equation, OutputRow output) {
  output.turning_equation = equation;
  return output;
}

OutputRow solving(OutputRow output) {
  output.solves = true;
  return output;
}

OutputRow differentiating(OutputRow output) {
  output.differentiates = true;
  return output;
}

OutputRow mass_matrix() {
  return row(K::mass_matrix, "mass_matrix", takes_q, square(),
             {{"M", "M"},
              {"M = d^2 L/dv^2", R"(M = \frac{\partial^{2} L}{\partial <v>^{2}})"},
              "Mass matrix, symmetric.",
              UnitRule::mass});
}

OutputRow coriolis_matrix() {
  return requiring(
      Requirement::quadratic,
      turning(
          {"C_ij = 1/2 d(C v)_i/dv_j + 1/2 (M [w]x)_ij",
           R"(C_{ij} = \frac{1}{2} \frac{\partial (C v)_{i}}{\partial v_{j}} + )"
           R"(\frac{1}{2} \left( M [\omega]_{\times} \right)_{ij})"},
          row(K::coriolis_matrix, "coriolis_matrix", takes_qv, square(),
              {{"C", "C"},
               {"C_ij = 1/2 sum_k (dM_ij/dq_k + dM_ik/dq_j - dM_jk/dq_i) v_k",
                R"(C_{ij} = \frac{1}{2} \sum_{k} \left( \frac{\partial M_{ij}}{\partial q_{k}} + )"
                R"(\frac{\partial M_{ik}}{\partial q_{j}} - )"
                R"(\frac{\partial M_{jk}}{\partial q_{i}} \right) <v>_{k})"},
               "Coriolis matrix of Christoffel symbols: (dM/dq dq/dt) - 2 C is skew.",
               UnitRule::coriolis})));
}

OutputRow velocity_force() {
  return requiring(Requirement::quadratic,
                   row(K::velocity_force, "velocity_force", takes_qv, vector(),
                       {{"C v", "C <v>"},
                        {"C(q, v) v", ""},
                        "Centrifugal and Coriolis forces.",
                        UnitRule::force}));
}

OutputRow gravity() {
  return requiring(Requirement::quadratic,
                   turning({"g = N^T dV0/dq", R"(g = N^{\top} \frac{\partial V_{0}}{\partial q})"},
                           row(K::gravity, "gravity", takes_q, vector(),
                               {{"g", "g"},
                                {"g = dV0/dq", R"(g = \frac{\partial V_{0}}{\partial q})"},
                                "Gradient of the potential energy.",
                                UnitRule::force})));
}

OutputRow potential_energy() {
  return requiring(Requirement::energies,
                   row(K::potential_energy, "potential_energy", takes_q, scalar(),
                       {{"V0", "V_{0}"},
                        {"V0 = V(q, v = 0)", "V_{0} = V(q, <v> = 0)"},
                        "Potential energy at rest.",
                        UnitRule::energy}));
}

OutputRow drift() {
  return requiring(
      Requirement::quadratic,
      turning({"dM/dt v + (db/dq N - (db/dq N)^T) v + db/dt + [w]x b - N^T dT0/dq",
               R"(\mathrm{drift} = \frac{\partial M}{\partial t} v + \left( )"
               R"(\frac{\partial b}{\partial q} N - \left( \frac{\partial b}{\partial q} N )"
               R"(\right)^{\top} \right) v + \frac{\partial b}{\partial t} + )"
               R"([\omega]_{\times} b - N^{\top} \frac{\partial T_{0}}{\partial q})"},
              row(K::drift, "drift", takes_qv, vector(),
                  {{"drift", R"(\mathrm{drift})"},
                   {"dM/dt v + (db/dq - (db/dq)^T) v + db/dt - dT0/dq",
                    R"(\mathrm{drift} = \frac{\partial M}{\partial t} <v> + \left( )"
                    R"(\frac{\partial b}{\partial q} - \frac{\partial b}{\partial q}^{\top} )"
                    R"(\right) <v> + \frac{\partial b}{\partial t} - )"
                    R"(\frac{\partial T_{0}}{\partial q})"},
                   "Forces of explicit time and of terms linear in the rates.",
                   UnitRule::force})));
}

OutputRow dissipation() {
  return row(K::dissipation, "dissipation", takes_qv, vector(),
             {{"dD/dv", R"(\frac{\partial D}{\partial <v>})"},
              {"dD/dv", ""},
              "Gradient of the Rayleigh function D.",
              UnitRule::force});
}

OutputRow applied_force() {
  return row(K::applied_force, "applied_force", takes_qv, vector(),
             {{"Q", "Q"},
              {"Q(q, v) = total generalized force at u = 0", ""},
              "Non-conservative generalized forces without inputs and without D.",
              UnitRule::force});
}

OutputRow bias() {
  return row(
      K::bias, "bias", takes_qv, vector(),
      {{"bias", R"(\mathrm{bias})"},
       {"bias = C v + drift + g + dD/dv - Q",
        R"(\mathrm{bias} = C <v> + \mathrm{drift} + g + \frac{\partial D}{\partial <v>} - Q)"},
       "Everything in the equation of motion that needs neither a nor u.",
       UnitRule::force});
}

std::vector<OutputRow> matrices_and_forces() {
  return {mass_matrix(), coriolis_matrix(), velocity_force(), gravity(), potential_energy(),
          drift(),       dissipation(),     applied_force(),  bias()};
}

std::vector<OutputRow> energies() {
  return {
      row(K::momentum, "momentum", takes_qv, vector(),
          {{"p", "p"},
           {"p = dL/dv", R"(p = \frac{\partial L}{\partial <v>})"},
           "Generalized momentum.",
           UnitRule::momentum}),
      requiring(
          Requirement::energies,
          row(K::kinetic_energy, "kinetic_energy", takes_qv, scalar(),
              {{"T", "T"}, {"T = T2 + b_T.v + T0", ""}, "Kinetic energy.", UnitRule::energy})),
      requiring(Requirement::energies,
                row(K::total_energy, "total_energy", takes_qv, scalar(),
                    {{"T + V", "T + V"},
                     {"T + V0 + V1.v", R"(T + V = T + V_{0} + V_{1}^{\top} <v>)"},
                     "Kinetic and potential energy.",
                     UnitRule::energy})),
      row(K::energy_function, "energy_function", takes_qv, scalar(),
          {{"E", "E"},
           {"E = v.dL/dv - L", R"(E = <v>^{\top} \frac{\partial L}{\partial <v>} - L)"},
           "Energy function (Jacobi integral): dE/dt = v.(B u + Q - dD/dv) - dL/dt.",
           UnitRule::energy}),
  };
}

OutputRow reaction() {
  return requiring(
      Requirement::held,
      turning({"r = (d/dt dL/dv + [w]x dL/dv - N^T dL/dq + dD/dv - Q - B u) of what is locked",
               R"(r = \left[ \frac{d}{dt} \frac{\partial L}{\partial v} + [\omega]_{\times} )"
               R"(\frac{\partial L}{\partial v} - N^{\top} \frac{\partial L}{\partial q} + )"
               R"(\frac{\partial D}{\partial v} - Q - B u \right]_{\mathrm{locked}})"},
              row(K::reaction, "reaction", takes_qvau, {{"", Extent::held, Extent::one}},
                  {{"r", "r"},
                   {"r = (d/dt dL/dv - dL/dq + dD/dv - Q - B u) of what is locked",
                    R"(r = \left[ \frac{d}{dt} \frac{\partial L}{\partial <v>} - )"
                    R"(\frac{\partial L}{\partial q} + \frac{\partial D}{\partial <v>} - Q - B u )"
                    R"(\right]_{\mathrm{locked}})"},
                   "Generalized force, beside the inputs, that holds the locked coordinates.",
                   UnitRule::held_force})));
}

std::vector<OutputRow> dynamics() {
  return {
      requiring(Requirement::inputs, row(K::input_matrix, "input_matrix", takes_q,
                                         {{"", Extent::velocities, Extent::inputs}},
                                         {{"B", "B"},
                                          {"B = dQ/du", R"(B = \frac{\partial Q}{\partial u})"},
                                          "Generalized force per unit of each input.",
                                          UnitRule::input})),
      row(K::inverse_dynamics, "inverse_dynamics", takes_qva, vector(),
          {{"tau", R"(\tau)"},
           {"tau = M a + bias", R"(\tau = M <a> + \mathrm{bias})"},
           "Generalized force that gives the acceleration a.",
           UnitRule::force}),
      reaction(),
      solving(row(
          K::forward_dynamics, "forward_dynamics", takes_qvu,
          {{"acceleration", Extent::velocities, Extent::one},
           {"relative_pivots", Extent::velocities, Extent::one}},
          {{"a", "<a>"},
           {"M a = B u - bias", R"(M <a> = B u - \mathrm{bias})"},
           "Acceleration, and the pivots D_i/M_ii of M = L D L^T: near 0, or no number where M_ii "
           "is 0, M is singular.",
           UnitRule::acceleration})),
  };
}

std::vector<OutputRow> derivatives() {
  return {
      solving(differentiating(
          row(K::linearization, "linearization", takes_qvu,
              {{"A", Extent::states, Extent::states}, {"B", Extent::states, Extent::inputs}},
              {{"d(dx)/dt", R"(\delta\dot{x})"},
               {"d(dx)/dt = A dx + B du, x = (q, v)",
                R"(\delta\dot{x} = A \, \delta x + B \, \delta u)"},
               "Linear equations of motion about the state and inputs given.",
               UnitRule::none}))),
      differentiating(row(K::inverse_dynamics_derivatives, "inverse_dynamics_derivatives",
                          takes_qva,
                          {{"by_position", Extent::velocities, Extent::velocities},
                           {"by_velocity", Extent::velocities, Extent::velocities}},
                          {{"d tau", R"(\delta\tau)"},
                           {"d tau = (dtau/dq) dq + (dtau/dv) dv + M da",
                            R"(\delta\tau = \frac{\partial \tau}{\partial q} \delta q + )"
                            R"(\frac{\partial \tau}{\partial <v>} \delta <v> + M \delta <a>)"},
                           "Derivatives of the inverse dynamics.",
                           UnitRule::none})),
      solving(differentiating(row(K::forward_dynamics_derivatives, "forward_dynamics_derivatives",
                                  takes_qvu,
                                  {{"by_position", Extent::velocities, Extent::velocities},
                                   {"by_velocity", Extent::velocities, Extent::velocities},
                                   {"by_input", Extent::velocities, Extent::inputs}},
                                  {{"da", R"(\delta <a>)"},
                                   {"da = (da/dq) dq + (da/dv) dv + (da/du) du",
                                    R"(\delta <a> = \frac{\partial <a>}{\partial q} \delta q + )"
                                    R"(\frac{\partial <a>}{\partial <v>} \delta <v> + )"
                                    R"(\frac{\partial <a>}{\partial u} \delta u)"},
                                   "Derivatives of the forward dynamics.",
                                   UnitRule::none}))),
  };
}

std::vector<OutputRow> rates() {
  return {
      requiring(Requirement::rotations,
                row(K::coordinate_rates, "coordinate_rates", takes_qv, coordinates(),
                    {{"dq/dt", R"(\dot{q})"},
                     {"dq/dt = N(q) v", R"(\dot{q} = N(q) v)"},
                     "Rates of the coordinates: of a rotation 1/2 q w, w in the axes of the body.",
                     UnitRule::coordinate_rate})),
      requiring(Requirement::rotations,
                row(K::normalized, "normalized", takes_q, coordinates(),
                    {{"q", "q"},
                     {"q with every quaternion divided by its length", ""},
                     "Coordinates with their quaternions scaled back to length 1.",
                     UnitRule::coordinate})),
  };
}

/// `<y>` is the output's symbol, `<y''>` its second rate.
std::vector<OutputRow> of_the_user() {
  return {
      row(K::user_value, "", takes_q, {{"", Extent::user, Extent::one}},
          {{"y", "<y>"}, {"y(q)", ""}, "Value of an [[output]].", UnitRule::user}),
      turning({"J = dy/dq N", ""},
              row(K::user_jacobian, "_jacobian", takes_q, {{"", Extent::user, Extent::velocities}},
                  {{"J", R"(\frac{\partial <y>}{\partial q}<N>)"},
                   {"J = dy/dq", ""},
                   "Jacobian of an [[output]].",
                   UnitRule::user})),
      row(K::user_bias, "_bias", takes_qv, {{"", Extent::user, Extent::one}},
          {{"bias of y", R"(\mathrm{bias}_{<y>})"},
           {"d^2 y/dt^2 = J a + bias",
            R"(<y''> = \frac{\partial <y>}{\partial q}<N> <a> + \mathrm{bias}_{<y>})"},
           "Second rate of an [[output]] at a = 0.",
           UnitRule::user}),
      row(K::dynamics, "dynamics", takes_qv, {},
          {{"dynamics", R"(\mathrm{dynamics})"},
           {"", ""},
           "Every chosen output that takes neither a nor u, computed at once.",
           UnitRule::none}),
  };
}

std::vector<OutputRow> all_rows() {
  std::vector<OutputRow> table = matrices_and_forces();
  for (const std::vector<OutputRow>& part :
       {energies(), dynamics(), derivatives(), rates(), of_the_user()}) {
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

const Notation& equation_of(const OutputRow& output, bool has_rotations) {
  const bool is_another = has_rotations && !output.turning_equation.text.empty();
  return is_another ? output.turning_equation : output.equation;
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
