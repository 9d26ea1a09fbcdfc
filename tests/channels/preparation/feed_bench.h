// A PathFeed alone, on the machine of MachineBench, and a sink that remembers what comes out.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "channels/contract/motion_config.h"
#include "channels/preparation/path_feed.h"
#include "channels/preparation/preparation.h"
#include "tests/support/machine/machine_bench.h"

namespace stanok::channels {

class RememberingSink final : public FeedSink {
 public:
  explicit RememberingSink(FeedDepth depth) : depth_(depth) {}

  [[nodiscard]] FeedDepth depth() const override { return depth_; }
  void begin_command(const lang::Command& /*command*/) override { ++commands; }
  void take_motion(const lang::Command& /*command*/,
                   std::span<const motion::PathBlock> made) override {
    blocks.insert(blocks.end(), made.begin(), made.end());
  }
  void take_segment(const motion::PathBuilder::Built& /*built*/) override { events += 's'; }
  void take_thread(motion::ThreadChain&& /*chain*/) override { events += 't'; }
  void take_item(const Item& item) override {
    events += 'i';
    items.push_back(item);
  }
  void take_request(const motion::BlockTag& tag, const lang::ProgramRequest& /*request*/) override {
    take_item({.tag = tag, .content = Request()});
  }
  void take_rider(const Rider& rider) override {
    events += 'r';
    riders.push_back(rider);
  }
  void take_remark(const Remark& remark) override {
    events += 'n';
    remarks.push_back(remark);
  }

  int commands = 0;
  std::string events;  // s: segment, t: thread, i: item, r: rider, n: remark
  std::vector<motion::PathBlock> blocks;
  std::vector<Item> items;
  std::vector<Rider> riders;
  std::vector<Remark> remarks;

 private:
  FeedDepth depth_;
};

struct FeedBench {
  explicit FeedBench(FeedDepth depth = FeedDepth::path,
                     MachineConfig config = stanok::testing::two_channel_machine())
      : machine(std::move(config)), sink(depth), feed(machine, channel, motion, sink) {
    feed.blocks().restart(schemes.at(channel.scheme).get(), {});
    feed.give_transform();
    feed.begin_run(3);
    sink.items.clear();
    sink.events.clear();
  }

  Expected<Taken, Diagnostic> take(lang::Payload payload) {
    command.payload = std::move(payload);
    command.origin.line = static_cast<std::uint32_t>(++command.block);
    return feed.take(command);
  }
  static lang::Move line_to_x(double x) {
    lang::Move move;
    move.kind = lang::MoveKind::line;
    move.words = 1;
    move.end[0] = x;
    move.feed = 600.0;
    return move;
  }

  MachineConfig machine;
  const ChannelConfig& channel = machine.channels[0];
  motion::MotionConfig motion = motion_config(machine, channel);
  SchemeSet schemes = make_schemes(channel);
  RememberingSink sink;
  PathFeed feed;
  lang::Command command;
};

}  // namespace stanok::channels
