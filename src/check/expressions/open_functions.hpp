// Open functions: a [[function]] without an expression. A closed function has an expression, from
// its own sample or from [functions] of the scene.
//
//     [[function]] V of ["x", "y"]   ->   the names V, V_1, V_2, V_11, V_12, V_22
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "check/names/context.hpp"
#include "elgen/scene.hpp"
#include "elgen/syntax.hpp"

namespace elgen {

/// "V"; "" if the entry has no name.
[[nodiscard]] std::string function_name(const EntrySyntax& function);

/// Fills Context::function_replacements from [functions] of the scene; E201 for an unknown
/// function. If the options require it, all other functions are replaced by their samples (note
/// E634; E633 without a sample). `scene` may be null.
void read_function_replacements(Context& context, const FileSyntax& model, const FileSyntax* scene,
                                const SceneOptions& options);

/// The expression that replaces a [[function]]; null if the function stays open.
[[nodiscard]] const FunctionReplacement* find_function_replacement(const Context& context,
                                                                   const EntrySyntax& function);

/// Declares the names of the function and of its derivatives. Adds an open function with its values
/// to the Model, or a definition for a closed function. Returns the index of the open function or
/// definition; none after E203, E204, E205 or E211.
[[nodiscard]] std::optional<std::uint32_t> declare_function(Context& context,
                                                            const EntrySyntax& entry,
                                                            const NewName& name);

/// Reports E319 if a function's sample, or its expression in the scene, depends on a variable on
/// which no argument of the function depends.
void check_function_expressions(Context& context);

/// True if a value names a derivative of a function that has an expression.
[[nodiscard]] bool uses_closed_derivative(const Context& context, const ValueSyntax& value);

}  // namespace elgen
