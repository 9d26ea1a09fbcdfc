// Announcements: what a program says where the path comes to its block, without stopping it:
// messages, warnings, and the workpiece (#workpiece, #workpiece_pos).
//
// Thread: the real-time cycle. Owner: the channel, whose ring of remarks is consumed here and
// nowhere else.
#pragma once

#include "base/ring.h"
#include "base/rt_safe.h"
#include "channels/contract/output.h"
#include "channels/cycle/channel_log.h"
#include "channels/messages/item.h"

namespace stanok::channels {

// Whether the path stands with nothing behind it, so that no block will come that shows more.
enum class PathEnd : std::uint8_t { not_reached, reached };

class Announcements {
 public:
  // Both outlive the announcements.
  Announcements(Ring<Remark>& remarks, ChannelLog& log) : remarks_(remarks), log_(log) {}

  // `path`: of the block on the path.
  void advance(const motion::BlockTag& path, PathEnd end) RT_SAFE;
  // What has not come to its block never will.
  void forget() RT_SAFE { remarks_.pop_front(remarks_.size()); }

  [[nodiscard]] const Workpiece& workpiece() const RT_SAFE { return workpiece_; }

 private:
  void show(const Remark& remark) RT_SAFE;

  Ring<Remark>& remarks_;
  ChannelLog& log_;
  Workpiece workpiece_;
};

}  // namespace stanok::channels
