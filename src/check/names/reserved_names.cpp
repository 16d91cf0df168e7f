// Reserved names have another meaning in expressions, or would not compile as members of the
// emitted structs.
#include "check/names/reserved_names.hpp"

#include <algorithm>
#include <array>

#include "base/ascii.hpp"
#include "elgen/functions.hpp"
#include "elgen/wording.hpp"

namespace elgen {

namespace {

constexpr auto keywords = std::to_array<std::string_view>({
#include "check/names/keywords.def"
});

/// Macros of the headers on the machine that builds elgen; sorted.
constexpr auto library_macros = std::to_array<std::string_view>({
#include "check/names/library_macros.def"
});

/// Macros of other platforms.
constexpr std::array more_macros{"HUGE",  "OVERFLOW", "UNDERFLOW", "DOMAIN", "SING",
                                 "PLOSS", "TLOSS",    "imaginary", "i386",   "signgam"};

constexpr std::array macro_prefixes{"M_",    "FP_",  "MATH_",  "DBL_",  "FLT_",
                                    "LDBL_", "INT_", "EIGEN_", "ELGEN_"};

template <class List>
bool contains(const List& list, std::string_view name) {
  return std::ranges::find(list, name) != list.end();
}

bool has_macro_prefix(std::string_view name) {
  const auto starts = [&](std::string_view prefix) { return name.starts_with(prefix); };
  return std::ranges::any_of(macro_prefixes, starts);
}

/// True if `word` occurs in a line without the text "unit" before `word`. After "unit", `J` is the
/// joule.
bool is_in_file(const SourceText* source, std::string_view word) {
  if (source == nullptr) return false;
  const std::string_view text = source->text;
  for (std::size_t at = text.find(word); at != std::string_view::npos;
       at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    const bool is_part = (at > 0 && is_word_character(text[at - 1])) ||
                         (end < text.size() && is_word_character(text[end]));
    const std::string_view before = text.substr(0, at);
    const std::string_view line = before.substr(before.rfind('\n') + 1);  // npos + 1 is 0
    if (!is_part && line.find("unit") == std::string_view::npos) return true;
  }
  return false;
}

/// The name without repeated and trailing underscores; in lower case if it has a macro's prefix.
std::string conventional_spelling(std::string_view name) {
  std::string result;
  for (const char c : name) {
    if (c != '_' || !result.ends_with('_')) result += c;
  }
  if (result.ends_with('_')) result.pop_back();
  if (has_macro_prefix(result + "_")) std::ranges::transform(result, result.begin(), to_lower_case);
  return result;
}

bool is_macro(std::string_view name) {
  return std::ranges::binary_search(library_macros, name) || contains(more_macros, name) ||
         has_macro_prefix(name);
}

}  // namespace

std::vector<std::string> function_names() {
  std::vector<std::string> names = column_words(function_table(), &FunctionRow::name);
  for (const CallRow& call : call_table()) names.emplace_back(call.name);
  return names;
}

std::string_view reserved_reason(std::string_view name) {
  if (name == "t") return "it is time";
  if (name == "pi") return "it is the number pi";
  if (is_reserved_function(name)) return "it is a function of expressions";
  if (contains(keywords, name)) return "it is a keyword of C++";
  if (is_macro(name)) return "it is a macro of C or C++";
  if (name.find("__") != std::string_view::npos) {
    return "names with two underscores in a row belong to C++";
  }
  return {};
}

std::string free_name_hint(std::string_view name, const Span& span) {
  const auto is_free = [&](const std::string& other) {
    return other != name && reserved_reason(other).empty() && !is_in_file(span.source, other);
  };
  const std::string usual = conventional_spelling(name);
  std::string found = name == "I" ? "J" : usual;  // the other common letter for moments of inertia
  for (int k = 1; !is_free(found); ++k) found = usual + "_" + std::to_string(k);
  return quote_text(found) + " is free";
}

bool is_well_formed_name(std::string_view name) {
  return !name.empty() && is_letter(name.front()) && std::ranges::all_of(name, is_word_character);
}

bool check_name(const std::string& name, const Span& span, Report& report) {
  if (!is_well_formed_name(name)) {
    report.add(
        Code::E205, span,
        quote_text(name) + " is no name: a name is a letter, then letters, digits and underscores");
    return false;
  }
  if (const std::string_view reason = reserved_reason(name); !reason.empty()) {
    report.add(Code::E204, span, quote_text(name) + " is reserved: " + std::string(reason),
               report.needs_suggestion() ? free_name_hint(name, span) : "");
    return false;
  }
  return true;
}

}  // namespace elgen
