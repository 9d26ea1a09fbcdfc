#include "lang/feed_law/feed_law_reader.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "lang/text/limits.h"

namespace stanok::lang {
namespace {

using enum LawAddress;

// The smallest step of feed: mm/min in G94, mm/rev in G95.
constexpr double feed_step_per_minute = 0.1;
constexpr double feed_step_per_revolution = 0.001;

// How far a multiple of a step may lie beside it, in steps: what decimal numbers and inches need.
constexpr double multiple_tolerance = 1e-6;

constexpr int steps_max = limits::feed_law_steps;

// The multiples that a value must be one of.
struct Grid {
  double step = 0.0;  // in mm, mm/min or mm/rev; 0: any value will do
  std::string_view unit;
};

class LawReader {
 public:
  LawReader(const LawSurroundings& around, const LawForm& form, const LawWords& words,
            LawScope scope)
      : around_(around), form_(form), words_(words), scope_(scope) {}

  Expected<FeedLaw, BlockFault> read() {
    law_.kind = form_.kind;
    law_.speed = form_.speed;
    law_.feed_mode = around_.feed_mode;
    if (form_.kind == FeedLaw::Kind::linear) read_linear();
    if (form_.kind == FeedLaw::Kind::modulated) read_modulated();
    if (form_.kind == FeedLaw::Kind::interrupted) {
      law_.stand_mm = length(stand);
      law_.cut_mm = length(cut);
    }
    if (form_.speed == FeedLaw::Speed::rev_per_min) read_speed(speed_first, speed_last, speed_step);
    if (form_.speed == FeedLaw::Speed::m_per_min) {
      read_speed(cutting_first, cutting_last, cutting_step);
    }
    if (failed()) return Unexpected<BlockFault>(std::move(*fault_));
    return std::move(law_);
  }

 private:
  void read_linear() {
    law_.feed_first = feed(feed_first);
    law_.feed_step = step_of_feed();
    law_.way_step_mm = std::abs(signed_length(way_step));
    law_.falls = words_.value(way_step) < 0.0;
    if (!words_.has(feed_last)) return;
    law_.feed_last = feed(feed_last);
    if (failed()) return;
    law_.falls = law_.feed_last < law_.feed_first;
    words_.has(way_step) ? check_direction() : check_way_step_follows();
    if (law_.feed_last == law_.feed_first) law_.feed_step = 0.0;
  }

  // S_k beside dl: the steps lead to it.
  void check_direction() {
    const double rise = law_.feed_last - law_.feed_first;
    if (rise * words_.value(way_step) >= 0.0) return;
    const std::string toward = rise > 0.0 ? "above" : "below";
    fail("E4341", way_step,
         text(way_step) + " leads away from " + text(feed_last) + ", which lies " + toward + " " +
             text(feed_first),
         "wrong sign", "write `dl=" + law_number_text(-words_.value(way_step)) + "`");
  }

  // S_k without dl: the length of the block over the number of steps.
  void check_way_step_follows() {
    const double steps_needed = std::abs(law_.feed_last - law_.feed_first) / law_.feed_step;
    if (steps_needed < 1.0 - multiple_tolerance) {
      fail("E4339", feed_last,
           text(feed_last) + " is not even one `dS` away from " + text(feed_first) +
               ": `dl` cannot follow from them",
           "no step between", "add `dl`, the distance after which a step is due");
    } else if (scope_ == LawScope::modal) {
      fail("E4340", feed_last,
           text(feed_last) +
               " without `dl` in a block without axis words: there is no length from "
               "which `dl` follows",
           "no path in this block", "add `dl`, or program the law in the block of the motion");
    }
  }

  void read_modulated() {
    law_.feed_first = feed(feed_min);
    law_.feed_step = step_of_feed();
    law_.way_step_mm = length(way_step);
    if (failed()) return;
    words_.has(steps) ? read_step_count() : read_largest_feed();
    law_.feed_last = law_.feed_first + law_.steps * law_.feed_step;
  }

  void read_step_count() {
    const double count = words_.value(steps);
    if (count >= 1.0 && count <= steps_max && count == std::round(count)) {
      law_.steps = static_cast<int>(count);
      return;
    }
    fail("E4337", steps, text(steps) + " must be a whole number from 1 to 1000000",
         "number of steps up, then down", "write e.g. `n_s=10`");
  }

