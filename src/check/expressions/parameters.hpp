// Parameters: [parameters] -> Model::parameters and Model::parameter_arrays. The sizes of their
// arrays: [sizes] -> Context::sizes.
#pragma once

#include "check/names/context.hpp"
#include "elgen/scene.hpp"
#include "elgen/syntax.hpp"

namespace elgen {

/// Declares the sizes of the model. The scene overrides them, and the options override the scene.
/// `scene` may be null. E605, E606, E201, E318.
void read_sizes(Context& context, const FileSyntax& model, const FileSyntax* scene,
                const SceneOptions& options);

/// Adds a parameter array with its elements, without values; false after E203, E204, E205 or E211.
[[nodiscard]] bool append_parameter_array(Context& context, const NewName& array,
                                          std::int64_t count, bool is_array);

/// Adds the parameter of a key, with its `size`. E209, E907.
void declare_parameter(Context& context, const KeySyntax& key);

/// The parameters with the name NAME (all elements) or NAME[i]; none after E602.
[[nodiscard]] std::vector<std::uint32_t> find_parameters(Context& context, const std::string& name,
                                                         const Span& span,
                                                         const std::string& hint = {});

/// Compares a value from the model or the scene with the parameter's declaration. E112 if the value
/// violates `assume`, on which the simplification relies. E518, a warning, if the value violates
/// `min` or `max`.
void check_parameter_value(Context& context, std::uint32_t parameter, const cln::cl_R& value,
                           const Span& span);

/// Reads value, unit, assumption and range of every declared parameter. E104, E112, E402, E518.
void read_parameters(Context& context, const FileSyntax& syntax);

}  // namespace elgen
