// A wrapper that makes a g++ or clang++ vector a Scalar of emitted code.
#pragma once

#include <cmath>
#include <cstddef>

namespace compiled {

template <class Element, std::size_t Count>
struct Vector {
  using type [[gnu::vector_size(Count * sizeof(Element))]] = Element;
};

template <class Element, std::size_t Count>
struct Lanes {
  using Native = typename Vector<Element, Count>::type;
  using value_type = Element;

  Lanes() = default;
  Lanes(Native lanes) : native(lanes) {}
  Lanes(Element number) : native(number - Native{}) {}
  auto& operator[](std::size_t lane) { return reinterpret_cast<Element*>(&native)[lane]; }
  Element operator[](std::size_t lane) const { return native[lane]; }
  static constexpr std::size_t size() { return Count; }

  friend Lanes operator+(const Lanes& x, const Lanes& y) { return x.native + y.native; }
  friend Lanes operator-(const Lanes& x, const Lanes& y) { return x.native - y.native; }
  friend Lanes operator*(const Lanes& x, const Lanes& y) { return x.native * y.native; }
  friend Lanes operator/(const Lanes& x, const Lanes& y) { return x.native / y.native; }
  friend Lanes operator-(const Lanes& x) { return -x.native; }
  friend Lanes sin(Lanes x) {
    for (std::size_t lane = 0; lane < Count; ++lane) x[lane] = std::sin(x[lane]);
    return x;
  }
  friend Lanes cos(Lanes x) {
    for (std::size_t lane = 0; lane < Count; ++lane) x[lane] = std::cos(x[lane]);
    return x;
  }

  Native native;
};

}  // namespace compiled
