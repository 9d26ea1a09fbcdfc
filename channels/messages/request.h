// Request: what a program or an operator asks of the coordinator, and what is answered when it is
// done. One struct for each kind of request; all plain data.
//
// Channels are named by their ids, shared variables by the cell where they are kept.
#pragma once

#include <concepts>
#include <cstdint>
#include <type_traits>
#include <variant>

#include "channels/contract/operator_command.h"
#include "channels/contract/texts.h"
#include "lang/contract/command.h"

namespace stanok::channels {

namespace requests {

// Nothing but that the axes stand; the answer says where.
struct Standstill {};
// Whether the probe of the move before has changed, and where.
struct ProbeResult {};
// The interpreter ends the run with an alarm once it has the answer.
struct Terminate {};
// M99 in the main program: it begins again, or with a false answer ends.
struct ProgramRestart {};

struct ProgramLoad {
  std::int32_t channel = 0;
  ShortText program;
};
struct ProgramStart {
  std::int32_t channel = 0;
};
struct ProgramRun {
  std::int32_t channel = 0;
  ShortText program;
};
// Until the run that goes on there has ended.
struct EndWait {
  std::int32_t channel = 0;
  double seconds = -1.0;  // < 0: for ever
};
struct ProgramStop {
  std::int32_t channel = 0;
};
struct ProgramReset {
  std::int32_t channel = 0;
};
struct KinematicsSelect {
  std::int32_t channel = 0;
  std::int32_t scheme = 0;
};
struct StateRead {
  std::int32_t channel = 0;
};

struct MarkRead {
  std::int32_t channel = 0;
  std::int32_t mark = 0;
};
struct MarkWait {
  std::int32_t mark = 0;
  std::uint32_t channels = 0;  // bit k: channel with id k
};

// G30 P99: the tap that was left in its hole comes out.
struct TapOut {};

// M902, M903; 0: the master.
struct SpindleToAxis {
  std::int32_t spindle = 0;
};
struct AxisToSpindle {
  std::int32_t spindle = 0;
};

// A value of the tool table.
struct ToolRead {
  std::int32_t tool = 0;
  std::int32_t edge = 0;
  std::int32_t value = 0;  // ToolValue
};
struct ToolWrite {
  ToolRead place;
  double value = 0.0;
};
// A value of a table of work offsets.
struct OffsetRead {
  std::int32_t table = 0;
  std::int32_t offset = 0;  // 1 = G54
  std::int32_t axis = 0;    // of the channel; -1 (there is none) or lang::rotation_of_offset
};
struct OffsetWrite {
  OffsetRead place;
  double value = 0.0;
};

// A system variable.
struct MachineValueRead {
  ShortText name;
  std::int32_t index = 0;
};

// M66 of an analog input.
struct AnalogRead {
  std::int32_t input = 0;
};
// What a digital input is waited for; the numbers are those of L in M66.
enum class InputEvent : std::uint8_t { none, rise, fall, on, off };
// M66: a time without the event is answered with -1.
struct InputWait {
  std::int32_t input = 0;
  InputEvent event = InputEvent::none;
  double seconds = 0.0;
};

struct SharedNumberRead {
  std::int32_t cell = 0;
};
struct SharedNumberWrite {
  std::int32_t cell = 0;
  double value = 0.0;
};
// += and its like.
struct SharedNumberCombine {
  std::int32_t cell = 0;
  lang::Combination combination = lang::Combination::add;
  double operand = 0.0;
};
struct SharedTextRead {
  std::int32_t cell = 0;
};
struct SharedTextWrite {
  std::int32_t cell = 0;
  ShortText text;
};
struct SharedTextAppend {
  std::int32_t cell = 0;
  ShortText more;
};

// Of operators alone; the channel is that of their command.
struct LineRun {
  ShortText line;
};
// Of a block of the loaded program, which is met for this many times.
struct Search {
  ShortText target;  // of lang::search_target
  SearchWay way = SearchWay::calculated;
  std::int32_t passes = 1;
};
struct Home {
  ShortText axis;  // empty: all
};
struct ProgramReturn {
  double velocity = 0.0;  // along the way; 0: that of each axis's search
};

}  // namespace requests

// For those who take some of them.
template <class Kind, class... Kinds>
concept IsOneOf = (std::same_as<Kind, Kinds> || ...);

using Request = std::variant<
    requests::Standstill, requests::ProbeResult, requests::Terminate, requests::ProgramRestart,
    requests::ProgramLoad, requests::ProgramStart, requests::ProgramRun, requests::EndWait,
    requests::ProgramStop, requests::ProgramReset, requests::KinematicsSelect, requests::StateRead,
    requests::MarkRead, requests::MarkWait, requests::TapOut, requests::SpindleToAxis,
    requests::AxisToSpindle, requests::ToolRead, requests::ToolWrite, requests::OffsetRead,
    requests::OffsetWrite, requests::MachineValueRead, requests::AnalogRead, requests::InputWait,
    requests::SharedNumberRead, requests::SharedNumberWrite, requests::SharedNumberCombine,
    requests::SharedTextRead, requests::SharedTextWrite, requests::SharedTextAppend,
    requests::LineRun, requests::Search, requests::Home, requests::ProgramReturn>;
static_assert(std::is_trivially_copyable_v<Request>);

}  // namespace stanok::channels
