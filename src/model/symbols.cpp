// symbols: the symbol of a name consists of its first letters; digits and the text after
// underscores become subscripts.
#include "model/symbols.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/ascii.hpp"
#include "formula/drawing.hpp"
#include "formula/glyphs.hpp"

namespace elgen {
namespace {

/// "theta" -> \theta, "x" -> x, "12" -> 12, "cart" -> \mathrm{cart}
Glyphs word_glyphs(std::string_view text) {
  const bool is_number = std::all_of(text.begin(), text.end(), is_digit);
  const std::string_view greek = greek_letter(text);
  if (is_number && !text.empty()) return {GlyphKind::number, std::string(text)};
  if (!greek.empty()) return {GlyphKind::letter, std::string(greek)};
  return {text.size() == 1 ? GlyphKind::letter : GlyphKind::word, std::string(text)};
}

/// True if the text names axes, such as "xx" in I_{xx}.
bool is_axes(std::string_view text) {
  return !text.empty() && text.size() <= 2 && text.find_first_not_of("xyz") == std::string::npos;
}

/// The text as a subscript. Names of axes are italic, as in xx and 3xx.
Glyphs subscript_glyphs(std::string_view text) {
  const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
  return is_axes(text.substr(digits)) ? read_latex(text) : word_glyphs(text);
}

/// Adds a subscript to the last part of a symbol.
void add_subscript(Glyphs& symbol, Glyphs piece) {
  const bool has_scripts = !symbol.parts.empty() && symbol.parts.back().kind == GlyphKind::scripts;
  Glyphs below = has_scripts ? std::move(symbol.parts.back().parts[1]) : Glyphs{};
  if (!below.parts.empty()) append_sign(below, ",", false);
  append(below, std::move(piece), true);
  add_script(symbol, 1, std::move(below));
}

std::size_t count_letters(std::string_view name) {
  return static_cast<std::size_t>(std::find_if_not(name.begin(), name.end(), is_letter) -
                                  name.begin());
}

/// True for two letters, perhaps with digits: `Jm` and `Jm1`, but not the Greek `mu` and no axes.
bool is_letter_pair(std::string_view name) {
  return count_letters(name) == 2 && greek_letter(name.substr(0, 2)).empty() &&
         !is_axes(name.substr(0, 2)) && std::all_of(name.begin() + 2, name.end(), is_digit);
}

/// The symbol of a name. Axes after a single letter become a subscript: Ixx is I_{xx}. The second
/// letter of a pair becomes a subscript if `splits_pairs` is set: Jm is J_{m}.
Glyphs symbol_from_letters(std::string_view name, bool splits_pairs) {
  const std::size_t letters = count_letters(name);
  const bool has_axes =
      letters > 1 && !is_axes(name.substr(0, 1)) && is_axes(name.substr(1, letters - 1));
  const bool is_split = has_axes || (splits_pairs && is_letter_pair(name));
  const std::size_t base = is_split ? 1 : letters;
  Glyphs symbol = make_row(word_glyphs(name.substr(0, base)));
  if (is_split) add_subscript(symbol, subscript_glyphs(name.substr(base, letters - base)));
  for (std::size_t at = letters; at < name.size();) {
    const std::size_t stop = std::min(name.find('_', at), name.size());
    if (stop > at) add_subscript(symbol, subscript_glyphs(name.substr(at, stop - at)));
    at = stop + 1;
  }
  return symbol;
}

/// True if a symbol, such as `{}` or `\mathrm{}`, has no visible character.
bool draws_nothing(const Glyphs& symbol) {
  const TextBlock block = draw_glyphs(symbol, Alphabet::unicode, FractionStyle::in_line);
  return std::ranges::all_of(block.lines, [](const std::string& line) {
    return line.find_first_not_of(' ') == std::string::npos;
  });
}

/// The symbol of a coordinate; e_{w} for a component of a rotation with `latex = "e"`.
Glyphs symbol_of(const Model& model, const Coordinate& c) {
  if (!c.rotation) return symbol_in_model(model, c.name, c.latex);
  const std::string& key = model.rotations[*c.rotation].latex;
  return symbol_of_name(c.name, key.empty() ? "" : fmt::format("{}_{{{}}}", key, c.name.back()));
}

/// The symbol \omega_{2} of an angular velocity, with the name of the rotation if the model has
/// several rotations.
Glyphs spin_symbol(const Model& model, const Velocity& velocity) {
  const char axis = velocity.name[velocity.name.size() - 2];
  Glyphs symbol = make_row(word_glyphs("omega"));
  if (model.rotations.size() > 1) {
    const Rotation& rotation = model.rotations[*velocity.rotation];
    add_subscript(symbol, symbol_of_name(rotation.name, rotation.latex));
  }
  add_subscript(symbol, word_glyphs(std::string(1, axis)));
  return symbol;
}

/// The symbol of an input; \tau_2 for `tau_elbow` on the coordinate `elbow` with `latex = "q_2"`.
Glyphs input_symbol(const Model& model, const Input& input) {
  Glyphs symbol = symbol_in_model(model, input.name);
  if (!input.velocity || model.velocities[*input.velocity].rotation) return symbol;
  const Coordinate& on = model.coordinates[model.velocities[*input.velocity].coordinate];
  const auto end = std::find_if_not(input.name.begin(), input.name.end(), is_letter);
  const bool is_called_so = std::string(end, input.name.end()) == "_" + on.name;
  const Glyphs of_coordinate = symbol_of(model, on);
  const Glyphs& last = of_coordinate.parts.back();
  if (!is_called_so || on.latex.empty() || last.kind != GlyphKind::scripts) return symbol;
  symbol.parts.back() = base_of(symbol.parts.back());
  for (const std::size_t place : {1U, 2U}) {
    if (!last.parts[place].parts.empty()) add_script(symbol, place, last.parts[place]);
  }
  return symbol;
}

/// The text by which symbols are compared: the LaTeX text without the style of letters, because
/// upright and italic letters look alike.
std::string visible_text(const Glyphs& symbol) {
  std::string text = to_latex(symbol);
  for (std::size_t at = 0; (at = text.find("\\mathrm", at)) != std::string::npos;) {
    text.erase(at, std::string_view("\\mathrm").size());
  }
  std::erase_if(text, [](char c) { return c == '{' || c == '}' || c == ' '; });
  return text;
}

Glyphs with_primes(Glyphs symbol, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) append(symbol, {GlyphKind::letter, "′"}, false);
  return symbol;
}

/// The symbol of an argument that is a name; empty for other expressions.
Glyphs argument_symbol(const Model& model, const LeafValues<Formula>& leaves,
                       ExpressionId argument) {
  const Expression& e = model.expressions[argument];
  if (e.kind == ExpressionKind::leaf) return glyphs_of(leaf_of(leaves, e.leaf, e.index));
  if (!refers_to_entry(e, NamedKind::definition)) return {};
  const NamedExpression& definition = model.definitions[e.index];
  return symbol_in_model(model, definition.name, definition.latex);
}

Glyphs partial_glyphs(const Glyphs& of, const char* order) {
  Glyphs row = read_latex(fmt::format("\\partial{}", order));
  append(row, of, true);
  return row;
}

/// The symbol of an open value: V(r), or V'(r) for the derivative of a function of one argument.
/// With respect to one of several arguments, the derivative is \frac{\partial V}{\partial x}, or
/// \partial_{1} V if an argument has no symbol.
Glyphs open_value_symbol(const Glyphs& function, const std::vector<Glyphs>& arguments,
                         const std::vector<std::uint32_t>& by) {
  const bool have_names =
      std::ranges::none_of(arguments, [](const Glyphs& x) { return x.parts.empty(); });
  if (arguments.size() == 1 || by.empty()) {
    Glyphs symbol = with_primes(function, by.size());
    if (!have_names) return symbol;
    Glyphs list;
    for (const Glyphs& argument : arguments) {
      if (!list.parts.empty()) append_sign(list, ",", false);
      append(list, argument, true);
    }
    append(symbol, enclose(std::move(list), "(", ")", false), false);
    return symbol;
  }
  if (!have_names) {
    Glyphs symbol = make_row({GlyphKind::letter, "∂"});
    for (const std::uint32_t argument : by)
      add_subscript(symbol, word_glyphs(std::to_string(argument + 1)));
    append(symbol, function, true);
    return symbol;
  }
  const Glyphs& x = arguments[by.front()];
  const Glyphs& y = arguments[by.back()];
  if (by.size() == 1) return fraction_row(partial_glyphs(function, ""), partial_glyphs(x, ""));
  Glyphs below = partial_glyphs(x, "");
  if (by.front() == by.back()) {
    add_script(below, 2, {GlyphKind::number, "2"});
  } else {
    append(below, partial_glyphs(y, ""), true);
  }
  return fraction_row(partial_glyphs(function, "^{2}"), std::move(below));
}

/// Replaces the letter s of a pattern, such as \dot{s}, by a symbol. The dots are put only over the
/// base of the symbol, not over its subscripts.
Glyphs fill_pattern(const Glyphs& pattern, const Glyphs& symbol) {
  Glyphs result;
  for (const Glyphs& piece : pattern.parts) {
    const bool is_hole = piece.kind == GlyphKind::letter && piece.text == "s";
    if (is_hole) {
      append(result, symbol, piece.has_space_before);
    } else if (piece.kind == GlyphKind::accent) {
      append(result, add_dots(symbol, piece.text), piece.has_space_before);
    } else {
      result.parts.push_back(piece);
      for (Glyphs& part : result.parts.back().parts) {
        if (part.kind == GlyphKind::row) part = fill_pattern(part, symbol);
      }
    }
  }
  return result;
}

Formula leaf_symbol(Opcode kind, std::string name, const Glyphs& symbol, bool has_own_symbol) {
  const LeafRow& row = leaf_row(kind);
  const Glyphs pattern = read_latex(has_own_symbol ? row.own_latex : row.latex);
  return symbol_formula(std::move(name), fill_pattern(pattern, symbol));
}

Glyphs remove_vector(Glyphs glyphs, std::string_view vector) {
  std::erase_if(glyphs.parts, [vector](const Glyphs& part) {
    return part.kind == GlyphKind::bold && part.text == vector;
  });
  for (Glyphs& part : glyphs.parts) part = remove_vector(std::move(part), vector);
  return glyphs;
}

}  // namespace

