// outputs: the table of outputs, with one row for each output.
//
// The equations use q, v, a, u, t and the splits
//
//     T = T2 + b_T.v + T0,   T2 = 1/2 v.M v,   V = V0 + V1.v,   b = b_T - V1
//
// If the model declares L instead of T and V, T0 = 0 and V0 = -L(q, 0, t). With rotations, dq/dt =
// N(q) v. [w]x is block diagonal: the cross product matrix of the angular velocity for each
// rotation, and 0 for all other velocities. Lagrange's equations are
//
//     d/dt dL/dv + [w]x dL/dv - N^T dL/dq = generalised forces
#include "elgen/outputs.hpp"

#include <array>

namespace elgen {
namespace rows {
namespace {

using E = Extent;
using U = UnitRule;
using N = Need;
using O = OutputOption;

constexpr std::string_view square_matrix_type = "SquareMatrix<Scalar>";
constexpr std::string_view force_type = "Forces<Scalar>";
constexpr std::string_view array_type = "std::array<Scalar, {1}>";

constexpr std::array energy{FieldRow{"", E::one, E::one, U::energy}};
constexpr std::array force{FieldRow{"", E::velocities, E::one, U::power, force_type}};

// Matrices.

constexpr std::array mass{
    FieldRow{"", E::velocities, E::velocities, U::energy, square_matrix_type}};
constexpr OutputRow mass_matrix{
    .symbol = {"M", "M"},
    .depends_like_mass = true,
    .fields = mass,
    .equation = {"M = d^2 L/dv^2", R"(M = \frac{\partial^{2} L}{\partial <v>^{2}})"},
    .doc = "Mass matrix, symmetric."};

constexpr std::array coriolis{
    FieldRow{"", E::velocities, E::velocities, U::power, square_matrix_type}};
constexpr OutputRow coriolis_matrix{
    .symbol = {"C", "C"},
    .argument_kinds = Opcode::velocity,
    .fields = coriolis,
    .equation = {"C_ij = 1/2 sum_k (dM_ij/dq_k + dM_ik/dq_j - dM_jk/dq_i) v_k",
                 R"(C_{ij} = \frac{1}{2} \sum_{k} \left( \frac{\partial M_{ij}}{\partial q_{k}} + )"
                 R"(\frac{\partial M_{ik}}{\partial q_{j}} - )"
                 R"(\frac{\partial M_{jk}}{\partial q_{i}} \right) \dot{q}_{k})"},
    .rotation_equation =
        {"C_ij = 1/2 d(C v)_i/dv_j + 1/2 (M [w]x)_ij",
         R"(C_{ij} = \frac{1}{2} \frac{\partial (C <v>)_{i}}{\partial v_{j}} + \frac{1}{2} \left( )"
         R"(M [<omega>]_{\times} \right)_{ij})"},
    .doc = "Coriolis matrix of Christoffel symbols: (dM/dq dq/dt) - 2 C is skew.",
    .needs = {N::quadratic}};

constexpr std::array input_matrix_fields{
    FieldRow{"", E::velocities, E::inputs, U::power, "InputMatrix<Scalar>"}};
constexpr OutputRow input_matrix{
    .symbol = {"B", "B"},
    .fields = input_matrix_fields,
    .equation = {"B = dQ/du", R"(B = \frac{\partial <Q>}{\partial <u>})"},
    .doc = "Generalized force per unit of each input.",
    .needs = {N::inputs}};

// Forces and momentum.

constexpr OutputRow velocity_force{.symbol = {"C v", "C <v>"},
                                   .argument_kinds = Opcode::velocity,
                                   .fields = force,
                                   .equation = {"C(q, v) v", ""},
                                   .definition = R"((C <v>)_{i} = \sum_{j} C_{ij} <v>_{j})",
                                   .doc = "Centrifugal and Coriolis forces.",
                                   .needs = {N::quadratic}};

constexpr OutputRow gravity{
    .symbol = {"g", "<g>"},
    .fields = force,
    .equation = {"g = dV0/dq", R"(<g> = \frac{\partial V_{0}}{\partial <q>})"},
    .rotation_equation = {"g = N^T dV0/dq",
                          R"(<g> = N^{\top} \frac{\partial V_{0}}{\partial <q>})"},
    .doc = "Gradient of the potential energy.",
    .needs = {N::quadratic}};

constexpr OutputRow drift{
    .symbol = {"drift", "<drift>"},
    .argument_kinds = Opcode::velocity,
    .fields = force,
    .equation = {"dM/dt v + (db/dq - (db/dq)^T) v + db/dt - dT0/dq",
                 R"(<drift> = \frac{\partial M}{\partial t} <v> + \left( )"
                 R"(\frac{\partial <b>}{\partial <q>} - \frac{\partial <b>}{\partial <q>}^{\top} )"
                 R"(\right) <v> + \frac{\partial <b>}{\partial t} - )"
                 R"(\frac{\partial T_{0}}{\partial <q>})"},
    .rotation_equation = {"dM/dt v + (db/dq N - (db/dq N)^T) v + db/dt + [w]x b - N^T dT0/dq",
                          R"(<drift> = \frac{\partial M}{\partial t} <v> + \left( )"
                          R"(\frac{\partial <b>}{\partial <q>} N - \left( )"
                          R"(\frac{\partial <b>}{\partial <q>} N \right)^{\top} \right) <v> + )"
                          R"(\frac{\partial <b>}{\partial t} + [<omega>]_{\times} <b> - )"
                          R"(N^{\top} \frac{\partial T_{0}}{\partial <q>})"},
    .doc =
        "Forces from the explicit time dependence of L, from its terms linear in v, and from T0, "
        "the part of T without v.",
    .needs = {N::quadratic}};

constexpr OutputRow dissipation{.symbol = {"dD/dv", R"(\frac{\partial D}{\partial <v>})"},
                                .argument_kinds = Opcode::velocity,
                                .fields = force,
                                .equation = {"dD/dv", ""},
                                .doc = "Gradient of the Rayleigh function D."};

constexpr OutputRow applied_force{
    .symbol = {"Q", "<Q>"},
    .argument_kinds = Opcode::velocity,
    .fields = force,
    .equation = {"Q(q, v) = total generalized force at u = 0", ""},
    .doc = "Non-conservative generalized forces, except those of the inputs and of D."};

constexpr OutputRow bias{
    .symbol = {"bias", "<bias>"},
    .argument_kinds = Opcode::velocity,
    .fields = force,
    .equation = {"bias = C v + drift + g + dD/dv - Q",
                 R"(<bias> = C <v> + <drift> + <g> + \frac{\partial D}{\partial <v>} - <Q>)"},
    .doc = "All terms of the equation of motion without a and u."};

constexpr OutputRow inverse_dynamics{.symbol = {"tau", "<tau>"},
                                     .argument_kinds = Opcode::velocity | Opcode::acceleration,
                                     .fields = force,
                                     .equation = {"tau = M a + bias", R"(<tau> = M <a> + <bias>)"},
                                     .doc = "Generalized force that gives the acceleration a."};

constexpr std::array reaction_fields{FieldRow{"", E::reaction, E::one, U::power, array_type}};
constexpr OutputRow reaction{
    .symbol = {"r", "<r>"},
    .argument_kinds = Opcode::velocity | Opcode::acceleration | Opcode::input,
    .fields = reaction_fields,
    .equation = {"r = (d/dt dL/dv - dL/dq + dD/dv - Q - B u) of the locked coordinates",
                 R"(<r> = \left[ \frac{d}{dt} \frac{\partial L}{\partial <v>} - )"
                 R"(\frac{\partial L}{\partial <q>} + \frac{\partial D}{\partial <v>} - <Q> - )"
                 R"(B <u> \right]_{\mathrm{locked}})"},
    .rotation_equation =
        {"r = (d/dt dL/dv + [w]x dL/dv - N^T dL/dq + dD/dv - Q - B u) of the locked coordinates",
         R"(<r> = \left[ \frac{d}{dt} \frac{\partial L}{\partial <v>} + )"
         R"([<omega>]_{\times} \frac{\partial L}{\partial <v>} - )"
         R"(N^{\top} \frac{\partial L}{\partial <q>} + \frac{\partial D}{\partial <v>} - <Q> - )"
         R"(B <u> \right]_{\mathrm{locked}})"},
    .doc = "Generalized force that holds the locked coordinates, in addition to the inputs.",
    .needs = {N::reaction}};

constexpr std::array momentum_fields{FieldRow{"", E::velocities, E::one, U::energy, force_type}};
constexpr OutputRow momentum{.symbol = {"p", "<p>"},
                             .argument_kinds = Opcode::velocity,
                             .fields = momentum_fields,
                             .equation = {"p = dL/dv", R"(<p> = \frac{\partial L}{\partial <v>})"},
                             .doc = "Generalized momentum."};

constexpr OutputRow position_gradient{
    .symbol = {"dL/dq", R"(\frac{\partial L}{\partial <q>})"},
    .argument_kinds = Opcode::velocity,
    .fields = force,
    .equation = {"dL/dq = dp/dt + dD/dv - Q - B u",
                 R"(\frac{\partial L}{\partial <q>} = \frac{d<p>}{dt} + )"
                 R"(\frac{\partial D}{\partial <v>} - <Q> - B <u>)"},
    .rotation_equation =
        {"N^T dL/dq = dp/dt + [w]x p + dD/dv - Q - B u",
         R"(N^{\top} \frac{\partial L}{\partial <q>} = \frac{d<p>}{dt} + [<omega>]_{\times} <p> + )"
         R"(\frac{\partial D}{\partial <v>} - <Q> - B <u>)"},
    .constrained_equation = {"dL/dq", R"(\frac{\partial L}{\partial <q>})"},
    .doc = "Gradient of the Lagrangian with respect to the coordinates."};

// Energies.

constexpr OutputRow potential_energy{.symbol = {"V0", "V_{0}"},
                                     .fields = energy,
                                     .equation = {"V0 = V(q, v = 0)", "V_{0} = V(<q>, <v> = <0>)"},
                                     .doc = "Potential energy at rest.",
                                     .needs = {N::quadratic},
                                     .is_energy = true};

constexpr OutputRow kinetic_energy{.symbol = {"T", "T"},
                                   .argument_kinds = Opcode::velocity,
                                   .fields = energy,
                                   .equation = {"T = T2 + b_T.v + T0", ""},
                                   .driftless_definition = R"(T = \frac{1}{2} <v>^{\top} M <v>)",
                                   .doc = "Kinetic energy.",
                                   .needs = {N::quadratic, N::energies},
                                   .is_energy = true};

constexpr OutputRow total_energy{
    .symbol = {"T + V", "T + V"},
    .argument_kinds = Opcode::velocity,
    .fields = energy,
    .equation = {"T + V0 + V1.v", R"(T + V = T + V_{0} + <V>_{1}^{\top} <v>)"},
    .doc = "Sum of kinetic and potential energy.",
    .needs = {N::quadratic, N::energies},
    .is_energy = true};

constexpr OutputRow energy_function{
    .symbol = {"E", "E"},
    .argument_kinds = Opcode::velocity,
    .fields = energy,
    .equation = {"E = v.dL/dv - L", R"(E = <v>^{\top} \frac{\partial L}{\partial <v>} - L)"},
    .doc =
        "Energy function (Jacobi integral): dE/dt = v.(B u + Q - dD/dv) - dL/dt, with the partial "
        "derivative dL/dt.",
    .constrained_doc =
        "Energy function (Jacobi integral): dE/dt = v.(B u + A^T lambda + Q - dD/dv) - dL/dt, with "
        "the partial derivative dL/dt.",
    .is_energy = true};

// Forward dynamics, and derivatives.

#include "base/dynamics_rows.def"

constexpr std::array state_matrix_fields{
    FieldRow{"A", E::states, E::states, U::none,
             "std::array<Scalar, 4 * velocity_count * velocity_count>", "A"},
    FieldRow{"B", E::states, E::inputs, U::none,
             "std::array<Scalar, 2 * velocity_count * input_count>", "B"}};
constexpr OutputRow linearization{
    .symbol = {"d(dx)/dt", R"(\delta\dot{<x>})"},
    .argument_kinds = Opcode::velocity | Opcode::input,
    .fields = state_matrix_fields,
    .equation = {"d(dx)/dt = A dx + B du, x = (q, v)",
                 R"(\delta\dot{<x>} = A \delta<x> + B \delta<u>)"},
    .doc = "Equations of motion, linearized about the given state and inputs.",
    .solves_mass_matrix = true,
    .differentiates = true};

constexpr std::array inverse_derivative_fields{
    FieldRow{"by_position", E::velocities, E::velocities, U::none, square_matrix_type,
             R"(\frac{\partial <tau>}{\partial <q>})"},
    FieldRow{"by_velocity", E::velocities, E::velocities, U::none, square_matrix_type,
             R"(\frac{\partial <tau>}{\partial <v>})"}};
constexpr OutputRow inverse_dynamics_derivatives{
    .symbol = {"d tau", R"(\delta<tau>)"},
    .argument_kinds = Opcode::velocity | Opcode::acceleration,
    .fields = inverse_derivative_fields,
    .equation = {"d tau = (dtau/dq) dq + (dtau/dv) dv + M da",
                 R"(\delta<tau> = \frac{\partial <tau>}{\partial <q>} \delta<q> + )"
                 R"(\frac{\partial <tau>}{\partial <v>} \delta<v> + M \delta<a>)"},
    .doc = "Derivatives of tau(q, v, a) with respect to q and v.",
    .differentiates = true};

constexpr std::array forward_derivative_fields{
    FieldRow{"by_position", E::velocities, E::velocities, U::none, square_matrix_type,
             R"(\frac{\partial <a>}{\partial <q>})"},
    FieldRow{"by_velocity", E::velocities, E::velocities, U::none, square_matrix_type,
             R"(\frac{\partial <a>}{\partial <v>})"},
    FieldRow{"by_input", E::velocities, E::inputs, U::none, "InputMatrix<Scalar>",
             R"(\frac{\partial <a>}{\partial <u>})"}};
constexpr OutputRow forward_dynamics_derivatives{
    .symbol = {"da", R"(\delta<a>)"},
    .argument_kinds = Opcode::velocity | Opcode::input,
    .fields = forward_derivative_fields,
    .equation = {"da = (da/dq) dq + (da/dv) dv + (da/du) du",
                 R"(\delta<a> = \frac{\partial <a>}{\partial <q>} \delta<q> + )"
                 R"(\frac{\partial <a>}{\partial <v>} \delta<v> + )"
                 R"(\frac{\partial <a>}{\partial <u>} \delta<u>)"},
    .doc = "Derivatives of the acceleration a(q, v, u) with respect to q, v and u.",
    .solves_mass_matrix = true,
    .differentiates = true};

constexpr std::array input_force_fields{
    FieldRow{"", E::velocities, E::velocities, U::none, square_matrix_type}};
constexpr OutputRow input_force_derivatives{
    .symbol = {"d(B u)/dq", R"(\frac{\partial (B <u>)}{\partial <q>})"},
    .argument_kinds = Opcode::velocity | Opcode::input,
    .fields = input_force_fields,
    .equation = {"d(B u)/dq", ""},
    .rotation_equation = {"d(B u)/dq N", R"(\frac{\partial (B <u>)}{\partial <q>} N)"},
    .doc = "Derivatives of the input forces with respect to the coordinates.",
    .needs = {N::inputs},
    .differentiates = true,
    .is_on_request = true};

constexpr std::array inverse_mass{
    FieldRow{"", E::velocities, E::velocities, U::none, square_matrix_type}};
constexpr OutputRow inverse_mass_matrix{.symbol = {"M^-1", "M^{-1}"},
                                        .depends_like_mass = true,
                                        .fields = inverse_mass,
                                        .equation = {"M^-1", ""},
                                        .doc = "Inverse of the mass matrix, symmetric.",
                                        .solves_mass_matrix = true,
                                        .is_on_request = true};

#include "base/momenta_rows.def"

// Coordinates.

constexpr std::array coordinate_rate_fields{
    FieldRow{"", E::coordinates, E::one, U::row_per_second, "Coordinates<Scalar>"}};
constexpr OutputRow coordinate_rates{
    .symbol = {"dq/dt", R"(\dot{<q>})"},
    .argument_kinds = Opcode::velocity,
    .fields = coordinate_rate_fields,
    .equation = {"dq/dt = N(q) v", R"(\dot{<q>} = N(<q>) <v>)"},
    .doc =
        "Rates of the coordinates. The rate of the quaternion q of a rotation is 1/2 q w, with the "
        "angular velocity w in the axes of the body.",
    .needs = {N::rotations}};

constexpr std::array coordinate{
    FieldRow{"", E::coordinates, E::one, U::row, "Coordinates<Scalar>"}};
constexpr OutputRow normalized{.symbol = {"q", "<q>"},
                               .fields = coordinate,
                               .equation = {"q with every quaternion divided by its length", ""},
                               .doc = "Coordinates with their quaternions scaled back to length 1.",
                               .needs = {N::rotations}};

constexpr std::array cyclic_rate_fields{FieldRow{"", E::cyclic, E::one, U::row, array_type}};
constexpr OutputRow cyclic_rates{
    .symbol = {"v_c", R"(<v>_{c})"},
    .argument_kinds = Opcode::velocity,
    .fields = cyclic_rate_fields,
    .equation = {"M_cc v_c = p - dL/dv_c at v_c = 0",
                 R"(M_{cc} <v>_{c} = <p> - )"
                 R"(\left[ \frac{\partial L}{\partial <v>_{c}} \right]_{<v>_{c} = <0>})"},
    .doc = "Rates of the eliminated cyclic coordinates, from their momenta.",
    .needs = {N::cyclic}};

#include "base/regressor_rows.def"
#include "base/user_rows.def"

constexpr OutputRow dynamics{
    .symbol = {"dynamics", R"(\mathrm{dynamics})"},
    .argument_kinds = Opcode::velocity,
    .doc = "All chosen outputs without the arguments a and u, computed at once.",
    .is_summary = true};

constexpr std::array next_state{
    FieldRow{"coordinates", E::coordinates, E::one, U::row, "Coordinates<Scalar>", "<q>"},
    FieldRow{"rates", E::velocities, E::one, U::row, "Velocities<Scalar>", "<v>"},
    FieldRow{.name = "residual",
             .rows = E::velocities,
             .unit = U::energy,
             .type = force_type,
             .latex = "<r>",
             .is_residual = true}};
constexpr OutputRow step{.symbol = {"(q, v)(t + h)", R"((<q>, <v>)(t + h))"},
                         .argument_kinds = Opcode::velocity | Opcode::input | Opcode::step,
                         .fields = next_state,
                         .equation = {"(q, v)(t + h) at constant u", ""},
                         .doc = "One step of length h at constant inputs:",
                         .options = {O::method, O::order, O::iterations, O::projected},
                         .is_step = true};

constexpr OutputRow step_derivatives{
    .symbol = {"d(q, v)(t + h)", R"(\delta(<q>, <v>)(t + h))"},
    .argument_kinds = Opcode::velocity | Opcode::input | Opcode::step,
    .fields = state_matrix_fields,
    .equation = {"dx(t + h) = A dx + B du, x = (q, v)", ""},
    .doc = "Derivatives of one step of length h at constant inputs:",
    .needs = {N::no_constraints, N::few_velocities},
    .options = {O::method, O::order, O::iterations},
    .differentiates = true,
    .is_step = true};

/// `row` with `kind` and `name`, and with the additional needs that follow from other columns.
constexpr OutputRow complete_row(OutputKind kind, std::string_view name, OutputRow row) {
  row.kind = kind;
  row.name = name;
  if (row.differentiates) row.needs.add(N::smooth_forces);
  if (row.argument_kinds.has_any(Opcode::momentum)) row.needs.add(N::no_constraints);
  if (row.is_user_output) row.needs.add(N::no_cyclic_coordinates);
  if (row.is_step) row.needs.add(N::closed_functions);
  return row;
}

constexpr std::array table{
#define ELGEN_OUTPUT(name) complete_row(OutputKind::name, #name, name),
#include "elgen/outputs.def"
};

}  // namespace
}  // namespace rows

std::span<const OutputRow> output_table() { return rows::table; }

const OutputRow& output_row(OutputKind kind) { return rows::table[static_cast<std::size_t>(kind)]; }

}  // namespace elgen
