// Notice: what the cycle tells the preparation of its channel to do. One struct for each kind of
// notice; all plain data.
#pragma once

#include <cstdint>
#include <type_traits>
#include <variant>

#include "channels/contract/held_tap.h"
#include "channels/contract/operator_command.h"
#include "channels/contract/output.h"
#include "channels/contract/texts.h"
#include "lang/contract/changed_rows.h"
#include "lang/contract/command.h"
#include "motion/path/path.h"

namespace stanok::channels {

// What a request of the program came to: `code` and `text` say why `ok` is false.
struct ChannelAnswer {
  bool ok = true;
  bool raises = false;  // lang::Answer
  double value = 0.0;
  motion::Point probe_M{};  // of a probing move: where the probe changed
  bool left_path = false;   // the axes stand elsewhere than at the end of the path
  FixedText<8> code;
  ReasonText text;
};

// How a channel stands: what begins, begins from here.
struct Stand {
  std::int32_t scheme = 0;
  motion::Point axes_M{};
  ToolAtWork tool{};
  std::uint32_t situation = 0;  // that the cycle shows
  std::uint64_t tables = 0;     // number of the newest write of the tables
};

// What a run begins with.
struct RunStart {
  std::uint32_t run = 0;
  std::int32_t load = 0;         // number of the load whose program the channel has; 0: of none
  std::uint16_t block_skip = 0;  // levels that are skipped from now on
  Stand stand{};
};

// Compile a program.
struct ProgramLoad {
  std::int32_t number = 0;       // of this load
  std::int32_t load_in_use = 0;  // as RunStart::load
  ShortText program;
};

// Compile a line of an operator.
struct LineLoad {
  std::int32_t load_in_use = 0;  // as RunStart::load
  ShortText line;
};

// Find a block of the loaded program, where its next run begins.
struct BlockSearch {
  RunStart start;  // what a run would begin with now
  SearchWay way = SearchWay::calculated;
  std::int32_t passes = 1;  // the block is met for this many times
  ShortText target;         // of lang::search_target
};

// Begin a run of the loaded program, where it was searched for.
struct ProgramStart {
  RunStart start;
};

// Begin a run of the line that was compiled last.
struct LineStart {
  RunStart start;
};

// The open request of the program is done.
struct RequestAnswer {
  ChannelAnswer answer;
  std::uint16_t block_skip = 0;  // levels that are skipped from now on
  motion::Point axes_M{};        // where the axes stand
  std::uint64_t tables = 0;      // number of the newest write of the tables
};

// Forget run and path, then say so with the item ResetDone.
struct PathReset {
  Stand stand{};
};

// Nothing runs: say with the item Settled in which frame the channel stands. An operator has
// changed `rows` of the tables.
struct Settle {
  Stand stand{};
  lang::ChangedRows rows{};
};

// Go over to another kinematic scheme.
struct SchemeSwitch {
  std::int32_t scheme = 0;
  motion::Point axes_M{};     // where the axes stand
  lang::AxisSet enabled = 0;  // axes whose drives are on
};

// Bring a tap out of its hole, then say so with the item TapOutEnd.
struct TapOut {
  HeldTap tap;
  motion::Point axes_M{};  // where the axes stand
};

using Notice = std::variant<ProgramLoad, LineLoad, BlockSearch, ProgramStart, LineStart,
                            RequestAnswer, PathReset, Settle, SchemeSwitch, TapOut>;
static_assert(std::is_trivially_copyable_v<Notice>);

}  // namespace stanok::channels
