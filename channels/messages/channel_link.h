// The rings between the preparation of a channel (one thread) and its part of the real-time cycle
// (another).
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

#include "base/ring.h"
#include "channels/contract/input_record.h"
#include "channels/messages/item.h"
#include "channels/messages/notice.h"
#include "kinematics/length_changes.h"
#include "motion/path/path_queue.h"

namespace stanok::channels {

// Of one chain of the path: its riders and those of the next one have room.
inline constexpr std::size_t riders_in_chain_max = 4096;

// Motion that is to be before the cycle: with less the preparation is urgent, and a path that ran
// dry goes on with so much; s.
inline constexpr double enough_path_s = 2.0;
// With so much of it before the cycle the preparation waits, so that what operators change
// meanwhile takes effect soon; s.
inline constexpr double far_ahead_s = 10.0;

struct ChannelLink {
  motion::PathQueue path;                       // preparation -> cycle
  Ring<Item> items{256};                        // preparation -> cycle
  Ring<Rider> riders{2 * riders_in_chain_max};  // preparation -> cycle
  Ring<Remark> remarks{1024};                   // preparation -> cycle
  Ring<TableTaking> takings{64};                // preparation -> cycle
  Ring<Notice> notices{16};                     // cycle -> preparation
  Ring<kinematics::LengthChange> lengths{64};   // cycle -> preparation

  // The cycle. Bound: a load or search, a start, a switch and an answer are each asked for one at a
  // time and the next only when the preparation has answered, and a reset ends them all; of an
  // operator's line there is a load and a start besides, and one Settle. So at most eight notices
  // wait. A notice
  // that finds no place is a fault of our own: the channel stops (has_lost_notice).
  void tell(const Notice& notice) RT_SAFE { has_lost_notice |= !notices.push(notice); }
  bool has_lost_notice = false;

  // The cycle: resets that were asked for since construction. A preparation that has obeyed fewer
  // ends what it compiles: the reset waits for it.
  std::atomic<std::uint32_t> resets_wanted{0};

  // The cycle: what it sees of the rings until the next call, counted since construction. In this
  // order a chunk comes with the items before it, and with the riders before its blocks.
  void show(const Arrivals& arrivals) RT_SAFE {
    path.show(arrivals.chunks);
    items.show(arrivals.items);
    riders.show(arrivals.riders);
    remarks.show(arrivals.remarks);
  }
  [[nodiscard]] Arrivals shown() const RT_SAFE {
    return {.chunks = path.chunks.shown(),
            .items = items.shown(),
            .riders = riders.shown(),
            .remarks = remarks.shown()};
  }
  // Of the running program, by motion::BlockTag::file; written before anything bears a tag of the
  // run, and read for such tags only.
  std::array<FileName, 256> file_names{};
};

}  // namespace stanok::channels
