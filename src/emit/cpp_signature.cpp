// cpp_signature: what a function takes is the table's affair, what is named the body's.
#include "cpp_signature.hpp"

#include <cctype>

#include "cpp_names.hpp"
#include "cpp_spelling.hpp"
#include "layout.hpp"

namespace elgen {
namespace {

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

std::string declared(const CppArgument& argument, std::string_view body) {
  return mentions(body, argument.name) ? argument.type + " " + argument.name : argument.type;
}

}  // namespace

std::vector<CppArgument> cpp_arguments(const Model& model, const Function& function) {
  const OutputRow& row = output_row(function.kind);
  const bool mass_takes_velocity = function.kind == OutputKind::mass_matrix && !model.quadratic;
  std::vector<CppArgument> list = {{"const Parameters<Scalar>&", "p"},
                                   {"const Coordinates<Scalar>&", "q"}};
  const auto add = [&list](bool is_taken, const char* type, const char* name) {
    if (is_taken) list.push_back({type, name});
  };
  add(row.takes_velocity || mass_takes_velocity, "const Velocities<Scalar>&", "v");
  add(row.takes_acceleration, "const Accelerations<Scalar>&", "a");
  add(row.takes_input, "const Inputs<Scalar>&", "u");
  add(model.uses_time, "const std::common_type_t<Scalar>&", "t");
  return list;
}

std::string result_type(const Function& function) {
  if (returns_struct(function)) return struct_name(function) + "<Scalar>";
  return field_type(function.kind, function.fields.front());
}

bool mentions(std::string_view text, std::string_view word) {
  for (std::size_t at = text.find(word); at != std::string_view::npos;
       at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    const bool begins = at == 0 || (!is_word(text[at - 1]) && text[at - 1] != '.');
    const bool ends = end == text.size() || !is_word(text[end]);
    if (begins && ends) return true;
  }
  return false;
}

std::string cpp_signature(const std::string& start, const std::vector<CppArgument>& arguments,
                          std::string_view body) {
  // Arguments stand below the first one, or indented where the start leaves too little room.
  constexpr std::size_t widest_alignment = 60;
  const bool is_aligned = start.size() < widest_alignment;
  const std::string indent(is_aligned ? start.size() + 1 : 4, ' ');
  std::string text = start + "(" + (is_aligned ? "" : "\n" + indent);
  std::size_t column = indent.size();
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const bool is_last = i + 1 == arguments.size();
    const std::string piece = declared(arguments[i], body) + (is_last ? ") noexcept" : ",");
    const std::size_t needed = 1 + piece.size() + (is_last ? 2 : 0);  // the brace follows the last
    const bool breaks = i > 0 && column + needed > line_width;
    if (breaks) text += "\n" + indent;
    if (i > 0 && !breaks) text += ' ';
    column = (breaks ? indent.size() : column + (i > 0 ? 1 : 0)) + piece.size();
    text += piece;
  }
  return text;
}

}  // namespace elgen
