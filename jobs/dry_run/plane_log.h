// PlaneLog: the positions of the rotary axes in the tilted planes of a program, and what hinders
// the other ones.
//
// Owner: the dry run of a channel; fed with its moves in order. A plane that the axes cannot reach
// is a fault of its block (E4354) and none of these.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/plane_position.h"
#include "lang/contract/command.h"
#include "lang/contract/environment.h"
#include "lang/contract/tool_alignment.h"

namespace stanok::jobs {

class PlaneLog {
 public:
  // Of one program, each place with other angles; more are left out.
  static constexpr std::size_t count_max = 1000;

  // `words` are those of the channel's axes. Both must outlive this.
  PlaneLog(const lang::Tables& tables, const std::vector<std::string>& words)
      : tables_(tables), words_(words) {}

  // A move that aligns the tool: from where the axes stand to where the rotary axes will be, in B.
  void note(const Place& place, const lang::AxisValues& from_B, const lang::AxisValues& to_B);

  [[nodiscard]] PlanePositions take() { return std::move(found_); }

 private:
  [[nodiscard]] std::vector<RotaryAngle> angles(lang::AxisSet axes,
                                                const lang::AxisValues& angles_B) const;
  [[nodiscard]] std::optional<PlanePosition::Other> other(
      const lang::AlignmentWish& wish, const std::vector<RotaryAngle>& taken) const;

  const lang::Tables& tables_;
  const std::vector<std::string>& words_;
  PlanePositions found_;
};

}  // namespace stanok::jobs
