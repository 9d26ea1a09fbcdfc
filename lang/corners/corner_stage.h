// Chamfers and roundings (`,C` `,R`) and lines by their angle (`,A`) as a stage between the
// execution of blocks and radius compensation: a corner is known when the next move is.
//
// The move of a block with such a word is held until the next move in the plane comes, which must
// be a line at feed or an arc; it is shortened, the chamfer or rounding follows at its feed, and
// the next move goes on from there. Coordinates that are not of the plane have their end where the
// shortened move ends. Dwells and functions between both moves keep their order behind the corner.
// A line whose end is not known waits likewise, for a line with an end and an angle of its own:
// both meet in one point. Source: Fanuc operator's manual B-63944EN, 13.6, optional-angle
// chamfering and corner rounding. All points in W, mm.
#pragma once

#include <vector>

#include "lang/block/active_block.h"
#include "lang/block/command_queue.h"
#include "lang/block/fault_of_command.h"
#include "lang/elements/corner_cut.h"
#include "lang/elements/plane_element.h"

namespace stanok::lang {

class CornerStage {
 public:
  explicit CornerStage(const ChannelWords& words) : words_(words) {}

  void reset();

  // A move waits for the next one.
  [[nodiscard]] bool holds() const { return held_.has_value(); }
  // The end of the line that waits is not known yet.
  [[nodiscard]] bool awaits_end() const;
  // Commands must pass through take() as long as this holds.
  [[nodiscard]] bool engaged() const { return holds() || request_.wanted() || !ready_.empty(); }

  // What the block asks for whose commands come next; the programmed point stood at `start_W`
  // before it.
  void select(const CornerRequest& request, Plane plane, const AxisValues& start_W);

  // The next command of the program, to be found in ready() now or later.
  [[nodiscard]] StageResult take(Command& command);

  // Gives out what is held as it was programmed, but a line whose end is not known.
  void finish();

  [[nodiscard]] CommandQueue& ready() { return ready_; }

 private:
  struct Held {
    Command command;
    PlaneElement element;  // from where it really starts
    CornerRequest request;
  };

  [[nodiscard]] PlanePoint plane_point(const AxisValues& values) const;
  [[nodiscard]] PlaneElement element_of(const Move& move, PlanePoint start) const;
  [[nodiscard]] bool is_element(const Move& move) const;
  [[nodiscard]] StageResult begin(Command& command);
  [[nodiscard]] StageResult go_on(Command& command);
  [[nodiscard]] StageResult go_on_without_end(Command& command);
  [[nodiscard]] StageResult meet(const Command& command);
  [[nodiscard]] StageResult cut(const Move& move, PlanePoint& from);
  void emit_cut(const CornerCut& cut);
  void release();
  void pass(Command& command);

  const ChannelWords& words_;
  CornerRequest request_;  // of the block whose motion comes next
  AxisIndex first_ = 0;    // axes of the plane
  AxisIndex second_ = 1;
  Plane plane_ = Plane::xy;
  PlanePoint start_;  // of the motion that comes next
  std::optional<Held> held_;
  std::vector<Command> waiting_;
  CommandQueue ready_;
};

}  // namespace stanok::lang
