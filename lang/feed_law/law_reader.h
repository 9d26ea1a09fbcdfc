// LawReader: the words of a feed law with their units, signs and increments, for the laws that read
// themselves from them (law_type.h).
//
// One object for one reading, on the thread that executes the block. Invariant: the first value
// that is wrong is the fault; what is read behind it does not matter.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lang/feed_law/feed_law_reader.h"

namespace stanok::lang {

class LawReader {
 public:
  // How far a multiple of a step may lie beside it, in steps: what decimal numbers and inches need.
  static constexpr double multiple_tolerance = 1e-6;

  // All outlive the reader.
  LawReader(const LawSurroundings& around, const LawWords& words, LawScope scope)
      : around_(around), words_(words), scope_(scope) {}

  // The law so far.
  [[nodiscard]] FeedLaw& law() { return law_; }
  [[nodiscard]] const LawSurroundings& around() const { return around_; }
  [[nodiscard]] LawScope scope() const { return scope_; }

  [[nodiscard]] bool has(LawAddress address) const { return words_.has(address); }
  // As programmed.
  [[nodiscard]] double value(LawAddress address) const { return words_.value(address); }
  // "`S_n` = 60"
  [[nodiscard]] std::string text(LawAddress address) const { return word_text(words_, address); }

  double positive(LawAddress address);
  // In mm/min or mm/rev.
  double feed(LawAddress address) { return positive(address) * around_.length_unit; }
  // dS, a multiple of the smallest step of feed.
  double step_of_feed();
  // A length above zero, a multiple of the increment of the machine.
  double length(LawAddress address);
  // The same with a sign; 0 when there is none.
  double signed_length(LawAddress address);

  // The first reason stands, with its remedy.
  void fail(std::string_view code, LawAddress address, std::string message, std::string label,
            std::string remedy);
  [[nodiscard]] bool failed() const { return fault_.has_value(); }
  // The law, or why there is none; ends the reading.
  [[nodiscard]] Expected<FeedLaw, BlockFault> result();

 private:
  // The multiples that a value must be one of.
  struct Grid {
    double step = 0.0;  // in mm, mm/min or mm/rev; 0: any value will do
    std::string_view unit;
    double unit_of_words = 0.0;  // of the words, in that unit; 0: the unit of length in mm
  };

  void check_grid(LawAddress address, double value, const Grid& grid);

  const LawSurroundings& around_;
  const LawWords& words_;
  LawScope scope_;
  FeedLaw law_;
  std::optional<BlockFault> fault_;
};

}  // namespace stanok::lang
