// A recursive-descent parser of shown equations that evaluates while it reads.
#include "random/shown.hpp"

#include <cctype>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace elgen::test::random {

namespace {

using boost::multiprecision::abs;

ScaledValue plus(const ScaledValue& a, const ScaledValue& b) {
  return {a.value + b.value, a.size + b.size};
}
ScaledValue times(const ScaledValue& a, const ScaledValue& b) {
  return {a.value * b.value, a.size * b.size};
}
ScaledValue over(const ScaledValue& a, const ScaledValue& b) {
  if (b.value == 0) throw std::domain_error("division by zero");
  const Number quotient = a.value / b.value;
  return {quotient, (a.size + abs(quotient) * b.size) / abs(b.value)};
}

/// f, with size |f| + sum |df/dx| size(x).
ScaledValue function_of(const std::string& name, const std::vector<ScaledValue>& arguments) {
  Vector jets;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    jets.push_back(Jet(arguments[i].value) + Jet::infinitesimal(static_cast<unsigned>(i)));
  }
  const Jet result = call(name, jets);
  Number size = abs(result.value());
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    size += abs(result.along(static_cast<unsigned>(i)).value()) * arguments[i].size;
  }
  return {result.value(), size};
}

ScaledValue to_the(const ScaledValue& base, const ScaledValue& exponent) {
  // Exponents are rational constants: integers, k/2, k/3, k/4 or k/6.
  const Number twelfths = exponent.value * 12;
  const int numerator = static_cast<int>(round(twelfths));
  if (abs(twelfths - numerator) > Number("1e-60")) throw std::runtime_error("exponent");
  const bool whole = numerator % 12 == 0;
  const Jet power_of = whole ? power(Jet(base.value) + Jet::infinitesimal(0), numerator / 12, 1)
                             : power(Jet(base.value) + Jet::infinitesimal(0), numerator, 12);
  if (whole && numerator > 0) {
    Number size = 1;
    for (int i = 0; i < numerator / 12; ++i) size *= base.size;
    return {power_of.value(), size};
  }
  return {power_of.value(), abs(power_of.value()) + abs(power_of.along(0).value()) * base.size};
}

class Reader {
 public:
  Reader(const std::string& text, const Names& names) : text_(text), names_(names) {}

  ScaledValue whole() {
    const ScaledValue result = sum();
    if (at_ != text_.size()) fail();
    return result;
  }

 private:
  const std::string& text_;
  const Names& names_;
  std::size_t at_ = 0;

  [[noreturn]] void fail() const {
    throw std::runtime_error("cannot read `" + text_.substr(at_, 40) + "` of `" + text_ + "`");
  }

  bool skip(char wanted) {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
    if (at_ == text_.size() || text_[at_] != wanted) return false;
    ++at_;
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
    return true;
  }

  ScaledValue sum() {
    ScaledValue total = term();
    while (true) {
      if (skip('+')) {
        total = plus(total, term());
      } else if (skip('-')) {
        const ScaledValue next = term();
        total = {total.value - next.value, total.size + next.size};
      } else {
        return total;
      }
    }
  }

  ScaledValue term() {
    ScaledValue total = signed_factor();
    while (true) {
      if (skip('*')) {
        total = times(total, signed_factor());
      } else if (skip('/')) {
        total = over(total, signed_factor());
      } else {
        return total;
      }
    }
  }

  ScaledValue signed_factor() {
    if (!skip('-')) return factor();
    const ScaledValue operand = signed_factor();
    return {-operand.value, operand.size};
  }

  ScaledValue factor() {
    const ScaledValue base = primary();
    return skip('^') ? to_the(base, signed_factor()) : base;
  }

  ScaledValue primary() {
    if (skip('(')) {
      const ScaledValue inner = sum();
      if (!skip(')')) fail();
      return inner;
    }
    if (at_ == text_.size()) fail();
    if (std::isdigit(static_cast<unsigned char>(text_[at_])) != 0) return literal();
    const std::string word = identifier();
    if (word == "dot") return named(word + parse_brackets());
    if (skip('(')) return call_of(word);
    return named(word);
  }

