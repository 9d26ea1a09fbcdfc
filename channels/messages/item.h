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
#include "channels/messages/texts.h"
#include "lang/contract/command.h"
#include "motion/path/path.h"

namespace stanok::channels {

enum class ItemKind : std::uint8_t {
  load_done,         // a program or line was compiled, a block found: flag = success, text = name,
                     // number = of the load
                     // or reason
  run_end,           // the program came to its end: number = blocks executed
  line_end,          // a line of an operator came to its end: number = blocks executed
  run_failed,        // the program failed: code, text
  broken_off,        // preparation cannot go on, whatever path comes before: code, text
  reset_done,        // everything pushed before belongs to an older generation
  transform,         // `transform` holds from here
  dwell,             // value = s
  spindle,           // spindle command
  cutting_speed,     // G96, G97
  coolant,           // mist, flood
  tool_change,       // number = tool, value = its edge
  override_control,  // M48 to M53
  force_control,     // #adaptive: force
  output,            // M64, M65, M68: number, value, flag = analog
  machine_function,  // M100 to M899: text
  program_stop,      // M0, M1, M60: number = lang::StopKind
  probe,             // the move behind it ends where the probe changes: flag = until contact,
                     // number = whether missing that is an alarm
  request,           // to the coordinator; preparation waits for the answer
  park_axes,         // axes = set: brakes closed, then drives off
  join_axes,         // axes = set: drives on, then brakes open
  scheme_set,        // number = scheme: the transformation is exchanged, with the next `transform`
  switch_done,       // the switch of kinematics is complete
  switch_failed,     // code, text
};

// A request of lang::Request as plain data.
struct RequestData {
  lang::RequestKind kind = lang::RequestKind::sync;
  std::int32_t channel = 0;
  std::int32_t number = 0;
  std::int32_t index = 0;
  bool analog = false;
  bool is_text = false;  // shared variables
  lang::Combination combination = lang::Combination::add;
  std::uint32_t channels = 0;  // bit k: channel with id k
  double seconds = -1.0;
  double value = 0.0;
};

struct Item {
  ItemKind kind = ItemKind::run_end;
  motion::BlockTag tag;
  std::uint64_t after_chunk = 0;  // chunks of the channel that come before it
  std::uint64_t after_rider = 0;  // riders that come before it
  bool flag = false;
  std::int64_t number = 0;
  double value = 0.0;
  lang::AxisSet axes = 0;
  lang::SpindleCommand spindle;
  lang::CuttingSpeedMode cutting;
  lang::CoolantCommand coolant;
  lang::OverrideControl overrides;
  lang::ForceControl force;
  RequestData request;
  const kinematics::Transform* transform = nullptr;
  FixedText<8> code;
  ShortText text;
};

[[nodiscard]] inline Item item_of(ItemKind kind, const motion::BlockTag& tag) {
  Item item;
  item.kind = kind;
  item.tag = tag;
  return item;
}

enum class RiderKind : std::uint8_t {
  mark_set,
  mark_clear,
  mark_wait,
  digital_output,
  analog_output,
};

// What travels with the path and takes effect where block `before_block` (or a later one) begins.
// Only a mark where the partners are not there yet stops the path.
struct Rider {
  RiderKind kind = RiderKind::mark_set;
  motion::BlockTag tag;
  std::uint64_t before_block = 0;
  std::int32_t number = 0;     // mark, output
  double value = 0.0;          // output
  std::uint32_t channels = 0;  // mark_wait: bit k: channel with id k
};

struct SpokenText {
  FixedText<8> code;  // of a warning; "" = a message
  ShortText text;
};

// A blank, and where the program has its zero: the frame W -> B where the blank is announced.
struct BlankNews {
  lang::WorkpieceAnnouncement shape;
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
