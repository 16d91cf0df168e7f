// integrate: the methods of step_methods.def, each as its textbook has it.
#include "elgen/integrate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <numeric>

#include "check/names/requests.hpp"
#include "elgen/step_methods.hpp"
#include "evaluate/subject.hpp"
#include "integrate/composition.hpp"
#include "lower/graph/prune.hpp"

namespace elgen {
namespace {

/// The method of a request, as a composition.
class Step {
 public:
  Step(const Model& model, const Program& calls, Program& program, Function& function)
      : model_(model),
        calls_(calls),
        compose_(program, function),
        h_(compose_.leaf(Opcode::step)),
        start_{compose_.leaves(Opcode::coordinate, model.coordinates.size()),
               compose_.leaves(Opcode::velocity, model.velocities.size()),
               model.uses_time ? compose_.leaf(Opcode::time) : 0} {}

  struct State {
    Places q;
    Places v;
  };

  State rk4() {
    const std::uint32_t half = times_h(cln::cl_RA(1) / 2);
    std::vector<Rates> k{rates_at(start_)};
    k.push_back(rates_at(after(half, k[0], 2)));
    k.push_back(rates_at(after(half, k[1], 3)));
    k.push_back(rates_at(after(h_, k[2], 4)));
    const std::uint32_t sixth = compose_.add(Opcode::divide, h_, compose_.number(6));
    return {unit(compose_.moved(start_.q, sixth, weighted(k, &Rates::q))),
            compose_.moved(start_.v, sixth, weighted(k, &Rates::v))};
  }

  State verlet() {
    const std::uint32_t half = times_h(cln::cl_RA(1) / 2);
    CallPoint end = start_;
    end.number = 2;
    end.v = compose_.moved(start_.v, half, acceleration(start_));
    end.q = compose_.moved(start_.q, h_, end.v);
    if (model_.uses_time) end.t = compose_.add(Opcode::add, start_.t, h_);
    name(end);
    return {end.q, compose_.moved(end.v, half, acceleration(end))};
  }

 private:
  struct Rates {
    Places q;
    Places v;
  };

  std::uint32_t times_h(const cln::cl_RA& factor) {
    return compose_.add(Opcode::multiply, compose_.number(factor), h_);
  }

  Places called(OutputKind kind, const CallPoint& at) {
    return compose_.call(calls_, *find_function(calls_, kind), at);
  }

  Places acceleration(const CallPoint& at) {
    const Places a = called(OutputKind::forward_dynamics, at);
    compose_.name(a, Opcode::acceleration, at.number);
    return a;
  }

  Rates rates_at(const CallPoint& at) {
    const bool turns = !model_.rotations.empty();
    return {turns ? called(OutputKind::coordinate_rates, at) : at.v, acceleration(at)};
  }

  /// The start and c k, for call `number`.
  CallPoint after(std::uint32_t c, const Rates& k, std::uint32_t number) {
    CallPoint at{unit(compose_.moved(start_.q, c, k.q)), compose_.moved(start_.v, c, k.v), start_.t,
                 number};
    if (model_.uses_time) at.t = compose_.add(Opcode::add, start_.t, c);
    name(at);
    return at;
  }

  void name(const CallPoint& at) {
    compose_.name(at.q, Opcode::coordinate, at.number);
    compose_.name(at.v, Opcode::velocity, at.number);
  }

  /// k1 + 2 (k2 + k3) + k4
  Places weighted(const std::vector<Rates>& k, Places Rates::*part) {
    const std::uint32_t two = compose_.number(2);
    const Places middle = sum(k[1].*part, k[2].*part);
    return sum(compose_.moved(k[0].*part, two, middle), k[3].*part);
  }

  Places sum(const Places& x, const Places& y) {
    Places result;
    for (std::size_t i = 0; i < x.size(); ++i) {
      result.push_back(compose_.add(Opcode::add, x[i], y[i]));
    }
    return result;
  }

  /// q with every quaternion divided by its length.
  Places unit(Places q) {
    for (const Rotation& rotation : model_.rotations) {
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

  const Model& model_;
  const Program& calls_;
  Composition compose_;
  std::uint32_t h_;
  CallPoint start_;
};

constexpr Step::State (Step::*methods[])() = {
#define ELGEN_STEP_METHOD(name, domain, doc, equation) &Step::name,
#include "elgen/step_methods.def"
#undef ELGEN_STEP_METHOD
};

bool needs_separable(const OutputRequest& step) {
  return step_methods[step.user].domain == StepDomain::separable;
}

Field column(std::string_view name, Places entries) {
  const auto rows = static_cast<std::uint32_t>(entries.size());
  return {std::string(name), rows, 1, std::move(entries)};
}

/// All entries, where what is called rests on zeros that were not proved.
std::vector<std::uint32_t> sampled_zeros(const Program& calls, const Function& step) {
  const bool is_sampled = std::ranges::any_of(
      calls.functions, [](const Function& f) { return !f.sampled_zeros.empty(); });
  std::vector<std::uint32_t> entries(is_sampled ? entry_count(step) : 0);
  std::iota(entries.begin(), entries.end(), 0U);
  return entries;
}

}  // namespace

std::vector<OutputRequest> needed_for_step(const Model& model, const OutputRequest& step) {
  std::vector<OutputKind> kinds;
  if (needs_separable(step)) {
    kinds = {OutputKind::mass_matrix, OutputKind::bias, OutputKind::momentum};
  }
  kinds.push_back(OutputKind::forward_dynamics);
  if (!model.rotations.empty()) kinds.push_back(OutputKind::coordinate_rates);
  std::vector<OutputRequest> needed;
  for (const OutputKind kind : kinds) {
    needed.push_back(request_of(model, kind, 0));
    needed.back().span = step.span;
    if (kind == OutputKind::forward_dynamics) needed.back().form = step.form;
  }
  return needed;
}

Diagnostics add_step(const CheckedModel& checked, const OutputRequest& step, const Program& calls,
                     Program& program) {
  const std::string reason = needs_separable(step) ? not_separable(checked, calls) : "";
  if (!reason.empty()) {
    return {{Code::E622, step.span,
             fmt::format("`{}` is not for this system: {}", step_methods[step.user].name, reason),
             "`rk4` takes any model"}};
  }
  program.leaves.h = leaf_row(Opcode::step).symbol;
  Function function{step.kind, step.user, step.name};
  auto [q, v] = (Step(checked.model, calls, program, function).*methods[step.user])();
  const std::span<const FieldRow> rows = output_row(step.kind).fields;
  function.fields = {column(rows[0].name, std::move(q)), column(rows[1].name, std::move(v))};
  function.sampled_zeros = sampled_zeros(calls, function);
  program.functions.push_back(pruned(function));
  assert(check_invariants(program).empty());
  return {};
}

}  // namespace elgen
