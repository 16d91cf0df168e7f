// SVG: the elements that pictures are made of, in black and grey on white, positions in pixels.
#pragma once

#include <string>

namespace elgen {

/// The opening tag, a white ground, and what the picture is called, in the topmost 30 pixels.
[[nodiscard]] std::string svg_start(double width, double height, const std::string& title);

[[nodiscard]] std::string svg_grid_line(double x1, double y1, double x2, double y2);

/// `anchor`: what of the text is at x: "start", "middle" or "end".
[[nodiscard]] std::string svg_label(double x, double y, const char* anchor,
                                    const std::string& text);

/// Of a part of the picture, in bold, from x on.
[[nodiscard]] std::string svg_title(double x, double y, const std::string& text);

}  // namespace elgen
