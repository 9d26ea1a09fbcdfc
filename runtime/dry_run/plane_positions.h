// Where the rotary axes will stand in the tilted planes of a program: of the two positions that
// incline the tool alike, the one that G53.1 or G53.6 takes, and what hinders the other.
//
// Owner: the dry run of a channel; fed with its moves in order. A plane that the axes cannot reach
// is a fault of its block (E4354) and none of these.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "lang/contract/command.h"
#include "lang/contract/environment.h"
#include "lang/contract/tool_alignment.h"

namespace stanok::runtime {

// A rotary axis by its word, and its angle in deg as the axis reads it.
struct RotaryAngle {
  std::string word;
  double deg = 0.0;
};

struct PlanePosition {
  // The position with the other sign of the first rotary axis, for which P1 or P2 asks.
  struct Other {
    lang::FirstRotary first = lang::FirstRotary::positive;
    std::vector<RotaryAngle> axes;    // where they would stand; else the one that cannot
    std::optional<double> limit_deg;  // of the one that cannot; nothing: they would stand there
  };

  Place place;                 // of G53.1 or G53.6
  lang::Direction normal_B{};  // of the plane, as it lies on the table
  std::vector<RotaryAngle> axes;
  std::optional<Other> other;  // nothing: there is no other position (pole)
};

class PlanePositions {
 public:
  // Of one program, each place with other angles; more are left out.
  static constexpr std::size_t count_max = 1000;

  // `words` are those of the channel's axes. Both must outlive this.
  PlanePositions(const lang::Tables& tables, const std::vector<std::string>& words)
      : tables_(tables), words_(words) {}

  // A move that aligns the tool: from where the axes stand to where the rotary axes will be, in B.
  void note(const Place& place, const lang::AxisValues& from_B, const lang::AxisValues& to_B);

  [[nodiscard]] std::vector<PlanePosition> take() { return std::move(found_); }

 private:
  [[nodiscard]] std::vector<RotaryAngle> angles(lang::AxisSet axes,
                                                const lang::AxisValues& angles_B) const;
  [[nodiscard]] std::optional<PlanePosition::Other> other(
      const lang::AlignmentWish& wish, const std::vector<RotaryAngle>& taken) const;

  const lang::Tables& tables_;
  const std::vector<std::string>& words_;
  std::vector<PlanePosition> found_;
};

}  // namespace stanok::runtime
