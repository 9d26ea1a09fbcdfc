#include "lang/feed_law/interrupted_law.h"

#include "lang/feed_law/law_reader.h"

namespace stanok::lang {

void read_interrupted_law(LawReader& reader) {
  // No way to stand for: no interruption, as the operator ends his.
  if (reader.value(LawAddress::stand) == 0.0) {
    static_cast<void>(reader.length(LawAddress::cut));
    reader.law() = {};
    return;
  }
  reader.law().stand_mm = reader.length(LawAddress::stand);
  reader.law().cut_mm = reader.length(LawAddress::cut);
}

bool is_plausible_interrupted_law(const FeedLaw& law) {
  return !law.gives_feed() && law.stand_mm > 0.0 && law.cut_mm > 0.0;
}

std::vector<LawValue> values_of_interrupted_law(const FeedLaw& law) {
  return {{"stand", law.stand_mm}, {"cut", law.cut_mm}};
}

}  // namespace stanok::lang
