// Keys and checks of [[axis]] with its homing, controller and drive, and of [[spindle]].
#include "config/sections/axis_section.h"

#include <algorithm>
#include <cmath>

#include "config/sections/drive_section.h"
#include "config/sections/plant_section.h"

namespace stanok::config {
namespace {

using channels::AxisConfig;
using channels::ControllerConfig;
using channels::HomingConfig;
using channels::SpindleConfig;
using motion::AxisLimits;
using motion::ControllerGains;

// The keys as they stand in the file; what differs from the configs is translated below.
struct AxisFile {
  AxisConfig axis;
  std::string kind;
  Subtable homing = nullptr;
  Subtable controller = nullptr;
  Subtable drive = nullptr;
  Subtable plant = nullptr;
};

struct HomingFile {
  channels::HomingConfig homing;
  std::string home_switch = "switch";
};

struct ControllerFile {
  ControllerConfig controller;
  std::string feedback = "drive";
};

const Keys<AxisFile>& axis_keys() {
  static const Keys<AxisFile> keys = {
      {"name", at<&AxisFile::axis, &AxisConfig::name>, required, "",
       "name of the axis in the whole machine (X, X2, C1)"},
      {"kind", at<&AxisFile::kind>, required, "", "type of motion; the unit of rotary axes is deg",
       one_of({"linear", "rotary"})},
      {"min", at<&AxisFile::axis, &AxisConfig::limits, &AxisLimits::position_min>, optional,
       "mm, deg", "lower end of travel; a rotary axis may have no ends", any, "unlimited"},
      {"max", at<&AxisFile::axis, &AxisConfig::limits, &AxisLimits::position_max>, optional,
       "mm, deg", "upper end of travel", any, "unlimited"},
      {"start", at<&AxisFile::axis, &AxisConfig::start>, optional, "mm, deg",
       "position of the axis when a simulation begins, and when a daemon starts for the first "
       "time"},
      {"velocity_max", at<&AxisFile::axis, &AxisConfig::limits, &AxisLimits::velocity_max>,
       required, "mm/s, deg/s", "highest velocity", limit_of_motion},
      {"acceleration_max", at<&AxisFile::axis, &AxisConfig::limits, &AxisLimits::acceleration_max>,
       required, "mm/s2, deg/s2", "highest acceleration", limit_of_motion},
      {"jerk_max", at<&AxisFile::axis, &AxisConfig::limits, &AxisLimits::jerk_max>, required,
       "mm/s3, deg/s3", "highest jerk", limit_of_motion},
      {"rapid_max", at<&AxisFile::axis, &AxisConfig::limits, &AxisLimits::rapid_max>, optional,
       "mm/s, deg/s", "velocity of rapid moves", limit_of_motion, "velocity_max"},
      {"stop_limits", at<&AxisFile::axis, &AxisConfig::limits, &AxisLimits::stop_limits>, optional,
       "", "multiple of acceleration_max and jerk_max that a stop may use", from(1.0, 2.0),
       "that of [machine]"},
      {"resolution", at<&AxisFile::axis, &AxisConfig::resolution>, optional, "mm, deg",
       "one increment of the position code", positive},
      {"kmv", at<&AxisFile::axis, &AxisConfig::kmv>, optional, "",
       "velocity code = velocity in increments per cycle x kmv", from(1.0, 1e6)},
      {"following_error_max", at<&AxisFile::axis, &AxisConfig::following_error_max>, optional,
       "mm, deg", "distance between setpoint and feedback that stops the axis", positive},
      {"modulo", at<&AxisFile::axis, &AxisConfig::modulo_deg>, optional, "deg",
       "one turn of a rotary axis that takes the shortest way with G90; 0: the position counts on",
       not_negative},
      {"homing", at<&AxisFile::homing>, optional, "", "how the axis finds its home position"},
      {"position_controller",
       at<&AxisFile::controller>,
       optional,
       "",
       "gains, and where the position loop is closed",
       any,
       {},
       "regulator"},
      {"drive", at<&AxisFile::drive>, optional, "", "drive on the bus of [drives]"},
      {"plant", at<&AxisFile::plant>, optional, "",
       "mechanics of the simulated drive: encoder, switches, backlash, friction"},
  };
  return keys;
}

const Keys<HomingFile>& homing_keys() {
  static const Keys<HomingFile> keys = {
      {"order", at<&HomingFile::homing, &HomingConfig::order>, optional, "",
       "order of homing, ascending; axes with the same number home together; 0: absolute encoder, "
       "no move",
       from(0)},
      {"position", at<&HomingFile::homing, &HomingConfig::position>, optional, "mm, deg",
       "position of the axis at its home switch or index pulse"},
      {"velocity", at<&HomingFile::homing, &HomingConfig::velocity>, optional, "mm/s, deg/s",
       "velocity of the search; its sign is the direction"},
      {"velocity_slow", at<&HomingFile::homing, &HomingConfig::velocity_slow>, optional,
       "mm/s, deg/s", "velocity of the approach to the switch or index pulse", positive,
       "a tenth of velocity"},
      {"home_switch",
       at<&HomingFile::home_switch>,
       optional,
       "",
       "what ends the search: the home switch, the limit switch on that side or, for a rotary "
       "axis, the index pulse",
       one_of({"switch", "limit", "index"}),
       {},
       "mark"},
      {"index", at<&HomingFile::homing, &HomingConfig::index>, optional, "",
       "use the first index pulse of the encoder after the switch instead of the edge of the "
       "switch"},
  };
  return keys;
}

const Keys<ControllerFile>& controller_keys() {
  static const Keys<ControllerFile> keys = {
      {"feedback", at<&ControllerFile::feedback>, optional, "",
       "where the position loop is closed: in the drive or in the cycle of the control",
       one_of({"drive", "cycle"})},
      {"kp", at<&ControllerFile::controller, &ControllerConfig::gains, &ControllerGains::kp>,
       optional, "1/s", "gain of the following error", not_negative},
      {"kd", at<&ControllerFile::controller, &ControllerConfig::gains, &ControllerGains::kd>,
       optional, "1/s", "gain of the change of the following error in a cycle", not_negative},
      {"kint", at<&ControllerFile::controller, &ControllerConfig::gains, &ControllerGains::kint>,
       optional, "1/s", "gain of the sum of the following error over the cycles", not_negative},
      {"kv", at<&ControllerFile::controller, &ControllerConfig::gains, &ControllerGains::kv>,
       optional, "", "gain of the velocity setpoint", not_negative},
      {"ka", at<&ControllerFile::controller, &ControllerConfig::gains, &ControllerGains::ka>,
       optional, "s", "gain of the acceleration setpoint", not_negative},
      {"kr", at<&ControllerFile::controller, &ControllerConfig::gains, &ControllerGains::kr>,
       optional, "s2", "gain of the jerk setpoint", not_negative},
  };
  return keys;
}

struct SpindleFile {
  SpindleConfig spindle;
  Subtable drive = nullptr;
};

template <auto Member>
inline constexpr auto of_spindle = at<&SpindleFile::spindle, Member>;

const Keys<SpindleFile>& spindle_keys() {
  static const Keys<SpindleFile> keys = {
      {"id", of_spindle<&SpindleConfig::id>, required, "",
       "number by which programs call it ($1, M902 H1=1)", from(1, 16)},
      {"speed_max", of_spindle<&SpindleConfig::speed_max>, required, "rev/min", "highest speed",
       positive},
      {"speed_min", of_spindle<&SpindleConfig::speed_min>, optional, "rev/min", "lowest speed",
       not_negative},
      {"acceleration", of_spindle<&SpindleConfig::acceleration>, optional, "rev/min/s",
       "acceleration; 0: immediate", not_negative},
      {"wait_at_speed", of_spindle<&SpindleConfig::wait_at_speed>, optional, "",
       "whether a feed waits until the spindle is at speed"},
      {"power_idle", of_spindle<&SpindleConfig::power_idle_w>, optional, "W",
       "power at the highest speed without cutting", not_negative},
      {"encoder", of_spindle<&SpindleConfig::encoder_pulses>, optional, "",
       "pulses of its encoder per revolution; 0: no encoder", from(0)},
      {"axis", of_spindle<&SpindleConfig::axis>, optional, "",
       "name of the rotary [[axis]] it becomes after M902"},
      {"drive", at<&SpindleFile::drive>, optional, "",
       "its own drive on the bus of [drives]; same keys as [axis.drive]"},
  };
  return keys;
}

void check_name(const toml::table& table, const std::string& name, const Scope& scope) {
  if (name.empty() || is_axis_name(name)) return;
  scope.fault(
      place_of(table, "name"),
      "'" + name + "' is not an axis name; use A, B, C, U, V, W, X, Y or Z, then digits, as in X2");
}

void check_travel(const toml::table& table, const AxisConfig& axis, const Scope& scope) {
  const AxisLimits& limits = axis.limits;
  const bool has_min = table.contains("min");
  const bool has_max = table.contains("max");
  if (has_min != has_max) {
    scope.fault(
        place_of(table, has_min ? "min" : "max"),
        std::string(has_min ? "max" : "min") +
            " is missing; give both ends of travel, or neither for an unlimited rotary axis");
  } else if (!has_min && !axis.rotary) {
    scope.fault(table.source(),
                "keys 'min' and 'max' are missing; a linear axis has ends of travel");
  } else if (limits.position_min >= limits.position_max) {
    scope.fault(place_of(table, "min"), "min is " + number_text(limits.position_min) + ", max is " +
                                            number_text(limits.position_max) +
                                            "; min must be below max");
  } else if (axis.start < limits.position_min || axis.start > limits.position_max) {
    scope.fault(place_of(table, "start"),
                "start is " + number_text(axis.start) + "; it must lie between min and max");
  }
}

void check_limits(const toml::table& table, const AxisConfig& axis, const Scope& scope) {
  if (table.contains("rapid_max") && axis.limits.rapid_max > axis.limits.velocity_max) {
    scope.fault(place_of(table, "rapid_max"), "rapid_max is " + number_text(axis.limits.rapid_max) +
                                                  "; it must not exceed velocity_max, " +
                                                  number_text(axis.limits.velocity_max));
  }
  if (axis.modulo_deg > 0.0 && !axis.rotary) {
    scope.fault(place_of(table, "modulo"), "modulo is only for rotary axes; remove it");
  }
}

void check_homing(const toml::table& table, const AxisConfig& axis, const Scope& scope) {
  if (axis.homing.order > 0 && axis.homing.velocity == 0.0) {
    scope.fault(place_of(table, "velocity"),
                "velocity of the search is missing; an axis with an order above 0 moves to find "
                "its home position");
  }
  if (std::abs(axis.homing.velocity) > axis.limits.velocity_max) {
    scope.fault(place_of(table, "velocity"),
                "velocity exceeds velocity_max, " + number_text(axis.limits.velocity_max));
  }
  if (axis.homing.velocity != 0.0 && axis.homing.velocity_slow > std::abs(axis.homing.velocity)) {
    scope.fault(place_of(table, "velocity_slow"),
                "velocity_slow exceeds the velocity of the search, " +
                    number_text(std::abs(axis.homing.velocity)));
  }
}

// Distance in which an axis comes to rest from this velocity: the mean of a ramp of limited jerk is
// half of it.
double stopping_distance(double velocity, const motion::AxisLimits& limits) {
  const double a = limits.acceleration_max;
  const double j = limits.jerk_max;
  const double time = velocity * j >= a * a ? velocity / a + a / j : 2.0 * std::sqrt(velocity / j);
  return 0.5 * velocity * time;
}

// Behind the home switch, where the search meets it slowly; a limit switch is left again, fast and
// at least as far as the axis takes to stop.
void check_homing_end(const toml::table& table, const AxisConfig& axis, const Scope& scope) {
  const HomingConfig& homing = axis.homing;
  const bool leaves_switch = homing.signal == channels::HomingSignal::limit_switch;
  const double speed = leaves_switch ? std::abs(homing.velocity) : homing.velocity_slow;
  const double distance = stopping_distance(speed, axis.limits);
  const bool goes_up = (homing.velocity > 0.0) != leaves_switch;
  const double end = homing.position + (goes_up ? distance : -distance);
  const bool is_known = homing.order > 0 && homing.velocity != 0.0 && std::isfinite(distance) &&
                        std::abs(homing.velocity) <= axis.limits.velocity_max;
  if (!is_known) return;  // or a fault already
  if (end >= axis.limits.position_min && end <= axis.limits.position_max) return;
  scope.fault(place_of(table, "position"),
              "E7011 the homing ends at " + number_text(end) + ", outside the travel from " +
                  number_text(axis.limits.position_min) + " to " +
                  number_text(axis.limits.position_max) + ": no program could start there");
}

void read_homing(const toml::table& table, AxisConfig& axis, const Scope& scope) {
  constexpr double slow_usual = 0.1;  // of the velocity of the search
  HomingFile file;
  read_table(table, homing_keys(), file, scope);
  axis.homing = file.homing;
  if (file.home_switch == "limit") axis.homing.signal = channels::HomingSignal::limit_switch;
  if (file.home_switch == "index") axis.homing.signal = channels::HomingSignal::index_alone;
  if (!table.contains("velocity_slow"))
    axis.homing.velocity_slow = slow_usual * std::abs(axis.homing.velocity);
  check_homing(table, axis, scope);
  check_homing_end(table, axis, scope);
}

void read_controller(const toml::table& table, AxisConfig& axis, const Scope& scope) {
  ControllerFile file;
  read_table(table, controller_keys(), file, scope);
  axis.controller = file.controller;
  if (file.feedback != "cycle") return;
  axis.controller.feedback = channels::FeedbackPlace::cycle;
  if (axis.controller.gains.kp == 0.0) {
    scope.fault(place_of(table, "kp"),
                "kp is 0; a position loop that is closed in the cycle needs a gain above 0");
  }
}

void read_drive_of(const AxisFile& file, int place, AxisSection& section, const Scope& scope) {
  AxisConfig& axis = section.axis;
  const bool in_cycle = axis.controller.feedback == channels::FeedbackPlace::cycle;
  DriveSection drive{
      .drive = {.axis = axis.name,
                .unit = place,
                .kind = in_cycle ? drives::DriveKind::velocity : drives::DriveKind::position,
                .absolute_encoder = axis.homing.order == 0,
                .following_error_max = axis.following_error_max,
                .velocity_max = axis.limits.velocity_max,
                .acceleration_max = axis.limits.acceleration_max},
      .brake_s = axis.brake_s,
      .power_s = axis.power_s};
  if (file.drive != nullptr) read_drive(*file.drive, DriveLoad::axis, drive, scope.inner("drive"));
  section.drive = drive.drive;
  axis.brake_s = drive.brake_s;
  axis.power_s = drive.power_s;
}

AxisSection read_axis(const toml::table& table, int place, const Scope& scope) {
  AxisFile file;
  read_table(table, axis_keys(), file, scope);
  AxisSection section{.axis = file.axis, .drive = {}, .plant = {}};
  AxisConfig& axis = section.axis;
  axis.rotary = file.kind == "rotary";
  axis.limits.linear = !axis.rotary;
  check_name(table, axis.name, scope);
  check_travel(table, axis, scope);
  check_limits(table, axis, scope);
  axis.limits.rapid_max = std::min(axis.limits.rapid_max, axis.limits.velocity_max);
  if (file.homing != nullptr) {
    read_homing(*file.homing, axis, scope.inner("homing"));
  }
  if (file.controller != nullptr)
    read_controller(*file.controller, axis, scope.inner("position_controller"));
  read_drive_of(file, place, section, scope);
  if (file.plant != nullptr) section.plant = read_axis_plant(*file.plant, scope.inner("plant"));
  return section;
}

drives::AxisDriveConfig read_spindle_drive(const toml::table& table, const SpindleConfig& spindle,
                                           const Scope& scope) {
  constexpr int first_unit = 200;
  DriveSection section{.drive = {.axis = "S" + std::to_string(spindle.id),
                                 .spindle = spindle.id,
                                 .unit = first_unit + spindle.id,
                                 .kind = drives::DriveKind::velocity,
                                 .velocity_max = spindle.speed_max}};
  read_drive(table, DriveLoad::spindle, section, scope);
  return section.drive;
}

SpindleSection read_spindle(const toml::table& table, const std::vector<AxisSection>& axes,
                            const Scope& scope) {
  SpindleFile file;
  read_table(table, spindle_keys(), file, scope);
  SpindleSection section{.spindle = file.spindle, .drive = {}};
  const SpindleConfig& spindle = section.spindle;
  if (spindle.speed_min > spindle.speed_max) {
    scope.fault(place_of(table, "speed_min"),
                "speed_min exceeds speed_max, " + number_text(spindle.speed_max));
  }
  const auto axis =
      std::ranges::find(axes, spindle.axis, [](const AxisSection& one) { return one.axis.name; });
  if (!spindle.axis.empty() && (axis == axes.end() || !axis->axis.rotary)) {
    scope.fault(place_of(table, "axis"),
                "'" + spindle.axis +
                    "' is not a rotary axis of the machine; write the name of an [[axis]]");
  }
  if (file.drive != nullptr && !spindle.axis.empty()) {
    scope.fault(place_of(table, "drive"), "the spindle is axis " + spindle.axis +
                                              ", whose drive turns it; remove one of the two");
  } else if (file.drive != nullptr) {
    section.drive = read_spindle_drive(*file.drive, spindle, scope.inner("drive"));
  }
  return section;
}

}  // namespace

bool names_are_right(const std::vector<AxisSection>& axes) {
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (!is_axis_name(axes[i].axis.name)) return false;
    for (std::size_t earlier = 0; earlier < i; ++earlier) {
      if (axes[earlier].axis.name == axes[i].axis.name) return false;
    }
  }
  return true;
}

