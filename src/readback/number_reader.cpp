// number_reader: three literals, and a fraction of integers in chunks of six digits.
#include "readback/number_reader.hpp"

#include <cln/integer.h>
#include <fmt/format.h>

#include "base/number_text.hpp"
#include "elgen/constant.hpp"
#include "elgen/wording.hpp"
#include "evaluate/scalar_literal.hpp"
#include "readback/literal.hpp"

namespace elgen {
namespace {

constexpr int irrational_digits = 66;
constexpr std::uint32_t chunk_size = 1'000'000;
constexpr std::uint32_t largest_exponent = 5000;

[[noreturn]] void fail_number(const TokenReader& tokens, const CodeToken& first,
                              const cln::cl_R& number) {
  const Span span = tokens.span_from(first);
  tokens.fail(span, fmt::format("{} is not {}", in_backticks(span), exact_text(number)));
}

/// detail::OutOfRange{} stands for the literal of a scalar that cannot hold the number.
void read_literal_of(TokenReader& tokens, const cln::cl_R& magnitude, ScalarKind scalar) {
  constexpr std::string_view suffixes("F\0L", 3);
  if (fit(magnitude, scalar) != Fit::fits) return tokens.expect_code("detail::OutOfRange{}");
  const CodeToken token = tokens.advance();
  const std::optional<Literal> literal = read_literal(token.text);
  const bool is_right = literal && literal->suffix == suffixes[static_cast<std::size_t>(scalar)] &&
                        rounds_alike(literal->value, magnitude, scalar);
  if (!is_right) fail_number(tokens, token, magnitude);
}

/// {9, 806650}: an integer in base 10^6.
cln::cl_I read_chunks(TokenReader& tokens) {
  cln::cl_I integer = 0;
  tokens.expect("{");
  do {
    const CodeToken first = tokens.current();
    const std::uint32_t chunk = tokens.integer();
    if (chunk >= chunk_size) tokens.fail(tokens.span(first), "a chunk of more than six digits");
    integer = integer * chunk_size + chunk;
  } while (tokens.accept(","));
  tokens.expect("}");
  return integer;
}

long read_exponent(TokenReader& tokens) {
  if (!tokens.accept(",")) return 0;
  const bool is_negative = tokens.accept("-");
  const CodeToken token = tokens.current();
  const std::uint32_t exponent = tokens.integer();
  if (exponent > largest_exponent) tokens.fail(tokens.span(token), "an exponent beyond 5000");
  return is_negative ? -static_cast<long>(exponent) : static_cast<long>(exponent);
}

void read_fraction(TokenReader& tokens, const cln::cl_R& magnitude) {
  const CodeToken first = tokens.current();
  const cln::cl_I numerator = read_chunks(tokens);
  tokens.expect(",");
  const cln::cl_I denominator = read_chunks(tokens);
  const long exponent = read_exponent(tokens);
  if (cln::zerop(denominator)) fail_number(tokens, first, magnitude);
  const cln::cl_RA written = numerator / cln::cl_RA(denominator) * power_of_ten(exponent);
  if (written == magnitude) return;
  const cln::cl_RA nearest = value_of(rounded_decimal(magnitude, irrational_digits));
  if (is_rational(magnitude) || written != nearest) fail_number(tokens, first, magnitude);
}

void expect_sign(TokenReader& tokens, const cln::cl_R& number) {
  if (cln::minusp(number)) tokens.expect("-");
}

}  // namespace

void read_cpp_number(TokenReader& tokens, const cln::cl_R& number) {
  const cln::cl_R magnitude = cln::abs(number);
  expect_sign(tokens, number);
  tokens.expect_code("constant<Scalar>(");
  if (exact_in_float(magnitude)) {
    const CodeToken token = tokens.advance();
    const std::optional<Literal> literal = read_literal(token.text);
    const bool is_right = literal && literal->suffix == '\0' && literal->value == magnitude;
    if (!is_right) fail_number(tokens, token, number);
  } else {
    for (const ScalarKind scalar :
         {ScalarKind::single_precision, ScalarKind::double_precision, ScalarKind::long_double}) {
      read_literal_of(tokens, magnitude, scalar);
      tokens.expect(",");
    }
    read_fraction(tokens, magnitude);
  }
  tokens.expect(")");
}

void read_c_number(TokenReader& tokens, const cln::cl_R& number, ScalarKind scalar) {
  expect_sign(tokens, number);
  const CodeToken token = tokens.advance();
  const std::optional<Literal> literal = read_literal(token.text);
  const char suffix = scalar == ScalarKind::single_precision ? 'f' : '\0';
  const bool is_right = literal && literal->suffix == suffix &&
                        rounds_alike(literal->value, cln::abs(number), scalar);
  if (!is_right) fail_number(tokens, token, number);
}

}  // namespace elgen
