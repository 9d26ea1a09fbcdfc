#include "client/offline/batch/batch_folder.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "client/offline/library/digest.h"
#include "client/offline/library/record.h"
#include "client/offline/library/whole_file.h"

namespace stanok::client {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::size_t name_digits = 16;  // of a digest: no two batches of a cluster share them

std::runtime_error unwritable(const fs::path& folder) {
  return std::runtime_error(folder.string() +
                            " cannot be written; check its permissions and the space of the disk");
}

}  // namespace

BatchFolder::BatchFolder(const fs::path& folder)
    : folder_(fs::weakly_canonical(fs::absolute(folder))) {}

void BatchFolder::lay_down(const BatchPlan& plan) {
  const std::string record = plan_record(plan);
  const std::string there = bytes_in(folder_ / "plan");
  if (there == record) return;
  if (!there.empty()) {
    throw std::runtime_error(folder_.string() +
                             " holds another batch: its programs, options, machine file, working "
                             "directory or version of stanok differ; choose another folder, or "
                             "delete this one if its results are no longer needed");
  }
  std::error_code error;
  for (const char* kind : {"results", "faults", "log"})
    fs::create_directories(folder_ / kind, error);
  if (!write_whole(folder_ / "plan", record)) throw unwritable(folder_);
}

BatchPlan BatchFolder::plan() const {
  const std::string bytes = bytes_in(folder_ / "plan");
  if (bytes.empty()) {
    throw std::runtime_error("there is no batch in " + folder_.string() +
                             "; name the folder that `stanok batch submit --work` was given");
  }
  auto plan = plan_of(bytes);
  if (!plan) {
    throw std::runtime_error("the plan in " + folder_.string() +
                             " is damaged, or of another version of stanok; submit the batch to a "
                             "new folder");
  }
  return std::move(*plan);
}

// A plan of many programs is long, and never changes.
const std::string& BatchFolder::plan_digest() const {
  if (plan_digest_.empty()) plan_digest_ = digest_of(bytes_in(folder_ / "plan"));
  return plan_digest_;
}

std::string BatchFolder::name() const {
  const std::string digest = Digest().add(folder_.string()).add(plan_digest()).text();
  return "stanok-" + digest.substr(0, name_digits);
}

fs::path BatchFolder::place(const char* kind, std::size_t chunk) const {
  return folder_ / kind / fmt::format("{:06}", chunk);
}

std::optional<std::vector<PieceResult>> BatchFolder::results(std::size_t chunk) const {
  const auto kept = record_in(bytes_in(place("results", chunk)));
  if (!kept) return std::nullopt;
  try {
    const auto bytes = kept->at("results").get<std::string>();
    if (kept->at("plan") != plan_digest() || kept->at("digest") != digest_of(bytes))
      return std::nullopt;
    const auto records = record_in(bytes);
    if (!records) return std::nullopt;
    std::vector<PieceResult> results;
    for (const json& record : *records) results.push_back({record.at(0), record.at(1)});
    return results;
  } catch (const json::exception&) {
    return std::nullopt;
  }
}

bool BatchFolder::keep(std::size_t chunk, const std::vector<PieceResult>& results) const {
  json records = json::array();
  for (const PieceResult& result : results)
    records.push_back(json::array({result.bytes, result.death}));
  const std::string bytes = bytes_of(records);
  const json record{{"plan", plan_digest()}, {"digest", digest_of(bytes)}, {"results", bytes}};
  if (!write_whole(place("results", chunk), bytes_of(record))) return false;
  forget_fault(chunk);
  return true;
}

void BatchFolder::note_fault(std::size_t chunk, std::string_view text) const {
  // Where not even this can be written, the chunk is told as lost.
  static_cast<void>(write_whole(place("faults", chunk), text));
}

void BatchFolder::forget_fault(std::size_t chunk) const {
  std::error_code ignored;
  fs::remove(place("faults", chunk), ignored);
}

std::string BatchFolder::fault(std::size_t chunk) const {
  return bytes_in(place("faults", chunk));
}

Engine BatchFolder::engine() const {
  const auto record = record_in(bytes_in(folder_ / "engine"));
  if (!record) return {};
  return {record->value("slurm", false) ? EngineKind::slurm : EngineKind::local,
          record->value("options", std::vector<std::string>())};
}

void BatchFolder::choose(const Engine& engine) const {
  const json record{{"slurm", engine.kind == EngineKind::slurm}, {"options", engine.options}};
  if (!write_whole(folder_ / "engine", bytes_of(record))) throw unwritable(folder_);
}

bool BatchFolder::is_cancelled() const {
  std::error_code ignored;
  return fs::exists(folder_ / "cancelled", ignored);
}

void BatchFolder::cancel() const {
  if (!write_whole(folder_ / "cancelled", "")) throw unwritable(folder_);
}

void BatchFolder::allow() const {
  std::error_code error;
  fs::remove(folder_ / "cancelled", error);
  if (error) throw unwritable(folder_);
}

}  // namespace stanok::client
