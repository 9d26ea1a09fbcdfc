// Points that a channel keeps from program to program, until power-off: reference points that
// programs store (G28.1, G30.1, #5161...) and what probing found.
#pragma once

#include <array>
#include <optional>

#include "lang/command.h"
#include "lang/environment.h"

namespace stanok::lang {

inline constexpr int reference_point_count = 4;  // 1: G28, 2 to 4: G30 P

class ReferencePoints {
 public:
  // Reference point `which` from 1, in M, per axis; of the machine file as long as no program
  // stored another.
  [[nodiscard]] AxisValues point(int which, const Tables& tables) const {
    const auto& stored = stored_[static_cast<std::size_t>(which - 1)];
    return stored ? *stored : tables.reference_point(which);
  }
  void store(int which, const AxisValues& point_M) {
    stored_[static_cast<std::size_t>(which - 1)] = point_M;
  }

 private:
  std::array<std::optional<AxisValues>, reference_point_count> stored_;
};

// The last G38: in programmed coordinates of the system in which it was done, mm and deg.
struct ProbeResult {
  bool found = false;
  AxisValues position{};
};

struct MachinePoints {
  ReferencePoints reference;
  ProbeResult probe;
};

}  // namespace stanok::lang