  void read_largest_feed() {
    const double largest = feed(feed_max);
    if (failed()) return;
    if (largest <= law_.feed_first) {
      fail("E4338", feed_max, text(feed_max) + " must be above " + text(feed_min),
           "the law starts at `Smin` and rises",
           "exchange them, or give the number of steps with `n_s`");
      return;
    }
    const double count = (largest - law_.feed_first) / law_.feed_step;
    if (count > steps_max) {
      fail("E4337", feed_max,
           text(feed_max) + " lies more than 1000000 steps of " + text(feed_step) + " above " +
               text(feed_min),
           "too many steps", "write a larger `dS`");
    } else if (std::abs(count - std::round(count)) > multiple_tolerance) {
      const double nearest =
          (law_.feed_first + std::round(count) * law_.feed_step) / around_.length_unit;
      fail("E4336", feed_max,
           text(feed_max) + " lies " + law_number_text(count) + " steps of " + text(feed_step) +
               " above " + text(feed_min),
           "not a whole number of steps", "write `Smax=" + law_number_text(nearest) + "`");
    } else {
      law_.steps = static_cast<int>(std::lround(count));
    }
  }

  // n_n n_k dn or v_n v_k dv; the last one is given or the step.
  void read_speed(LawAddress first, LawAddress last, LawAddress step) {
    const bool cuts = form_.speed == FeedLaw::Speed::m_per_min;
    const double unit = cuts ? around_.cutting_speed_unit : 1.0;
    law_.speed_first = positive(first) * unit;
    if (words_.has(last)) law_.speed_last = positive(last) * unit;
    if (words_.has(step)) law_.speed_step = words_.value(step) * unit;
    // Its steps are as many as those of the feed, or as fit into the block.
    if (words_.has(last) && law_.feed_step == 0.0 && scope_ == LawScope::modal) {
      fail("E4340", last,
           text(last) + " with " + text(feed_last) +
               ", the same as `S_n`, in a block without axis "
               "words: there is no length over which the speed changes",
           "no path in this block",
           "give the step `" + std::string(name_of(step)) +
               "`, or program the law in the block of the motion");
    }
  }

  double step_of_feed() {
    const bool per_revolution = law_.feed_mode == FeedMode::per_revolution;
    const double step = feed(feed_step);
    check_grid(feed_step, step,
               per_revolution ? Grid{feed_step_per_revolution, "mm/rev"}
                              : Grid{feed_step_per_minute, "mm/min"});
    return step;
  }

  double feed(LawAddress address) { return positive(address) * around_.length_unit; }

  // A length above zero, a multiple of the increment of the machine.
  double length(LawAddress address) {
    if (words_.has(address)) static_cast<void>(positive(address));
    return signed_length(address);
  }

  // 0 when there is none.
  double signed_length(LawAddress address) {
    if (!words_.has(address)) return 0.0;
    const double value = words_.value(address) * around_.length_unit;
    if (value == 0.0) {
      fail("E4335", address, text(address) + " must not be 0", "no length", "give a length");
    }
    check_grid(address, std::abs(value), {around_.resolution_mm, "mm"});
    return value;
  }

  double positive(LawAddress address) {
    const double value = words_.value(address);
    if (value > 0.0) return value;
    fail("E4335", address, text(address) + " must be above 0", "not above 0",
         "give a value above 0");
    return value;
  }

  void check_grid(LawAddress address, double value, const Grid& grid) {
    if (failed() || grid.step <= 0.0) return;
    const double ratio = value / grid.step;
    const double nearest = std::max(std::round(ratio), 1.0);
    if (std::abs(ratio - nearest) <= multiple_tolerance) return;
    const std::string unit(grid.unit);
    const double sign = words_.value(address) < 0.0 ? -1.0 : 1.0;
    fail("E4336", address,
         text(address) + " is no multiple of " + law_number_text(grid.step) + " " + unit,
         law_number_text(value) + " " + unit,
         "the nearest is `" + std::string(name_of(address)) + "=" +
             law_number_text(sign * nearest * grid.step / around_.length_unit) + "`");
  }

  [[nodiscard]] std::string text(LawAddress address) const { return word_text(words_, address); }

  // The first reason stands, with its remedy.
  void fail(std::string_view code, LawAddress address, std::string message, std::string label,
            std::string remedy) {
    if (failed()) return;
    fault_ = fault_at(code, word_name(address), std::move(message), std::move(label));
    fault_->help.push_back(std::move(remedy));
  }
  [[nodiscard]] bool failed() const { return fault_.has_value(); }

  const LawSurroundings& around_;
  const LawForm& form_;
  const LawWords& words_;
  LawScope scope_;
  FeedLaw law_;
  std::optional<BlockFault> fault_;
};

}  // namespace

Expected<FeedLaw, BlockFault> read_feed_law(const LawSurroundings& around, const LawForm& form,
                                            const LawWords& words, LawScope scope) {
  return LawReader(around, form, words, scope).read();
}

}  // namespace stanok::lang
