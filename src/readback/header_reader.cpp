// header_reader: the holes of each picture, and who reads them.
#include "readback/header_reader.hpp"

#include <memory>

#include "evaluate/scalar_literal.hpp"
#include "readback/comment_reader.hpp"
#include "readback/declarations.hpp"
#include "readback/function_reader.hpp"
#include "readback/number_reader.hpp"
#include "readback/operation_table.hpp"
#include "readback/picture.hpp"

namespace elgen {
namespace {

using Texts = std::map<std::string, std::string>;

/// The holes that are the same everywhere in a file.
Texts known_texts(const Origin& origin, const CodeDialect& dialect) {
  const auto& [model, scene, program] = origin;
  const bool is_row_major = scene.emission.storage == Storage::row_major;
  return {{"namespace", name_space(scene)},
          {"capitals", capitals(name_space(scene))},
          {"guard", capitals(scene.base_name)},
          {"header", scene.base_name + ".hpp"},
          {"order", is_row_major ? "RowMajor" : "ColMajor"},
          {"scalar", dialect.scalar},
          {"coordinate_count", std::to_string(model.coordinates.size())},
          {"velocity_count", std::to_string(model.velocities.size())},
          {"input_count", std::to_string(model.inputs.size())},
          {"parameter_count", std::to_string(emitted_parameter_count(model, program))}};
}

/// The sections and holes of functions, which all languages have.
class Functions {
 public:
  /// `equations`: what reads those above functions; null where there are none.
  Functions(TokenReader& tokens, const FileScope& file, EquationReader* equations)
      : tokens_(tokens), file_(file), equations_(equations) {}

  void add_to(HoleReaders& readers) {
    const Program& program = file_.origin.program;
    readers.sections["functions"] = [this] { return next(); };
    readers.sections["struct"] = [this] { return reader_->wants_struct(); };
    readers.sections["parts"] = [this] { return reader_->wants_parts(); };
    readers.sections["part"] = [this] { return reader_->wants_part(); };
    readers.sections["members"] = whole(&FunctionReader::struct_members);
    readers.sections["values"] = whole(&FunctionReader::workspace_members);
    readers.sections["kinks"] = once(calls_own_functions(program));
    readers.sections["sine_cosine"] = once(has_sine_with_cosine(program));
    readers.sections["regular"] = once(gives_pivots(program));
    readers.holes["name"] = [this] { reader_->struct_name(); };
    readers.holes["workspace"] = [this] { reader_->workspace_name(); };
    readers.holes["signature"] = [this] { reader_->signature(); };
    readers.holes["body"] = [this] { reader_->body(); };
  }

 private:
  bool next() {
    const Program& program = file_.origin.program;
    if (read_ > 0) read_equations();
    tokens_.set_function("");
    if (read_ == program.functions.size()) return false;
    reader_ = std::make_unique<FunctionReader>(tokens_, file_, program.functions[read_++]);
    return true;
  }

  /// Those above the function that has been read.
  void read_equations() {
    if (equations_ == nullptr) return;
    equations_->start(read_ - 1);
    read_comment(reader_->comments(), tokens_, *equations_, file_.origin);
  }

  /// A section that is read at once.
  std::function<bool()> whole(void (FunctionReader::*read)()) {
    return [this, read] {
      (*reader_.*read)();
      return false;
    };
  }

  TokenReader& tokens_;
  const FileScope& file_;
  EquationReader* equations_;
  std::unique_ptr<FunctionReader> reader_ = {};
  std::size_t read_ = 0;
};

/// The numbers too long to stand in equations, in the order of the program.
std::vector<cln::cl_R> long_numbers(const Program& program) {
  std::vector<cln::cl_R> numbers;
  for (const Constant& constant : executed_constants(program)) {
    const cln::cl_R magnitude = cln::abs(constant.value);
    if (!exact_in_float(magnitude)) numbers.push_back(magnitude);
  }
  return numbers;
}

/// The name of a number is known from here on.
void read_number_name(TokenReader& tokens, FileScope& scope, const cln::cl_R& value) {
  const CodeToken name = tokens.current();
  const bool is_new = scope.numbers.emplace(tokens.name(), value).second;
  if (!is_new) tokens.fail(tokens.span(name), "a number of this name stands above");
}

void read_cpp_header(TokenReader& tokens, FileScope& scope, EquationReader& equations) {
  const Origin& origin = scope.origin;
  const Picture picture("cpp/header.hpp.mustache", known_texts(origin, scope.dialect));
  const std::vector<DeclaredArray> arrays = declared_arrays(origin.model);
  const std::vector<cln::cl_R> numbers = long_numbers(origin.program);
  std::size_t array = 0;
  std::size_t number = 0;
  HoleReaders readers;
  Functions functions(tokens, scope, &equations);
  functions.add_to(readers);
  const auto name = readers.holes["name"];
  bool is_declared = false;  // of the arrays, whose section comes first
  bool is_numbered = false;  // of the numbers, which come next
  readers.sections["declared"] = [&] { return (is_declared = array++ < arrays.size()); };
  readers.sections["numbers"] = [&] { return (is_numbered = number++ < numbers.size()); };
  readers.holes["type"] = [&] {
    tokens.expect_code(arrays[array - 1].has_texts ? "const char*" : "Interval");
  };
  readers.holes["count"] = [&] { tokens.expect_integer(arrays[array - 1].size()); };
  readers.holes["name"] = [&] {
    if (is_declared) return tokens.expect(arrays[array - 1].name);
    if (!is_numbered) return name();
    read_number_name(tokens, scope, numbers[number - 1]);
  };
  readers.holes["value"] = [&] {
    if (is_declared) return read_declared_values(tokens, arrays[array - 1]);
    read_cpp_number(tokens, numbers[number - 1]);
  };
  readers.sections["parameters"] = [&] {
    read_cpp_parameters(tokens, origin);
    return false;
  };
  read_picture(picture, readers, tokens);
}

void read_c_header(TokenReader& tokens, FileScope& scope, EquationReader& equations) {
  const Origin& origin = scope.origin;
  const Picture picture("c99/header.h.mustache", known_texts(origin, scope.dialect));
  HoleReaders readers;
  Functions functions(tokens, scope, &equations);
  functions.add_to(readers);
  readers.sections["parameters"] = [&] {
    read_c_parameters(tokens, origin, scope.dialect);
    return false;
  };
  readers.sections["default_parameters"] = [&] {
    read_c_defaults(tokens, origin, scope.dialect);
    return false;
  };
  read_picture(picture, readers, tokens);
}

}  // namespace

FileScope read_header(TokenReader& tokens, const Origin& origin, EquationReader& equations) {
  const bool is_c = origin.scene.emission.language == LanguageId::c99;
  FileScope scope{origin, dialect_of(is_c ? Shape::c99 : Shape::cpp, origin.scene),
                  parameter_members(origin)};
  const auto [line, problem] = wrong_operations(origin.program, tokens.comments());
  if (!problem.empty()) tokens.fail(tokens.span(line), problem);
  if (is_c) {
    read_c_header(tokens, scope, equations);
  } else {
    read_cpp_header(tokens, scope, equations);
  }
  return scope;
}

void read_eigen_header(TokenReader& tokens, const FileScope& header) {
  FileScope scope = header;
  scope.dialect = dialect_of(Shape::eigen, header.origin.scene);
  const Picture picture("cpp/eigen.hpp.mustache", known_texts(scope.origin, scope.dialect));
  HoleReaders readers;
  Functions functions(tokens, scope, nullptr);
  functions.add_to(readers);
  read_picture(picture, readers, tokens);
}

}  // namespace elgen
