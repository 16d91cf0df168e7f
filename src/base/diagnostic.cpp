// diagnostic: the table of codes; sorting of diagnostics, and their exit code.
#include "elgen/diagnostic.hpp"

#include <algorithm>
#include <iterator>
#include <tuple>

#include "base/reason.hpp"

namespace elgen {

namespace {

constexpr Code codes_of_texts[]{
#define ELGEN_CODE(code, severity, exit_code, title, explanation) Code::code,
#include "base/error_texts.def"
#undef ELGEN_CODE
};

/// True if the table is in the order of the enumeration Code, which code_row() requires because it
/// uses a code as an index.
constexpr bool is_in_order() {
  for (std::size_t i = 0; i < std::size(codes_of_texts); ++i) {
    if (static_cast<std::size_t>(codes_of_texts[i]) != i) return false;
  }
  return true;
}
constexpr Code all_codes[]{
#define ELGEN_CODE(code) Code::code,
#include "elgen/error_codes.def"
#undef ELGEN_CODE
};
static_assert(is_in_order() && std::size(codes_of_texts) == std::size(all_codes));

struct ReasonRow {
  Code code;
  std::string_view text;
};

constexpr ReasonRow reason_rows[]{
#define ELGEN_REASON(code, id, text) {Code::code, text},
#include "base/error_reasons.def"
#undef ELGEN_REASON
};

}  // namespace

const std::vector<CodeRow>& code_table() {
  static const std::vector<CodeRow> table{
#define ELGEN_CODE(code, severity, exit_code, title, explanation) \
  {Code::code, Severity::severity, ExitCode::exit_code, #code, title, explanation},
#include "base/error_texts.def"
#undef ELGEN_CODE
  };
  return table;
}

const CodeRow& code_row(Code code) { return code_table()[static_cast<std::size_t>(code)]; }

const CodeRow* find_code(std::string_view name) {
  const auto& table = code_table();
  const auto row = std::ranges::find(table, name, &CodeRow::name);
  return row == table.end() ? nullptr : &*row;
}

std::vector<std::string_view> reasons_of(Code code) {
  std::vector<std::string_view> texts;
  for (const ReasonRow& row : reason_rows) {
    if (row.code == code) texts.push_back(row.text);
  }
  return texts;
}

const Diagnostic* find_error(const Diagnostics& diagnostics) {
  const auto found = std::ranges::find_if(diagnostics, [](const Diagnostic& diagnostic) {
    return code_row(diagnostic.code).severity == Severity::error;
  });
  return found == diagnostics.end() ? nullptr : &*found;
}

bool has_errors(const Diagnostics& diagnostics) { return find_error(diagnostics) != nullptr; }

void sort_by_position(Diagnostics& diagnostics) {
  const auto key = [](const Diagnostic& d) {
    const bool is_file = d.span.source != nullptr && d.span.source->path != "command line";
    const std::string_view path =
        d.span.source == nullptr ? std::string_view() : std::string_view(d.span.source->path);
    return std::tuple(!is_file, path, d.span.begin, d.code, std::string_view(d.message));
  };
  std::stable_sort(
      diagnostics.begin(), diagnostics.end(),
      [&](const Diagnostic& left, const Diagnostic& right) { return key(left) < key(right); });
  const auto last = std::unique(
      diagnostics.begin(), diagnostics.end(),
      [&](const Diagnostic& left, const Diagnostic& right) { return key(left) == key(right); });
  diagnostics.erase(last, diagnostics.end());
}

ExitCode exit_code(const Diagnostics& diagnostics) {
  ExitCode worst = ExitCode::success;
  for (const Diagnostic& diagnostic : diagnostics) {
    worst = std::max(worst, code_row(diagnostic.code).exit_code);
  }
  return worst;
}

}  // namespace elgen