  ScaledValue literal() {
    const std::size_t start = at_;
    const auto digits = [&] {
      while (at_ < text_.size() &&
             (std::isdigit(static_cast<unsigned char>(text_[at_])) != 0 || text_[at_] == '.')) {
        ++at_;
      }
    };
    digits();
    if (at_ < text_.size() && text_[at_] == 'e') {
      ++at_;
      if (at_ < text_.size() && (text_[at_] == '-' || text_[at_] == '+')) ++at_;
      digits();
    }
    const Number value(text_.substr(start, at_ - start));
    return {value, value};
  }

  /// A name with its index.
  std::string identifier() {
    const std::size_t start = at_;
    while (at_ < text_.size() &&
           (std::isalnum(static_cast<unsigned char>(text_[at_])) != 0 || text_[at_] == '_')) {
      ++at_;
    }
    if (at_ == start) fail();
    if (at_ < text_.size() && text_[at_] == '[') at_ = text_.find(']', at_) + 1;
    return text_.substr(start, at_ - start);
  }

  /// Brackets with their content, as written.
  std::string parse_brackets() {
    const std::size_t start = at_;
    int depth = 0;
    do {
      if (at_ == text_.size()) fail();
      depth += text_[at_] == '(' ? 1 : text_[at_] == ')' ? -1 : 0;
      ++at_;
    } while (depth > 0);
    const std::string result = text_.substr(start, at_ - start);
    skip(' ');
    return result;
  }

  ScaledValue call_of(const std::string& function) {
    std::vector<ScaledValue> arguments{sum()};
    while (skip(',')) arguments.push_back(sum());
    if (!skip(')')) fail();
    return function_of(function, arguments);
  }

  ScaledValue named(const std::string& name) {
    const auto known = names_.find(name);
    if (known == names_.end()) throw std::runtime_error("unknown `" + name + "` in " + text_);
    return known->second;
  }
};

void name_place(Names& names, const Layout::Place& place, const State& state) {
  const auto put = [&](const std::string& name, const Jet& x) {
    names[name] = {x.value(), abs(x.value())};
  };
  for (std::size_t i = 0; place.is_rotation && i < 4; ++i) {
    put(place.name + "_" + "wxyz"[i], state.q[place.q + i]);
  }
  if (!place.is_rotation) put(place.name, state.q[place.q]);
  for (std::size_t i = 0; i < (place.is_rotation ? 3U : 1U); ++i) {
    const std::string name =
        place.is_rotation ? place.name + "[" + std::to_string(i + 1) + "]" : place.name;
    put("dot(" + name + ")", state.v[place.v + i]);
    put("dot(dot(" + name + "))", state.a[place.v + i]);
  }
}

}  // namespace

ScaledValue read_expression(const std::string& text, const Names& names) {
  return Reader(text, names).whole();
}

Names names_of(const System& system, const Layout& layout, const State& state,
               const ParameterValues& parameters) {
  Names names;
  const auto put = [&](const std::string& name, const Number& x) { names[name] = {x, abs(x)}; };
  put("pi", pi());
  put("t", state.t.value());
  for (const Layout::Place& place : layout.places) {
    if (place.lock < 0) name_place(names, place, state);
  }
  for (std::size_t k = 0; k < system.model.inputs.size(); ++k) {
    put(system.model.inputs[k].name, state.u[k].value());
  }
  for (const auto& [key, value] : parameters) {
    put(key.second.empty() ? key.first : key.first + "[" + key.second + "]", value);
  }
  return names;
}

Shown read_equations(const std::string& json, const Names& names) {
  Shown result;
  const auto document = nlohmann::json::parse(json);
  for (const auto& [output, shown] : document.at("outputs").items()) {
    Names all = names;
    if (shown.contains("definitions")) {
      for (const auto& definition : shown.at("definitions")) {
        all[definition.at("name")] =
            read_expression(definition.at("value").get<std::string>(), all);
      }
    }
    const auto read_entries = [&](const std::string& name, const nlohmann::json& field) {
      result[name].columns = field.at("shape").at(1).get<std::size_t>();
      for (const auto& entry : field.at("entries")) {
        result[name].entries.push_back(read_expression(entry.get<std::string>(), all));
      }
    };
    if (shown.contains("entries")) read_entries(output, shown);
    if (!shown.contains("fields")) continue;
    for (const auto& [field, of_field] : shown.at("fields").items()) {
      if (of_field.contains("entries")) read_entries(output + "." + field, of_field);
    }
  }
  return result;
}

}  // namespace elgen::test::random
