// function_reader: one statement after another; the n-th one is the n-th named instruction.
#include "readback/function_reader.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "elgen/fold.hpp"
#include "elgen/wording.hpp"

namespace elgen {
namespace {

std::vector<std::uint32_t> named_instructions(const std::vector<std::string>& names) {
  std::vector<std::uint32_t> named;
  for (std::uint32_t i = 0; i < names.size(); ++i) {
    if (!names[i].empty()) named.push_back(i);
  }
  return named;
}

/// The order in which a field's entries are stored: an own way to say what the writer has done.
std::vector<std::uint32_t> stored_entries(const Field& field, Storage storage) {
  if (storage == Storage::row_major) return field.entries;
  std::vector<std::uint32_t> entries;
  for (std::size_t column = 0; column < field.columns; ++column) {
    for (std::size_t row = 0; row < field.rows; ++row) {
      entries.push_back(field.entries[row * field.columns + column]);
    }
  }
  return entries;
}

}  // namespace

FunctionReader::FunctionReader(TokenReader& tokens, const FileScope& file, const Function& function)
    : tokens_(tokens),
      file_(file),
      function_(function),
      graph_(file.dialect.scalar_kind),
      arguments_(arguments_of(file.origin.model, function)),
      expressions_(tokens, graph_, file, workspace_) {
  tokens.set_function(function.name);
  const Program& program = file.origin.program;
  values_ = fold<SignedNode>(graph_, program, function);
  const std::vector<std::string> names = temporary_names(program, function);
  named_ = named_instructions(names);
  for (const std::uint32_t named : named_) graph_.set_name(values_[named], names[named]);
  for (const Field& field : function.fields) {
    results_.push_back({field, stored_entries(field, file.origin.scene.emission.storage),
                        std::vector<bool>(field.entries.size(), false),
                        is_scalar(program, function, field)});
  }
}

bool FunctionReader::wants_struct() const { return gives_struct(function_) && !has_members_; }

bool FunctionReader::wants_parts() {
  in_parts_ = !has_parts() && tokens_.at(is_c() ? "typedef" : "namespace");
  if (!in_parts_) comments_ = tokens_.comments();
  return in_parts_;
}

bool FunctionReader::wants_part() {
  const std::string start = "static inline void " + name_of_part(parts_ + 1);
  const bool is_next = is_c() ? tokens_.begins_code(start) : tokens_.at("template");
  if (is_next) ++parts_;
  return is_next;
}

std::string FunctionReader::name_of_part(std::size_t part) const {
  return fmt::format("{}{}_part_{}", file_.dialect.prefix, function_.name, part);
}

void FunctionReader::body() {
  if (has_parts() && !in_parts_) {
    calls_of_parts();
  } else {
    while (!tokens_.at("}")) statement();
  }
  if (is_returned_ && !has_returned_) tokens_.fail_expected("a return");
  if (!in_parts_) expect_complete();
}

void FunctionReader::statement() {
  if (has_returned_) tokens_.fail_expected("the end of the function");
  if (tokens_.at("using")) return using_declaration();
  if (tokens_.at("(")) return unused_argument();
  if (tokens_.begins_code("const auto")) return declared_pair();
  if (tokens_.at("const")) return declaration();
  if (tokens_.at("std") && scope_.has_workspace) return shared_pair();
  if (tokens_.at("return")) return returned();
  if (tokens_.at("result") && has_result_) return assignment();
  if (tokens_.at("w") && scope_.has_workspace) return shared_assignment();
  result_declaration();
}

void FunctionReader::using_declaration() {
  if (is_c()) tokens_.fail_expected("a statement of C");
  tokens_.expect_code("using std::");
  const CodeToken name = tokens_.current();
  const bool is_new = scope_.used.insert(tokens_.name()).second;
  if (!is_new) tokens_.fail(tokens_.span(name), in_backticks(name.text) + " is declared twice");
  tokens_.expect(";");
}

/// (void)q;
void FunctionReader::unused_argument() {
  if (!is_c()) tokens_.fail_expected("a statement of C++");
  tokens_.expect_code("(void)");
  const CodeToken name = tokens_.current();
  tokens_.name();
  const bool is_argument =
      std::any_of(scope_.arguments.begin(), scope_.arguments.end(),
                  [&](Opcode argument) { return leaf_row(argument).symbol == name.text; });
  if (!is_argument && name.text != "w" && name.text != "result") {
    tokens_.fail(tokens_.span(name), in_backticks(name.text) + " is no argument");
  }
  tokens_.expect(";");
}

void FunctionReader::declaration() {
  tokens_.expect("const");
  tokens_.expect(file_.dialect.scalar);
  const CodeToken name = tokens_.current();
  tokens_.name();
  declare(name, named_value(name));
}

/// const auto [sin_x, cos_x] = detail::SineCosine<Scalar>::of(x);
void FunctionReader::declared_pair() {
  if (is_c()) tokens_.fail_expected("a statement of C");
  tokens_.expect_code("const auto [");
  const CodeToken sine = tokens_.current();
  tokens_.name();
  tokens_.expect(",");
  const CodeToken cosine = tokens_.current();
  tokens_.name();
  tokens_.expect("]");
  const auto [of_sine, of_cosine] = pair_values(sine, cosine);
  declare(sine, of_sine);
  declare(cosine, of_cosine);
}

void FunctionReader::declare(const CodeToken& name, SignedNode value) {
  const bool is_new = scope_.locals.emplace(name.text, value).second;
  if (!is_new) tokens_.fail(tokens_.span(name), in_backticks(name.text) + " is declared twice");
}

/// Vector<Scalar, 2> result;
void FunctionReader::result_declaration() {
  if (file_.dialect.shape != Shape::eigen || !is_returned_) tokens_.fail_expected("a statement");
  tokens_.expect_code(result_type() + " result;");
  has_result_ = true;
}

void FunctionReader::shared_assignment() {
  const CodeToken name = shared_name();
  share(name, named_value(name));
}

/// std::tie(w.sin_x, w.cos_x) = detail::SineCosine<Scalar>::of(x);
void FunctionReader::shared_pair() {
  if (is_c()) tokens_.fail_expected("a statement of C");
  tokens_.expect_code("std::tie(");
  const CodeToken sine = shared_name();
  tokens_.expect(",");
  const CodeToken cosine = shared_name();
  tokens_.expect(")");
  const auto [of_sine, of_cosine] = pair_values(sine, cosine);
  share(sine, of_sine);
  share(cosine, of_cosine);
}

/// w.t_1, a name that the workspace declares
CodeToken FunctionReader::shared_name() {
  tokens_.expect("w");
  tokens_.expect(file_.dialect.member);
  const CodeToken name = tokens_.current();
  const bool is_declared = workspace_.count(tokens_.name()) > 0;
  if (!is_declared)
    tokens_.fail(tokens_.span(name), in_backticks(name.text) + " is not declared here");
  return name;
}

void FunctionReader::share(const CodeToken& name, SignedNode value) {
  std::optional<SignedNode>& shared = workspace_.at(name.text);
  if (shared) tokens_.fail(tokens_.span(name), in_backticks(name.text) + " is written twice");
  shared = value;
}

/// The next named instruction, up to the semicolon.
SignedNode FunctionReader::named_value(const CodeToken& name) {
  tokens_.expect("=");
  const CodeToken first = tokens_.current();
  const SignedNode value = next_value(name, expressions_.read(scope_), first);
  tokens_.expect(";");
  return value;
}

/// The next two: the sine and the cosine of what is written.
FunctionReader::Pair FunctionReader::pair_values(const CodeToken& sine, const CodeToken& cosine) {
  tokens_.expect("=");
  const CodeToken first = tokens_.current();
  const SignedNode angle = expressions_.read_sine_cosine(scope_);
  const SignedNode of_sine = next_value(sine, graph_.call(FunctionId::sin, angle, {}), first);
  const SignedNode of_cosine = next_value(cosine, graph_.call(FunctionId::cos, angle, {}), first);
  tokens_.expect(";");
  return {of_sine, of_cosine};
}

/// What the program has for it, which is what is written.
SignedNode FunctionReader::next_value(const CodeToken& name, SignedNode written,
                                      const CodeToken& first) {
  if (next_statement_ == named_.size()) {
    tokens_.fail(tokens_.span(name), in_backticks(name.text) + " is one statement too many");
  }
  const SignedNode derived = values_[named_[next_statement_++]];
  compare(written, derived, first, in_backticks(name.text));
  return derived;
}

std::size_t FunctionReader::result_named(std::string_view name, const CodeToken& token) {
  for (std::size_t i = 0; i < results_.size(); ++i) {
    if (results_[i].field.name == name) return i;
  }
  tokens_.fail(tokens_.span(token), in_backticks(token.text) + " is no part of the result");
}

/// result[0] = …;   result.acceleration[0] = …;   result.kinetic_energy = …;
void FunctionReader::assignment() {
  const CodeToken start = tokens_.advance();
  std::size_t result = 0;
  if (gives_struct(function_)) {
    tokens_.expect(file_.dialect.member);
    const CodeToken name = tokens_.current();
    result = result_named(tokens_.name(), name);
  }
  std::size_t index = 0;
  if (!results_[result].is_number) {
    tokens_.expect(file_.dialect.open);
    index = tokens_.integer();
    tokens_.expect(file_.dialect.close);
  }
  tokens_.expect("=");
  entry(result, index, start);
  tokens_.expect(";");
}

void FunctionReader::entry(std::size_t result, std::size_t index, const CodeToken& first) {
  Result& target = results_[result];
  if (index >= target.entries.size()) {
    tokens_.fail(tokens_.span_from(first),
                 fmt::format("entry {} of {}", index, target.entries.size()));
  }
  if (target.written[index])
    tokens_.fail(tokens_.span(first), fmt::format("entry {} is written twice", index));
  const std::string field =
      target.field.name.empty() ? "the result" : in_backticks(target.field.name);
  const CodeToken start = tokens_.current();
  const SignedNode written = expressions_.read(scope_);
  compare(written, values_[target.entries[index]], start,
          fmt::format("entry {} of {}", index, field));
  target.written[index] = true;
}

void FunctionReader::compare(SignedNode written, SignedNode derived, const CodeToken& first,
                             const std::string& what) {
  if (written == derived) return;
  const LeafNames& leaves = file_.origin.program.leaves;
  const auto [x, y] = graph_.difference(written, derived);
  tokens_.fail(tokens_.span_from(first),
               fmt::format("{} {} `{}` instead of `{}`", what, x == written ? "is" : "has",
                           graph_.text(leaves, x), graph_.text(leaves, y)));
}

void FunctionReader::returned() {
  if (!is_returned_) tokens_.fail_expected("the end of the function");
  tokens_.expect("return");
  if (has_result_) {
    tokens_.expect("result");
  } else {
    returned_values();
  }
  tokens_.expect(";");
  has_returned_ = true;
}

/// One number, the entries of one array, or those of each field of a struct.
void FunctionReader::returned_values() {
  if (!gives_struct(function_) && results_.front().is_number) {
    return entry(0, 0, tokens_.current());
  }
  if (file_.dialect.shape != Shape::cpp) tokens_.fail_expected("`result`");
  if (!gives_struct(function_)) return array_value(0);
  tokens_.expect("{");
  for (std::size_t i = 0; i < results_.size(); ++i) {
    if (i > 0) tokens_.expect(",");
    if (results_[i].is_number) {
      entry(i, 0, tokens_.current());
    } else {
      array_value(i);
    }
  }
  tokens_.accept(",");
  tokens_.expect("}");
}

/// {{a, b}}, or {} of no entries
void FunctionReader::array_value(std::size_t result) {
  const std::size_t size = results_[result].entries.size();
  tokens_.expect("{");
  if (size > 0) tokens_.expect("{");
  for (std::size_t index = 0; index < size; ++index) {
    if (index > 0) tokens_.expect(",");
    entry(result, index, tokens_.current());
  }
  if (size > 0) {
    tokens_.accept(",");
    tokens_.expect("}");
  }
  tokens_.expect("}");
}

/// The body of a function whose parts compute it one after another.
void FunctionReader::calls_of_parts() {
  std::string arguments;
  for (const Opcode argument : scope_.arguments) {
    arguments += fmt::format(", {}", leaf_row(argument).symbol);
  }
  if (scope_.arguments.size() != arguments_.size())
    tokens_.fail_expected("an argument with a name");
  if (is_c()) {
    if (is_returned_) tokens_.expect_code(file_.dialect.scalar + " result[1];");
    tokens_.expect_code(fmt::format("{} w;", workspace_name_));
  } else {
    if (is_returned_) tokens_.expect_code(result_type() + " result;");
    tokens_.expect_code(fmt::format("detail::{}<Scalar> w;", workspace_name_));
  }
  for (std::size_t part = 1; part <= parts_; ++part) {
    tokens_.expect_code(
        is_c() ? fmt::format("{}({}, &w, result);", name_of_part(part), arguments.substr(2))
               : fmt::format("detail::{}(result, w{});", name_of_part(part), arguments));
  }
  if (is_returned_) tokens_.expect_code(is_c() ? "return result[0];" : "return result;");
  has_returned_ = is_returned_;
}

void FunctionReader::expect_complete() {
  if (next_statement_ < named_.size()) {
    const SignedNode missing = values_[named_[next_statement_]];
    tokens_.fail(tokens_.span(tokens_.current()),
                 fmt::format("the statement `{}` is missing",
                             graph_.text(file_.origin.program.leaves, missing)));
  }
  for (const Result& result : results_) {
    const auto missing = std::find(result.written.begin(), result.written.end(), false);
    if (missing == result.written.end()) continue;
    tokens_.fail(
        tokens_.span(tokens_.current()),
        fmt::format("entry {} of {} is missing", missing - result.written.begin(),
                    result.field.name.empty() ? "the result" : in_backticks(result.field.name)));
  }
}

}  // namespace elgen
