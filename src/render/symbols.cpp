// symbols: letters first, digits and what follows an underscore below the line.
#include "render/symbols.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/ascii.hpp"
#include "elgen/leaf_names.hpp"
#include "render/drawing.hpp"

namespace elgen {
namespace {

struct GreekRow {
  std::string_view command;
  std::string_view letter;
};

constexpr std::array greek_table{
    GreekRow{"alpha", "α"},    GreekRow{"beta", "β"},    GreekRow{"gamma", "γ"},
    GreekRow{"delta", "δ"},    GreekRow{"epsilon", "ϵ"}, GreekRow{"varepsilon", "ε"},
    GreekRow{"zeta", "ζ"},     GreekRow{"eta", "η"},     GreekRow{"theta", "θ"},
    GreekRow{"vartheta", "ϑ"}, GreekRow{"iota", "ι"},    GreekRow{"kappa", "κ"},
    GreekRow{"lambda", "λ"},   GreekRow{"mu", "μ"},      GreekRow{"nu", "ν"},
    GreekRow{"xi", "ξ"},       GreekRow{"pi", "π"},      GreekRow{"rho", "ρ"},
    GreekRow{"varrho", "ϱ"},   GreekRow{"sigma", "σ"},   GreekRow{"tau", "τ"},
    GreekRow{"upsilon", "υ"},  GreekRow{"phi", "ϕ"},     GreekRow{"varphi", "φ"},
    GreekRow{"chi", "χ"},      GreekRow{"psi", "ψ"},     GreekRow{"omega", "ω"},
    GreekRow{"Gamma", "Γ"},    GreekRow{"Delta", "Δ"},   GreekRow{"Theta", "Θ"},
    GreekRow{"Lambda", "Λ"},   GreekRow{"Xi", "Ξ"},      GreekRow{"Pi", "Π"},
    GreekRow{"Sigma", "Σ"},    GreekRow{"Upsilon", "Υ"}, GreekRow{"Phi", "Φ"},
    GreekRow{"Psi", "Ψ"},      GreekRow{"Omega", "Ω"},
};

/// "theta" -> \theta, "x" -> x, "12" -> 12, "cart" -> \mathrm{cart}
std::string word(std::string_view text) {
  const bool is_number = std::all_of(text.begin(), text.end(), is_digit);
  if (text.size() == 1 || is_number) return std::string(text);
  const bool is_greek = !greek_letter(text).empty();
  return fmt::format(fmt::runtime(is_greek ? "\\{}" : "\\mathrm{{{}}}"), text);
}

/// "xx" of I_{xx}: axes.
bool is_axes(std::string_view text) {
  return !text.empty() && text.size() <= 2 && text.find_first_not_of("xyz") == std::string::npos;
}

/// A word below the line, where axes are slanted: xx and 3xx.
std::string script(std::string_view text) {
  const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
  return is_axes(text.substr(digits)) ? std::string(text) : word(text);
}

std::string subscripts(const std::vector<std::string>& parts) {
  return parts.empty() ? "" : fmt::format("_{{{}}}", fmt::join(parts, ", "));
}

/// "_{1}" and the index 2 -> "_{1, 2}"
std::string with_index(const std::string& scripts, const std::string& index) {
  if (index.empty()) return scripts;
  if (scripts.empty()) return subscripts({index});
  if (scripts.front() != '_' || scripts.find('^') != std::string::npos) {
    return scripts + "," + index;
  }
  const bool is_group = scripts.back() == '}';
  const std::string inside = is_group ? scripts.substr(2, scripts.size() - 3) : scripts.substr(1);
  return subscripts({inside, index});
}

/// Where the scripts of a user's symbol begin: the first `_` or `^` outside of braces.
std::size_t scripts_of(std::string_view key) {
  int depth = 0;
  for (std::size_t i = 0; i < key.size(); ++i) {
    depth += (key[i] == '{') - (key[i] == '}');
    if (depth == 0 && (key[i] == '_' || key[i] == '^')) return i;
  }
  return key.size();
}

/// Axes behind one letter stand below the line, as what follows an underscore: Ixx is I_{xx}.
SymbolText named_symbol(std::string_view name) {
  const std::size_t letters = static_cast<std::size_t>(
      std::find_if_not(name.begin(), name.end(), is_letter) - name.begin());
  const bool has_axes =
      letters > 1 && !is_axes(name.substr(0, 1)) && is_axes(name.substr(1, letters - 1));
  const std::size_t base = has_axes ? 1 : letters;
  std::vector<std::string> parts;
  if (has_axes) parts.push_back(script(name.substr(base, letters - base)));
  for (std::size_t at = letters; at < name.size();) {
    const std::size_t stop = std::min(name.find('_', at), name.size());
    if (stop > at) parts.push_back(script(name.substr(at, stop - at)));
    at = stop + 1;
  }
  return {word(name.substr(0, base)), subscripts(parts)};
}

/// "e_{w}" of a rotation with `latex = "e"`; empty where it has no key.
std::string component_key(const Model& model, const Coordinate& component) {
  const std::string& latex = model.rotations[*component.rotation].latex;
  return latex.empty() ? "" : fmt::format("{}_{{{}}}", latex, component.name.back());
}

SymbolText symbol_of(const Model& model, const Coordinate& c) {
  return latex_symbol(c.name, c.rotation ? component_key(model, c) : c.latex);
}

/// "\\omega_{2}", with the name of the rotation where there are several.
SymbolText spin_symbol(const Model& model, const Velocity& velocity) {
  const std::string axis(1, velocity.name[velocity.name.size() - 2]);
  std::vector<std::string> parts = {axis};
  if (model.rotations.size() > 1) {
    const Rotation& rotation = model.rotations[*velocity.rotation];
    parts.insert(parts.begin(), latex_symbol(rotation.name, rotation.latex).text());
  }
  return {"\\omega", subscripts(parts)};
}

/// `tau_elbow` on the coordinate `elbow` with `latex = "q_2"`: \tau_2.
SymbolText input_symbol(const Model& model, const Input& input) {
  SymbolText symbol = latex_symbol(input.name);
  if (!input.on || model.velocities[*input.on].rotation) return symbol;
  const Coordinate& on = model.coordinates[model.velocities[*input.on].coordinate];
  const auto end = std::find_if_not(input.name.begin(), input.name.end(), is_letter);
  const bool is_called_so = std::string(end, input.name.end()) == "_" + on.name;
  const std::string scripts = symbol_of(model, on).scripts;
  if (is_called_so && !on.latex.empty() && !scripts.empty()) symbol.scripts = scripts;
  return symbol;
}

/// Without the marks of upright letters, which are hard to tell from slanted ones.
std::string seen(const SymbolText& symbol) {
  std::string text = symbol.text();
  for (std::size_t at = 0; (at = text.find("\\mathrm", at)) != std::string::npos;) {
    text.erase(at, std::string_view("\\mathrm").size());
  }
  std::erase_if(text, [](char c) { return c == '{' || c == '}' || c == ' '; });
  return text;
}

/// The symbol of an argument that is a name; empty for other expressions.
std::string argument_symbol(const Model& model, const LeafValues<std::string>& leaves,
                            ExpressionId argument) {
  const Expression& e = model.expressions[argument];
  if (e.kind == ExpressionKind::leaf) return leaf_of(leaves, e.leaf, e.index);
  if (e.kind != ExpressionKind::definition) return {};
  const NamedExpression& definition = model.definitions[e.index];
  return latex_symbol(definition.name, definition.latex).text();
}

/// V(r), V'(r); of several arguments \frac{\partial V}{\partial x}, or \partial_{1} V where some
/// have no names.
std::string open_symbol(const std::string& function, const std::vector<std::string>& arguments,
                        const std::vector<std::uint32_t>& by) {
  const bool have_names =
      std::ranges::none_of(arguments, [](const std::string& x) { return x.empty(); });
  if (arguments.size() == 1 || by.empty()) {
    const std::string primed = function + std::string(by.size(), '\'');
    return have_names ? fmt::format("{}({})", primed, fmt::join(arguments, ", ")) : primed;
  }
  if (!have_names) {
    std::vector<std::string> numbers;
    for (const std::uint32_t argument : by) numbers.push_back(std::to_string(argument + 1));
    return fmt::format("\\partial{} {}", subscripts(numbers), function);
  }
  const std::string& x = arguments[by.front()];
  const std::string& y = arguments[by.back()];
  if (by.size() == 1) return fmt::format("\\frac{{\\partial {}}}{{\\partial {}}}", function, x);
  const std::string below = by.front() == by.back()
                                ? fmt::format("\\partial {}^{{2}}", x)
                                : fmt::format("\\partial {} \\partial {}", x, y);
  return fmt::format("\\frac{{\\partial^{{2}} {}}}{{{}}}", function, below);
}

std::string written(Opcode kind, const SymbolText& symbol, bool has_own_symbol) {
  const LeafRow& row = leaf_row(kind);
  return fmt::format(fmt::runtime(has_own_symbol ? row.own_latex : row.latex), symbol.base,
                     symbol.scripts);
}

}  // namespace

std::string_view greek_letter(std::string_view command) {
  for (const GreekRow& row : greek_table) {
    if (row.command == command) return row.letter;
  }
  return {};
}

std::string_view greek_command(std::string_view letter) {
  for (const GreekRow& row : greek_table) {
    if (row.letter == letter) return row.command;
  }
  return {};
}

namespace {

/// A key such as `{}` or `\mathrm{}`.
bool draws_nothing(const std::string& key) {
  const Block block = drawing(read_latex(key), Alphabet::unicode, Fractions::in_line);
  return std::ranges::all_of(block.lines, [](const std::string& line) {
    return line.find_first_not_of(' ') == std::string::npos;
  });
}

}  // namespace

SymbolText latex_symbol(std::string_view name, const std::string& key) {
  const std::size_t bracket = std::min(name.find('['), name.size());
  std::string index(name.substr(bracket));
  if (!index.empty()) index = index.substr(1, index.size() - 2);
  SymbolText symbol = named_symbol(name.substr(0, bracket));
  if (!key.empty() && !draws_nothing(key)) {
    const std::size_t scripts = scripts_of(key);
    symbol = {key.substr(0, scripts), key.substr(scripts)};
  }
  symbol.scripts = with_index(symbol.scripts, index);
  return symbol;
}

std::string ModelSymbols::primes_for(const std::vector<SymbolText>& symbols) {
  std::string primes;
  const auto is_taken = [&](const SymbolText& symbol) {
    return taken_.count(seen(symbol) + primes) > 0;
  };
  while (std::ranges::any_of(symbols, is_taken)) primes += '\'';
  for (const SymbolText& symbol : symbols) taken_.insert(seen(symbol) + primes);
  return primes;
}

SymbolText ModelSymbols::distinct(SymbolText symbol) {
  symbol.scripts += primes_for({symbol});
  return symbol;
}

ModelSymbols::ModelSymbols(const Model& model) {
  for (const Coordinate& c : model.coordinates) {
    coordinates_.push_back(distinct(symbol_of(model, c)));
    leaves_.q.push_back(coordinates_.back().text());
  }
  for (const Velocity& velocity : model.velocities) {
    // Components of angular velocities are not written as rates of something.
    const bool has_own = velocity.rotation.has_value();
    const SymbolText symbol =
        has_own ? distinct(spin_symbol(model, velocity)) : coordinates_[velocity.coordinate];
    leaves_.v.push_back(written(Opcode::velocity, symbol, has_own));
    leaves_.momenta.push_back(written(Opcode::momentum, symbol, has_own));
    leaves_.a.push_back(written(Opcode::acceleration, symbol, has_own));
  }
  leaves_.parameters.resize(model.parameters.size());
  for (const ParameterArray& array : model.parameter_arrays) {
    arrays_.push_back(latex_symbol(array.is_array ? array.name + "[i]" : array.name, array.latex));
    std::vector<SymbolText> all;
    for (std::uint32_t i = array.first; i < array.first + array.count; ++i) {
      all.push_back(latex_symbol(model.parameters[i].name, array.latex));
    }
    const std::string primes = primes_for(all);
    arrays_.back().scripts += primes;
    for (std::uint32_t i = 0; i < array.count; ++i) {
      leaves_.parameters[array.first + i] = all[i].text() + primes;
    }
  }
  for (const Input& input : model.inputs) {
    leaves_.u.push_back(distinct(input_symbol(model, input)).text());
  }
  for (std::uint32_t i = 0; i < model.constraints.size(); ++i) {
    const std::string name = leaf_text(model, Opcode::multiplier, i);
    leaves_.multipliers.push_back(distinct(latex_symbol(name, "")).text());
  }
  leaves_.t = leaf_row(Opcode::time).symbol;
  leaves_.h = leaf_row(Opcode::step).symbol;
  leaves_.E = leaf_row(Opcode::energy).symbol;
  add_open_values(model);
}

void ModelSymbols::add_open_values(const Model& model) {
  std::vector<std::string> functions;
  for (const OpenFunction& function : model.functions) {
    functions.push_back(distinct(latex_symbol(function.name, function.latex)).text());
  }
  for (const OpenValue& value : model.open_values) {
    std::vector<std::string> arguments;
    for (const ExpressionId id : model.functions[value.function].arguments) {
      arguments.push_back(argument_symbol(model, leaves_, id));
    }
    leaves_.f.push_back(open_symbol(functions[value.function], arguments, value.by));
  }
}

std::string unit_text(std::string unit, std::string_view times,
                      std::string (*exponent_text)(const std::string& exponent)) {
  std::erase(unit, ' ');
  std::string text;
  for (std::size_t i = 0; i < unit.size(); ++i) {
    const std::size_t begin = i + 1;
    if (unit[i] == '*') {
      text += times;
    } else if (unit[i] == '^' && unit[std::min(begin, unit.size() - 1)] == '(') {
      i = std::min(unit.find(')', begin), unit.size());
      text += exponent_text(unit.substr(begin + 1, i - begin - 1));
    } else if (unit[i] == '^') {
      i = std::min(unit.find_first_not_of("-0123456789", begin), unit.size());
      text += exponent_text(unit.substr(begin, i - begin));
      --i;
    } else {
      text += unit[i];
    }
  }
  return text;
}

}  // namespace elgen
