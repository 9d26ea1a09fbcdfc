// What the operator asks of a channel's feed in a cycle.
#pragma once

namespace stanok::motion {

struct FeedControl {
  double feed_override = 1.0;   // 0..2, of programmed feed
  double rapid_override = 1.0;  // 0..1
  bool hold = false;            // feed hold: come to rest on the path

  [[nodiscard]] bool is_nominal() const {
    return feed_override == 1.0 && rapid_override == 1.0 && !hold;
  }
  friend bool operator==(const FeedControl&, const FeedControl&) = default;
};

}  // namespace stanok::motion
