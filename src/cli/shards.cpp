// Shards are compared by a table: a row of everything that decides what a shard finds.
#include "cli/shards.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <nlohmann/json.hpp>

#include "cli/files/inputs.hpp"

namespace elgen::cli {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* format_name = "elgen shard 1";

/// Shards of many outputs have megabytes.
constexpr std::uint64_t most_bytes = 1U << 30U;

Json json_of(const SourcePointer& source) {
  if (source == nullptr) return nullptr;
  return {{"path", source->path}, {"text", source->text}};
}

SourcePointer source_from(const Json& json) {
  return json.is_null() ? nullptr : make_source(json.at("path"), json.at("text"));
}

Json json_of(const ScreenedStates& screened) {
  Json lists = Json::array();
  for (const std::vector<ScreenedFigure>& worst : screened.worst) {
    Json list = Json::array();
    for (const auto& [state, figure] : worst) list.push_back({state, figure});
    lists.push_back(std::move(list));
  }
  return {{"scalar", name_of(screened.scalar)},
          {"states", screened.states},
          {"worst", std::move(lists)}};
}

ScreenedStates screened_from(const Json& json) {
  ScreenedStates screened;
  const std::string scalar = json.at("scalar");
  const auto row = std::ranges::find(scalar_table, scalar, &ScalarRow::name);
  if (row == scalar_table.end()) throw std::invalid_argument("scalar");
  screened.scalar = row->kind;
  screened.states = json.at("states");
  for (const Json& list : json.at("worst")) {
    std::vector<ScreenedFigure>& worst = screened.worst.emplace_back();
    for (const Json& pair : list) worst.push_back({pair.at(0), pair.at(1)});
  }
  return screened;
}

ShardFile file_from(const std::string& path, const Json& json) {
  if (json.at("format") != format_name) throw std::invalid_argument("format");
  ShardFile file;
  file.path = path;
  file.version = json.at("version");
  file.limits = json.at("limits");
  file.inputs = {source_from(json.at("model")), source_from(json.at("scene"))};
  file.samples = json.at("samples");
  file.seed = json.at("seed");
  file.shard = {json.at("shard").at(0), json.at("shard").at(1)};
  const Json& machine = json.at("machine");
  file.machine = {machine.at("compiler"), machine.at("command"), machine.at("processor"),
                  machine.at("c_library")};
  for (const Json& screened : json.at("screened"))
    file.screening.push_back(screened_from(screened));
  const bool is_part = 1 <= file.shard.number && file.shard.number <= file.shard.count;
  if (!is_part || file.inputs.model == nullptr) throw std::invalid_argument("shard");
  return file;
}

std::string text_of(const SourcePointer& source) { return source == nullptr ? "" : source->text; }

/// "double 62 float 62": lists of either scalar.
std::string shape(const ShardFile& file) {
  std::string text;
  for (const ScreenedStates& screened : file.screening) {
    text += fmt::format(" {} {}", static_cast<int>(screened.scalar), screened.worst.size());
  }
  return text;
}

/// What has to be alike.
struct ComparedRow {
  const char* name;
  bool is_shown;  ///< texts of models are long
  std::string (*value)(const ShardFile& file);
};

const std::vector<ComparedRow>& compared_rows() {
  static const std::vector<ComparedRow> rows{
      {"version of elgen", true, [](const ShardFile& f) { return f.version; }},
      {"model", false, [](const ShardFile& f) { return text_of(f.inputs.model); }},
      {"scene", false, [](const ShardFile& f) { return text_of(f.inputs.scene); }},
      {"number of samples", true, [](const ShardFile& f) { return std::to_string(f.samples); }},
      {"seed", true, [](const ShardFile& f) { return std::to_string(f.seed); }},
      {"number of shards", true, [](const ShardFile& f) { return std::to_string(f.shard.count); }},
      {"set of outputs", false, shape},
      {"limits", true, [](const ShardFile& f) { return f.limits; }},
      {"compiler", true, [](const ShardFile& f) { return f.machine.compiler; }},
      {"flags of the compiler", true, [](const ShardFile& f) { return f.machine.command; }},
      {"processor", true, [](const ShardFile& f) { return f.machine.processor; }},
      {"C library", true, [](const ShardFile& f) { return f.machine.c_library; }},
  };
  return rows;
}

/// The rows in which `other` is not like `first`.
Diagnostics differences(const ShardFile& first, const ShardFile& other, const std::string& where) {
  Diagnostics found;
  for (const ComparedRow& row : compared_rows()) {
    const std::string x = row.value(first);
    const std::string y = row.value(other);
    if (x == y) continue;
    std::string message = fmt::format("the {} of `{}` is not that {}", row.name, first.path, where);
    if (row.is_shown) message += fmt::format(": `{}`, `{}`", x, y);
    found.push_back({Code::E711, {}, std::move(message)});
  }
  return found;
}

Diagnostics missing_and_double(const std::vector<ShardFile>& files) {
  std::map<std::uint64_t, const ShardFile*> known;
  Diagnostics found;
  const std::uint64_t count = files.front().shard.count;
  for (const ShardFile& file : files) {
    const auto [first, is_new] = known.emplace(file.shard.number, &file);
    if (is_new) continue;
    found.push_back({Code::E711,
                     {},
                     fmt::format("shard {}/{} is there twice: `{}`, `{}`", file.shard.number, count,
                                 first->second->path, file.path)});
  }
  for (std::uint64_t number = 1; number <= count && found.size() < 20; ++number) {
    if (known.count(number) > 0) continue;
    found.push_back({Code::E711, {}, fmt::format("shard {}/{} is missing", number, count)});
  }
  return found;
}

}  // namespace

