#include "tests/support/machine/channel_bench.h"

namespace stanok::testing {
namespace {

motion::AxisLimits limits(bool linear) {
  return {.linear = linear,
          .position_min = -500.0,
          .position_max = 500.0,
          .velocity_max = bench_velocity_max,
          .acceleration_max = 1000.0,
          .jerk_max = 20000.0,
          .rapid_max = bench_velocity_max};
}

channels::AxisConstants axis(std::string_view name, bool linear) {
  channels::AxisConstants constants;
  constants.codes = {bench_resolution, 10000.0};
  constants.brake_s = 0.002;
  constants.power_s = 0.003;
  constants.name = {name};
  constants.demand_max = 1.2 * bench_velocity_max;
  constants.manual.name = {name};
  constants.manual.limits = limits(linear);
  return constants;
}

}  // namespace

channels::ChannelConstants bench_constants() {
  channels::ChannelConstants constants;
  constants.id = 4;
  constants.axis_count = 3;
  constants.cycle_s = bench_cycle_s;
  constants.axes[bench_x] = axis("X", true);
  constants.axes[bench_y] = axis("Y", true);
  constants.axes[bench_c] = axis("C", false);
  constants.machine_axis = {1, 0, 2};
  constants.start = {10.0, 20.0, 0.0};
  constants.spindles[0].speed_max = 6000.0;
  constants.spindles[0].acceleration = 60000.0;
  constants.spindles[0].axis = "C";
  constants.spindle_axis[0] = bench_c;
  constants.spindle_count = 1;
  return constants;
}

motion::MotionConfig bench_motion() {
  motion::MotionConfig config;
  config.axis_count = 3;
  config.axes[bench_x] = limits(true);
  config.axes[bench_y] = limits(true);
  config.axes[bench_c] = limits(false);
  config.geometry = {bench_x, bench_y, -1};
  config.cycle_s = bench_cycle_s;
  return config;
}

BenchSchemes bench_schemes() {
  kinematics::SchemeConfig both;
  both.type = "cartesian";
  both.axes = {bench_x, bench_y};
  both.linear = {bench_x, bench_y, -1};
  kinematics::SchemeConfig one;
  one.id = 1;
  one.type = "cartesian";
  one.axes = {bench_x};
  one.parking = {{.axis = bench_y, .position = 0.0}};
  one.linear = {bench_x, -1, -1};
  BenchSchemes schemes;
  schemes[0] = kinematics::make_scheme(both);
  schemes[1] = kinematics::make_scheme(one);
  return schemes;
}

std::vector<channels::AxisFeedback> bench_feedback(double x, double y, double c) {
  std::vector<channels::AxisFeedback> feedback(3);
  for (channels::AxisFeedback& drive : feedback) {
    drive.valid = true;
    drive.enabled = true;
    drive.referenced = true;
    drive.brake_closed = false;
  }
  of_axis(feedback, bench_x).position = x;
  of_axis(feedback, bench_y).position = y;
  of_axis(feedback, bench_c).position = c;
  return feedback;
}

channels::AxisFeedback& of_axis(std::vector<channels::AxisFeedback>& feedback, int axis) {
  const auto constants = bench_constants();
  const int place = constants.machine_axis[static_cast<std::size_t>(axis)];
  return feedback.at(static_cast<std::size_t>(place));
}

}  // namespace stanok::testing
