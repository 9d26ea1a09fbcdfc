// FaultSieve: which faults of a program are told when it was followed beyond the first one.
//
// What a block says by itself is wrong wherever it stands. What depends on the blocks before is
// told once for each code, as it may follow from the fault that was passed; and where it is not
// known any more where the axes are, faults of geometry are not told.
#pragma once

#include <set>
#include <string>
#include <tuple>

#include "base/diagnostic.h"

namespace stanok::jobs {

class FaultSieve {
 public:
  // A block at fault was passed.
  void pass() { ++passed_; }
  // A loop over faulty blocks comes to its end.
  [[nodiscard]] bool may_pass() const { return passed_ < passes_max; }
  // Not told before of its place: a block in a loop is at fault each time.
  [[nodiscard]] bool is_new(const Diagnostic& diagnostic);
  void lose_position() { is_position_known_ = false; }

  // Whether the block says it by itself: its words and codes are wrong wherever it stands.
  [[nodiscard]] static bool is_of_its_block(const Diagnostic& diagnostic);
  [[nodiscard]] bool lets_through(const Diagnostic& diagnostic);

 private:
  static constexpr int passes_max = 10'000;

  int passed_ = 0;
  bool is_position_known_ = true;
  std::set<std::tuple<std::string, std::string, int, int>> places_;  // with code and file
  std::set<std::string> told_;  // codes that depend on the blocks before
};

// The diagnostics in the order of their places: those of `program` first, then files in the order
// in which they come up.
void sort_by_place(Diagnostics& diagnostics, const std::string& program);

}  // namespace stanok::jobs
