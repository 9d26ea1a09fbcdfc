#include "lang/feed_law/feed_law_reader.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lang/feed_law/law_reader.h"

namespace stanok::lang {
namespace {

// The smallest step of feed: mm/min in G94, mm/rev in G95.
constexpr double feed_step_per_minute = 0.1;
constexpr double feed_step_per_revolution = 0.001;
// The same where lengths are in inches: a step of 0.1 mm/min is no number of inches.
constexpr double feed_step_inch_per_minute = 0.01;
constexpr double feed_step_inch_per_revolution = 0.0001;

}  // namespace

double LawReader::positive(LawAddress address) {
  const double value = words_.value(address);
  if (value > 0.0) return value;
  fail("E4335", address, text(address) + " must be above 0", "not above 0", "give a value above 0");
  return value;
}

double LawReader::step_of_feed() {
  const bool per_revolution = law_.feed_mode == FeedMode::per_revolution;
  const double step = feed(LawAddress::feed_step);
  if (const double inch = around_.length_unit; inch != 1.0) {
    check_grid(LawAddress::feed_step, step / inch,
               per_revolution ? Grid{feed_step_inch_per_revolution, "in/rev", 1.0}
                              : Grid{feed_step_inch_per_minute, "in/min", 1.0});
    return step;
  }
  check_grid(LawAddress::feed_step, step,
             per_revolution ? Grid{feed_step_per_revolution, "mm/rev"}
                            : Grid{feed_step_per_minute, "mm/min"});
  return step;
}

double LawReader::length(LawAddress address) {
  if (words_.has(address)) static_cast<void>(positive(address));
  return signed_length(address);
}

double LawReader::signed_length(LawAddress address) {
  if (!words_.has(address)) return 0.0;
  const double value = words_.value(address) * around_.length_unit;
  if (value == 0.0) {
    fail("E4335", address, text(address) + " must not be 0", "no length", "give a length");
  }
  check_grid(address, std::abs(value), {around_.resolution_mm, "mm"});
  return value;
}

void LawReader::check_grid(LawAddress address, double value, const Grid& grid) {
  if (failed() || grid.step <= 0.0) return;
  const double ratio = value / grid.step;
  const double nearest = std::max(std::round(ratio), 1.0);
  if (std::abs(ratio - nearest) <= multiple_tolerance) return;
  const std::string unit(grid.unit);
  const double sign = words_.value(address) < 0.0 ? -1.0 : 1.0;
  fail("E4336", address,
       text(address) + " is not a multiple of " + law_number_text(grid.step) + " " + unit,
       law_number_text(value) + " " + unit,
       "the nearest is `" + std::string(name_of(address)) + "=" +
           law_number_text(sign * nearest * grid.step /
                           (grid.unit_of_words > 0.0 ? grid.unit_of_words : around_.length_unit)) +
           "`");
}

void LawReader::fail(std::string_view code, LawAddress address, std::string message,
                     std::string label, std::string remedy) {
  if (failed()) return;
  fault_ = fault_at(code, word_name(address), std::move(message), std::move(label));
  fault_->help.push_back(std::move(remedy));
}

Expected<FeedLaw, BlockFault> LawReader::result() {
  if (failed()) return Unexpected<BlockFault>(std::move(*fault_));
  return std::move(law_);
}

Expected<FeedLaw, BlockFault> read_feed_law(const LawSurroundings& around, const LawForm& form,
                                            const LawWords& words, LawScope scope) {
  const LawType& type = law_type_of(form);
  LawReader reader(around, words, scope);
  reader.law().kind = type.kind;
  reader.law().speed = type.speed;
  reader.law().feed_mode = around.feed_mode;
  type.read(reader);
  return reader.result();
}

}  // namespace stanok::lang
