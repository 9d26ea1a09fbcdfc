#include "daemon/report/part_json.h"

#include <cmath>

namespace stanok::daemon {
namespace {

using nlohmann::json;

// What a picture does not show is no change.
constexpr double steps_per_mm = 1e5;
constexpr double steps_of_direction = 1e7;

double rounded(double value, double steps) {
  return std::round(value * steps) / steps + 0.0;
}

json rounded_vector(const simulation::Vector& vector, double steps) {
  return {rounded(vector.x(), steps), rounded(vector.y(), steps), rounded(vector.z(), steps)};
}

json pose_json(const simulation::Pose& pose) {
  json numbers = json::array();
  for (Eigen::Index row = 0; row < 3; ++row) {
    for (Eigen::Index column = 0; column < 3; ++column)
      numbers.push_back(rounded(pose.linear()(row, column), steps_of_direction));
    numbers.push_back(rounded(pose.translation()[row], steps_per_mm));
  }
  return numbers;
}

}  // namespace

json carried_json(int scheme, const simulation::Pose& in_base) {
  return {{"scheme", scheme}, {"pose", pose_json(in_base)}};
}

json on_part_json(const simulation::ToolPlace& tool, const std::optional<simulation::Pose>& work,
                  const std::optional<simulation::Pose>& machine) {
  return {{"tip", rounded_vector(tool.tip, steps_per_mm)},
          {"direction", rounded_vector(tool.axis, steps_of_direction)},
          {"work", work ? pose_json(*work) : json(nullptr)},
          {"machine", machine ? pose_json(*machine) : json(nullptr)}};
}

}  // namespace stanok::daemon
