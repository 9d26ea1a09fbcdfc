// LengthChanges: lengths of tools that count at once for a path that was made before they changed.
//
// A transform carries the row of the tool table that its tool vector was read from, and the number
// of the write of the tables behind which it was read. A change with a later number is added to it
// wherever axes are computed. One object in the cycle and one beside each preparation, which follow
// each other by these numbers; real-time. Lengths mm, along X, Y, Z of the machine when not tilted.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "base/rt_safe.h"
#include "base/vector3.h"

namespace stanok::kinematics {

// Where the vector of a tool comes from.
struct ToolRow {
  int tool = 0;
  int edge = 1;
  int sign = 0;               // how the lengths of the row are in the vector; 0: not at all
  std::uint64_t version = 0;  // number of the newest write that it was read behind

  // The same row, read behind a later write.
  [[nodiscard]] ToolRow behind(std::uint64_t later) const RT_SAFE {
    return {.tool = tool, .edge = edge, .sign = sign, .version = later};
  }
  [[nodiscard]] bool is_same(const ToolRow& other) const RT_SAFE {
    return tool == other.tool && edge == other.edge && sign == other.sign;
  }
};

struct LengthChange {
  int tool = 0;
  int edge = 1;
  std::array<double, 3> by_mm{};
  std::uint64_t version = 0;  // number of the write
};

class LengthChanges {
 public:
  // In the order of their numbers; not when it is full.
  void note(const LengthChange& change) RT_SAFE { changes_[count_++] = change; }
  void forget() RT_SAFE { count_ = 0; }
  [[nodiscard]] bool is_empty() const RT_SAFE { return count_ == 0; }
  [[nodiscard]] bool is_full() const RT_SAFE { return count_ == changes_.size(); }

  // The row has changed since it was read.
  [[nodiscard]] bool concern(const ToolRow& row) const RT_SAFE;
  // By how much its length is longer now, with its sign.
  [[nodiscard]] Vector3<double> since(const ToolRow& row) const RT_SAFE;

 private:
  static constexpr std::size_t changes_max = 64;

  std::array<LengthChange, changes_max> changes_{};
  std::size_t count_ = 0;
};

}  // namespace stanok::kinematics