Glyphs add_dots(Glyphs symbol, std::string_view dots) {
  std::size_t primes = 0;
  for (; symbol.parts.back().text == "′"; ++primes) symbol.parts.pop_back();
  Glyphs last = symbol.parts.back();
  symbol.parts.back() = base_of(last);
  Glyphs accent{GlyphKind::accent, std::string(dots), {std::move(symbol)}};
  if (last.kind != GlyphKind::scripts) return with_primes(make_row(std::move(accent)), primes);
  last.parts[0] = std::move(accent);
  last.has_space_before = false;
  return with_primes(make_row(std::move(last)), primes);
}

Glyphs symbol_of_name(std::string_view name, const std::string& key, bool splits_pairs) {
  const std::size_t bracket = std::min(name.find('['), name.size());
  Glyphs symbol = key.empty() ? Glyphs{} : read_latex(key);
  if (key.empty() || draws_nothing(symbol)) {
    symbol = symbol_from_letters(name.substr(0, bracket), splits_pairs);
  }
  if (bracket == name.size()) return symbol;
  std::string_view index = name.substr(bracket + 1, name.size() - bracket - 2);
  for (std::size_t at = 0; at < index.size();) {
    const std::size_t stop = std::min(index.find(',', at), index.size());
    add_subscript(symbol, read_latex(index.substr(at, stop - at)));
    at = stop + 1;
  }
  return symbol;
}

