// Fields sorted and joined to runs, runs paired to requests.
#include "drives/modbus/exchange_plan.h"

#include <algorithm>
#include <span>

namespace stanok::drives {
namespace {

// What one request carries at most: 121 registers written by function 23, 125 read by any.
constexpr int written_max = 121;
constexpr int read_max = 125;

std::vector<RegisterRun> runs_of(const RegisterMap& map, std::span<const FieldOfMap> fields,
                                 int gap_max, int count_max) {
  std::vector<RegisterRun> places;
  for (const FieldOfMap field : fields) {
    const RegisterField& placed = map.*field;
    if (placed.exists()) places.push_back({placed.address, placed.words});
  }
  std::ranges::sort(places, {}, &RegisterRun::first);
  std::vector<RegisterRun> runs;
  for (const RegisterRun& place : places) {
    if (!runs.empty() && place.first <= runs.back().end() + gap_max &&
        place.end() - runs.back().first <= count_max) {
      RegisterRun& run = runs.back();
      run.count = std::max(run.count, place.end() - run.first);
    } else {
      runs.push_back(place);
    }
  }
  return runs;
}

// Writes by function 6 have one register each.
std::vector<RegisterRun> single_registers(const std::vector<RegisterRun>& runs) {
  std::vector<RegisterRun> singles;
  for (const RegisterRun& run : runs) {
    for (int at = run.first; at < run.end(); ++at) singles.push_back({at, 1});
  }
  return singles;
}

bool holds(const RegisterRun& run, const RegisterField& field) {
  return field.exists() && field.address >= run.first && field.address < run.end();
}

std::vector<RegisterRun> written_runs(const AxisDriveConfig& drive, WriteOrder order) {
  std::vector<RegisterRun> runs = runs_of(drive.map, written_fields, 0, written_max);
  if (drive.requests == RequestStyle::write_single) runs = single_registers(runs);
  std::ranges::stable_partition(runs, [&](const RegisterRun& run) {
    const bool has_control_word = holds(run, drive.map.control_word);
    return order == WriteOrder::control_word_first ? has_control_word : !has_control_word;
  });
  return runs;
}

// The echo is read last.
std::vector<RegisterRun> read_runs(const AxisDriveConfig& drive) {
  std::vector<RegisterRun> runs = runs_of(drive.map, read_fields, drive.gap_max, read_max);
  std::ranges::stable_partition(
      runs, [&](const RegisterRun& run) { return !holds(run, drive.map.heartbeat_echo); });
  return runs;
}

void add_writes(std::span<const RegisterRun> runs, RequestStyle style,
                std::vector<ModbusRequest>& plan) {
  const Function function =
      style == RequestStyle::write_single ? Function::write_register : Function::write_registers;
  for (const RegisterRun& run : runs) plan.push_back({.function = function, .written = run});
}

void add_reads(std::span<const RegisterRun> runs, std::vector<ModbusRequest>& plan) {
  for (const RegisterRun& run : runs)
    plan.push_back({.function = Function::read_registers, .read = run});
}

}  // namespace

std::vector<ModbusRequest> exchange_plan(const AxisDriveConfig& drive, WriteOrder order) {
  const std::vector<RegisterRun> writes = written_runs(drive, order);
  const std::vector<RegisterRun> reads = read_runs(drive);
  const std::span<const RegisterRun> written = writes;
  const std::span<const RegisterRun> read = reads;
  const bool pairs_up = drive.requests == RequestStyle::write_and_read;
  const std::size_t pairs = pairs_up ? std::min(written.size(), read.size()) : 0;
  const std::size_t alone = written.size() - pairs;
  std::vector<ModbusRequest> plan;
  add_writes(written.first(alone), drive.requests, plan);
  for (std::size_t k = 0; k < pairs; ++k) {
    plan.push_back({.function = Function::write_and_read_registers,
                    .written = written[alone + k],
                    .read = read[k]});
  }
  add_reads(read.subspan(pairs), plan);
  return plan;
}

std::vector<ModbusRequest> look_plan(const AxisDriveConfig& drive) {
  std::vector<ModbusRequest> plan;
  add_reads(read_runs(drive), plan);
  return plan;
}

}  // namespace stanok::drives
