// SymbolTable: one namespace of a model, with the elements of indexed names.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/report.hpp"

namespace elgen {

enum class SymbolKind : std::uint8_t {
  coordinate,
  rotation,              ///< elements 1 to 3: its velocities
  quaternion_component,  ///< of a rotation; expressions may not use it
  parameter,
  definition,
  prescribed,
  open_value,         ///< an open function
  open_derivative,    ///< a derivative of an open function
  closed_derivative,  ///< a derivative of a function that has an expression; it is no number
  point,
  frame,
  body,
  input,
  force,
  output,
  constraint,
  equilibrium,
  size,
};

[[nodiscard]] std::string_view symbol_noun(SymbolKind kind);

/// The inertial frame, and the default of every key that names a frame.
inline constexpr std::string_view world = "world";

/// "an input"
[[nodiscard]] std::string with_article(std::string_view word);

/// A name with one meaning, or with one meaning per index if `is_array`.
struct DeclaredName {
  SymbolKind kind = SymbolKind::parameter;
  bool is_array = false;
  std::map<std::int64_t, std::uint32_t> elements = {};  ///< index in the file -> index in the Model
  Span span = {};
};

/// A name about to be declared: "q", or "q[3]" from "q[i]".
struct NewName {
  std::string base;
  std::optional<std::int64_t> index = {};
  Span span = {};

  [[nodiscard]] std::string text() const;        ///< "q[3]"
  [[nodiscard]] std::string identifier() const;  ///< "q_3"
};

/// "`q` has the elements 1 to 3"
[[nodiscard]] std::string elements_of(const std::string& name, const DeclaredName& symbol);

class SymbolTable {
 public:
  /// Declares a name; false after E203, E204, E205 or E211. `target` is the index in the Model.
  bool declare(const NewName& name, SymbolKind kind, std::uint32_t target, Report& report);

  /// Marks a name whose declaration has an error, so that its uses are not reported too.
  void mark_failed(const std::string& base) { failed_.insert(base); }
  [[nodiscard]] bool has_failed(std::string_view base) const { return failed_.count(base) > 0; }

  [[nodiscard]] const DeclaredName* find(std::string_view base) const;
  [[nodiscard]] std::vector<std::string> names() const;
  [[nodiscard]] std::vector<std::string> names(const std::vector<SymbolKind>& kinds) const;
  /// "did you mean `m`? (parameter, line 20)", or "".
  [[nodiscard]] std::string suggest(std::string_view word,
                                    const std::vector<std::string>& among) const;

 private:
  bool report_duplicate(const NewName& name, const DeclaredName& first, Report& report) const;
  bool claim_identifier(const NewName& name, Report& report);

  std::set<std::string, std::less<>> failed_;
  std::map<std::string, DeclaredName, std::less<>> symbols_;
  std::map<std::string, NewName, std::less<>> identifiers_;
};

}  // namespace elgen
