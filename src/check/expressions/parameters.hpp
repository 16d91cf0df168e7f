// Parameters: [parameters] -> Model::parameters and Model::parameter_arrays. And the sizes of their
// arrays, [sizes] -> Context::sizes.
#pragma once

#include "check/names/context.hpp"
#include "elgen/scene.hpp"
#include "elgen/syntax.hpp"

namespace elgen {

/// Declares the sizes of the model, then sets them as the scene and at last as the options say.
/// `scene` may be null. E605, E606, E201, E318.
void read_sizes(Context& context, const FileSyntax& model, const FileSyntax* scene,
                const SceneOptions& options);

/// Adds a parameter with its elements, without values; false after E203, E204, E205 or E211.
[[nodiscard]] bool add_elements(Context& context, const NewName& array, std::int64_t count,
                                bool is_array);

/// The same of a key, with its `size`. E209, E907.
void declare_parameter(Context& context, const KeySyntax& key);

/// The parameters that NAME (all elements) or NAME[i] stands for; none after E602.
[[nodiscard]] std::vector<std::uint32_t> named_parameters(Context& context, const std::string& name,
                                                          const Span& span,
                                                          const std::string& hint = {});

/// Holds a value of a parameter, the model's own or that of a scene, against what the model says
/// of it: E112 where `assume` denies it, since the algebra relies on that; E518, a warning, where
/// it is beyond `min` or `max`.
void check_value(Context& context, std::uint32_t parameter, const cln::cl_R& value,
                 const Span& span);

/// Reads value, unit, assumption and range of every declared parameter. E104, E112, E402, E518.
void read_parameters(Context& context, const FileSyntax& syntax);

}  // namespace elgen
