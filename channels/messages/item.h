// Items, riders and remarks: what travels from a channel's preparation to its part of the cycle,
// apart from the path itself.
//
// Items come in program order with the path (an item is due when the chunks before it are done and
// the axes stand); riders and remarks travel with the path without stopping it. All plain data.
#pragma once

#include <cstdint>
#include <type_traits>
#include <variant>

#include "channels/contract/output.h"
#include "channels/contract/texts.h"
#include "channels/messages/request.h"
#include "lang/contract/command.h"
#include "motion/path/path.h"

namespace stanok::channels {

// A program or a line was compiled, or a block found.
struct LoadDone {
  bool succeeded = false;
  std::int32_t number = 0;   // of the load of a program; 0: of none
  ShortText text{};          // the name of what was loaded, or why it was not
  std::uint64_t digest = 0;  // of the texts of the program
};

// How the channel stands where nothing runs any more: the transform in which the programmed point
// is shown, and from which the next line begins; nullptr: as before.
struct Rest {
  const kinematics::Transform* transform = nullptr;
  std::uint32_t situation = 0;
};

// The program came to its end.
struct RunEnd {
  std::uint64_t blocks = 0;  // that it executed
  bool is_restart = false;   // by M99, where a simulation ends
  Rest rest{};
};

// A line of an operator came to its end.
struct LineEnd {
  std::uint64_t blocks = 0;  // that it executed
  Rest rest{};
};

struct RunFailed {
  std::uint64_t blocks = 0;  // that it executed
  FixedText<8> code{};
  ShortText text{};
  Rest rest{};
};

// The preparation cannot go on, whatever path comes before.
struct BrokenOff {
  FixedText<8> code{};
  ShortText text{};
};

// Everything that was pushed before belongs to a run that a reset has ended.
struct ResetDone {
  Rest rest{};
};

// The answer to Settle.
struct Settled {
  Rest rest{};
};

// The transform holds from here on, and the path goes on from its point `start`.
struct TransformSet {
  const kinematics::Transform* transform = nullptr;
  motion::Point start{};  // of the path in it
};

// The move behind it ends where the probe changes.
struct ProbeBegin {
  int input = -1;  // digital, on while it touches
  bool until_contact = false;
  bool alarm_when_missed = false;
};

// A step of a switch of kinematics: brakes closed, then drives off; or drives on, then brakes open.
struct AxesStep {
  enum class Kind : std::uint8_t { park, join };
  Kind kind = Kind::park;
  lang::AxisSet axes = 0;
};

// The scheme is exchanged, with the TransformSet behind it.
struct SchemeChosen {
  std::int32_t scheme = 0;
};

// The switch of kinematics is complete.
struct SwitchDone {};

struct SwitchFailed {
  FixedText<8> code{};
  ShortText text{};
};

// The tap is out, or `code` and `text` say why it cannot be taken out.
struct TapOutEnd {
  FixedText<8> code{};
  ShortText text{};
};

// Those of lang are commands of the program that reach the cycle as they are. The preparation waits
// for the answer to a Request.
using ItemContent =
    std::variant<LoadDone, RunEnd, LineEnd, RunFailed, BrokenOff, ResetDone, Settled, TransformSet,
                 lang::Dwell, lang::SpindleCommand, lang::CuttingSpeedMode, lang::CoolantCommand,
                 lang::ToolChange, lang::OverrideControl, lang::ForceControl, lang::OutputCommand,
                 lang::MachineFunction, lang::ProgramStop, ProbeBegin, Request, AxesStep,
                 SchemeChosen, SwitchDone, SwitchFailed, TapOutEnd>;

struct Item {
  motion::BlockTag tag{};
  std::uint64_t after_chunk = 0;  // chunks of the channel that come before it
  std::uint64_t after_rider = 0;  // riders that come before it
  ItemContent content{};
};

namespace riders {

struct MarkChange {
  std::int32_t mark = 0;
  bool is_set = false;  // else it is cleared
};
// Stops the path where the partners are not there yet; all others never do.
struct SoftMark {
  std::int32_t mark = 0;
  std::uint32_t channels = 0;  // the partners: bit k: channel with id k
};
struct DigitalOutput {
  std::int32_t number = 0;
  bool is_on = false;
};
struct AnalogOutput {
  std::int32_t number = 0;
  double value = 0.0;
};

}  // namespace riders

// What travels with the path and takes effect where block `before_block` (or a later one) begins.
struct Rider {
  motion::BlockTag tag;
  std::uint64_t before_block = 0;
  std::variant<riders::MarkChange, riders::SoftMark, riders::DigitalOutput, riders::AnalogOutput>
      content{};
};

struct SpokenText {
  FixedText<8> code;  // of a warning; "" = a message
  ShortText text;
};

// A blank, and where the program has its zero: the frame W -> B where the blank is announced.
struct BlankNews {
  lang::WorkpieceShape shape;
  FixedText<lang::blank_path_max + 1> file;
  kinematics::Frame frame;
};

// Told to the outside where the block behind `tag` begins (or a later one); it never stops the
// path.
struct Remark {
  motion::BlockTag tag;
  std::variant<SpokenText, BlankNews, lang::WorkpiecePosition> news;
};

static_assert(std::is_trivially_copyable_v<Item> && std::is_trivially_copyable_v<Rider> &&
              std::is_trivially_copyable_v<Remark>);

}  // namespace stanok::channels
