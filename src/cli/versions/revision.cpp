// revision: git packs what belongs to it, tar unpacks it where scenes find their models.
#include "cli/versions/revision.hpp"

#include <fmt/format.h>

#include "elgen/wording.hpp"
#include "toolchain/process.hpp"

namespace elgen::cli {

namespace {

constexpr std::uint64_t seconds_of_git = 60;

Diagnostic git_failed(const std::string& what, const ProcessResult& result) {
  if (result.ending == Ending::not_started) return {Code::E713, {}, "git could not be run"};
  return {Code::E713, {}, fmt::format("{}: {}", what, result.output)};
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

/// The files of a revision that match a pattern, where there are any: git packs no empty archive.
ProcessResult unpack(const std::string& repository, const std::string& revision,
                     const std::string& pattern, const std::filesystem::path& folder) {
  const ProcessResult any = run(
      {"git", "-C", repository, "grep", "-q", "-e", "", revision, "--", pattern}, seconds_of_git);
  if (!any.succeeded()) return {Ending::exited, 0};
  const std::string archive = (folder / "archive.tar").string();
  const ProcessResult packed = run({"git", "-C", repository, "archive", "--format=tar", "--output",
                                    archive, revision, "--", pattern},
                                   seconds_of_git);
  if (!packed.succeeded()) return packed;
  return run({"tar", "-xf", archive, "-C", folder.string()}, seconds_of_git);
}

}  // namespace

Result<std::string> unpack_revision(const std::string& revision,
                                    const std::filesystem::path& folder) {
  const ProcessResult prefix = run({"git", "rev-parse", "--show-prefix"}, seconds_of_git);
  if (!prefix.succeeded()) return git_failed("there is no repository here", prefix);
  const ProcessResult top = run({"git", "rev-parse", "--show-toplevel"}, seconds_of_git);
  const std::string repository = first_line(top.output);
  const ProcessResult known =
      run({"git", "rev-parse", "--quiet", "--verify", revision + "^{commit}"}, seconds_of_git);
  if (!known.succeeded()) {
    return git_failed(fmt::format("{} is no revision", in_backticks(revision)), known);
  }
  for (const char* const pattern : {"*.toml", "*.equations.json"}) {
    const ProcessResult unpacked = unpack(repository, revision, pattern, folder);
    if (!unpacked.succeeded()) {
      return git_failed(fmt::format("{} was not read", in_backticks(revision)), unpacked);
    }
  }
  return first_line(prefix.output);
}

}  // namespace elgen::cli
