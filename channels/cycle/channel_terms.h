// Words between a channel, the coordinator and the parts of both: what is asked for, what came of
// it, and where a channel writes what others read.
#pragma once

#include <cstdint>

#include "channels/contract/output.h"
#include "channels/messages/item.h"
#include "channels/stores/event_book.h"
#include "channels/stores/report_book.h"

namespace stanok::channels {

enum class Switch : std::uint8_t { off, on };

// What is loaded and run: a program, or one line of an operator (MDI).
enum class Job : std::uint8_t { program, line, search };

// What a search computes on its way to a block; else the run begins with the default modal state.
enum class SearchWay : std::uint8_t { calculated, not_calculated };

// How a run of the channel, a load, a switch came out; the coordinator reads and acts.
enum class Outcome : std::uint8_t { pending, succeeded, failed };

// What a request of the program came to: `code` and `text` say why `ok` is false.
struct ChannelAnswer {
  bool ok = true;
  bool raises = false;  // lang::Answer
  double value = 0.0;
  motion::Point probe_M{};  // of a probing move
  bool left_path = false;   // the axes stand elsewhere than at the end of the path
  FixedText<8> code;
  ReasonText text;
};

// The latest alarm of a channel.
struct ChannelAlarm {
  std::uint32_t run = 0;
  std::uint32_t line = 0;
  FixedText<8> code;
  FileName file;
};

// Where events, alarms and run records go; owned by the machine.
struct CycleBooks {
  EventBook* events = nullptr;
  ReportBook* reports = nullptr;
  Signals* outputs = nullptr;
  const Signals* inputs = nullptr;  // of this cycle
};

}  // namespace stanok::channels
