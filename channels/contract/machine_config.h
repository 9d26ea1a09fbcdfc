// The machine as channels sees it: axes, spindles, channels, schemes. Filled by config from the
// machine file.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/axis_index.h"
#include "base/numbered.h"
#include "channels/contract/entry_limits.h"
#include "kinematics/scheme.h"
#include "lang/contract/environment.h"
#include "motion/interpolation/automatic_feed.h"
#include "motion/path/path.h"
#include "motion/threads/position_controller.h"

namespace stanok::channels {

// What shows the home position of an axis; the index pulse of the encoder may make it finer.
enum class HomingSignal : std::uint8_t { home_switch, limit_switch, index_alone };

// How the axis finds its home position.
struct HomingConfig {
  int order = 0;          // ascending; equal numbers home together; 0: absolute encoder, no move
  double position = 0.0;  // reading of the axis at the switch or index pulse, mm or deg
  double velocity = 0.0;  // of the search, mm/s or deg/s; the sign is its direction
  double velocity_slow = 0.0;  // with which the switch or index pulse is met; > 0
  HomingSignal signal = HomingSignal::home_switch;
  bool index = false;  // the first index pulse behind the switch counts
};

// Where the position loop is closed: in the drive, or in the cycle by the position controller.
enum class FeedbackPlace { drive, cycle };

struct ControllerConfig {
  FeedbackPlace feedback = FeedbackPlace::drive;
  motion::ControllerGains gains;
  double demand_held_s =
      0.0;  // how long the drive keeps a demand: a poll of the bus, not below a cycle
};

struct AxisConfig {
  std::string name;           // machine-wide: "X", "X2", "C1"
  motion::AxisLimits limits;  // mm or deg per s^n
  bool rotary = false;
  double modulo_deg = 0.0;    // > 0: G90 takes the shortest way
  double start = 0.0;         // position at power-on of `simulate`
  double resolution = 0.001;  // one increment of the position code, mm or deg
  double kmv = 10000.0;       // velocity code = velocity in increments per cycle x kmv
  double following_error_max = 0.5;
  HomingConfig homing;
  ControllerConfig controller;
  double brake_s = 0.1;  // time the brake takes to close or open
  double power_s = 0.1;  // time the drive takes to take the axis over
};

struct SpindleConfig {
  int id = 1;
  double speed_min = 0.0;  // rev/min
  double speed_max = 0.0;
  double acceleration = 0.0;  // rev/min/s; 0 = at once
  bool wait_at_speed = true;
  double power_idle_w = 0.0;  // at speed_max, not cutting
  int encoder_pulses = 0;     // per revolution; 0: no encoder
  std::string axis;           // the axis it becomes after M902; empty: none
};

enum class OwnerFailure { hold, continue_run, reset };

struct ChannelConfig {
  int id = 1;
  std::string name;
  lang::ChannelKind kind = lang::ChannelKind::mill;
  AxisList<int> axes;              // indices into MachineConfig::axes
  std::vector<std::string> words;  // how programs call them, parallel to `axes`
  std::vector<int> spindles;
  int scheme = 0;                                 // active at power-on
  std::vector<kinematics::SchemeConfig> schemes;  // axis indices are channel-local
  double path_tolerance_mm = 0.01;
  double orientation_tolerance_deg = 0.05;
  double arc_radius_tolerance_mm = 0.01;
  lang::ToolMeasuring tool_measuring;
  OwnerFailure on_owner_failure = OwnerFailure::hold;
  int probe_input = -1;          // digital input that is on while the probe touches; -1: no probe
  std::vector<int> skip_inputs;  // those of G31 P2, P3 and P4
  std::vector<motion::AutomaticFeedConfig> automatic_feeds;  // at most one of each law
  bool force_control = false;                        // its master spindle has a power sensor for it
  std::map<std::string, std::string> codes;          // "G200" -> "cycles/groove.nc"
  std::map<std::string, std::string> address_alias;  // "E" -> "dS"
  std::string tool_change = "m6";                    // "m6" | "t_word"
  std::string t_format = "plain";                    // "plain" | "tool_edge" | "tool_offset"
  bool plain_corners = false;                        // A, C, R of G1 without a comma
  lang::TextRules rules;                             // of programs that do not say otherwise
};

// Tools and offsets at first start, and later the live tables.
struct ToolEdge {
  int number = 0;
  int edge = 1;
  std::string name;
  std::string kind = "flat";                            // flat, ball, ..., see tool_keys
  double length = 0.0, length_x = 0.0, length_y = 0.0;  // mm
  double radius = 0.0, corner_radius = 0.0;
  double wear_length = 0.0, wear_length_x = 0.0, wear_radius = 0.0, overhang = 0.0;
  double flute_length = 0.0, shank_diameter = 0.0, holder_diameter = 0.0, holder_length = 0.0;
  int orientation = 0;
  double angle_front = 0.0, angle_back = 0.0;  // deg
  double point_angle = 0.0, taper_angle = 0.0;
};

using AxisRow = std::map<std::string, double>;  // axis name -> mm or deg

struct TablesConfig {
  std::vector<ToolEdge> tools;             // see MachineConfig::unnamed_tools
  std::map<std::string, AxisRow> offsets;  // "G54" -> axes
  // channel id -> "G28", "G30 P2" to "G30 P4" -> axes, in M; absent values are zero
  std::map<int, std::map<std::string, AxisRow>> reference_points;
  // channel id -> number (500 to 999) -> common variable of the Fanuc dialect; absent: vacant
  std::map<int, std::map<int, double>> variables;
};

struct MachineConfig {
  std::string name;
  std::string file;  // machine file, for messages
  int cycle_us = 1000;
  double stop_time_max_s =
      0.0;  // of any stop, until power is removed; 0: by the limits of the axes
  double request_age_max_s = 0.5;  // of what begins motion, until the cycle takes it
  int retrace_memory_mb = 64;      // of each channel, for the path that lies behind
  bool first_run = false;          // rapid is limited until a program has run to its end once
  int catch_up_max = 3;            // periods without a cycle behind which the path still goes on
  NumberedList<AxisConfig> axes;
  std::vector<SpindleConfig> spindles;
  NumberedList<ChannelConfig> channels;  // ascending ids
  TablesConfig tables;
  // Tools 1 to 99 that no row names exist too, with length 0 and radius 0: where the machine file
  // has no table of tools. Else they are free places, for an operator to fill.
  bool unnamed_tools = true;
  bool tables_write_protected = false;  // against programs
  lang::ProgramBounds program_bounds;
  EntryLimits entry_limits;
  std::string program_encoding;  // of files that are not UTF-8; empty: unknown
};

}  // namespace stanok::channels
