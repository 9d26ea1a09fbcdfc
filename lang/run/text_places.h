// Places of a text that a run goes to by line or block number: contours of cycles, the line behind
// one, and the line with which a search begins.
//
// Owner: ProgramExecution, on the thread of the preparation. Owns where G70 returns to. Invariant:
// while a contour is run, the plain lines being executed are those of the contour.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lang/block/active_block.h"
#include "lang/run/block_search.h"
#include "lang/run/block_state.h"
#include "lang/run/vm.h"
#include "lang/tree/text_value.h"

namespace stanok::lang {

class TextPlaces final : public ContourSource {
 public:
  // All must outlive this. Makes itself the source of contours of `state`.
  TextPlaces(Vm& vm, BlockState& state, Parameters& parameters);

  // The first N `first` of the file and all that follows up to N `last`.
  [[nodiscard]] Contour contour(int first, int last) override;
  [[nodiscard]] Contour subprogram(int number) override;
  [[nodiscard]] Contour o_subprogram(int number) override;

  void go_behind_line(std::uint32_t line);
  // GOTO, and M99 P behind the call: to block N `number` of the current text.
  void go_to_block(int number);
  void go_to_number_on_stack();
  // The lines `first` to `last`, then back to where the tool stands.
  void run_contour(std::uint32_t first, std::uint32_t last);
  [[nodiscard]] bool in_contour() const { return contour_return_.has_value(); }
  void leave_contour();
  void forget_contour() { contour_return_.reset(); }

  // Goes to a line outside braces and subprograms; false when it is none.
  [[nodiscard]] bool enter(std::uint32_t line);

 private:
  // The piece of plain text that holds a line, from there on, and the instruction behind it.
  struct PlainPlace {
    PlainCursor cursor;
    std::uint32_t position = 0;
  };
  struct ContourReturn {
    PlainCursor plain;
    AxisValues start_W{};
  };
  // Reads the plain line at `at`, which then is behind it; false: it is none.
  bool read_line(const Source& source, const char*& at, BlockWords& words);
  // The blocks from a place of a file up to M99, or the O-line of a number that ends them.
  [[nodiscard]] Contour blocks_up_to_return(std::uint16_t file, const char* at,
                                            std::optional<int> o_number = std::nullopt);
  [[nodiscard]] std::optional<PlainPlace> plain_place(std::uint32_t line) const;
  void go_to(const PlainPlace& place);

  Vm& vm_;
  BlockState& state_;
  TextValues text_values_;  // of the lines of a contour
  std::optional<ContourReturn> contour_return_;
};

// The line at which a search stops, and whether the run is there.
class SearchStop {
 public:
  void set(const StopPlace& place) {
    place_ = place;
    was_there_ = false;
  }
  void reset() { place_.reset(); }
  [[nodiscard]] bool active() const { return place_.has_value(); }
  // What is executed next stands in the line searched for, which was not so just before. It is
  // reached once.
  [[nodiscard]] bool is_reached(Vm& vm, const TextPlaces& texts);

 private:
  std::optional<StopPlace> place_;
  bool was_there_ = false;  // what was executed last stands in the line
};

}  // namespace stanok::lang
