// Errand: one wish on its way: a request of a program (channel_run, channel_wait, #kinematics, ...)
// or a command of an operator. It is stepped once a cycle until it is done.
#pragma once

#include <cstdint>

#include "channels/coordinator/wait_graph.h"
#include "channels/cycle/channel_terms.h"
#include "channels/messages/item.h"

namespace stanok::channels {

inline constexpr int operator_asker = -1;

struct Errand {
  bool active = false;
  std::uint64_t order = 0;       // in which errands came
  std::uint32_t generation = 0;  // of the target, when it was asked
  std::int32_t controller = 0;   // of the target, when it was asked
  int asker = operator_asker;    // index of the channel that asks
  std::uint64_t reply_id = 0;
  Job job = Job::program;
  lang::RequestKind kind = lang::RequestKind::sync;
  int target = -1;  // index of the channel concerned
  int number = 0;
  SearchWay way = SearchWay::calculated;
  std::int32_t passes = 1;  // of a search
  ChannelSet members = 0;   // mark_wait
  RequestData request;      // of a program
  double seconds = -1.0;
  int stage = 0;
  std::int64_t cycles = 0;  // since the errand, or its stage, began
  std::uint32_t awaited_run = 0;
  bool homes = false;         // of an operator: looks for the home switches of axes
  bool input_before = false;  // input_wait: the input in the cycle before
  motion::BlockTag tag;
  ShortText text;
};

}  // namespace stanok::channels
