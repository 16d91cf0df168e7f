// Open functions: [[function]], and the expressions that close some.
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

/// "V"; empty where the entry has no name.
[[nodiscard]] std::string function_name(const EntrySyntax& function);

/// Fills Context::closures: from [functions] of the scene (E201 for names of no function), and
/// where options say so by samples, of which a note E634 tells; E633 where there is none. `scene`
/// may be null.
void read_closures(Context& context, const FileSyntax& model, const FileSyntax* scene,
                   const SceneOptions& options);

/// The closure of a [[function]]; null where it stays open.
[[nodiscard]] const Closure* closure_of(const Context& context, const EntrySyntax& function);

/// Declares the name and those of the derivatives, and adds the function with its values to the
/// Model, or the definition that stands for it; its index there. E203, E204, E205, E211.
[[nodiscard]] std::optional<std::uint32_t> declare_function(Context& context,
                                                            const EntrySyntax& entry,
                                                            const NewName& name);

/// E319: a sample, or an expression of a scene, that reads what no argument of its function reads.
void check_function_expressions(Context& context);

/// Whether a value speaks of a derivative of a function that has an expression.
[[nodiscard]] bool uses_closed_derivative(const Context& context, const ValueSyntax& value);

}  // namespace elgen
