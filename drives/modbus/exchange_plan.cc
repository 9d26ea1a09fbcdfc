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

void add_single_writes(const std::vector<RegisterRun>& runs, std::vector<Request>& plan) {
  for (const RegisterRun& run : runs) {
    for (int at = run.first; at < run.end(); ++at)
      plan.push_back({.function = Function::write_register, .written = {at, 1}});
  }
}

// The last of both runs go together, so that the last read follows every write.
void add_pairs(std::vector<RegisterRun> written, std::vector<RegisterRun> read,
               std::vector<Request>& plan) {
  const std::size_t pairs = std::min(written.size(), read.size());
  for (std::size_t k = 0; k + pairs < written.size(); ++k)
    plan.push_back({.function = Function::write_registers, .written = written[k]});
  for (std::size_t k = 0; k + pairs < read.size(); ++k)
    plan.push_back({.function = Function::read_registers, .read = read[k]});
  for (std::size_t k = pairs; k > 0; --k) {
    plan.push_back({.function = Function::write_and_read_registers,
                    .written = written[written.size() - k],
                    .read = read[read.size() - k]});
  }
}

}  // namespace

std::vector<Request> exchange_plan(const AxisDriveConfig& drive) {
  const std::vector<RegisterRun> written = runs_of(drive.map, written_fields, 0, written_max);
  const std::vector<RegisterRun> read = runs_of(drive.map, read_fields, drive.gap_max, read_max);
  std::vector<Request> plan;
  if (drive.requests == RequestStyle::write_and_read) {
    add_pairs(written, read, plan);
    return plan;
  }
  if (drive.requests == RequestStyle::write_single) {
    add_single_writes(written, plan);
  } else {
    for (const RegisterRun& run : written)
      plan.push_back({.function = Function::write_registers, .written = run});
  }
  for (const RegisterRun& run : read)
    plan.push_back({.function = Function::read_registers, .read = run});
  return plan;
}

}  // namespace stanok::drives
