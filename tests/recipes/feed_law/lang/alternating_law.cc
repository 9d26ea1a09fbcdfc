#include "lang/feed_law/alternating_law.h"

#include "lang/feed_law/law_reader.h"

namespace stanok::lang {

void read_alternating_law(LawReader& reader) {
  reader.law().feed_first = reader.feed(LawAddress::feed_min);
  reader.law().feed_last = reader.feed(LawAddress::feed_max);
  reader.law().path_step_mm = reader.length(LawAddress::path_step);
}

bool is_plausible_alternating_law(const FeedLaw& law) {
  return law.feed_first > 0.0 && law.feed_last > 0.0 && law.path_step_mm > 0.0;
}

std::vector<LawValue> values_of_alternating_law(const FeedLaw& law) {
  return {
      {"feed_min", law.feed_first}, {"feed_max", law.feed_last}, {"path_step", law.path_step_mm}};
}

}  // namespace stanok::lang
