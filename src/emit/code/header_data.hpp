// header_data: EmissionInput -> the values of the holes that the headers of every language have:
// stamp, counts, introduction, table of operations, and the functions with their documentation.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/fill_template.hpp"
#include "emit/code/dialect.hpp"
#include "emit/interface/code_interface.hpp"
#include "emit/text/emission_input.hpp"

namespace elgen {

/// Who made the file from what, its namespace and storage.
[[nodiscard]] TemplateData stamp_data(const EmissionInput& input);

/// Section `regular`, which is there where pivots are.
void set_regular(TemplateData& data, const EmissionInput& input);

/// Whether a function has a loop over columns.
[[nodiscard]] bool has_loops(const Program& program);

/// Sections `kinks` and `columns` are there where sign, min or max, and where loops are.
[[nodiscard]] TemplateData header_data(const EmissionInput& input, const Dialect& dialect);

/// The elements of an array at the head, as literals; {0} and {1} of `interval` are its bounds.
[[nodiscard]] std::vector<std::string> declared_elements(const DeclaredArray& array,
                                                         std::string_view interval,
                                                         std::string_view unbounded);

/// Whether an element has no bound, or one beyond double: `unbounded` stands there.
[[nodiscard]] bool has_unbounded(const DeclaredArray& array);

/// " step is left out: it has more than 4096 entries."
[[nodiscard]] std::string left_out_note(const Function& function);

/// Notes as the lines of a comment.
[[nodiscard]] std::vector<std::string> wrapped_notes(const std::vector<std::string>& notes);

/// The filled template with its body hash, and with at most so many empty lines in a row.
[[nodiscard]] std::string header_text(std::string_view path, const TemplateData& data,
                                      std::size_t most_empty = 1);

}  // namespace elgen
