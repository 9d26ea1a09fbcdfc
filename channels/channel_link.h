// The rings between the preparation of a channel (one thread) and its part of the real-time cycle
// (another).
#pragma once

#include "base/ring.h"
#include "channels/item.h"
#include "motion/path_queue.h"

namespace stanok::channels {

struct ChannelLink {
  motion::PathQueue path;      // preparation -> cycle
  Ring<Item> items{256};       // preparation -> cycle
  Ring<Remark> remarks{1024};  // preparation -> cycle
  Ring<Notice> notices{16};    // cycle -> preparation
};

}  // namespace stanok::channels
