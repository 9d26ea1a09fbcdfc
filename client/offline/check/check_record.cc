#include "client/offline/check/check_record.h"

#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>

#include "client/offline/library/diagnostic_record.h"
#include "client/offline/library/record.h"

namespace stanok::client {
namespace {

using nlohmann::json;

json optional_record(const std::optional<double>& value) {
  return value ? json(*value) : json(nullptr);
}

std::optional<double> optional_of(const json& record) {
  return record.is_null() ? std::nullopt : std::optional(record.get<double>());
}

json estimate_record(const motion::LawEstimate& estimate) {
  json cycle = nullptr;
  if (estimate.cycle) {
    cycle = {estimate.cycle->exact, optional_record(estimate.cycle->printed),
             optional_record(estimate.cycle->corrected)};
  }
  return {estimate.increments,
          estimate.feed_first,
          estimate.feed_last,
          estimate.time_s,
          optional_record(estimate.closed_form_s),
          std::move(cycle),
          optional_record(estimate.duration_rev),
          optional_record(estimate.spacing_rev),
          optional_record(estimate.modulation_depth)};
}

motion::LawEstimate estimate_of(const json& record) {
  motion::LawEstimate estimate;
  estimate.increments = record.at(0);
  estimate.feed_first = record.at(1);
  estimate.feed_last = record.at(2);
  estimate.time_s = record.at(3);
  estimate.closed_form_s = optional_of(record.at(4));
  if (const json& cycle = record.at(5); !cycle.is_null())
    estimate.cycle = motion::TimeForms{.exact = cycle.at(0),
                                       .printed = optional_of(cycle.at(1)),
                                       .corrected = optional_of(cycle.at(2))};
  estimate.duration_rev = optional_of(record.at(6));
  estimate.spacing_rev = optional_of(record.at(7));
  estimate.modulation_depth = optional_of(record.at(8));
  return estimate;
}

json law_record(const jobs::LawBlock& law) {
  return {{"file", law.place.file},
          {"line", law.place.line},
          {"kind", static_cast<int>(law.kind)},
          {"per_revolution", law.units.per_revolution},
          {"speed", static_cast<int>(law.units.speed)},
          {"path_mm", law.path_mm},
          {"estimate", estimate_record(law.estimate)},
          {"time_is_least", law.time_is_least}};
}

jobs::LawBlock law_of(const json& record) {
  jobs::LawBlock law;
  law.place.file = record.at("file");
  law.place.line = record.at("line");
  law.kind = static_cast<motion::LawKind>(record.at("kind").get<int>());
  law.units.per_revolution = record.at("per_revolution");
  law.units.speed = static_cast<motion::LawSpeed>(record.at("speed").get<int>());
  law.path_mm = record.at("path_mm");
  law.estimate = estimate_of(record.at("estimate"));
  law.time_is_least = record.at("time_is_least");
  return law;
}

json angles_record(const std::vector<RotaryAngle>& axes) {
  json record = json::array();
  for (const RotaryAngle& axis : axes) record.push_back(json::array({axis.word, axis.deg}));
  return record;
}

std::vector<RotaryAngle> angles_of(const json& record) {
  std::vector<RotaryAngle> axes;
  for (const json& axis : record) axes.push_back({axis.at(0), axis.at(1)});
  return axes;
}

json plane_record(const PlanePosition& plane) {
  json other = nullptr;
  if (plane.other) {
    other = {plane.other->word, angles_record(plane.other->axes),
             optional_record(plane.other->limit_deg)};
  }
  return {{"file", plane.place.file},
          {"line", plane.place.line},
          {"tool", plane.tool},
          {"axes", angles_record(plane.axes)},
          {"other", std::move(other)}};
}

PlanePosition plane_of(const json& record) {
  PlanePosition plane;
  plane.place.file = record.at("file");
  plane.place.line = record.at("line");
  plane.tool = record.at("tool").get<std::array<double, 3>>();
  plane.axes = angles_of(record.at("axes"));
  const json& other = record.at("other");
  if (other.is_null()) return plane;
  plane.other = {
      .word = other.at(0), .axes = angles_of(other.at(1)), .limit_deg = optional_of(other.at(2))};
  return plane;
}

}  // namespace

std::string check_record(const CheckedProgram& program) {
  json laws = json::array();
  for (const jobs::LawBlock& law : program.laws) laws.push_back(law_record(law));
  json planes = json::array();
  for (const PlanePosition& plane : program.planes) planes.push_back(plane_record(plane));
  return bytes_of({{"file", program.file},
                   {"diagnostics", diagnostics_record(program.diagnostics)},
                   {"blocks", program.blocks},
                   {"seconds", program.seconds},
                   {"laws", std::move(laws)},
                   {"planes", std::move(planes)}});
}

CheckedProgram checked_program(const std::string& bytes) {
  const json record = record_in(bytes).value_or(json());
  CheckedProgram program;
  program.file = record.at("file");
  program.diagnostics = diagnostics_of(record.at("diagnostics"));
  program.blocks = record.at("blocks");
  program.seconds = record.at("seconds");
  for (const json& law : record.at("laws")) program.laws.push_back(law_of(law));
  for (const json& plane : record.at("planes")) program.planes.push_back(plane_of(plane));
  return program;
}

std::vector<std::string> asked_of(const JobOptions& job) {
  std::vector<std::string> asked{"check", std::to_string(job.channel), std::to_string(job.steps),
                                 std::to_string(job.limit), job.program_root};
  asked.insert(asked.end(), job.schemes.begin(), job.schemes.end());
  return asked;
}

}  // namespace stanok::client