std::optional<Shard> parse_shard(const std::string& text) {
  Shard shard;
  const char* const end = text.data() + text.size();
  const auto number = std::from_chars(text.data(), end, shard.number);
  if (number.ec != std::errc() || number.ptr == end || *number.ptr != '/') return std::nullopt;
  const auto count = std::from_chars(number.ptr + 1, end, shard.count);
  const bool is_read = count.ec == std::errc() && count.ptr == end;
  if (!is_read || shard.number < 1 || shard.number > shard.count) return std::nullopt;
  return shard;
}

std::string limits_text(const Limits& limits) {
  std::string text;
  for (const LimitRow& row : limit_table()) {
    if (row.member == &Limits::seconds || row.member == &Limits::memory_mib) continue;
    text += fmt::format("{}{}={}", text.empty() ? "" : " ", row.name, limits.*row.member);
  }
  return text;
}

std::string to_json(const ShardFile& file) {
  Json screened = Json::array();
  for (const ScreenedStates& states : file.screening) screened.push_back(json_of(states));
  const Machine& machine = file.machine;
  const Json json{{"format", format_name},
                  {"version", file.version},
                  {"limits", file.limits},
                  {"model", json_of(file.inputs.model)},
                  {"scene", json_of(file.inputs.scene)},
                  {"samples", file.samples},
                  {"seed", file.seed},
                  {"shard", {file.shard.number, file.shard.count}},
                  {"machine",
                   {{"compiler", machine.compiler},
                    {"command", machine.command},
                    {"processor", machine.processor},
                    {"c_library", machine.c_library}}},
                  {"screened", std::move(screened)}};
  return json.dump() + "\n";
}

Result<ShardFile> read_shard(const std::string& path, const Limits& limits) {
  Limits of_shards = limits;
  of_shards.file_bytes = std::max(limits.file_bytes, most_bytes);
  const Result<SourcePointer> source = read_source(path, of_shards);
  if (!source) return source.diagnostics;
  try {
    return file_from(path, Json::parse((*source)->text));
  } catch (const std::exception&) {
    return Diagnostic{Code::E712,
                      {},
                      fmt::format("`{}` is not a shard", path),
                      "written by `elgen verify --shard i/N -o FILE`"};
  }
}

Diagnostics misfits(const std::vector<ShardFile>& files, const Limits& limits,
                    const Machine& here) {
  const ShardFile& first = files.front();
  Diagnostics found;
  const auto append = [&found](const Diagnostics& more) {
    found.insert(found.end(), more.begin(), more.end());
  };
  for (const ShardFile& file : files) {
    append(differences(first, file, fmt::format("of `{}`", file.path)));
  }
  if (!found.empty()) return found;
  ShardFile made_here = first;
  made_here.version = ELGEN_VERSION;
  made_here.limits = limits_text(limits);
  made_here.machine = here;
  append(differences(first, made_here, "here"));
  append(missing_and_double(files));
  return found;
}

}  // namespace elgen::cli
