// The key table: every entry and key of model and scene files, the type of its value, and whether
// this version supports it. The reader, its messages and the documentation use these rows. Defaults
// and details are rows of *_key_texts.def. The .def files are in this folder, because src/base has
// no access to keys.
#include <algorithm>
#include <array>
#include <utility>

#include "elgen/syntax.hpp"

namespace elgen {

namespace {

constexpr bool optional = false;
constexpr bool required = true;
constexpr bool unsupported = false;  ///< value of `supported`: a later version reads the key
constexpr bool drawn = true;

using enum KeyType;

constexpr auto key_rows = std::to_array<KeyRow>({
    // model file: header, variables, parameters, functions
    {"", "format", integer, required, true, "version of the file format"},

    {"model", "name", name, required, true, "name of the model and C++ namespace of its code"},
    {"model", "title", text, optional, true, "title on pages and in headers"},
    {"model", "description", text, optional, true, "conventions, such as the zero of an angle"},
    {"model", "reference", text, optional, true, "book or paper that the model comes from"},

    {"coordinate", "name", name, required, true, "name of q_i; its rate is dot(name)"},
    {"coordinate", "kind", choice, optional, true, "one number, or a rotation in space"},
    {"coordinate", "unit", unit, optional, true, "unit of q_i"},
    {"coordinate", "range", range, optional, true, "[low, high] in which q_i is sampled"},
    {"coordinate", "rate_range", range, optional, true, "[low, high] in which the rate is sampled"},
    {"coordinate", "start", value_or_table, optional, true, "initial state of runs"},
    {"coordinate", "wrap", boolean, optional, true, "true for an angle that may turn full circles"},
    {"coordinate", "singular", expression, optional, true, "is 0 where the chart breaks"},
    {"coordinate", "armature", expression, optional, true, "rotor inertia J: adds 1/2 J v^2 to T"},
    {"coordinate", "latex", latex_symbol, optional, true, "LaTeX of the symbol in formulas"},
    {"coordinate", "doc", text, optional, true, "one line of documentation"},
    {"coordinate", "for", repetition, optional, true, "repeats the entry for each index"},
    {"coordinate.start", "value", expression_or_list, optional, true, "q_i at the start"},
    {"coordinate.start", "rate", expression_or_list, optional, true, "v_i at the start"},

    {"parameters", "*", expression_or_table, optional, true, "a constant with its value"},
    {"parameters.*", "value", expression_or_list, required, true, "a number, or one per element"},
    {"parameters.*", "unit", unit, optional, true, "unit of the value"},
    {"parameters.*", "min", expression, optional, true, "smallest value allowed"},
    {"parameters.*", "max", expression, optional, true, "largest value allowed"},
    {"parameters.*", "assume", choice, optional, true, "sign of the value"},
    {"parameters.*", "size", expression, optional, true, "length of an array"},
    {"parameters.*", "latex", latex_symbol, optional, true, "LaTeX of the symbol in formulas"},
    {"parameters.*", "doc", text, optional, true, "one line of documentation"},

    {"sizes", "*", integer, optional, true, "an integer"},
    {"define", "*", expression, optional, true, "a named expression"},

    {"function", "name", name, required, true, "name of the function"},
    {"function", "of", expression_list, required, true, "its 1 to 4 arguments"},
    {"function", "unit", unit, optional, true, "unit of its value"},
    {"function", "sample", expression, optional, true, "expression for runs"},
    {"function", "latex", latex_symbol, optional, true, "LaTeX of the symbol in formulas"},
    {"function", "doc", text, optional, true, "one line of documentation"},

    {"prescribed", "name", name, required, true, "name of the function"},
    {"prescribed", "value", expression, required, true, "its value as a function of t"},
    {"prescribed", "unit", unit, optional, true, "unit of the value"},
    {"prescribed", "latex", latex_symbol, optional, true, "LaTeX of the symbol in formulas"},
    {"prescribed", "doc", text, optional, true, "one line of documentation"},
    {"prescribed", "for", repetition, optional, true, "repeats the entry for each index"},

    // moving frames
    {"frame", "name", name, required, true, "name of the frame"},
    {"frame", "parent", name, optional, true, "`world`, or the frame that carries this frame"},
    {"frame", "translate", expression_list, optional, true, "its origin in the parent's axes"},
    {"frame", "rotate", turns, optional, true, "turns about axes, one after another"},
    {"frame", "rpy", expression_list, optional, true, "roll, pitch, yaw [r, p, y]"},
    {"frame", "dh", table, optional, true, "Denavit-Hartenberg parameters"},
    {"frame", "quaternion", expression_list, optional, true, "[w, x, y, z], scalar first"},
    {"frame", "rotation", name, optional, true, "a coordinate of kind rotation"},
    {"frame", "for", repetition, optional, true, "repeats the entry for each index"},
    {"frame", "doc", text, optional, true, "one line of documentation"},
    {"frame.dh", "convention", choice, required, true, "standard, or modified (Craig)"},
    {"frame.dh", "a", expression, optional, true, "length along x, in m"},
    {"frame.dh", "alpha", expression, optional, true, "angle about x, in rad"},
    {"frame.dh", "d", expression, optional, true, "length along z, in m"},
    {"frame.dh", "theta", expression, optional, true, "angle about z, in rad"},

    // masses, forces, outputs, constraints, checks
    {"point", "name", name, required, true, "name of the point"},
    {"point", "at", expression_list, required, true, "its 2 or 3 components, in m"},
    {"point", "mass", expression, optional, true, "mass m: adds 1/2 m v^2 to T"},
    {"point", "frame", name, optional, true, "frame in whose axes `at` is given"},
    {"point", "joined_to", expression_or_list, optional, true,
     "places that a page joins to the point by lines", drawn},
    {"point", "as", choice, optional, true, "how these lines are drawn", drawn},
    {"point", "for", repetition, optional, true, "repeats the entry for each index"},
    {"point", "doc", text, optional, true, "one line of documentation"},

    {"body", "name", name, required, true, "name of the body"},
    {"body", "mass", expression, optional, true, "mass in kg, an expression of parameters"},
    {"body", "com", expression_list, optional, true, "centre of mass, in m"},
    {"body", "frame", name, optional, true, "frame in which com and inertia are given"},
    {"body", "spin", expression_or_list, optional, true, "angular velocity in rad/s"},
    {"body", "inertia", expression_or_list, optional, true, "moments of inertia, in kg m²"},
    {"body", "inertia_about", choice, optional, true, "point that the inertia refers to"},
    {"body", "for", repetition, optional, true, "repeats the entry for each index"},
    {"body", "doc", text, optional, true, "one line of documentation"},

    {"gravity", "vector", expression_list, required, true, "acceleration of gravity, in m/s²"},

    {"energy", "T", expression, optional, true,
     "kinetic energy besides that of points and bodies, in J"},
    {"energy", "V", expression, optional, true, "potential energy besides weights, in J"},
    {"energy", "D", expression, optional, true, "Rayleigh's dissipation function, in W"},
    {"energy", "L", expression, optional, true, "Lagrangian instead of T and V, in J"},

    {"input", "name", name, required, true, "name of u_k"},
    {"input", "unit", unit, optional, true, "unit of u_k"},
    {"input", "on", name, optional, true, "coordinate that the input acts on"},
    {"input", "wrench", name, optional, true, "frame that a torque and a force act on"},
    {"input", "at", name, optional, true, "point that a force acts on"},
    {"input", "in", name, optional, true, "frame in whose axes the components are"},
    {"input", "limits", range, optional, true, "smallest and largest value of u_k"},
    {"input", "doc", text, optional, true, "one line of documentation"},
    {"input", "for", repetition, optional, true, "repeats the entry for each index"},

    {"force", "name", name, optional, true, "name of the force"},
    {"force", "value", expression_or_list, required, true, "the force, or its components"},
    {"force", "on", name, optional, true, "coordinate that a generalised force acts on"},
    {"force", "at", name, optional, true, "point that a force in N acts on"},
    {"force", "from", name, optional, true, "point, or frame, that takes the reaction"},
    {"force", "frame", name, optional, true, "frame that a torque in N*m acts on"},
    {"force", "in", name, optional, true, "frame in whose axes the components are"},
    {"force", "for", repetition, optional, true, "repeats the entry for each index"},

    {"output", "name", name, required, true, "name of the emitted function"},
    {"output", "value", expression_or_list, optional, true, "expression or list to return"},
    {"output", "jacobian", boolean, optional, true, "also emits NAME_jacobian and NAME_bias"},
    {"output", "point", name, optional, true, "point whose position the function returns"},
    {"output", "frame", name, optional, true, "frame whose pose [R p] the function returns, 3 × 4"},
    {"output", "axes", name, optional, true, "axes of the twist"},
    {"output", "motion", boolean, optional, true,
     "computes the accelerations from the equations of motion"},
    {"output", "doc", text, optional, true, "one line of documentation"},
    {"output", "for", repetition, optional, true, "repeats the entry for each index"},

    {"outputs", "forward_dynamics", table, optional, true, "options of forward dynamics"},
    {"outputs.forward_dynamics", "pivots", boolean, optional, true, "returns relative_pivots"},

    {"constraint", "name", name, required, true, "name of the constraint and of its multiplier"},
    {"constraint", "kind", choice, optional, true, "equation on positions, or on velocities"},
    {"constraint", "equation", equations, optional, true, "left = right, or a list"},
    {"constraint", "coincide", expression_list, optional, true, "two points that stay together"},
    {"constraint", "stabilise", table, optional, true, "decay of constraint errors (Baumgarte)"},
    {"constraint", "doc", text, optional, true, "one line of documentation"},
    {"constraint", "for", repetition, optional, true, "repeats the entry for each index"},
    {"constraint.stabilise", "omega", expression, required, true, "angular frequency ω, in 1/s"},
    {"constraint.stabilise", "zeta", expression, optional, true, "damping ratio ζ"},

    {"equilibrium", "name", name, required, true, "name of the equilibrium"},
    {"equilibrium", "at", table, required, true, "coordinates at the equilibrium"},
    {"equilibrium", "inputs", table, optional, true, "inputs that hold the system there"},
    {"equilibrium", "when", condition, optional, true, "condition on parameters"},
    {"equilibrium", "frequencies_squared", expression_list, optional, true,
     "ω² of small motions, one per velocity"},
    {"equilibrium", "doc", text, optional, true, "one line of documentation"},
    {"equilibrium.at", "*", expression, optional, true, "value of a coordinate"},
    {"equilibrium.inputs", "*", expression, optional, true, "value of an input"},

    {"expect", "conserved", expression_list, optional, true,
     "expressions constant along the motion with u = 0"},
    {"expect", "equations", equations, optional, true, "equations of motion, in any form"},
    {"expect", "at", table, optional, true, "state at which outputs are numbers"},
    {"expect", "within", expression, optional, true, "tolerance of the numbers at a state"},
    {"expect", "*", closed_form, optional, true, "closed form of an output"},
    {"expect.at", "*", expression, optional, true, "value of a variable"},
    {"expect.*", "for", repetition, required, true, "indices of the entry"},
    {"expect.*", "value", expression, required, true, "the entry at these indices"},

    // a scene file
    {"scene", "format", integer, required, true, "version of the file format"},
    {"scene", "model", text, required, true, "path of the model, relative to the scene"},
    {"scene", "name", name, required, true, "name of the scene"},
    {"scene", "doc", text, optional, true, "one line of documentation"},

    {"scene.outputs", "*", output_request, optional, true, "true, or options of the output"},
    {"scene.outputs.*", "form", choice, optional, true, "closed forms, or recursive computation"},
    {"scene.outputs.*", "rename", name, optional, true, "name of the emitted function"},
    {"scene.outputs.*", "method", text, optional, true, "integration method of `step`"},
    {"scene.outputs.*", "order", integer, optional, true, "order of verlet and midpoint"},
    {"scene.outputs.*", "iterations", integer, optional, true, "iterations of midpoint"},
    {"scene.outputs.*", "projected", boolean, optional, true,
     "ends `step` with a projection onto the constraints"},
    {"scene.outputs.*", "pivots", boolean, optional, true, "returns relative_pivots"},
    {"scene.outputs.*", "independent", expression_list, optional, true, "independent coordinates"},

    {"scene.parameters", "fixed", names_or_table, optional, true, "the fixed parameters"},
    {"scene.parameters.fixed", "*", expression, optional, true, "value of the parameter"},

    {"scene.sizes", "*", integer, optional, true, "an integer"},

    {"scene.lock", "*", value_or_table, optional, true, "value of a coordinate, and options"},
    {"scene.lock.*", "value", expression_or_list, required, true, "a function of time"},
    {"scene.lock.*", "reaction", boolean, optional, true,
     "adds the holding force to the output `reaction`"},
    {"scene.routh", "*", boolean_or_expression, optional, true, "momentum of a cyclic coordinate"},
    {"scene.functions", "*", expression, optional, true, "expression of the function"},
    {"scene.regressor", "parameters", expression_list, required, true,
     "parameters besides those of bodies, armatures and friction"},
    {"scene.approximate", "order", integer, required, true, "order of the equations, 1 to 5"},
    {"scene.approximate", "about", text_or_table, required, true, "the equilibrium"},
    {"scene.approximate", "small", expression_list, optional, true, "coordinates that are small"},
    {"scene.approximate.about", "*", expression, optional, true, "value of a coordinate or input"},

    {"scene.numeric", "scalar", choice_list, optional, true, "scalar types that the code is for"},
    {"scene.numeric", "inner", choice, optional, true,
     "type of computations between arguments and results in double"},
    {"scene.numeric", "form", choice, optional, true, "form of every output"},
    {"scene.numeric", "prefer", choice, optional, true,
     "criterion for choosing between equal formulas"},
    {"scene.numeric", "check", table, optional, unsupported, "ranges and tolerance of the checks"},
    {"scene.numeric", "trigonometry", table, optional, true, "sines and cosines of the code"},
    {"scene.numeric.trigonometry", "max_error", expression, optional, true,
     "largest error of sines and cosines"},
    {"scene.numeric.trigonometry", "scalar", choice, optional, true,
     "computation of sines and cosines outside of batches"},
    {"scene.numeric", "max_error", expression, optional, true,
     "bound for the errors of all outputs"},
    {"scene.numeric", "ranges", table, optional, true, "ranges in which max_error holds"},
    {"scene.numeric.ranges", "*", range, optional, true, "range of a variable"},

    {"scene.emit", "language", choice, optional, true, "language of the emitted code"},
    {"scene.emit", "namespace", text, optional, true, "C++ namespace, or prefix of names in C"},
    {"scene.emit", "eigen", boolean, optional, true, "also emits functions on Eigen types"},
    {"scene.emit", "batch", boolean, optional, true, "also emits functions on arrays"},
    {"scene.emit", "storage", choice, optional, true, "order of matrix entries in arrays"},
    {"scene.emit", "files", choice_list, optional, true, "files that are written"},
});

/// A row of the *_key_texts.def.
struct KeyText {
  std::string_view entry;
  std::string_view key;
  KeyDefault default_value;
  std::string_view details;
};

constexpr KeyDefault words(std::string_view text) { return DefaultInWords{text}; }

constexpr bool single = false;
constexpr bool repeated = true;
constexpr bool listed = true;  ///< a list of keys may replace the table

constexpr auto entry_rows = std::to_array<EntryRow>({
    {"model", single, required, true, "name and description of the system"},
    {"coordinate", repeated, required, true,
     "a generalised coordinate; entries are in the order of q"},
    {"parameters", single, optional, true, "constants that the code takes as arguments"},
    {"sizes", single, optional, true, "integers for repetitions"},
    {"define", single, optional, true, "named expressions, in any order"},
    {"function", repeated, optional, true, "a function left open: the caller computes its values"},
    {"prescribed", repeated, optional, true, "a known function of time"},
    {"point", repeated, optional, true, "a place that moves with the coordinates"},
    {"frame", repeated, optional, true, "a coordinate system that moves"},
    {"body", repeated, optional, true, "a rigid body"},
    {"gravity", single, optional, true, "acceleration of gravity"},
    {"energy", single, optional, true, "energies as expressions"},
    {"input", repeated, optional, true, "an actuator, or an external force or wrench"},
    {"force", repeated, optional, true, "a force that no energy gives"},
    {"output", repeated, optional, true, "a function to emit"},
    {"outputs", single, optional, true, "options of the standard outputs"},
    {"constraint", repeated, optional, true, "equations that the motion obeys"},
    {"equilibrium", repeated, optional, true, "a point at which the system stays at rest"},
    {"expect", repeated, optional, true,
     "closed forms, equations and numbers that `elgen verify` checks"},
    {"scene.outputs", single, optional, true, "outputs that are derived and emitted", listed},
    {"scene.parameters", single, optional, true, "parameters that become numbers"},
    {"scene.sizes", single, optional, true, "sizes that replace the sizes of the model"},
    {"scene.lock", single, optional, true, "coordinates that are known functions of time"},
    {"scene.routh", single, optional, true, "cyclic coordinates that are eliminated"},
    {"scene.functions", single, optional, true, "expressions of functions left open"},
    {"scene.frame", repeated, optional, true, "a tool, which is fixed to a frame of the model"},
    {"scene.input", repeated, optional, true, "an external force or wrench"},
    {"scene.output", repeated, optional, true, "a function to emit besides those of the model"},
    {"scene.expect", repeated, optional, true,
     "closed forms, equations and numbers of what the scene emits"},
    {"scene.regressor", single, optional, true, "further columns of the regressor"},
    {"scene.approximate", single, optional, true, "polynomial expansion about an equilibrium"},
    {"scene.numeric", single, optional, true, "arithmetic of the code"},
    {"scene.emit", single, optional, true, "the emitted code"},
});

constexpr auto key_texts = std::to_array<KeyText>({
#define ELGEN_ENTRY(...)
#define ELGEN_KEY(...) {__VA_ARGS__},
#include "parse/model_key_texts.def"
#include "parse/scene_key_texts.def"
});

constexpr auto entry_texts = std::to_array<std::pair<std::string_view, std::string_view>>({
#define ELGEN_ENTRY(...) {__VA_ARGS__},
#define ELGEN_KEY(...)
#include "parse/model_key_texts.def"
#include "parse/scene_key_texts.def"
});

static_assert(std::ranges::equal(key_rows, key_texts, [](const KeyRow& row, const KeyText& text) {
  return row.entry == text.entry && row.key == text.key;
}));
static_assert(std::ranges::equal(entry_rows, entry_texts, {}, &EntryRow::entry,
                                 [](const auto& text) { return text.first; }));

constexpr auto documented_keys = [] {
  auto rows = key_rows;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].default_value = key_texts[i].default_value;
    rows[i].details = key_texts[i].details;
  }
  return rows;
}();

constexpr auto documented_entries = [] {
  auto rows = entry_rows;
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].details = entry_texts[i].second;
  return rows;
}();

}  // namespace

std::span<const KeyRow> key_table() { return documented_keys; }
std::span<const EntryRow> entry_table() { return documented_entries; }

}  // namespace elgen
