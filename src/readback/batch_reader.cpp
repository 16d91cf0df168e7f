// batch_reader: the holes of templates/cpp/batch.hpp.mustache, and what has to stand there.
#include "readback/batch_reader.hpp"

#include <fmt/format.h>

#include "base/exact_number.hpp"
#include "elgen/arguments.hpp"
#include "elgen/wording.hpp"
#include "evaluate/sine_polynomials.hpp"
#include "readback/literal.hpp"
#include "readback/picture.hpp"

namespace elgen {
namespace {

class BatchHeaderReader {
 public:
  BatchHeaderReader(TokenReader& tokens, const Origin& origin)
      : tokens_(tokens), origin_(origin), calls_(library_calls(origin.program)) {}

  void read() {
    const Picture picture("cpp/batch.hpp.mustache", {{"namespace", name_space(origin_.scene)},
                                                     {"header", origin_.scene.base_name + ".hpp"}});
    HoleReaders readers;
    add_elements(readers);
    readers.sections["calls"] = [this] { return call_++ < calls_.size(); };
    readers.holes["call"] = [this] { tokens_.expect(calls_[call_ - 1]); };
    readers.sections["atan2"] = once(calls(origin_.program, FunctionId::atan2));
    readers.sections["sine_cosine"] = once(has_sine_with_cosine(origin_.program));
    readers.sections["parameters"] = [this] { return parameters(); };
    readers.sections["functions"] = [this] { return next_function(); };
    readers.holes["signature"] = [this] { signature(); };
    readers.holes["body"] = [this] { body(); };
    read_picture(picture, readers, tokens_);
  }

 private:
  /// The numbers of each scalar.
  void add_elements(HoleReaders& readers) {
    readers.sections["elements"] = [this] {
      return element_++ < origin_.scene.numerics.scalars.size();
    };
    readers.holes["element"] = [this] { tokens_.expect(name_of(scalar())); };
    readers.holes["integer"] = [this] {
      const bool is_single = scalar() == ScalarKind::single_precision;
      tokens_.expect_code(is_single ? "std::int32_t" : "std::int64_t");
    };
    readers.sections["reduction"] = [this] {
      reduction();
      return false;
    };
    readers.holes["sine"] = [this] { polynomial(sine_polynomials()); };
    readers.holes["cosine"] = [this] { polynomial(cosine_polynomials()); };
  }

  [[nodiscard]] ScalarKind scalar() const { return origin_.scene.numerics.scalars[element_ - 1]; }

  void reduction() {
    const AngleReduction& known = angle_reduction(scalar());
    const auto constant = [this](const char* name, double value) {
      tokens_.expect_code(fmt::format("static constexpr {} {} =", name_of(scalar()), name));
      number(value);
      tokens_.expect(";");
    };
    constant("domain", known.domain);
    constant("high", known.high);
    constant("low", known.low);
    constant("inverse", known.inverse);
    constant("shift", known.shift);
  }

  void polynomial(const std::vector<SinePolynomial>& all) {
    const cln::cl_RA error = trigonometry_error(origin_.scene.numerics, scalar());
    tokens_.expect("{");
    for (const double coefficient : cheapest(all, error, scalar()).coefficients) {
      number(coefficient);
      tokens_.expect(",");
    }
    tokens_.expect("}");
  }

  void number(double value) {
    const bool is_negative = tokens_.accept("-");
    const CodeToken token = tokens_.advance();
    const std::optional<Literal> literal = read_literal(token.text);
    const bool is_single = scalar() == ScalarKind::single_precision;
    const bool is_right = literal && literal->suffix == (is_single ? 'F' : '\0') &&
                          is_negative == (value < 0) &&
                          rounds_alike(literal->value, cln::abs(exact_value(value)), scalar());
    if (!is_right)
      tokens_.fail(tokens_.span(token), in_backticks(token.text) + " is another number");
  }

  /// result.m = p.m;
  bool parameters() {
    for (const ParameterArray& array : emitted_parameters(origin_.model, origin_.program)) {
      const std::string index = array.is_array ? "[i]" : "";
      if (array.is_array) {
        tokens_.expect_code(fmt::format("for (std::size_t i = 0; i < {}; ++i)", array.count));
      }
      tokens_.expect_code(fmt::format("result.{0}{1} = p.{0}{1};", array.name, index));
    }
    return false;
  }

  bool next_function() {
    const std::vector<Function>& all = origin_.program.functions;
    while (function_ < all.size() && !is_returned(all[function_])) ++function_;
    tokens_.set_function(function_ < all.size() ? all[function_].name : "");
    return function_++ < all.size();
  }

  [[nodiscard]] const Function& function() const {
    return origin_.program.functions[function_ - 1];
  }

  void signature() {
    tokens_.expect_code(
        fmt::format("void {}(const Parameters<T>& p, std::size_t count,", function().name));
    for (const Opcode argument : arguments_of(origin_.model, function())) {
      if (argument == Opcode::parameter) continue;
      tokens_.expect_code(fmt::format("const T* {},", leaf_row(argument).symbol));
    }
    tokens_.expect_code("T* result)");
  }

  void body() {
    tokens_.expect_code(
        fmt::format("using Scalar = {};", needs_order(function()) ? "T" : "Pack<T>"));
    tokens_.expect_code("const auto constants = detail::repeated<Scalar>(p);");
    tokens_.expect_code("detail::for_each_pack<Scalar>(count, [&](const detail::Place& at) {");
    tokens_.expect_code(fmt::format("const auto values = {}::{}<Scalar>(",
                                    name_space(origin_.scene), function().name));
    bool is_first = true;
    for (const Opcode argument : arguments_of(origin_.model, function())) {
      if (!is_first) tokens_.expect(",");
      is_first = false;
      loaded(argument);
    }
    tokens_.expect_code(");");
    stores();
    tokens_.expect_code("});");
  }

  void loaded(Opcode argument) {
    const LeafRow& leaf = leaf_row(argument);
    if (argument == Opcode::parameter) return tokens_.expect("constants");
    const bool is_number = is_single(argument);
    tokens_.expect_code(fmt::format("detail::loaded<{}>({}, at){}",
                                    is_number ? "std::array<Scalar, 1>" : leaf.type, leaf.symbol,
                                    is_number ? "[0]" : ""));
  }

  /// Every field behind the entries of those before it.
  void stores() {
    std::size_t before = 0;
    for (const Field& field : function().fields) {
      tokens_.expect_code("detail::store(values");
      if (!field.name.empty()) tokens_.expect_code("." + field.name);
      tokens_.expect_code(", at, result");
      if (before > 0) tokens_.expect_code(fmt::format("+ {} * count", before));
      tokens_.expect_code(");");
      before += field.entries.size();
    }
  }

  TokenReader& tokens_;
  const Origin& origin_;
  std::vector<std::string_view> calls_;
  std::size_t call_ = 0;      ///< those read
  std::size_t element_ = 0;   ///< those read, the present one among them
  std::size_t function_ = 0;  ///< those read, the present one among them
};

}  // namespace

void read_batch_header(TokenReader& tokens, const Origin& origin) {
  BatchHeaderReader(tokens, origin).read();
}

}  // namespace elgen
