// read_page. A section starts with the name of a function after a blank line, and has one equation
// per line. Definitions shared by several functions come first; each line uses only lines above it.
#include <fmt/format.h>

#include <vector>

#include "elgen/program.hpp"
#include "elgen/wording.hpp"
#include "texts/readers.hpp"

namespace elgen::test {
namespace {

constexpr std::string_view table_margin = "  ";

class PageReader {
 public:
  PageReader(const std::string& text, WrittenEquations& equations)
      : text_(text), origin_(equations.origin()), equations_(equations) {}

  void read() {
    read_parts();
    for (std::size_t i = 0; i < origin_.program.functions.size(); ++i) {
      const Function& function = origin_.program.functions[i];
      if (!has_equations(output_row(function.kind))) continue;
      equations_.start(i);
      const std::size_t behind = at_ == 0 ? 0 : at_ - 1;  // the end of the previous line
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

  void read_parts() {
    equations_.clear_parts();
    const std::string heading = "\n\nnamed parts\n";
    const std::size_t start = text_.find(heading);
    if (start == std::string::npos) return;
    for (at_ = start + heading.size(); line().starts_with(table_margin); at_ += line().size() + 1) {
      const std::size_t equal = line().find(" = ");
      if (equal == std::string_view::npos) throw Mistake(std::string(line()) + ": no equation");
      const std::string name(line().substr(table_margin.size(), equal - table_margin.size()));
      const std::string problem = equations_.part(name, std::string(line().substr(equal + 3)));
      if (!problem.empty()) throw Mistake(quote_text(name) + ": " + problem);
    }
  }

  [[noreturn]] void fail(const Function& function, const std::string& problem) const {
    throw Mistake(quote_text(function.name) + ": " + problem);
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

  /// Reads the entry of this name.
  void entry(const Function& function, const std::string& name, std::uint32_t instruction) {
    const std::string_view text = line();
    const std::string left = fmt::format("{}{} = ", table_margin, name);
    if (!text.starts_with(left)) fail(function, quote_text(name) + " is missing");
    const std::string right(text.substr(left.size()));
    const std::string problem = equations_.entry(instruction, right);
    if (!problem.empty()) fail(function, problem);
    at_ += text.size() + 1;
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

}  // namespace elgen::test
