// The key table: every entry and key of model and scene files, the type of its value, and whether
// this version supports it. The reader, its messages and the documentation use these rows.
#include <algorithm>
#include <array>

#include "elgen/syntax.hpp"

namespace elgen {

namespace {

constexpr bool optional = false;
constexpr bool required = true;
constexpr bool later = false;  ///< value of `supported`: a later version reads the key
constexpr bool drawn = true;

using enum KeyType;

constexpr auto key_rows = std::to_array<KeyRow>({
    // model file: header, variables, parameters, functions
    {"", "format", integer, required, true, "version of the file format: 1"},

    {"model", "name", name, required, true, "lower-case name; becomes the C++ namespace"},
    {"model", "title", text, optional, true, "one line"},
    {"model", "description", text, optional, true, "where angles are measured from, …"},
    {"model", "reference", text, optional, true, "book or paper"},

    {"coordinate", "name", name, required, true, "name of q_i; its rate is dot(name)"},
    {"coordinate", "kind", choice, optional, true, "one number, or a unit quaternion"},
    {"coordinate", "unit", unit, optional, true, "unit of q_i"},
    {"coordinate", "range", range, optional, true, "[low, high], for sampling and plots"},
    {"coordinate", "rate_range", range, optional, true, "[low, high] of the rate"},
    {"coordinate", "start", table, optional, true, "nominal state"},
    {"coordinate", "wrap", boolean, optional, true, "an angle that may turn all the way round"},
    {"coordinate", "singular", expression, optional, true, "zero where the chart breaks"},
    {"coordinate", "armature", expression, optional, true, "J: adds 1/2 J v^2 to T"},
    {"coordinate", "latex", symbol, optional, true, "symbol in formulas"},
    {"coordinate", "doc", text, optional, true, "one line"},
    {"coordinate", "for", repetition, optional, true, "repeats the entry"},
    {"coordinate.start", "value", expression_or_list, optional, true, "q_i at the start"},
    {"coordinate.start", "rate", expression_or_list, optional, true, "v_i at the start"},

    {"parameters", "*", expression_or_table, optional, true, "a constant with its value"},
    {"parameters.*", "value", expression_or_list, required, true, "number, or one per element"},
    {"parameters.*", "unit", unit, optional, true, "unit of the value"},
    {"parameters.*", "min", expression, optional, true, "smallest value, for sampling"},
    {"parameters.*", "max", expression, optional, true, "largest value, for sampling"},
    {"parameters.*", "assume", choice, optional, true, "sign of the value"},
    {"parameters.*", "size", expression, optional, true, "makes it an array NAME[1] … NAME[size]"},
    {"parameters.*", "latex", symbol, optional, true, "symbol in formulas"},
    {"parameters.*", "doc", text, optional, true, "one line"},

    {"sizes", "*", integer, optional, true, "an integer for repetitions"},
    {"define", "*", expression, optional, true, "a named expression"},

    {"function", "name", name, required, true, "a function that callers compute"},
    {"function", "of", expression_list, required, true, "its 1 to 4 arguments"},
    {"function", "unit", unit, optional, true, "unit of its value"},
    {"function", "sample", expression, optional, true, "its value where a run needs one"},
    {"function", "latex", symbol, optional, true, "symbol in formulas"},
    {"function", "doc", text, optional, true, "one line"},

    {"prescribed", "name", name, required, true, "a known function of time"},
    {"prescribed", "value", expression, required, true, "its value as a function of t"},
    {"prescribed", "unit", unit, optional, true, "unit of the value"},
    {"prescribed", "latex", symbol, optional, true, "symbol in formulas"},
    {"prescribed", "doc", text, optional, true, "one line"},
    {"prescribed", "for", repetition, optional, true, "repeats the entry"},

    // moving frames
    {"frame", "name", name, required, true, "name of the frame"},
    {"frame", "parent", name, required, true, "world, or the frame it moves with"},
    {"frame", "translate", expression_list, optional, true, "its origin, in the parent's axes"},
    {"frame", "rotate", turns, optional, true, "[axis, angle] one after another, turning axes"},
    {"frame", "rpy", expression_list, optional, true, "[r, p, y]: Rz(y) Ry(p) Rx(r)"},
    {"frame", "dh", table, optional, true, "Denavit-Hartenberg parameters"},
    {"frame", "quaternion", expression_list, optional, true, "[w, x, y, z], of any length"},
    {"frame", "rotation", name, optional, true, "a coordinate of kind rotation"},
    {"frame", "for", repetition, optional, true, "repeats the entry"},
    {"frame", "doc", text, optional, true, "one line"},
    {"frame.dh", "convention", choice, required, true, "standard, or modified (Craig)"},
    {"frame.dh", "a", expression, optional, true, "length along x"},
    {"frame.dh", "alpha", expression, optional, true, "angle about x"},
    {"frame.dh", "d", expression, optional, true, "length along z"},
    {"frame.dh", "theta", expression, optional, true, "angle about z"},

    // masses, forces, outputs, constraints, checks
    {"point", "name", name, required, true, "name of the point"},
    {"point", "at", expression_list, required, true, "its 2 or 3 coordinates, in the world"},
    {"point", "mass", expression, optional, true, "adds 1/2 m v^2 to T and its weight to V"},
    {"point", "frame", name, optional, true, "`at` in the axes of this frame"},
    {"point", "joined_to", expression_or_list, optional, true,
     "lines on a page to points, frames, or origin", drawn},
    {"point", "as", choice, optional, true, "how they are drawn; a rod unless given", drawn},
    {"point", "for", repetition, optional, true, "repeats the entry"},
    {"point", "doc", text, optional, true, "one line"},

    {"body", "name", name, required, true, "name of the body"},
    {"body", "mass", expression, optional, true, "without it, rotation only"},
    {"body", "com", expression_list, optional, true, "centre of mass, in the world or frame"},
    {"body", "frame", name, optional, true, "com and inertia in this frame"},
    {"body", "spin", expression_or_list, optional, true, "angular velocity, axes of inertia"},
    {"body", "inertia", expression_or_list, optional, true, "1, 3 or 6: xx yy zz xy xz yz"},
    {"body", "inertia_about", choice, optional, true, "com, or origin: that of its frame"},
    {"body", "for", repetition, optional, true, "repeats the entry"},
    {"body", "doc", text, optional, true, "one line"},

    {"gravity", "vector", expression_list, required, true, "acceleration of gravity, m/s^2"},

    {"energy", "T", expression, optional, true, "kinetic energy beside points and bodies"},
    {"energy", "V", expression, optional, true, "potential energy beside that of weights"},
    {"energy", "D", expression, optional, true, "Rayleigh function; force -dD/dv"},
    {"energy", "L", expression, optional, true, "Lagrangian, instead of T and V"},

    {"input", "name", name, required, true, "name of u_k"},
    {"input", "unit", unit, optional, true, "unit of u_k"},
    {"input", "on", name, optional, true, "coordinate it acts on"},
    {"input", "wrench", name, optional, true,
     "frame: inputs NAME[1] … are a torque, then a force at its origin"},
    {"input", "at", name, optional, true, "point: inputs NAME[1] … are a force"},
    {"input", "in", name, optional, true, "frame, or world: axes of these components"},
    {"input", "limits", range, optional, true, "[low, high]"},
    {"input", "doc", text, optional, true, "one line"},
    {"input", "for", repetition, optional, true, "repeats the entry"},

    {"force", "name", name, optional, true, "name of the force"},
    {"force", "value", expression_or_list, required, true, "affine in the inputs"},
    {"force", "on", name, optional, true, "coordinate: a generalized force"},
    {"force", "at", name, optional, true, "point: a force in N, world axes"},
    {"force", "from", name, optional, true, "point, or frame, that takes the reaction"},
    {"force", "frame", name, optional, true, "frame: a torque in N*m, axes of the frame"},
    {"force", "in", name, optional, true, "frame, or world: axes of the components"},
    {"force", "for", repetition, optional, true, "repeats the entry"},

    {"output", "name", name, required, true, "name of the emitted function"},
    {"output", "value", expression_or_list, optional, true, "what it returns"},
    {"output", "jacobian", boolean, optional, true, "also emits its Jacobian and bias"},
    {"output", "frame", name, optional, true, "pose and Jacobian of this frame"},
    {"output", "axes", name, optional, true, "axes of its Jacobian: world, or the frame"},
    {"output", "motion", boolean, optional, true,
     "true: accelerations and lambda(CONSTRAINT) are those of the motion"},
    {"output", "doc", text, optional, true, "one line"},
    {"output", "for", repetition, optional, true, "repeats the entry"},

    {"outputs", "forward_dynamics", table, optional, true, "unless a scene says otherwise"},
    {"outputs.forward_dynamics", "pivots", boolean, optional, true,
     "false: without relative_pivots"},

    {"constraint", "name", name, required, true, "name of the constraint and of its multiplier"},
    {"constraint", "kind", choice, optional, true,
     "position, unless given: f(q, t) = 0; velocity: affine in the rates"},
    {"constraint", "equation", equations, optional, true, "left = right, or a list of such"},
    {"constraint", "coincide", expression_list, optional, true, "two points that stay together"},
    {"constraint", "stabilise", table, optional, true, "how an error decays"},
    {"constraint", "doc", text, optional, true, "one line"},
    {"constraint", "for", repetition, optional, true, "repeats the entry"},
    {"constraint.stabilise", "omega", expression, required, true, "angular frequency, 1/s"},
    {"constraint.stabilise", "zeta", expression, optional, true, "damping ratio; 1 unless given"},

    {"equilibrium", "name", name, required, true, "name of the equilibrium"},
    {"equilibrium", "at", table, required, true, "where the system stays at rest"},
    {"equilibrium", "inputs", table, optional, true, "inputs that hold it there; others are 0"},
    {"equilibrium", "when", condition, optional, true, "on parameters: where it exists"},
    {"equilibrium", "frequencies_squared", expression_list, optional, true,
     "of small motions, one per velocity, 1/s^2"},
    {"equilibrium", "doc", text, optional, true, "one line"},
    {"equilibrium.at", "*", expression, optional, true, "a coordinate there"},
    {"equilibrium.inputs", "*", expression, optional, true, "an input there"},

    {"expect", "conserved", expression_list, optional, true,
     "constant along the motion, u = 0; E and p(NAME) are names"},
    {"expect", "equations", equations, optional, true, "equations of motion, in any form"},
    {"expect", "at", table, optional, true, "outputs are numbers at this state, else the start"},
    {"expect", "within", expression, optional, true, "of the largest entry; 1e-12 unless given"},
    {"expect", "*", closed_form, optional, true, "an output's closed form"},
    {"expect.at", "*", expression, optional, true,
     "a coordinate, a rate such as dot(theta), an input, a parameter, …"},
    {"expect.*", "for", repetition, required, true, "the indices of the entry"},
    {"expect.*", "value", expression, required, true, "the entry at these indices"},

    // scene file
    {"scene", "format", integer, required, true, "version of the file format: 1"},
    {"scene", "model", text, required, true, "path of the model, relative to the scene"},
    {"scene", "name", name, required, true, "files and namespace are called MODEL_NAME"},
    {"scene", "doc", text, optional, true, "one line"},

    {"scene.outputs", "*", boolean_or_table, optional, true, "true where it is wanted"},
    {"scene.outputs.*", "form", choice, optional, true,
     "closed or recursive, whichever costs less"},
    {"scene.outputs.*", "rename", name, optional, true, "name of the emitted function"},
    {"scene.outputs.*", "method", text, optional, true,
     "of `step`, which needs one: rk4, verlet, midpoint"},
    {"scene.outputs.*", "order", integer, optional, true,
     "of verlet and midpoint: 2 (unless given), 4 or 8"},
    {"scene.outputs.*", "iterations", integer, optional, true, "of midpoint, 1 to 20"},
    {"scene.outputs.*", "projected", boolean, optional, true,
     "of `step`; true: back onto the constraints behind it"},
    {"scene.outputs.*", "pivots", boolean, optional, true,
     "of forward_dynamics; false: without relative_pivots"},
    {"scene.outputs.*", "independent", expression_list, optional, true,
     "of completed: coordinates whose rates determine the others"},

    {"scene.parameters", "fixed", text_or_table, optional, true, "become numbers in the code"},
    {"scene.parameters.fixed", "*", expression, optional, true, "the parameter's value"},

    {"scene.sizes", "*", integer, optional, true, "instead of the model's"},

    {"scene.lock", "*", table, optional, true, "a coordinate held at a function of time"},
    {"scene.lock.*", "value", expression_or_list, required, true,
     "of constants, parameters and t; [w, x, y, z] of a rotation"},
    {"scene.lock.*", "reaction", boolean, optional, true,
     "adds the force that holds it to the output reaction"},
    {"scene.routh", "*", boolean_or_expression, optional, true,
     "the momentum of a cyclic coordinate: true (that at the start), or its value"},
    {"scene.functions", "*", expression, optional, true, "what a function left open is"},
    {"scene.regressor", "parameters", expression_list, required, true,
     "that it has columns of, beside those of bodies, armatures and friction"},
    {"scene.approximate", "order", integer, required, true, "of the equations, 1 to 5"},
    {"scene.approximate", "about", text_or_table, required, true,
     "the equilibrium: a name in the model, or its values"},
    {"scene.approximate", "small", expression_list, optional, true, "coordinates that are small"},
    {"scene.approximate.about", "*", expression, optional, true, "a coordinate or input there"},

    {"scene.numeric", "scalar", choice_list, optional, true, "scalar types the code is for"},
    {"scene.numeric", "inner", choice, optional, true,
     "what functions of doubles compute in, in a header of their own"},
    {"scene.numeric", "form", choice, optional, true, "of every output: closed or recursive"},
    {"scene.numeric", "prefer", choice, optional, true,
     "of formulas: those that keep their digits, or the fastest"},
    {"scene.numeric", "check", table, optional, later, "ranges and tolerance of the checks"},
    {"scene.numeric", "trigonometry", table, optional, true, "sines and cosines of the code"},
    {"scene.numeric.trigonometry", "max_error", expression, optional, true,
     "of batches: absolute, rounding included; from 2^-52, float 2^-23"},
    {"scene.numeric.trigonometry", "scalar", choice, optional, true,
     "of functions of numbers: in line, or calls of the library"},
    {"scene.numeric", "max_error", expression, optional, true,
     "of every output, relative to the largest value of its field; verify looks"},
    {"scene.numeric", "ranges", table, optional, true, "where max_error holds, and tradeoff looks"},
    {"scene.numeric.ranges", "*", range, optional, true,
     "of a coordinate, a rate such as dot(theta), an acceleration, an input or t"},

    {"scene.emit", "language", choice, optional, true, "language of the emitted code"},
    {"scene.emit", "namespace", text, optional, true,
     "C++ namespace or prefix in C, instead of the base name"},
    {"scene.emit", "eigen", boolean, optional, true, "the same functions on Eigen types"},
    {"scene.emit", "batch", boolean, optional, true, "the same functions on arrays of states"},
    {"scene.emit", "storage", choice, optional, true, "order of matrix entries"},
    {"scene.emit", "files", choice_list, optional, true, "what is written; all unless given"},
});

constexpr std::string_view of_sines = "scene.numeric.trigonometry";

constexpr auto choice_rows = std::to_array<ChoiceRow>({
    {of_sines, "scalar", "in-line"},
    {of_sines, "scalar", "library"},
    {"coordinate", "kind", "scalar"},
    {"coordinate", "kind", "rotation"},
    {"frame.dh", "convention", "standard"},
    {"frame.dh", "convention", "modified"},
    {"parameters.*", "assume", "positive"},
    {"parameters.*", "assume", "nonnegative"},
    {"body", "inertia_about", "com"},
    {"body", "inertia_about", "origin"},
    {"point", "as", "rod"},
    {"point", "as", "spring"},
    {"constraint", "kind", "position"},
    {"constraint", "kind", "velocity"},
    {"scene.numeric", "scalar", "float"},
    {"scene.numeric", "scalar", "double"},
    {"scene.numeric", "scalar", "long double"},
    {"scene.numeric", "inner", "double"},
    {"scene.numeric", "inner", "long double"},
    {"scene.numeric", "inner", "double-double"},
    {"scene.numeric", "inner", "float"},
    {"scene.numeric", "form", "closed"},
    {"scene.numeric", "form", "recursive"},
    {"scene.numeric", "prefer", "balanced"},
    {"scene.numeric", "prefer", "speed"},
    {"scene.outputs.*", "form", "closed"},
    {"scene.outputs.*", "form", "recursive"},
    {"scene.emit", "storage", "row-major"},
    {"scene.emit", "storage", "column-major"},
    {"scene.emit", "files", "header"},
    {"scene.emit", "files", "equations"},
    {"scene.emit", "files", "page"},
#define ELGEN_LANGUAGE(id, name, ...) {"scene.emit", "language", name},
#include "elgen/languages.def"
#undef ELGEN_LANGUAGE
});

/// A former word of a choice, and the hint on its replacement.
struct FormerChoice {
  ChoiceRow choice;
  std::string_view hint;
};

constexpr std::array former_choices{
    FormerChoice{{"scene.numeric", "prefer", "accuracy"},
                 "`inner = \"double-double\"` adds functions that compute in more digits"}};

constexpr bool single = false;
constexpr bool repeated = true;

constexpr auto entry_rows = std::to_array<EntryRow>({
    {"model", single, required, true, "what the system is called"},
    {"coordinate", repeated, required, true, "a generalized coordinate, in this order"},
    {"parameters", single, optional, true, "constants that stay variables of the code"},
    {"sizes", single, optional, true, "integers for repetitions"},
    {"define", single, optional, true, "named expressions, in any order"},
    {"function", repeated, optional, true, "a function left open: callers compute it"},
    {"prescribed", repeated, optional, true, "a known function of time"},
    {"point", repeated, optional, true, "a place that moves with the coordinates"},
    {"frame", repeated, optional, true, "a coordinate system that moves"},
    {"body", repeated, optional, true, "a rigid body"},
    {"gravity", single, optional, true, "acceleration of gravity"},
    {"energy", single, optional, true, "energies as expressions"},
    {"input", repeated, optional, true, "an actuator"},
    {"force", repeated, optional, true, "a force that no energy gives"},
    {"output", repeated, optional, true, "a function to emit"},
    {"outputs", single, optional, true, "how the model's own outputs are given"},
    {"constraint", repeated, optional, true, "an equation the motion obeys"},
    {"equilibrium", repeated, optional, true, "a point at which the system stays at rest"},
    {"expect", repeated, optional, true, "closed forms, equations and numbers to be verified"},
    {"scene.outputs", single, optional, true, "what is derived and emitted"},
    {"scene.parameters", single, optional, true, "parameters that become numbers"},
    {"scene.sizes", single, optional, true, "sizes other than the model's"},
    {"scene.lock", single, optional, true, "coordinates that are known functions of time"},
    {"scene.routh", single, optional, true, "cyclic coordinates that are taken out"},
    {"scene.functions", single, optional, true, "expressions of functions left open"},
    {"scene.regressor", single, optional, true, "further parameters in which forces are affine"},
    {"scene.approximate", single, optional, true, "expansion about an equilibrium"},
    {"scene.numeric", single, optional, true, "arithmetic"},
    {"scene.emit", single, optional, true, "the emitted code"},
});

}  // namespace

std::span<const KeyRow> key_table() { return key_rows; }
std::span<const ChoiceRow> choice_table() { return choice_rows; }
std::span<const EntryRow> entry_table() { return entry_rows; }

bool is_drawn(std::string_view entry, std::string_view key) {
  return std::ranges::any_of(key_rows, [&](const KeyRow& row) {
    return row.is_drawn && row.entry == entry && row.key == key;
  });
}

std::vector<std::string_view> choice_words(const KeyRow& row) {
  std::vector<std::string_view> words;
  for (const ChoiceRow& each : choice_rows) {
    if (each.entry == row.entry && each.key == row.key) words.push_back(each.word);
  }
  return words;
}

std::string_view hint_of_former_choice(const KeyRow& row, std::string_view word) {
  for (const auto& [choice, hint] : former_choices) {
    if (choice.entry == row.entry && choice.key == row.key && choice.word == word) return hint;
  }
  return {};
}

}  // namespace elgen
