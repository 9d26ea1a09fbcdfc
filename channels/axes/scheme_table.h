// SchemeTable: the kinematic schemes of a channel, and the one that is active.
//
// Thread: set up before the first cycle, then the real-time cycle. Owner: the channel.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <utility>

#include "base/rt_safe.h"
#include "kinematics/scheme.h"
#include "lang/contract/environment.h"

namespace stanok::channels {

class SchemeTable {
 public:
  // `schemes` outlives the table and is written by nobody.
  SchemeTable(const std::map<int, std::unique_ptr<const kinematics::Scheme>>& schemes, int active);

  void select(int scheme) RT_SAFE { active_ = scheme; }
  [[nodiscard]] int active_id() const RT_SAFE { return active_; }
  // nullptr: there is no such scheme.
  [[nodiscard]] const kinematics::Scheme* find(int scheme) const RT_SAFE;
  [[nodiscard]] const kinematics::Scheme* active() const RT_SAFE { return find(active_); }

  // Axes that take part in the active scheme, and those of a scheme with the parked ones.
  [[nodiscard]] lang::AxisSet participants() const RT_SAFE;
  [[nodiscard]] lang::AxisSet axes_of(int scheme) const RT_SAFE;
  // By the active scheme.
  [[nodiscard]] bool parks(int axis) const RT_SAFE;

 private:
  static constexpr std::size_t schemes_max = 16;

  std::array<std::pair<int, const kinematics::Scheme*>, schemes_max> schemes_{};
  std::size_t count_ = 0;
  int active_;
};

}  // namespace stanok::channels
