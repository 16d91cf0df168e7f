// Characters that get into expressions by typing in another alphabet or pasting from a text, and
// what the language writes for them.
#include "characters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace elgen::parsing {

namespace {

struct Replacement {
  char32_t character;
  std::string_view written;
};

constexpr std::array replacements{
    // ASCII that other languages use
    Replacement{U'\'', "dot(x)"},
    Replacement{U'{', "("},
    Replacement{U'}', ")"},
    // operators
    Replacement{0x00B7, "*"},
    Replacement{0x00D7, "*"},
    Replacement{0x2022, "*"},
    Replacement{0x2217, "*"},
    Replacement{0x2219, "*"},
    Replacement{0x22C5, "*"},
    Replacement{0x00F7, "/"},
    Replacement{0x2044, "/"},
    Replacement{0x2215, "/"},
    Replacement{0x00AD, "-"},
    Replacement{0x2010, "-"},
    Replacement{0x2011, "-"},
    Replacement{0x2012, "-"},
    Replacement{0x2013, "-"},
    Replacement{0x2014, "-"},
    Replacement{0x2212, "-"},
    Replacement{0x221A, "sqrt(x)"},
    Replacement{0x2032, "dot(x)"},
    Replacement{0x0307, "dot(x)"},
    Replacement{0x02D9, "dot(x)"},
    Replacement{0x2019, "dot(x)"},
    // superscripts, fractions, degrees
    Replacement{0x00B2, "^2"},
    Replacement{0x00B3, "^3"},
    Replacement{0x00B9, "^1"},
    Replacement{0x2070, "^0"},
    Replacement{0x2074, "^4"},
    Replacement{0x207B, "^-"},
    Replacement{0x00BC, "1/4"},
    Replacement{0x00BD, "1/2"},
    Replacement{0x00BE, "3/4"},
    Replacement{0x00B0, "*pi/180"},
    // spaces
    Replacement{0x00A0, " "},
    Replacement{0x2009, " "},
    Replacement{0x202F, " "},
    Replacement{0x3000, " "},
    // Greek
    Replacement{0x03B1, "alpha"},
    Replacement{0x03B2, "beta"},
    Replacement{0x03B3, "gamma"},
    Replacement{0x03B4, "delta"},
    Replacement{0x03B5, "epsilon"},
    Replacement{0x03B6, "zeta"},
    Replacement{0x03B7, "eta"},
    Replacement{0x03B8, "theta"},
    Replacement{0x03D1, "theta"},
    Replacement{0x03B9, "iota"},
    Replacement{0x03BA, "kappa"},
    Replacement{0x03BB, "lambda"},
    Replacement{0x03BC, "mu"},
    Replacement{0x00B5, "mu"},
    Replacement{0x03BD, "nu"},
    Replacement{0x03BE, "xi"},
    Replacement{0x03C0, "pi"},
    Replacement{0x03C1, "rho"},
    Replacement{0x03C3, "sigma"},
    Replacement{0x03C4, "tau"},
    Replacement{0x03C5, "upsilon"},
    Replacement{0x03C6, "phi"},
    Replacement{0x03D5, "phi"},
    Replacement{0x03C7, "chi"},
    Replacement{0x03C8, "psi"},
    Replacement{0x03C9, "omega"},
    Replacement{0x0393, "Gamma"},
    Replacement{0x0394, "Delta"},
    Replacement{0x0398, "Theta"},
    Replacement{0x039B, "Lambda"},
    Replacement{0x03A0, "Pi"},
    Replacement{0x03A3, "sum(i, a, b, e)"},
    Replacement{0x2211, "sum(i, a, b, e)"},
    Replacement{0x03A6, "Phi"},
    Replacement{0x03A8, "Psi"},
    Replacement{0x03A9, "Omega"},
    // Cyrillic letters that look like Latin ones
    Replacement{0x0410, "A"},
    Replacement{0x0412, "B"},
    Replacement{0x0415, "E"},
    Replacement{0x041A, "K"},
    Replacement{0x041C, "M"},
    Replacement{0x041D, "H"},
    Replacement{0x041E, "O"},
    Replacement{0x0420, "P"},
    Replacement{0x0421, "C"},
    Replacement{0x0422, "T"},
    Replacement{0x0425, "X"},
    Replacement{0x0430, "a"},
    Replacement{0x0435, "e"},
    Replacement{0x043E, "o"},
    Replacement{0x0440, "p"},
    Replacement{0x0441, "c"},
    Replacement{0x0443, "y"},
    Replacement{0x0445, "x"},
    Replacement{0x0456, "i"},
    Replacement{0x0458, "j"},
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
  const auto row = std::find_if(replacements.begin(), replacements.end(),
                                [&](const Replacement& r) { return r.character == character; });
  if (row == replacements.end()) return {};
  if (row->written == " ") return "write a plain space";
  if (character < 0x80) return fmt::format("write `{}`", row->written);
  return fmt::format("write `{}` instead of {}", row->written, script_name(character));
}

}  // namespace elgen::parsing
