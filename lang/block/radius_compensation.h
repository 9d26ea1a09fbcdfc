// Tool radius compensation (G40 to G42.1) as a stage between the execution of blocks and the
// delivery of their commands: programmed contours go in, parallels at the distance of the tool
// radius come out.
//
// Rules: the first plane move (G0 or G1) leads in to the perpendicular of the first contour element
// at its start, around an outside corner as around all others. Inside corners are cut at the
// intersection of the parallels; outside corners get an arc about the programmed corner, but for
// lines up to 10 degrees, which are extended. The first plane move after G40 leads from the
// perpendicular at the end of the contour to the programmed point. Gouges are errors: an arc
// smaller than the tool, a corner that the tool cannot reach, an element that vanishes between its
// corners. Places that are narrow between elements which do not follow each other are not seen. A
// tool without a radius runs on the contour itself. Outside of the dialects of Fanuc an arc may
// lead in: from where the tool is to the perpendicular at its end, in the direction programmed
// there. One element is held until the next one is
// known; commands without plane motion wait with it, in their order. The feed law of a block stays
// before the parallel of its own element, behind the arc about the corner. Source: T. R. Kramer, F.
// M. Proctor, E. Messina, "The NIST RS274NGC Interpreter - Version 3" (NISTIR 6556, 2000), appendix
// B; the intersections and the orientations of lathe tools as in LinuxCNC. All points in W, mm.
#pragma once

#include <optional>
#include <vector>

#include "lang/block/active_block.h"
#include "lang/block/command_queue.h"
#include "lang/block/fault_of_command.h"
#include "lang/elements/plane_element.h"

namespace stanok::lang {

class CompensationStage {
 public:
  explicit CompensationStage(const ChannelWords& words) : words_(words) {}

  void reset();

  // Commands must pass through take() as long as this holds.
  [[nodiscard]] bool engaged() const { return state_ != State::off || !ready_.empty(); }

  [[nodiscard]] bool changes(const RadiusCompensation& wanted) const {
    return !(wanted == selected_);
  }

  // The compensation of the block whose commands come next; the programmed point stood at `start_W`
  // before it.
  [[nodiscard]] StageResult select(const RadiusCompensation& wanted, const AxisValues& start_W);

  // The next command of the program, to be found in ready() now or later.
  [[nodiscard]] StageResult take(Command& command);

  // Gives out what is held, to the perpendicular at its end. An element that cannot be executed is
  // dropped.
  StageResult finish();

  // The axes stand, and the program goes on from where they are.
  void adopt_position();

  [[nodiscard]] CommandQueue& ready() { return ready_; }

 private:
  enum class State {
    off,
    armed,    // G41, G42: no plane move yet
    active,   // an element is held
    leaving,  // G40: the tool stands `deviation_` off the programmed point
  };

  // The last plane move, whose end depends on the next one.
  struct Held {
    PlaneElement element;
    Command command;
    PlanePoint start;  // of the parallel
    double cut = 0.0;  // at the start
    bool lead_in = false;
    std::optional<Command> law;  // of its block
  };

  [[nodiscard]] bool compensating() const { return selected_.on(); }
  [[nodiscard]] PlanePoint plane_point(const AxisValues& values) const;
  void set_plane_point(AxisValues& values, PlanePoint point) const;
  [[nodiscard]] bool moves_in_plane(const Move& move) const;
  [[nodiscard]] PlaneElement element_of(const Move& move) const;

  StageResult take_move(Command& command, Move& move);
  StageResult wait_with_law(Command& command);
  void pass_law();
  StageResult lead_in(Command& command, Move& move);
  StageResult lead_in_by_arc(Command& command, Move& move);
  StageResult continue_contour(Command& command, const Move& move);
  StageResult lead_out(Command& command, Move& move);
  StageResult wait_with_element(Command& command);
  StageResult emit_held(PlanePoint end, double cut);
  [[nodiscard]] Move parallel_move(const Held& held, PlanePoint end, double remaining) const;
  void emit_round(const Corner& corner, const Held& before, const Command& after);
  void pass(Command& command);
  void release_waiting();

  const ChannelWords& words_;
  State state_ = State::off;
  RadiusCompensation selected_;
  AxisIndex first_ = 0;  // axes of the plane
  AxisIndex second_ = 1;
  double offset_ = 0.0;  // of the parallel, positive to the left
  PlanePoint tip_;       // programmed tip of a lathe tool from the centre of its nose
  AxisValues programmed_W_{};
  AxisValues emitted_{};  // end of the last move given out
  PlanePoint deviation_;  // the tool's point - the programmed one
  // While leaving: lengths or frames have changed since, so that ends cannot be compared.
  bool coordinates_changed_ = false;
  std::optional<Held> held_;
  std::optional<Command> law_;  // of the block whose motion comes next
  std::vector<Command> waiting_;
  CommandQueue ready_;
};

}  // namespace stanok::lang
