// Heads are compared by a table: a row of everything that decides what a shard finds.
#include "cli/shards/shard_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>

#include "cli/files/inputs.hpp"

namespace elgen::cli {

namespace {

constexpr const char* format_name = "elgen shard 1";

/// Shards of many outputs have megabytes.
constexpr std::uint64_t most_bytes = 1U << 30U;

/// By ShardJob.
constexpr std::array job_names{"verify", "tradeoff"};

std::string name_of(ShardJob job) { return job_names[static_cast<std::size_t>(job)]; }

/// All limits but those on time and memory.
std::string limits_text(const Limits& limits) {
  std::string text;
  for (const LimitRow& row : limit_table()) {
    if (row.member == &Limits::seconds || row.member == &Limits::memory_mib) continue;
    text += fmt::format("{}{}={}", text.empty() ? "" : " ", row.name, limits.*row.member);
  }
  return text;
}

Json json_of(const SourcePointer& source) {
  if (source == nullptr) return nullptr;
  return {{"path", source->path}, {"text", source->text}};
}

SourcePointer source_from(const Json& json) {
  return json.is_null() ? nullptr : make_source(json.at("path"), json.at("text"));
}

ShardHead head_from(const std::string& path, ShardJob job, const Json& json) {
  ShardHead head;
  head.path = path;
  head.job = job;
  head.version = json.at("version");
  head.limits = json.at("limits");
  head.inputs = {source_from(json.at("model")), source_from(json.at("scene"))};
  head.shard = {json.at("shard").at(0), json.at("shard").at(1)};
  const Json& machine = json.at("machine");
  head.machine = {machine.at("compiler"), machine.at("command"), machine.at("processor"),
                  machine.at("c_library")};
  const bool is_part = 1 <= head.shard.number && head.shard.number <= head.shard.count;
  if (!is_part || head.inputs.model == nullptr) throw std::invalid_argument("shard");
  return head;
}

Diagnostic no_shard(const std::string& message, ShardJob job) {
  return {Code::E712,
          {},
          message,
          fmt::format("written by `elgen {} --shard i/N -o FILE`", name_of(job))};
}

Diagnostics read_shard(const std::string& path, ShardJob job, const Limits& limits,
                       const TakeShard& take) {
  const Result<SourcePointer> source = read_source(path, limits);
  if (!source) return source.diagnostics;
  try {
    const Json json = Json::parse((*source)->text);
    if (json.at("format") != format_name) throw std::invalid_argument("format");
    const std::string written_by = json.at("job");
    if (written_by != name_of(job)) {
      return {no_shard(fmt::format("`{}` is a shard of `elgen {}`", path, written_by), job)};
    }
    take(head_from(path, job, json), json);
    return {};
  } catch (const std::exception&) {
    return {no_shard(fmt::format("`{}` is not a shard", path), job)};
  }
}

std::string text_of(const SourcePointer& source) { return source == nullptr ? "" : source->text; }

/// All that has to be alike.
std::vector<ComparedValue> all_compared(const ShardHead& head) {
  std::vector<ComparedValue> rows{{"version of elgen", head.version},
                                  {"model", text_of(head.inputs.model), false},
                                  {"scene", text_of(head.inputs.scene), false}};
  rows.insert(rows.end(), head.compared.begin(), head.compared.end());
  const Machine& machine = head.machine;
  rows.insert(rows.end(), {{"number of shards", std::to_string(head.shard.count)},
                           {"limits", head.limits},
                           {"compiler", machine.compiler},
                           {"flags of the compiler", machine.command},
                           {"processor", machine.processor},
                           {"C library", machine.c_library}});
  return rows;
}

/// The rows in which `other` is not like `first`.
Diagnostics differences(const ShardHead& first, const ShardHead& other, const std::string& where) {
  const std::vector<ComparedValue> ours = all_compared(first);
  const std::vector<ComparedValue> theirs = all_compared(other);
  Diagnostics found;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const auto& [name, x, is_shown] = ours[i];
    const std::string& y = theirs[i].value;
    if (x == y) continue;
    std::string message = fmt::format("the {} of `{}` is not that {}", name, first.path, where);
    if (is_shown) message += fmt::format(": `{}`, `{}`", x, y);
    found.push_back({Code::E711, {}, std::move(message)});
  }
  return found;
}

Diagnostics missing_and_double(const std::vector<ShardHead>& heads) {
  constexpr std::size_t most_told = 20;
  std::map<std::uint64_t, const ShardHead*> known;
  Diagnostics found;
  const std::uint64_t count = heads.front().shard.count;
  for (const ShardHead& head : heads) {
    const auto [first, is_new] = known.emplace(head.shard.number, &head);
    if (is_new) continue;
    found.push_back({Code::E711,
                     {},
                     fmt::format("shard {}/{} is there twice: `{}`, `{}`", head.shard.number, count,
                                 first->second->path, head.path)});
  }
  for (std::uint64_t number = 1; number <= count && found.size() < most_told; ++number) {
    if (known.count(number) > 0) continue;
    found.push_back({Code::E711, {}, fmt::format("shard {}/{} is missing", number, count)});
  }
  return found;
}

}  // namespace

ShardHead head_here(ShardJob job, const Inputs& inputs, const Shard& shard, const Machine& machine,
                    const Limits& limits) {
  return {.job = job,
          .version = ELGEN_VERSION,
          .limits = limits_text(limits),
          .inputs = inputs,
          .shard = shard,
          .machine = machine};
}

Json json_of(const ShardHead& head) {
  const Machine& machine = head.machine;
  return {{"format", format_name},
          {"job", name_of(head.job)},
          {"version", head.version},
          {"limits", head.limits},
          {"model", json_of(head.inputs.model)},
          {"scene", json_of(head.inputs.scene)},
          {"shard", {head.shard.number, head.shard.count}},
          {"machine",
           {{"compiler", machine.compiler},
            {"command", machine.command},
            {"processor", machine.processor},
            {"c_library", machine.c_library}}}};
}

Diagnostics read_shards(const std::vector<std::string>& paths, ShardJob job, const Limits& limits,
                        const TakeShard& take) {
  Limits of_shards = limits;
  of_shards.file_bytes = std::max(limits.file_bytes, most_bytes);
  Diagnostics unread;
  for (const std::string& path : paths) {
    const Diagnostics found = read_shard(path, job, of_shards, take);
    unread.insert(unread.end(), found.begin(), found.end());
  }
  return unread;
}

Diagnostics misfits(const std::vector<ShardHead>& heads, const Limits& limits,
                    const Machine& machine) {
  const ShardHead& first = heads.front();
  Diagnostics found;
  const auto append = [&found](const Diagnostics& more) {
    found.insert(found.end(), more.begin(), more.end());
  };
  for (const ShardHead& head : heads) {
    append(differences(first, head, fmt::format("of `{}`", head.path)));
  }
  if (!found.empty()) return found;
  ShardHead made_here = head_here(first.job, first.inputs, first.shard, machine, limits);
  made_here.compared = first.compared;
  append(differences(first, made_here, "here"));
  append(missing_and_double(heads));
  return found;
}

}  // namespace elgen::cli
