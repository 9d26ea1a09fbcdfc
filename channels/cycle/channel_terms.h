// Words between a channel, the coordinator and the parts of both: what is asked for, what came of
// it, and where a channel writes what others read.
#pragma once

#include <cstdint>

#include "channels/contract/output.h"
#include "channels/messages/notice.h"
#include "channels/stores/event_book.h"
#include "channels/stores/live_tables.h"
#include "channels/stores/report_book.h"

namespace stanok::channels {

// What is loaded and run: a program, or one line of an operator (MDI).
enum class Job : std::uint8_t { program, line, search };

// How a run of the channel, a load, a switch came out; the coordinator reads and acts.
enum class Outcome : std::uint8_t { pending, succeeded, failed };

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
  const LiveTables* tables = nullptr;
};

}  // namespace stanok::channels