Glyphs symbol_in_model(const Model& model, std::string_view name, const std::string& key) {
  const std::string_view base = name.substr(0, name.find('['));
  const bool is_ambiguous =
      is_letter_pair(base) && has_value_named(model, fmt::format("{}_{}", base[0], base.substr(1)));
  return symbol_of_name(name, key, !is_ambiguous);
}

std::size_t ModelSymbols::reserve_primes(const std::vector<Glyphs>& symbols) {
  std::size_t primes = 0;
  const auto text = [&primes](const Glyphs& symbol) {
    return visible_text(with_primes(symbol, primes));
  };
  const auto is_used = [&](const Glyphs& symbol) { return used_texts_.count(text(symbol)) > 0; };
  while (std::ranges::any_of(symbols, is_used)) ++primes;
  for (const Glyphs& symbol : symbols) used_texts_.insert(text(symbol));
  return primes;
}

Glyphs ModelSymbols::make_distinct(Glyphs symbol) {
  const std::size_t primes = reserve_primes({symbol});
  return with_primes(std::move(symbol), primes);
}

ModelSymbols::ModelSymbols(const Model& model, const LeafNames& names) {
  for (const Coordinate& c : model.coordinates) {
    leaves_.q.push_back(symbol_formula(c.name, make_distinct(symbol_of(model, c))));
  }
  for (std::uint32_t i = 0; i < model.velocities.size(); ++i) {
    const Velocity& velocity = model.velocities[i];
    // An angular velocity is not the rate of a coordinate, so it has its own symbol.
    const bool has_own = velocity.rotation.has_value();
    const Glyphs symbol = has_own ? make_distinct(spin_symbol(model, velocity))
                                  : glyphs_of(leaves_.q[velocity.coordinate]);
    const auto add = [&](const LeafRow& row, Formulas& list) {
      if (row.owner != LeafOwner::velocities) return;
      list.push_back(leaf_symbol(row.id, leaf_text(model, row.id, i), symbol, has_own));
    };
    for_each_list(add, leaves_);
  }
  leaves_.parameters.resize(model.parameters.size());
  for (const ParameterArray& array : model.parameter_arrays) {
    std::vector<Glyphs> all;
    for (std::uint32_t i = array.first; i < array.first + array.count; ++i) {
      all.push_back(symbol_in_model(model, model.parameters[i].name, array.latex));
    }
    const std::size_t primes = reserve_primes(all);
    const std::string name = array.is_array ? array.name + "[i]" : array.name;
    arrays_.push_back(
        symbol_formula(name, with_primes(symbol_in_model(model, name, array.latex), primes)));
    for (std::uint32_t i = 0; i < array.count; ++i) {
      leaves_.parameters[array.first + i] = symbol_formula(model.parameters[array.first + i].name,
                                                           with_primes(std::move(all[i]), primes));
    }
  }
  for (const Input& input : model.inputs) {
    leaves_.u.push_back(symbol_formula(input.name, make_distinct(input_symbol(model, input))));
  }
  for (std::uint32_t i = 0; i < model.constraints.size(); ++i) {
    std::string name = leaf_text(model, Opcode::multiplier, i);
    Glyphs symbol = make_distinct(symbol_of_name(name));
    leaves_.multipliers.push_back(symbol_formula(std::move(name), std::move(symbol)));
  }
  const auto single = [](Opcode kind, const std::string& name) {
    const std::string_view letter = leaf_row(kind).symbol;
    return symbol_formula(name.empty() ? std::string(letter) : name, read_latex(letter));
  };
  leaves_.t = single(Opcode::time, names.t);
  leaves_.h = single(Opcode::step, names.h);
  leaves_.E = single(Opcode::energy, names.E);
  add_open_values(model);
  // A derivation may have more open values than the model: with_open_potential(), FrameQuantity.
  for (std::size_t i = leaves_.f.size(); i < names.f.size(); ++i) {
    leaves_.f.push_back(symbol_formula(names.f[i], make_distinct(symbol_of_name(names.f[i]))));
  }
}

