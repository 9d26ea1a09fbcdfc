// The axes of a channel with their drives and their motion, by hand, for tests of what moves them.
#pragma once

#include "channels/axes/axis_motion.h"
#include "tests/support/machine/channel_bench.h"

namespace stanok::testing {

struct MotionBench {
  explicit MotionBench(const channels::ChannelConstants& made = bench_constants())
      : constants(made) {}

  motion::MotionConfig config = bench_motion();
  channels::ChannelConstants constants;

 private:
  BenchSchemes made_ = bench_schemes();

 public:
  channels::SchemeTable schemes{made_, 0};
  channels::AxisGroup axes{constants};
  channels::DriveGuard drives{constants, axes};
  motion::PathQueue queue;
  channels::AxisMotion motion{config, constants, schemes, axes, drives};
};

}  // namespace stanok::testing
