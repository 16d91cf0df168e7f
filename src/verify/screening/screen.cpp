// screen: every process goes through the same sequence of states and judges its share of them. What
// it finds is in shared memory when it ends.
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <type_traits>

#include "elgen/screening.hpp"
#include "emit/text/scalar_range.hpp"
#include "evaluate/states.hpp"
#include "toolchain/forked.hpp"
#include "toolchain/shared_array.hpp"
#include "verify/screening/worst_figures.hpp"

namespace elgen {
namespace {

std::size_t figures_of(const Program& program) {
  std::size_t fields = 0;
  for (const Function& function : program.functions) fields += function.fields.size();
  return fields * figures_per_field;
}

/// What the processes of one scalar write to.
struct SharedFigures {
  SharedFigures(std::size_t jobs, std::size_t figures)
      : done(jobs),
        judged(jobs),
        kept(jobs * figures),
        worst(jobs * figures * visits_after_screening) {}

  SharedArray<std::atomic<std::uint64_t>> done;  ///< states that each has gone through
  SharedArray<std::uint64_t> judged;
  SharedArray<std::uint64_t> kept;  ///< figures, of each
  SharedArray<ScreenedFigure> worst;
};

template <class Scalar>
class Screener {
 public:
  Screener(const Subject& subject, const ScreeningCode& code, const ScreeningOptions& options)
      : subject_(subject),
        code_(code),
        options_(options),
        figures_(figures_of(subject.program)),
        found_(options.jobs, figures_) {}

  Result<ScreenedStates> run() {
    const auto work = [this](std::size_t job) { judge_share(job); };
    const ForkedEnding ending = run_forked(options_.jobs, work, [this] { tell(); });
    if (!ending.succeeded()) return failure(ending);
    std::vector<Screening> parts;
    for (std::size_t job = 0; job < options_.jobs; ++job) parts.push_back({part(job)});
    return joined(parts).front();
  }

 private:
  void judge_share(std::size_t job) {
    StateSequence<Scalar> sequence(subject_, {options_.samples, options_.seed, true});
    const std::uint64_t step = options_.shard.count * options_.jobs;
    const std::uint64_t mine = options_.shard.number - 1 + options_.shard.count * job;
    std::vector<WorstFigures> worst(figures_, WorstFigures(visits_after_screening));
    std::vector<double> figures(figures_);
    for (std::uint64_t number = 0;; ++number) {
      found_.done[job] = number;
      if (number % step != mine) {
        if (!sequence.skip()) break;
        continue;
      }
      const auto state = sequence.next();
      if (!state) break;
      code_.judge(state->values, figures.data());
      ++found_.judged[job];
      for (std::size_t i = 0; i < figures_; ++i) {
        if (figures[i] >= 0) worst[i].add({number, figures[i]});
      }
    }
    for (std::size_t i = 0; i < figures_; ++i) keep(job * figures_ + i, worst[i].sorted());
  }

  void keep(std::size_t list, const std::vector<ScreenedFigure>& worst) {
    found_.kept[list] = worst.size();
    for (std::size_t i = 0; i < worst.size(); ++i) {
      found_.worst[list * visits_after_screening + i] = worst[i];
    }
  }

  [[nodiscard]] ScreenedStates part(std::size_t job) const {
    ScreenedStates states{scalar_kind<Scalar>, found_.judged[job], {}};
    for (std::size_t list = job * figures_; list < (job + 1) * figures_; ++list) {
      const ScreenedFigure* const first = &found_.worst[list * visits_after_screening];
      states.worst.emplace_back(first, first + found_.kept[list]);
    }
    return states;
  }

  void tell() const {
    if (!options_.on_step) return;
    std::uint64_t least = options_.samples;
    for (std::size_t job = 0; job < options_.jobs; ++job) {
      least = std::min<std::uint64_t>(least, found_.done[job]);
    }
    options_.on_step(fmt::format("screening in {}, {} % of {} states", name_of(scalar_kind<Scalar>),
                                 100 * least / options_.samples, options_.samples));
  }

  [[nodiscard]] Diagnostic failure(const ForkedEnding& ending) const {
    switch (ending.ending) {
      case Ending::out_of_time:
        return {Code::E909,
                {},
                fmt::format("{} s of processor time are over", options_.seconds),
                "raised by --limit seconds=N"};
      case Ending::exited:
        return {Code::E710, {}, fmt::format("a screening process exits {}", ending.status)};
      case Ending::signalled:
        return {Code::E710,
                {},
                fmt::format("a screening process was ended by signal {}", ending.status - 128)};
      case Ending::interrupted:
        return {Code::E710, {}, "screening was interrupted"};
      case Ending::not_started:
        break;
    }
    return {Code::E710, {}, "a screening process could not be started"};
  }

  const Subject& subject_;
  const ScreeningCode& code_;
  const ScreeningOptions& options_;
  std::size_t figures_;
  SharedFigures found_;
};

}  // namespace

Result<Screening> screen(const Model& model, const Scene& scene, const Program& program,
                         const ScreeningCode& code, const ScreeningOptions& options) {
  const Subject subject{model, scene, program};
  Screening screening;
  const auto add = [&screening](Result<ScreenedStates> states) {
    if (states) screening.push_back(std::move(*states));
    return states.diagnostics;
  };
  Diagnostics failed = add(Screener<double>(subject, code, options).run());
  if (failed.empty() && fits(model, program, ScalarKind::single_precision)) {
    failed = add(Screener<float>(subject, code, options).run());
  }
  if (!failed.empty()) return failed;
  return screening;
}

}  // namespace elgen