void ModelSymbols::add_open_values(const Model& model) {
  std::vector<Glyphs> functions;
  for (const OpenFunction& function : model.functions) {
    functions.push_back(make_distinct(symbol_in_model(model, function.name, function.latex)));
  }
  for (const OpenValue& value : model.open_values) {
    std::vector<Glyphs> arguments;
    for (const ExpressionId id : model.functions[value.function].arguments) {
      arguments.push_back(argument_symbol(model, leaves_, id));
    }
    constexpr bool is_long = true;
    leaves_.f.push_back(symbol_formula(
        value.name,
        open_value_symbol(functions[value.function], arguments, value.derivative_arguments),
        is_long));
  }
}

Glyphs replace_vector(Glyphs glyphs, std::string_view vector, const Glyphs& by) {
  if (glyphs.kind == GlyphKind::bold && glyphs.text == vector) {
    const bool is_apart = glyphs.has_space_before;
    const bool is_single = by.parts.size() == 1;
    glyphs = is_single ? by.parts[0] : by;
    glyphs.has_space_before = is_apart;
    return glyphs;
  }
  for (Glyphs& part : glyphs.parts) part = replace_vector(std::move(part), vector, by);
  return glyphs;
}

Glyphs latex_glyphs(const Model& model, std::string_view latex) {
  Glyphs glyphs = read_latex(latex);
  if (!model.rotations.empty()) return replace_vector(std::move(glyphs), "N", read_latex("N"));
  glyphs = replace_vector(std::move(glyphs), "v", read_latex("\\dot{<q>}"));
  glyphs = replace_vector(std::move(glyphs), "a", read_latex("\\ddot{<q>}"));
  return remove_vector(std::move(glyphs), "N");
}

Formula latex_formula(const Model& model, std::string_view latex) {
  return symbol_formula(text_of(latex_formula(latex)), latex_glyphs(model, latex));
}

Formula partial_derivative(std::string_view function, const Formula& x) {
  const std::string name = text_of(x);
  const bool is_call = name.find('(') != std::string::npos;
  return symbol_formula(
      fmt::format("d{}/d{}", function, is_call ? fmt::format("({})", name) : name),
      fraction_row(partial_glyphs(read_latex(function), ""), partial_glyphs(glyphs_of(x), "")));
}

}  // namespace elgen
