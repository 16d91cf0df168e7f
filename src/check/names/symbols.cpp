// Every declaration passes through declare(). It finds duplicates, reserved names and names that
// would become the same C++ identifier.
#include "check/names/symbols.hpp"

#include <array>

#include "check/names/reserved_names.hpp"

namespace elgen {
namespace {

/// In the order of SymbolKind.
constexpr std::array<std::string_view, 18> nouns{"coordinate",
                                                 "rotation",
                                                 "component of a rotation",
                                                 "parameter",
                                                 "definition",
                                                 "prescribed function",
                                                 "function left open",
                                                 "derivative of a function left open",
                                                 "derivative of a function with an expression",
                                                 "point",
                                                 "frame",
                                                 "body",
                                                 "input",
                                                 "force",
                                                 "output",
                                                 "constraint",
                                                 "equilibrium",
                                                 "size"};
static_assert(nouns[static_cast<std::size_t>(SymbolKind::size)] == "size");

std::string at_line(const Span& span) {
  if (span.source == nullptr) return "";
  return "line " + std::to_string(line_column(*span.source, span.begin).line);
}

bool check_spelling(const NewName& name, Report& report) {
  if (!check_name(name.base, name.span, report)) return false;
  if (name.index.value_or(0) < 0) {
    report.add(Code::E205, name.span, quote_text(name.text()) + " has a negative index");
    return false;
  }
  return true;
}

}  // namespace

std::string_view symbol_noun(SymbolKind kind) { return nouns[static_cast<std::size_t>(kind)]; }

std::string with_article(std::string_view word) {
  const bool vowel = std::string_view("aeiou").find(word.front()) != std::string_view::npos;
  return (vowel ? "an " : "a ") + std::string(word);
}

std::string NewName::text() const {
  return index ? base + "[" + std::to_string(*index) + "]" : base;
}

std::string NewName::identifier() const {
  return index ? base + "_" + std::to_string(*index) : base;
}

std::string elements_of(const std::string& name, const DeclaredName& symbol) {
  const std::int64_t first = symbol.elements.begin()->first;
  const std::int64_t last = symbol.elements.rbegin()->first;
  return quote_text(name) + " has the elements " + std::to_string(first) + " to " +
         std::to_string(last);
}

bool SymbolTable::declare(const NewName& name, SymbolKind kind, std::uint32_t target,
                          Report& report) {
  if (!check_spelling(name, report)) {
    mark_failed(name.base);
    return false;
  }
  const auto found = symbols_.find(name.base);
  if (found != symbols_.end()) {
    const DeclaredName& first = found->second;
    const bool joins = first.is_array && name.index && first.kind == kind &&
                       first.elements.count(*name.index) == 0;
    if (!joins) return report_duplicate(name, first, report);
  }
  if (!claim_identifier(name, report)) return false;
  DeclaredName& symbol = found == symbols_.end() ? symbols_[name.base] : found->second;
  if (found == symbols_.end()) {
    symbol = {kind, name.index.has_value(), {}, name.span};
  }
  symbol.elements[name.index.value_or(0)] = target;
  return true;
}

bool SymbolTable::report_duplicate(const NewName& name, const DeclaredName& first,
                                   Report& report) const {
  Diagnostic diagnostic{
      Code::E203, name.span,
      quote_text(name.text()) + " is already " + with_article(symbol_noun(first.kind))};
  if (first.span.source != nullptr) {
    const bool is_same_file = first.span.source == name.span.source;
    diagnostic.hint = "first " + (is_same_file ? "at " + at_line(first.span)
                                               : "in " + quote_text(file_name(*first.span.source)));
    diagnostic.related = first.span;
    diagnostic.related_message = "first declared here";
  }
  report.add(std::move(diagnostic));
  return false;
}

bool SymbolTable::claim_identifier(const NewName& name, Report& report) {
  const auto [first, is_new] = identifiers_.emplace(name.identifier(), name);
  if (is_new) return true;
  report.add({Code::E211, name.span,
              quote_text(name.text()) + " and " + quote_text(first->second.text()) +
                  " both become " + quote_text(first->first) + " in code",
              "", first->second.span, quote_text(first->second.text()) + " is declared here"});
  return false;
}

const DeclaredName* SymbolTable::find(std::string_view base) const {
  const auto found = symbols_.find(base);
  return found == symbols_.end() ? nullptr : &found->second;
}

std::vector<std::string> SymbolTable::names() const {
  std::vector<std::string> result;
  for (const auto& [name, symbol] : symbols_) result.push_back(name);
  return result;
}

std::vector<std::string> SymbolTable::names(const std::vector<SymbolKind>& kinds) const {
  std::vector<std::string> result;
  for (const SymbolKind kind : kinds) {
    for (const auto& [name, symbol] : symbols_) {
      if (symbol.kind == kind) result.push_back(name);
    }
  }
  return result;
}

std::string SymbolTable::suggest(std::string_view word,
                                 const std::vector<std::string>& among) const {
  const std::string near = nearest_word(word, among);
  const DeclaredName* symbol = near.empty() ? nullptr : find(near);
  if (symbol == nullptr) return suggestion(word, among);
  std::string where(symbol_noun(symbol->kind));
  if (symbol->span.source != nullptr) where += ", " + at_line(symbol->span);
  return "did you mean `" + near + "`? (" + where + ")";
}

}  // namespace elgen