bool is_axis_name(std::string_view name) {
  constexpr std::string_view letters = "ABCUVWXYZ";
  constexpr std::string_view digits = "0123456789";
  return !name.empty() && letters.find(name[0]) != std::string_view::npos &&
         name.find_first_not_of(digits, 1) == std::string_view::npos;
}

std::vector<AxisSection> read_axes(Subtables axes, const Scope& scope) {
  std::vector<AxisSection> sections;
  if (axes == nullptr) return sections;
  for (const toml::node& node : *axes) {
    const toml::table& table = *node.as_table();
    const std::string name = table["name"].value_or(std::to_string(sections.size() + 1));
    const Scope inner{scope.faults, "axis " + name};
    AxisSection section = read_axis(table, static_cast<int>(sections.size()) + 1, inner);
    const bool is_known = std::ranges::any_of(sections, [&](const AxisSection& other) {
      return !section.axis.name.empty() && other.axis.name == section.axis.name;
    });
    if (is_known) {
      inner.fault(place_of(table, "name"), "the name is taken; every axis needs its own");
    }
    sections.push_back(std::move(section));
  }
  if (sections.size() > 64) {
    scope.fault(axes->get(64)->source(), "more than 64 axes; a machine has at most 64");
  }
  return sections;
}

std::vector<SpindleSection> read_spindles(Subtables spindles, const std::vector<AxisSection>& axes,
                                          const Scope& scope) {
  std::vector<SpindleSection> sections;
  if (spindles == nullptr) return sections;
  for (const toml::node& node : *spindles) {
    const toml::table& table = *node.as_table();
    const Scope inner{scope.faults, "spindle " + std::to_string(table["id"].value_or(0))};
    SpindleSection section = read_spindle(table, axes, inner);
    const bool is_known = std::ranges::any_of(sections, [&](const SpindleSection& other) {
      return other.spindle.id == section.spindle.id;
    });
    if (is_known)
      inner.fault(place_of(table, "id"), "the id is taken; every spindle needs its own");
    sections.push_back(std::move(section));
  }
  return sections;
}

std::vector<KeyRow> axis_key_rows() {
  return describe(axis_keys());
}
std::vector<KeyRow> homing_key_rows() {
  return describe(homing_keys());
}
std::vector<KeyRow> controller_key_rows() {
  return describe(controller_keys());
}
std::vector<KeyRow> spindle_key_rows() {
  return describe(spindle_keys());
}

}  // namespace stanok::config
