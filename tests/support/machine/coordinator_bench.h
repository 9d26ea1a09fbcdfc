// Two channels side by side, without preparations, for tests of what the coordinator is made of.
//
// Channel 4 (index 0) and channel 7 (index 1) have axes of their own; both have power and are
// settled.
#pragma once

#include <memory>

#include "channels/coordinator/axis_ownership.h"
#include "channels/coordinator/channel_table.h"
#include "channels/cycle/channel.h"
#include "tests/support/machine/channel_bench.h"

namespace stanok::testing {

class CoordinatorBench {
 public:
  CoordinatorBench() {
    for (channels::Channel* const channel : table.all()) {
      channel->power(channels::Power::on);
      channel->run.apply(channels::Change::loaded);
    }
    cycles(3);
  }

  // A cycle of both; their preparations do nothing but say how they stand.
  void cycle() {
    ++now_;
    for (std::size_t k = 0; k < links_.size(); ++k) {
      obey(links_[k]);
      channels::Channel& channel = table[static_cast<int>(k)];
      channel.see_arrivals();
      channel.watch_drives({});
      channel.advance(now_, channels::Period::present);
    }
  }
  void cycles(int count) {
    for (int k = 0; k < count; ++k) cycle();
  }
  [[nodiscard]] channels::ChannelLink& link(int index) {
    return links_[static_cast<std::size_t>(index)];
  }

  Signals inputs;

 private:
  static channels::ChannelConstants constants(int id, int first_axis) {
    channels::ChannelConstants made = bench_constants();
    made.id = id;
    made.machine_axis = {first_axis, first_axis + 1, first_axis + 2};
    return made;
  }
  static void obey(channels::ChannelLink& link) {
    for (std::size_t count = link.notices.size(); count > 0; --count) {
      channels::Notice notice;
      static_cast<void>(link.notices.pop(notice));
      if (std::holds_alternative<channels::PathReset>(notice)) {
        static_cast<void>(link.items.push({.content = channels::ResetDone{}}));
      } else if (std::holds_alternative<channels::Settle>(notice)) {
        static_cast<void>(link.items.push({.content = channels::Settled{}}));
      } else {
        static_cast<void>(link.notices.push(notice));  // for the test
      }
    }
  }

  channels::EventBook events_{256};
  channels::ReportBook reports_;
  Signals outputs_;
  channels::MachineConfig machine_;
  channels::LiveTables tables_{machine_};
  BenchSchemes schemes_ = bench_schemes();
  std::array<channels::ChannelLink, 2> links_;
  std::int64_t now_ = 0;
  channels::Channel first_{bench_motion(), constants(4, 0),
                           schemes_,       0,
                           links_[0],      {&events_, &reports_, &outputs_, &inputs, &tables_}};
  channels::Channel second_{bench_motion(), constants(7, 3),
                            schemes_,       0,
                            links_[1],      {&events_, &reports_, &outputs_, &inputs, &tables_}};
  std::array<channels::Channel*, 2> all_{&first_, &second_};

 public:
  channels::ChannelTable table{all_};
  channels::AxisOwnership ownership{all_};
};

}  // namespace stanok::testing
