// A pack that names its element type only if VALUE_TYPE is defined. Without an element type,
// constants could have a wrong type.
#include "lanes.hpp"
#include "two_link_arm/two_link_arm.hpp"

struct Unnamed {
  Unnamed() = default;
  Unnamed(double number) : lanes(number) {}
  double& operator[](std::size_t lane) { return lanes[lane]; }
  friend Unnamed operator+(const Unnamed& x, const Unnamed& y) { return {x.lanes + y.lanes}; }
  friend Unnamed operator*(const Unnamed& x, const Unnamed& y) { return {x.lanes * y.lanes}; }
  friend Unnamed operator/(const Unnamed& x, const Unnamed& y) { return {x.lanes / y.lanes}; }
  Unnamed(const compiled::Lanes<double, 4>& all) : lanes(all) {}
#ifdef VALUE_TYPE
  using value_type = double;
#endif
  compiled::Lanes<double, 4> lanes;
};

int main() {
  const two_link_arm::Parameters<Unnamed> p{};
  return p.g.lanes[3] > 9.0 ? 0 : 1;
}
