// The explicit methods, which call nothing but accelerations (and rates, where rotations turn).
#include "program/evaluate/subject.hpp"
#include "program/steps/methods.hpp"

namespace elgen {
namespace {

class Explicit {
 public:
  explicit Explicit(const StepContext& step) : step_(step), compose_(step.compose) {}

  NextState rk4() {
    std::vector<Rates> k{rates_at(step_.start)};
    k.push_back(rates_at(after(step_.half, k[0], 2)));
    k.push_back(rates_at(after(step_.half, k[1], 3)));
    k.push_back(rates_at(after(step_.h, k[2], 4)));
    const std::uint32_t sixth = compose_.add(Opcode::divide, step_.h, compose_.number(6));
    return {unit(compose_.moved(step_.start.q, sixth, weighted(k, &Rates::q))),
            compose_.moved(step_.start.v, sixth, weighted(k, &Rates::v))};
  }

  /// The kick that ends a part and the one that begins the next are merged.
  NextState verlet() {
    CallPoint at = step_.start;
    cln::cl_RA before = 0;
    cln::cl_RA time = 0;
    for (const cln::cl_RA& part : step_.parts) {
      const std::uint32_t kick = step_.part((before + part) / 2);
      at.v = compose_.moved(at.v, kick, acceleration(at));
      at.q = compose_.moved(at.q, step_.part(part), at.v);
      time = time + part;
      at.t = step_.time_at(time);
      ++at.number;
      step_.name(at);
      before = part;
    }
    const std::uint32_t kick = step_.part(before / 2);
    return {at.q, compose_.moved(at.v, kick, acceleration(at))};
  }

 private:
  struct Rates {
    Places q;
    Places v;
  };

  Places called(OutputKind kind, const CallPoint& at) {
    const Function& function = *find_function(step_.calls, kind);
    const bool is_inner = step_.has_inner && kind == OutputKind::forward_dynamics;
    return compose_.call(step_.calls, function, function.fields.front(), at, is_inner);
  }

  Places acceleration(const CallPoint& at) {
    const Places a = called(OutputKind::forward_dynamics, at);
    compose_.name(a, Opcode::acceleration, at.number);
    return a;
  }

  Rates rates_at(const CallPoint& at) {
    const bool turns = !step_.model.rotations.empty();
    return {turns ? called(OutputKind::coordinate_rates, at) : at.v, acceleration(at)};
  }

  /// The start and c k, for call `number`.
  CallPoint after(std::uint32_t c, const Rates& k, std::uint32_t number) {
    CallPoint at{.q = unit(compose_.moved(step_.start.q, c, k.q)),
                 .v = compose_.moved(step_.start.v, c, k.v)};
    at.t = step_.time_after(c);
    at.number = number;
    step_.name(at);
    return at;
  }

  /// k1 + 2 (k2 + k3) + k4
  Places weighted(const std::vector<Rates>& k, Places Rates::*part) {
    const std::uint32_t two = compose_.number(2);
    const Places middle = compose_.add(Opcode::add, k[1].*part, k[2].*part);
    return compose_.add(Opcode::add, compose_.moved(k[0].*part, two, middle), k[3].*part);
  }

  /// q with every quaternion divided by its length.
  Places unit(Places q) {
    for (const Rotation& rotation : step_.model.rotations) {
      std::uint32_t* const e = &q[rotation.first_coordinate];
      std::uint32_t square = compose_.add(Opcode::multiply, e[0], e[0]);
      for (std::size_t i = 1; i < quaternion_size; ++i) {
        square = compose_.add(Opcode::add, square, compose_.add(Opcode::multiply, e[i], e[i]));
      }
      const std::uint32_t length = compose_.add(Opcode::square_root, square);
      for (std::size_t i = 0; i < quaternion_size; ++i) {
        e[i] = compose_.add(Opcode::divide, e[i], length);
      }
    }
    return q;
  }

  const StepContext& step_;
  Composition& compose_;
};

}  // namespace

NextState compose_rk4(const StepContext& step) { return Explicit(step).rk4(); }

NextState compose_verlet(const StepContext& step) { return Explicit(step).verlet(); }

}  // namespace elgen
