#include "programs/generators/path_files.h"

#include <cstdint>
#include <cstdio>

namespace stanok::programs {
namespace {

struct Limits {
  const char* axis;
  double velocity;
  double acceleration;
  double jerk;
};

// Of the head-table milling machine of the workloads, mm or deg, per s, s^2, s^3.
constexpr std::array<Limits, coordinate_count> limits{{{"x", 400.0, 4000.0, 1e5},
                                                       {"y", 400.0, 4000.0, 1e5},
                                                       {"z", 400.0, 4000.0, 1e5},
                                                       {"b", 60.0, 600.0, 12000.0},
                                                       {"c", 120.0, 1200.0, 24000.0}}};

// Shortest of 15 and 17 digits that reads back to the same double.
std::string number(double value) {
  std::array<char, 40> text{};
  for (const int digits : {15, 17}) {
    std::snprintf(text.data(), text.size(), "%.*g", digits, value);
    if (std::strtod(text.data(), nullptr) == value) break;
  }
  return text.data();
}

enum class RowEnd : std::uint8_t { passes, stops };

void append_row(std::string& csv, const PathStep& step, std::size_t axis_count, RowEnd end) {
  for (std::size_t k = 0; k < axis_count; ++k) {
    csv.append(number(step.end[k])).push_back(',');
  }
  csv.append(number(step.feed_mm_per_s)).push_back(',');
  csv.append(std::to_string(step.shape)).push_back(',');
  csv.append(number(step.centre[0])).push_back(',');
  csv.append(number(step.centre[1])).append(end == RowEnd::stops ? ",1\n" : ",0\n");
}

}  // namespace

std::string path_csv(const Workload& workload, const BlockRange& range) {
  const std::size_t axis_count = workload.layout.axis_count;
  const std::vector<PathStep>& path = workload.program.path();
  std::string csv = axis_count == 5 ? "x,y,z,b,c,f,g,i,j,stop\n" : "x,y,z,f,g,i,j,stop\n";
  const PathStep* start = &path.front();
  for (const PathStep& step : path) {
    if (step.block < range.first) {
      start = &step;
      continue;
    }
    if (step.block > range.last) break;
    if (start != nullptr && step.block > 0) {
      append_row(csv, {.end = start->end, .feed_mm_per_s = step.feed_mm_per_s}, axis_count,
                 RowEnd::passes);
      start = nullptr;
    }
    if (step.block > 0)
      append_row(csv, step, axis_count, &step == &path.back() ? RowEnd::stops : RowEnd::passes);
  }
  return csv;
}

std::string limits_json(const Workload& workload) {
  std::string json = "{\"axes\": {";
  for (std::size_t k = 0; k < workload.layout.axis_count; ++k) {
    const Limits& axis = limits[k];
    if (k > 0) json.append(", ");
    json.append("\"").append(axis.axis).append("\": {\"v\": ").append(number(axis.velocity));
    json.append(", \"a\": ").append(number(axis.acceleration));
    json.append(", \"j\": ").append(number(axis.jerk)).append("}");
  }
  json.append("},\n \"tol\": 0.01, \"tol_axis\": {");
  if (workload.layout.axis_count == 5) json.append("\"b\": 0.05, \"c\": 0.05");
  return json.append("}}\n");
}

}  // namespace stanok::programs
