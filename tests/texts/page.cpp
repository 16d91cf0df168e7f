// read_page: a section is the name of a function behind a blank line, and one equation a line.
#include <fmt/format.h>

#include <vector>

#include "elgen/wording.hpp"
#include "lower/code_interface.hpp"
#include "texts/readers.hpp"

namespace elgen::texts {
namespace {

constexpr std::string_view table_margin = "  ";

class PageReader {
 public:
  PageReader(const std::string& text, WrittenEquations& equations)
      : text_(text), origin_(equations.origin()), equations_(equations) {}

  void read() {
    for (std::size_t i = 0; i < origin_.program.functions.size(); ++i) {
      const Function& function = origin_.program.functions[i];
      if (!has_equations(output_row(function.kind))) continue;
      equations_.start(i);
      const std::size_t behind = at_ == 0 ? 0 : at_ - 1;  // the end of the line before
      const std::size_t heading = text_.find(fmt::format("\n\n{}\n", function.name), behind);
      if (heading == std::string::npos) {
        expect_zero(function);
      } else {
        at_ = heading + 2 + function.name.size() + 1;
        section(function);
      }
    }
  }

 private:
  [[nodiscard]] std::string_view line() const {
    const std::string_view rest = std::string_view(text_).substr(at_);
    return rest.substr(0, rest.find('\n'));
  }

  [[noreturn]] void fail(const Function& function, const std::string& problem) const {
    throw Mistake(in_backticks(function.name) + ": " + problem);
  }

  void expect_zero(const Function& function) {
    for (const Field& field : function.fields) {
      for (const std::uint32_t entry : field.entries) {
        if (!equations_.entry(entry, "0").empty()) fail(function, "the function is missing");
      }
    }
  }

  void section(const Function& function) {
    for (const Field& field : function.fields) {
      const std::string& name = field.name.empty() ? function.name : field.name;
      for (std::size_t i = 0; i < field.entries.size(); ++i) {
        entry(function, name + index_text(field, i), field.entries[i]);
      }
    }
    if (line().starts_with(table_margin)) fail(function, "one line too many");
  }

  /// The definitions before it, and the entry of this name.
  void entry(const Function& function, const std::string& name, std::uint32_t instruction) {
    for (bool is_entry = false; !is_entry;) {
      const std::string_view text = line();
      const std::size_t equal = text.find(" = ");
      const bool is_equation = text.starts_with(table_margin) && equal != std::string_view::npos;
      if (!is_equation) fail(function, in_backticks(name) + " is missing");
      const std::string left(text.substr(table_margin.size(), equal - table_margin.size()));
      const std::string right(text.substr(equal + 3));
      is_entry = left == name;
      const std::string problem =
          is_entry ? equations_.entry(instruction, right) : equations_.definition(left, right);
      if (!problem.empty()) fail(function, problem);
      at_ += text.size() + 1;
    }
  }

  const std::string& text_;
  const Origin& origin_;
  WrittenEquations& equations_;
  std::size_t at_ = 0;
};

}  // namespace

void read_page(const std::string& page, WrittenEquations& equations) {
  PageReader(page, equations).read();
}

}  // namespace elgen::texts
