// Characters that get into expressions by typing in another alphabet or pasting from a text, and
// what the language writes for them.
#include "parse/characters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace elgen {

namespace {

struct SpelledCharacter {
  char32_t character;
  std::string_view written;
};

constexpr std::array replacements{
    // ASCII that other languages use
    SpelledCharacter{U'\'', "dot(x)"},
    SpelledCharacter{U'{', "("},
    SpelledCharacter{U'}', ")"},
    // operators
    SpelledCharacter{0x00B7, "*"},
    SpelledCharacter{0x00D7, "*"},
    SpelledCharacter{0x2022, "*"},
    SpelledCharacter{0x2217, "*"},
    SpelledCharacter{0x2219, "*"},
    SpelledCharacter{0x22C5, "*"},
    SpelledCharacter{0x00F7, "/"},
    SpelledCharacter{0x2044, "/"},
    SpelledCharacter{0x2215, "/"},
    SpelledCharacter{0x00AD, "-"},
    SpelledCharacter{0x2010, "-"},
    SpelledCharacter{0x2011, "-"},
    SpelledCharacter{0x2012, "-"},
    SpelledCharacter{0x2013, "-"},
    SpelledCharacter{0x2014, "-"},
    SpelledCharacter{0x2212, "-"},
    SpelledCharacter{0x221A, "sqrt(x)"},
    SpelledCharacter{0x2032, "dot(x)"},
    SpelledCharacter{0x0307, "dot(x)"},
    SpelledCharacter{0x02D9, "dot(x)"},
    SpelledCharacter{0x2019, "dot(x)"},
    // superscripts, fractions, degrees
    SpelledCharacter{0x00B2, "^2"},
    SpelledCharacter{0x00B3, "^3"},
    SpelledCharacter{0x00B9, "^1"},
    SpelledCharacter{0x2070, "^0"},
    SpelledCharacter{0x2074, "^4"},
    SpelledCharacter{0x207B, "^-"},
    SpelledCharacter{0x00BC, "1/4"},
    SpelledCharacter{0x00BD, "1/2"},
    SpelledCharacter{0x00BE, "3/4"},
    SpelledCharacter{0x00B0, "*pi/180"},
    // spaces
    SpelledCharacter{0x00A0, " "},
    SpelledCharacter{0x2009, " "},
    SpelledCharacter{0x202F, " "},
    SpelledCharacter{0x3000, " "},
    // Greek
    SpelledCharacter{0x03B1, "alpha"},
    SpelledCharacter{0x03B2, "beta"},
    SpelledCharacter{0x03B3, "gamma"},
    SpelledCharacter{0x03B4, "delta"},
    SpelledCharacter{0x03B5, "epsilon"},
    SpelledCharacter{0x03B6, "zeta"},
    SpelledCharacter{0x03B7, "eta"},
    SpelledCharacter{0x03B8, "theta"},
    SpelledCharacter{0x03D1, "theta"},
    SpelledCharacter{0x03B9, "iota"},
    SpelledCharacter{0x03BA, "kappa"},
    SpelledCharacter{0x03BB, "lambda"},
    SpelledCharacter{0x03BC, "mu"},
    SpelledCharacter{0x00B5, "mu"},
    SpelledCharacter{0x03BD, "nu"},
    SpelledCharacter{0x03BE, "xi"},
    SpelledCharacter{0x03C0, "pi"},
    SpelledCharacter{0x03C1, "rho"},
    SpelledCharacter{0x03C3, "sigma"},
    SpelledCharacter{0x03C4, "tau"},
    SpelledCharacter{0x03C5, "upsilon"},
    SpelledCharacter{0x03C6, "phi"},
    SpelledCharacter{0x03D5, "phi"},
    SpelledCharacter{0x03C7, "chi"},
    SpelledCharacter{0x03C8, "psi"},
    SpelledCharacter{0x03C9, "omega"},
    SpelledCharacter{0x0393, "Gamma"},
    SpelledCharacter{0x0394, "Delta"},
    SpelledCharacter{0x0398, "Theta"},
    SpelledCharacter{0x039B, "Lambda"},
    SpelledCharacter{0x03A0, "Pi"},
    SpelledCharacter{0x03A3, "sum(i, a, b, e)"},
    SpelledCharacter{0x2211, "sum(i, a, b, e)"},
    SpelledCharacter{0x03A6, "Phi"},
    SpelledCharacter{0x03A8, "Psi"},
    SpelledCharacter{0x03A9, "Omega"},
    // Cyrillic letters that look like Latin ones
    SpelledCharacter{0x0410, "A"},
    SpelledCharacter{0x0412, "B"},
    SpelledCharacter{0x0415, "E"},
    SpelledCharacter{0x041A, "K"},
    SpelledCharacter{0x041C, "M"},
    SpelledCharacter{0x041D, "H"},
    SpelledCharacter{0x041E, "O"},
    SpelledCharacter{0x0420, "P"},
    SpelledCharacter{0x0421, "C"},
    SpelledCharacter{0x0422, "T"},
    SpelledCharacter{0x0425, "X"},
    SpelledCharacter{0x0430, "a"},
    SpelledCharacter{0x0435, "e"},
    SpelledCharacter{0x043E, "o"},
    SpelledCharacter{0x0440, "p"},
    SpelledCharacter{0x0441, "c"},
    SpelledCharacter{0x0443, "y"},
    SpelledCharacter{0x0445, "x"},
    SpelledCharacter{0x0456, "i"},
    SpelledCharacter{0x0458, "j"},
};

/// Full-width forms stand at a fixed distance from their ASCII.
bool is_full_width(char32_t c) { return c >= 0xFF01 && c <= 0xFF5E; }
constexpr char32_t full_width_distance = 0xFEE0;

std::string_view script_name(char32_t c) {
  if (c >= 0x0370 && c <= 0x03FF) return "the Greek letter";
  if (c >= 0x0400 && c <= 0x04FF) return "the Cyrillic letter";
  return "this character";
}

}  // namespace

std::string replacement_hint(char32_t character) {
  if (is_full_width(character)) {
    return fmt::format("write `{}`", static_cast<char>(character - full_width_distance));
  }
  const auto row =
      std::find_if(replacements.begin(), replacements.end(),
                   [&](const SpelledCharacter& r) { return r.character == character; });
  if (row == replacements.end()) return {};
  if (row->written == " ") return "write a plain space";
  if (character < 0x80) return fmt::format("write `{}`", row->written);
  return fmt::format("write `{}` instead of {}", row->written, script_name(character));
}

}  // namespace elgen
