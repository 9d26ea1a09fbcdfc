// One ISO block while it is executed: what its actions read and change.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/diagnostic.h"
#include "lang/block/command_queue.h"
#include "lang/block/modal_state.h"
#include "lang/block/probe_result.h"
#include "lang/block/state_stack.h"
#include "lang/contract/environment.h"
#include "lang/elements/corner_cut.h"
#include "lang/words/block_fault.h"
#include "lang/words/block_words.h"
#include "lang/words/channel_words.h"

namespace stanok::lang {

enum class Flow : std::uint8_t {
  next,
  end_of_program,
  call_numbered,
  return_from_subprogram,
  go_to_block,     // `block` of the current text
  call_block,      // the same as a subprogram, `repeats` times
  end_modal_call,  // G67
  behind_line,     // on behind `line`
  run_contour,     // the lines from `contour_line` to `line`, then back to where the tool stands
};

// What a block does to the flow of the program behind its own effects.
struct BlockFlow {
  Flow kind = Flow::next;
  CodeNumber code = 0;  // M98 or M198
  ProgramEndKind end_kind = ProgramEndKind::end;
  std::uint32_t line = 0;
  std::uint32_t contour_line = 0;
  int repeats = 1;
  bool moves = false;  // a motion code took the axis words of the block
  int block = -1;      // N to go to, behind a return; -1: on behind the call
};

// Blocks of a text that a cycle refers to.
struct Contour {
  struct Block {
    BlockWords words;
    Origin origin;
  };
  std::vector<Block> blocks;
  std::string problem;  // why there is none
};

class ContourSource {
 public:
  virtual ~ContourSource() = default;
  // N `first` to N `last` of the current text.
  [[nodiscard]] virtual Contour contour(int first, int last) = 0;
  // From N `number` of the current text, or else of the program of that number, up to M99.
  [[nodiscard]] virtual Contour subprogram(int number) = 0;
  // Of O `number` sub of the current text or an included one.
  [[nodiscard]] virtual Contour o_subprogram(int number) = 0;
};

// What lies around a block: its channel, and where its effects go.
struct BlockSurroundings {
  ModalState& modal;
  const ChannelWords& channel_words;
  const ChannelDescription& channel;
  Tables& tables;
  CommandQueue& queue;
  ProbeResult& probe;
  StateStack& states;
  ContourSource* contours = nullptr;
};

// What of these lengths (X, Y, Z) lies between an axis and the programmed point, mm; 0 for axes
// that have none, and for those that do not take part in the scheme.
[[nodiscard]] double length_along(const BlockSurroundings& around, AxisIndex axis,
                                  const std::array<double, 3>& lengths_mm);

// How the motion of a block ends.
struct BlockEnd {
  bool stops = false;            // G9
  LetterSet plain_corners = 0;   // of A, C and R those that say `,A`, `,C` and `,R`
  CornerRequest corner;          // ,C or ,R
  AxisValues length_travel_W{};  // what a new tool length adds to the increments of its block
};

// How far the execution of a block has come, in the order of its actions.
struct BlockProgress {
  std::size_t actions = 0;
  std::size_t parts = 0;  // of the next action, where it counts itself out: how often it has
};

// Why a block fails.
struct BlockFaults {
  std::optional<BlockFault> first;  // which is told
  std::optional<BlockFault> later;  // so that help for it does not go to the first one
};

struct ActiveBlock : BlockSurroundings {
  ActiveBlock(const BlockWords& block_words, const BlockSurroundings& surroundings,
              std::uint32_t block_line)
      : BlockSurroundings(surroundings), words(block_words), line(block_line) {}

  const BlockWords& words;
  std::uint32_t line = 0;

  // The axis words in mm and deg (radius), as programmed: neither G91 nor offsets are applied.
  AxisSet programmed = 0;
  AxisSet incremental = 0;  // those of them that are given from the position, whatever G90 says
  AxisSet absolute = 0;     // those of them that are given from zero, whatever G91 says
  AxisValues values{};

  bool machine_coordinates = false;  // G53
  BlockEnd end;                      // of its motion
  char dwell_word = 0;               // the word that holds G4's time; 0 without G4
  double law_feed = 0.0;  // of its motion, from the feed law of the block; 0: it has none

  // An action after which the position is known only when the axes stand (TCP, M902, G12.1)
  // sets `awaits_position`. Is it still set after the execution, what `done` counts is done, and
  // the block is to be executed again with it when the position is known. An action that has more
  // to do then counts itself out again.
  bool awaits_position = false;
  BlockProgress done;

  GroupSet kept_groups = 0;  // of which the block's code does not become the active one

  BlockFlow flow;

  BlockFaults faults;

  // Records why the block fails; the first reason stands. The result may be completed.
  BlockFault& fail(std::string_view code, WordName word, std::string message,
                   std::string label = {});
  [[nodiscard]] bool failed() const { return faults.first.has_value(); }

  [[nodiscard]] bool has(char letter) const { return words.has(letter); }
  [[nodiscard]] double value(char letter) const { return words.value(letter); }
  // mm per unit of programmed lengths
  [[nodiscard]] double length_unit() const { return modal.inches() ? mm_per_inch : 1.0; }
  // A length word in mm.
  [[nodiscard]] double length(char letter) const { return value(letter) * length_unit(); }
  // The integer in a word, within limits; fails the block otherwise.
  [[nodiscard]] std::optional<int> integer(char letter, int smallest, int largest);
  void set_modal(Group group, CodeNumber number) { modal.set(group, number, line); }
};

// The block has a word for this axis.
[[nodiscard]] inline bool is_programmed(const ActiveBlock& block, AxisIndex axis) {
  return (block.programmed & axis_bit(axis)) != 0;
}

}  // namespace stanok::lang
