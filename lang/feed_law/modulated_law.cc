#include "lang/feed_law/modulated_law.h"

#include <cmath>

#include "lang/feed_law/law_reader.h"
#include "lang/text/limits.h"

namespace stanok::lang {
namespace {

using enum LawAddress;

constexpr int steps_max = limits::feed_law_steps;

void read_step_count(LawReader& reader) {
  const double count = reader.value(steps);
  if (count >= 1.0 && count <= steps_max && count == std::round(count)) {
    reader.law().steps = static_cast<int>(count);
    return;
  }
  reader.fail("E4337", steps, reader.text(steps) + " must be a whole number from 1 to 1000000",
              "number of steps up, then down", "write e.g. `n_s=10`");
}

void read_largest_feed(LawReader& reader) {
  FeedLaw& law = reader.law();
  const double largest = reader.feed(feed_max);
  if (reader.failed()) return;
  if (largest <= law.feed_first) {
    reader.fail(
        "E4338", feed_max, reader.text(feed_max) + " must be above " + reader.text(feed_min),
        "the law starts at `Smin` and rises", "swap them, or give the number of steps with `n_s`");
    return;
  }
  const double count = (largest - law.feed_first) / law.feed_step;
  if (count > steps_max) {
    reader.fail("E4337", feed_max,
                reader.text(feed_max) + " is more than 1000000 steps of " + reader.text(feed_step) +
                    " above " + reader.text(feed_min),
                "too many steps", "write a larger `dS`");
  } else if (std::abs(count - std::round(count)) > LawReader::multiple_tolerance) {
    const double nearest =
        (law.feed_first + std::round(count) * law.feed_step) / reader.around().length_unit;
    reader.fail("E4336", feed_max,
                reader.text(feed_max) + " lies " + law_number_text(count) + " steps of " +
                    reader.text(feed_step) + " above " + reader.text(feed_min),
                "not a whole number of steps", "write `Smax=" + law_number_text(nearest) + "`");
  } else {
    law.steps = static_cast<int>(std::lround(count));
  }
}

}  // namespace

void read_modulated_law(LawReader& reader) {
  FeedLaw& law = reader.law();
  law.feed_first = reader.feed(feed_min);
  law.feed_step = reader.step_of_feed();
  law.path_step_mm = reader.length(path_step);
  if (reader.failed()) return;
  reader.has(steps) ? read_step_count(reader) : read_largest_feed(reader);
  law.feed_last = law.feed_first + law.steps * law.feed_step;
}

bool is_plausible_modulated_law(const FeedLaw& law) {
  return law.feed_first > 0.0 && law.path_step_mm > 0.0 && law.feed_step > 0.0 && law.steps > 0;
}

std::vector<LawValue> values_of_modulated_law(const FeedLaw& law) {
  return {{"feed_min", law.feed_first},
          {"feed_max", law.feed_last},
          {"feed_step", law.feed_step},
          {"path_step", law.path_step_mm},
          {"steps", static_cast<double>(law.steps)}};
}

}  // namespace stanok::lang
