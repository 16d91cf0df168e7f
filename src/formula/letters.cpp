// letters: the commands that stand for one character, and those with arguments.
#include <algorithm>
#include <array>

#include "formula/glyphs.hpp"

namespace elgen {
namespace {

constexpr std::array greek_table{
    CommandRow{"alpha", "α"},    CommandRow{"beta", "β"},    CommandRow{"gamma", "γ"},
    CommandRow{"delta", "δ"},    CommandRow{"epsilon", "ϵ"}, CommandRow{"varepsilon", "ε"},
    CommandRow{"zeta", "ζ"},     CommandRow{"eta", "η"},     CommandRow{"theta", "θ"},
    CommandRow{"vartheta", "ϑ"}, CommandRow{"iota", "ι"},    CommandRow{"kappa", "κ"},
    CommandRow{"lambda", "λ"},   CommandRow{"mu", "μ"},      CommandRow{"nu", "ν"},
    CommandRow{"xi", "ξ"},       CommandRow{"pi", "π"},      CommandRow{"rho", "ρ"},
    CommandRow{"varrho", "ϱ"},   CommandRow{"sigma", "σ"},   CommandRow{"tau", "τ"},
    CommandRow{"upsilon", "υ"},  CommandRow{"phi", "ϕ"},     CommandRow{"varphi", "φ"},
    CommandRow{"chi", "χ"},      CommandRow{"psi", "ψ"},     CommandRow{"omega", "ω"},
    CommandRow{"Gamma", "Γ"},    CommandRow{"Delta", "Δ"},   CommandRow{"Theta", "Θ"},
    CommandRow{"Lambda", "Λ"},   CommandRow{"Xi", "Ξ"},      CommandRow{"Pi", "Π"},
    CommandRow{"Sigma", "Σ"},    CommandRow{"Upsilon", "Υ"}, CommandRow{"Phi", "Φ"},
    CommandRow{"Psi", "Ψ"},      CommandRow{"Omega", "Ω"},
};

constexpr std::array command_table{
    CommandRow{"cdot", "⋅", GlyphKind::sign},
    CommandRow{"partial", "∂", GlyphKind::letter},
    CommandRow{"top", "⊤", GlyphKind::letter},
    CommandRow{"sum", "∑", GlyphKind::sign},
    CommandRow{"int", "∫", GlyphKind::sign},
    CommandRow{"prime", "′", GlyphKind::letter},
    CommandRow{"pm", "±", GlyphKind::letter},
    CommandRow{"mp", "∓", GlyphKind::sign},
    CommandRow{"le", "<=", GlyphKind::sign},
    CommandRow{"times", "×", GlyphKind::sign},
    CommandRow{"ell", "ℓ", GlyphKind::letter},
    CommandRow{"quad", "1", GlyphKind::space},
    CommandRow{"thinspace", "0.17", GlyphKind::space},
    CommandRow{"left", "", GlyphKind::left},
    CommandRow{"right", "", GlyphKind::right},
    CommandRow{"frac", "", GlyphKind::fraction, 2},
    CommandRow{"sqrt", "", GlyphKind::root, 1},
    CommandRow{"dot", "˙", GlyphKind::accent, 1},
    CommandRow{"ddot", "¨", GlyphKind::accent, 1},
    CommandRow{"mathbf", "", GlyphKind::bold},
    CommandRow{"boldsymbol", "", GlyphKind::bold},
    CommandRow{"bm", "", GlyphKind::bold},
    CommandRow{"text", "", GlyphKind::prose},
    CommandRow{"mathrm", "", GlyphKind::word},
    CommandRow{"operatorname", "", GlyphKind::function},
};

}  // namespace

std::span<const CommandRow> commands() { return command_table; }

std::string_view greek_letter(std::string_view command) {
  const auto row = std::ranges::find(greek_table, command, &CommandRow::command);
  return row == greek_table.end() ? std::string_view() : row->letter;
}

std::string_view greek_command(std::string_view letter) {
  const auto row = std::ranges::find(greek_table, letter, &CommandRow::letter);
  return row == greek_table.end() ? std::string_view() : row->command;
}

}  // namespace elgen
