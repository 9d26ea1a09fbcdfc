#include "lang/feed_law/linear_law.h"

#include <cmath>

#include "lang/feed_law/law_reader.h"

namespace stanok::lang {
namespace {

using enum LawAddress;

// S_k beside dl: the steps lead to it.
void check_direction(LawReader& reader) {
  const FeedLaw& law = reader.law();
  const double rise = law.feed_last - law.feed_first;
  if (rise * reader.value(path_step) >= 0.0) return;
  const std::string toward = rise > 0.0 ? "above" : "below";
  reader.fail("E4341", path_step,
              reader.text(path_step) + " leads away from " + reader.text(feed_last) +
                  ", which is " + toward + " " + reader.text(feed_first),
              "wrong sign", "write `dl=" + law_number_text(-reader.value(path_step)) + "`");
}

// S_k without dl: the length of the block over the number of steps.
void check_path_step_follows(LawReader& reader) {
  const FeedLaw& law = reader.law();
  const double steps_needed = std::abs(law.feed_last - law.feed_first) / law.feed_step;
  if (steps_needed < 1.0 - LawReader::multiple_tolerance) {
    reader.fail("E4339", feed_last,
                reader.text(feed_last) + " is less than one `dS` away from " +
                    reader.text(feed_first) + ": `dl` cannot be computed from them",
                "no step between", "add `dl`, the distance after which a step is due");
  } else if (reader.scope() == LawScope::modal) {
    reader.fail("E4340", feed_last,
                reader.text(feed_last) +
                    " without `dl` in a block without axis words: there is no length from which "
                    "`dl` could be computed",
                "no path in this block", "add `dl`, or program the law in the block of the motion");
  }
}

}  // namespace

void read_linear_law(LawReader& reader) {
  FeedLaw& law = reader.law();
  law.feed_first = reader.feed(feed_first);
  law.feed_step = reader.step_of_feed();
  law.path_step_mm = std::abs(reader.signed_length(path_step));
  law.falls = reader.value(path_step) < 0.0;
  if (!reader.has(feed_last)) return;
  law.feed_last = reader.feed(feed_last);
  if (reader.failed()) return;
  law.falls = law.feed_last < law.feed_first;
  reader.has(path_step) ? check_direction(reader) : check_path_step_follows(reader);
  if (law.feed_last == law.feed_first) law.feed_step = 0.0;
}

bool is_plausible_linear_law(const FeedLaw& law) {
  return law.feed_first > 0.0 && law.path_step_mm > 0.0;
}

std::vector<LawValue> values_of_linear_law(const FeedLaw& law) {
  std::vector<LawValue> values{{"feed_first", law.feed_first},
                               {"feed_step", law.falls ? 0.0 - law.feed_step : law.feed_step}};
  if (law.feed_last != 0.0) values.push_back({"feed_last", law.feed_last});
  if (law.path_step_mm != 0.0) values.push_back({"path_step", law.path_step_mm});
  if (law.speed == FeedLaw::Speed::unchanged) return values;
  const bool cutting = law.speed == FeedLaw::Speed::m_per_min;
  values.push_back({"speed_unit", cutting ? std::string_view("m/min") : std::string_view("1/min")});
  values.push_back({"speed_first", law.speed_first});
  values.push_back(law.speed_last != 0.0 ? LawValue{"speed_last", law.speed_last}
                                         : LawValue{"speed_step", law.speed_step});
  return values;
}

}  // namespace stanok::lang
