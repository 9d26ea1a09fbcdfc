// The parts of a channel's cycle with the rings that a preparation would fill, for tests of one of
// them.
#pragma once

#include "channels/cycle/cycle_parts.h"
#include "tests/support/machine/channel_bench.h"

namespace stanok::testing {

class CycleBench {
 public:
  // `constants`: of the channel, where they differ from bench_constants().
  explicit CycleBench(const channels::ChannelConstants& constants = bench_constants())
      : parts(bench_motion(), constants, schemes_, 0, link,
              {&events, &reports, &outputs, &inputs, &tables}) {}

  // Power, a program and a run of it.
  void begin_run() {
    parts.run.apply(channels::Change::power_on);
    parts.run.apply(channels::Change::loaded);
    parts.axes.power(parts.axes.all());
    parts.run.begin_run();
  }
  // The path and the spindles for so many cycles.
  void cycles(int count) {
    for (int k = 0; k < count; ++k) {
      parts.runs.begin_cycle(parts.runs.cycle() + 1);
      parts.spindles.observe();
      static_cast<void>(parts.motion.advance(link.path, {}, 0, channels::SoftLimits::not_guarded));
      parts.spindles.turn();
    }
  }
  // The latest notice to the preparation; PathReset where there is none.
  [[nodiscard]] channels::Notice notice() {
    channels::Notice popped = channels::PathReset{};
    while (link.notices.pop(popped)) {
    }
    return popped;
  }
  [[nodiscard]] std::string event() {
    channels::Event popped;
    return events.events().pop(popped) ? std::string(popped.code.view()) : "none";
  }

  channels::ChannelLink link;
  channels::EventBook events{64};
  channels::ReportBook reports;
  Signals outputs;
  Signals inputs;
  channels::MachineConfig machine;
  channels::LiveTables tables{machine};

 private:
  BenchSchemes schemes_ = bench_schemes();

 public:
  channels::CycleParts parts;
};

}  // namespace stanok::testing
