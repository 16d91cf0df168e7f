// Visits states in several child processes. Each child writes its findings to an unnamed file,
// which the parent reads when all children have ended.
#include <fmt/format.h>
#include <sys/mman.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <type_traits>

#include "elgen/outputs.hpp"
#include "toolchain/forked.hpp"
#include "verify/bounds/accuracy.hpp"
#include "verify/bounds/projection.hpp"

namespace elgen {
namespace {

/// Calls `pass` with every member of `finding` in turn.
template <class AnyFinding, class Pass>
void for_each_member(AnyFinding& finding, const Pass& pass) {
  auto& [regime, is_compared, is_finite, mistake, errors, loss, users, wide] = finding;
  const auto all = [&pass](auto&... members) { (pass(members), ...); };
  all(regime, is_compared, is_finite, mistake, errors, loss, users.error, users.mistake, wide.error,
      wide.mistake);
}

/// A file in memory with the findings of one child process, in the order of its states. The child
/// writes the file, and the parent reads the file.
class FindingsFile {
 public:
  FindingsFile() : file_(::fdopen(::memfd_create("elgen", MFD_CLOEXEC), "w+")) {}

  [[nodiscard]] bool is_open() const { return file_ != nullptr; }

  void write(const Findings& findings) const {
    put(findings.size());
    for (const std::optional<Finding>& finding : findings) {
      put(finding.has_value());
      if (finding) for_each_member(*finding, [this](const auto& member) { put(member); });
    }
  }
  void flush() const { require(std::fflush(file_.get()) == 0); }

  void rewind() const { std::rewind(file_.get()); }
  [[nodiscard]] Findings read() const {
    std::size_t count = 0;
    get(count);
    Findings findings(count);
    for (std::optional<Finding>& finding : findings) {
      bool has_value = false;
      get(has_value);
      if (has_value) for_each_member(finding.emplace(), [this](auto& member) { get(member); });
    }
    return findings;
  }

 private:
  struct FileCloser {
    void operator()(std::FILE* file) const { (void)std::fclose(file); }
  };

  static void require(bool succeeds) {
    if (!succeeds) throw std::runtime_error("findings are lost on the way");
  }

  template <class T>
  void put(const T& value) const {
    if constexpr (std::is_trivially_copyable_v<T>) {
      require(std::fwrite(&value, sizeof value, 1, file_.get()) == 1);
    } else {
      put(value.size());
      for (const auto& element : value) put(element);
    }
  }

  template <class T>
  void get(T& value) const {
    if constexpr (std::is_trivially_copyable_v<T>) {
      require(std::fread(&value, sizeof value, 1, file_.get()) == 1);
    } else {
      std::size_t size = 0;
      get(size);
      value.resize(size);
      for (auto& element : value) get(element);
    }
  }

  std::unique_ptr<std::FILE, FileCloser> file_;
};

/// True if the field is compared at this sample. The oracle's derivatives of the dynamics cost
/// `velocities` times as much as all other outputs together. With ComparisonMode::entries and more
/// than three velocities, these derivatives are compared at every sixteenth sample.
bool is_compared_at(const ComparedField& place, const Model& model, std::size_t sample,
                    ComparisonMode comparison) {
  if (comparison == ComparisonMode::projections)
    return sample == 0 || !is_projected_once(place, model);
  const bool is_costly = model.velocities.size() > 3;
  return !is_costly || !output_row(place.request.kind).differentiates || sample % 16 == 0;
}

template <class Scalar>
class StateCheckRunner {
 public:
  StateCheckRunner(const SystemUnderTest& subject, const std::vector<SampledState<Scalar>>& states,
                   const AccuracyOptions& options)
      : subject_(subject), states_(states), options_(options), places_(field_places(subject)) {}

  void run(const FindingsHandler& take) const {
    const std::size_t jobs = std::min(options_.jobs, states_.size());
    if (jobs > 1 && check_in_processes(jobs, take)) return;
    for (std::size_t i = 0; i < states_.size(); ++i) {
      report_step(i);
      take(i, findings_at(i));
    }
  }

 private:
  [[nodiscard]] Findings findings_at(std::size_t i) const {
    StateCheck<Scalar> visit(subject_, states_[i], options_.check_options);
    Sampler draw(i + 1);
    Findings findings;
    for (const ComparedField& place : places_) {
      const bool looks =
          is_compared_at(place, subject_.model, i, options_.check_options.comparison);
      findings.push_back(looks ? std::optional(visit.check_field(place, draw)) : std::nullopt);
    }
    return findings;
  }

  /// False if a process failed; then `take` has not been called.
  [[nodiscard]] bool check_in_processes(std::size_t jobs, const FindingsHandler& take) const {
    const std::vector<FindingsFile> files(jobs);
    if (!std::ranges::all_of(files, &FindingsFile::is_open)) return false;
    SharedArray<std::atomic<std::size_t>> next(1);
    SharedArray<std::size_t> visitors(states_.size());
    const auto work = [&](std::size_t job) {
      for (std::size_t i = next[0]++; i < states_.size(); i = next[0]++) {
        visitors[i] = job;
        files[job].write(findings_at(i));
      }
      files[job].flush();
    };
    const ForkResult ending = run_forked(jobs, work, [&] { report_step(next[0]); });
    if (ending.ending == ProcessEnding::out_of_time) (void)std::raise(SIGXCPU);
    if (!ending.succeeded()) return false;
    for (const FindingsFile& file : files) file.rewind();
    for (std::size_t i = 0; i < states_.size(); ++i) take(i, files[visitors[i]].read());
    return true;
  }

  /// `at`: index of the state.
  void report_step(std::size_t at) const {
    if (!options_.on_step) return;
    options_.on_step(fmt::format("accuracy in {}, state {} of {}", name_of(scalar_kind<Scalar>),
                                 std::min(at + 1, states_.size()), states_.size()));
  }

  const SystemUnderTest& subject_;
  const std::vector<SampledState<Scalar>>& states_;
  const AccuracyOptions& options_;
  std::vector<ComparedField> places_;
};

}  // namespace

template <class Scalar>
void check_states(const SystemUnderTest& subject, const std::vector<SampledState<Scalar>>& states,
                  const AccuracyOptions& options, const FindingsHandler& take) {
  StateCheckRunner<Scalar>(subject, states, options).run(take);
}

template void check_states(const SystemUnderTest&, const std::vector<SampledState<double>>&,
                           const AccuracyOptions&, const FindingsHandler&);
template void check_states(const SystemUnderTest&, const std::vector<SampledState<float>>&,
                           const AccuracyOptions&, const FindingsHandler&);

}  // namespace elgen
