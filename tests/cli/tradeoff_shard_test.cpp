// Shards of tradeoff: joined they have the rows of one process, to the last bit but for the times.
#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <nlohmann/json.hpp>

#include "support/shell.hpp"

namespace elgen::test {

namespace {

using Json = nlohmann::ordered_json;

class TradeoffShards {
 public:
  TradeoffShards() { prepare("cp " ELGEN_SOURCE_DIR "/models/simple_pendulum.toml .", path()); }

  [[nodiscard]] const std::filesystem::path& path() const { return workspace_.path(); }
  [[nodiscard]] Outcome run(const std::string& words) const {
    return shell("elgen tradeoff " + words, path());
  }
  [[nodiscard]] Json table(const std::string& words) const {
    const Outcome outcome = run("--format json " + words);
    INFO(outcome.errors);
    REQUIRE(outcome.status == 0);
    return Json::parse(outcome.output);
  }
  [[nodiscard]] Json file(const std::string& name) const {
    return Json::parse(read_text(path() / name));
  }

 private:
  Workspace workspace_;
};

/// By the values of the dimensions.
std::map<std::string, Json> errors_in(const Json& table) {
  std::map<std::string, Json> errors;
  for (const Json& row : table["designs"]) errors[row["design"].dump()] = row["error"];
  return errors;
}

bool beats(const Json& x, const Json& y) {
  const double cost = x["cost"]["median"];
  const double error = x["error"]["worst"];
  const bool is_as_good = cost <= y["cost"]["median"] && error <= y["error"]["worst"];
  return is_as_good && (cost < y["cost"]["median"] || error < y["error"]["worst"]);
}

/// All rows are on the front that no other beats.
bool is_judged(const Json& table) {
  const Json& rows = table["designs"];
  return std::all_of(rows.begin(), rows.end(), [&rows](const Json& row) {
    const bool is_beaten = std::any_of(rows.begin(), rows.end(),
                                       [&row](const Json& other) { return beats(other, row); });
    return row["front"] == !is_beaten;
  });
}

}  // namespace

TEST_CASE_METHOD(TradeoffShards, "designs of all shards are one table, of which one is chosen") {
  const Json one = table("simple_pendulum.toml");
  prepare("elgen tradeoff --shard 2/2 -o b.json simple_pendulum.toml", path());
  prepare("elgen tradeoff --shard 1/2 -o a.json simple_pendulum.toml", path());
  CHECK(file("a.json")["table"]["rows"].size() == 5);
  CHECK(file("b.json")["table"]["rows"].size() == 5);
  prepare("mv simple_pendulum.toml moved.toml", path());  // the shards have all
  const Json all = table("--merge b.json a.json --max-error 1 --write-scene fast.scene.toml");
  CHECK(errors_in(all) == errors_in(one));
  CHECK(is_judged(all));
  for (const char* key : {"model", "subject", "cost", "error", "compiler", "processor"}) {
    CHECK(all[key] == one[key]);
  }
  CHECK(all["sentences"].size() == one["sentences"].size());
  prepare("mv moved.toml simple_pendulum.toml", path());
  CHECK(shell("elgen verify --quick fast.scene.toml", path()).status == 0);
}

TEST_CASE_METHOD(TradeoffShards, "runs of all shards are one table, with what is said of methods") {
  prepare("cp " ELGEN_SOURCE_DIR "/models/double_pendulum.toml .", path());
  const std::string runs = "--trajectory 0.5 double_pendulum.toml";
  const Json one = table(runs);
  for (const char* shard : {"1", "2", "3"}) {
    prepare(std::string("elgen tradeoff --shard ") + shard + "/3 -o " + shard + ".json " + runs,
            path());
  }
  const Json all = table("--merge 1.json 2.json 3.json");
  CHECK(errors_in(all) == errors_in(one));
  CHECK(is_judged(all));
  CHECK(all["sentences"].size() == one["sentences"].size());
  CHECK(all["sentences"].back() == one["sentences"].back());
  const Outcome scene =
      run("--merge 1.json 2.json 3.json --max-error 1 --write-scene x.scene.toml");
  CHECK(scene.status == 2);
  CHECK(mentions(scene.errors, "error[E913]: shards of runs have no designs to write as scenes\n"));
}

TEST_CASE_METHOD(TradeoffShards, "of more shards than libraries some are empty") {
  prepare("elgen tradeoff --shard 5/5 -o a.json simple_pendulum.toml", path());
  CHECK(file("a.json")["table"]["rows"].empty());
}

TEST_CASE_METHOD(TradeoffShards,
                 "rows are joined on any machine, failures and infinite errors too") {
  prepare("elgen tradeoff --shard 5/5 -o a.json simple_pendulum.toml", path());
  Json shard = file("a.json");
  shard["machine"]["processor"] = "Z80";
  const auto write = [&](const std::string& name, int number, const char* row) {
    shard["shard"] = {number, 3};
    shard["table"]["rows"] = Json::array({Json::parse(row)});
    write_text(path() / name, shard.dump());
  };
  write("a.json", 1,
        R"({"number": 9, "values": ["double", "1", "full", "fixed"], "failure": "E705: refused"})");
  write("b.json", 2,
        R"({"number": 3, "values": ["float", "1", "full", "fixed"],
            "cost": [3.5, 3.25, 4], "error": [null, 0.1]})");
  write("c.json", 3,
        R"({"number": 1, "values": ["double", "packs", "full", "fixed"],
            "cost": [5, 4, 6], "error": [2e-16, 1e-17]})");
  const Outcome csv = run("--as csv --merge a.json b.json c.json");
  CHECK(csv.status == 0);
  CHECK(csv.output ==
        "scalar,batch,trigonometry,parameters,cost,cost_low,cost_high,worst_error,median_error,"
        "front,failure\n"
        "float,1,full,fixed,3.5,3.25,4,inf,0.1,1,\n"
        "double,packs,full,fixed,5,4,6,2e-16,1e-17,1,\n"
        "double,1,full,fixed,,,,,,0,E705: refused\n");
  CHECK(mentions(run("--merge a.json b.json c.json").output, "\nmeasured on Z80, "));
}

TEST_CASE_METHOD(TradeoffShards, "a measured shard is not written over another file") {
  write_text(path() / "a.json", "mine");
  const Outcome refused = run("--shard 1/2 -o a.json simple_pendulum.toml");
  CHECK(refused.status == 4);
  CHECK(mentions(refused.errors, "error[E703]: `a.json` exists"));
}

}  // namespace elgen::test
