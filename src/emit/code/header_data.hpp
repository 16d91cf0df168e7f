// header_data: EmissionInput -> the template data that headers of every language need: stamp,
// counts, introduction, table of operations, and the functions with their documentation.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/fill_template.hpp"
#include "emit/code/dialect.hpp"
#include "emit/interface/code_interface.hpp"
#include "emit/text/emission_input.hpp"

namespace elgen {

/// Generator and sources, hashes, namespace and storage order of the file.
[[nodiscard]] TemplateData stamp_data(const EmissionInput& input);

/// Sets the number of pivots, and the section `regular` if some function returns pivots.
void set_pivot_data(TemplateData& data, const EmissionInput& input);

/// The section `parts` of a function; absent if the function is short. `types`: the template
/// parameters of the parts in C++.
[[nodiscard]] TemplateData parts_section(const Function& function,
                                         const FunctionDefinition& definition,
                                         const std::string& types = "class Scalar");

/// True if a function has a loop over columns.
[[nodiscard]] bool has_column_loops(const Program& program);

/// The data of a header. The section `kinks` is present if the program calls sign, min or max; the
/// section `columns` is present if a function has a loop over columns.
[[nodiscard]] TemplateData header_data(const EmissionInput& input, const Dialect& dialect);

/// The elements of a declared array as literals. The bounds replace {0} and {1} of `interval`;
/// `unbounded` replaces a bound that is missing or too large for double.
[[nodiscard]] std::vector<std::string> element_literals(const DeclaredArray& array,
                                                        std::string_view interval,
                                                        std::string_view unbounded);

/// True if a bound is missing, or a number or bound is too large for double, so that
/// element_literals() writes `unbounded`.
[[nodiscard]] bool has_unbounded_element(const DeclaredArray& array);

/// " step is omitted: it has more than 4096 entries."
[[nodiscard]] std::string omission_note(const Function& function);

/// Notes, wrapped as lines of a comment.
[[nodiscard]] std::vector<std::string> wrap_notes(const std::vector<std::string>& notes);

/// The filled template with its body hash and at most `most_empty` empty lines in a row.
[[nodiscard]] std::string fill_header_template(std::string_view path, const TemplateData& data,
                                               std::size_t most_empty = 1);

}  // namespace elgen
