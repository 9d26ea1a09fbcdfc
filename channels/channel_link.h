// The rings between the preparation of a channel (one thread) and its part of the real-time cycle
// (another).
#pragma once

#include <array>

#include "base/ring.h"
#include "channels/item.h"
#include "motion/path_queue.h"

namespace stanok::channels {

struct ChannelLink {
  motion::PathQueue path;      // preparation -> cycle
  Ring<Item> items{256};       // preparation -> cycle
  Ring<Rider> riders{8192};    // preparation -> cycle
  Ring<Remark> remarks{1024};  // preparation -> cycle
  Ring<Notice> notices{16};    // cycle -> preparation
  // Of the running program, by motion::BlockTag::file; written before anything bears a tag of the
  // run, and read for such tags only.
  std::array<FileName, 256> file_names{};
};

}  // namespace stanok::channels
