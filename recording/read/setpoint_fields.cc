#include "recording/read/setpoint_fields.h"

#include <algorithm>

namespace stanok::recording {

const std::vector<SetpointField>& setpoint_fields() {
  static const std::vector<SetpointField> list{
      {"time_s", SetpointField::Time{}},
      {"cycle", &setpoint_t::cycle},
      {"seq", &setpoint_t::seq},
      {"state", &setpoint_t::state},
      {"flags", &setpoint_t::flags},
      {"run", &setpoint_t::run},
      {"file", &setpoint_t::file},
      {"line", &setpoint_t::line},
      {"block", &setpoint_t::block},
      {"scheme", &setpoint_t::scheme},
      {"feed_commanded", &setpoint_t::feed_commanded},
      {"path_speed", &setpoint_t::path_speed},
      {"feed_override", &setpoint_t::feed_override},
      {"tip_position", &setpoint_t::tip_position},
      {"tip_velocity", &setpoint_t::tip_velocity},
      {"position", &setpoint_t::position},
      {"velocity", &setpoint_t::velocity},
      {"acceleration", &setpoint_t::acceleration},
      {"jerk", &setpoint_t::jerk},
      {"position_code", &setpoint_t::position_code},
      {"velocity_code", &setpoint_t::velocity_code},
  };
  return list;
}

int axis_count_of(const setpoint_t& first) {
  return std::clamp<int>(first.axis_count, 0, 8);
}

}  // namespace stanok::recording
