#include "lang/feed_law/speed_law.h"

#include "lang/feed_law/law_reader.h"

namespace stanok::lang {
namespace {

using enum LawAddress;

struct SpeedAddresses {
  LawAddress first;
  LawAddress last;
  LawAddress step;
};

// `unit`: of the speed per programmed unit.
void read_speed(LawReader& reader, const SpeedAddresses& speed, double unit) {
  FeedLaw& law = reader.law();
  law.speed_first = reader.positive(speed.first) * unit;
  if (reader.has(speed.last)) law.speed_last = reader.positive(speed.last) * unit;
  if (reader.has(speed.step)) law.speed_step = reader.value(speed.step) * unit;
  // Its steps are as many as those of the feed, or as fit into the block.
  if (reader.has(speed.last) && law.feed_step == 0.0 && reader.scope() == LawScope::modal) {
    reader.fail("E4340", speed.last,
                reader.text(speed.last) + " with " + reader.text(feed_last) +
                    ", the same as `S_n`, in a block without axis "
                    "words: there is no length over which the speed changes",
                "no path in this block",
                "give the step `" + std::string(name_of(speed.step)) +
                    "`, or program the law in the block of the motion");
  }
}

}  // namespace

void read_spindle_speed_law(LawReader& reader) {
  read_linear_law(reader);
  read_speed(reader, {speed_first, speed_last, speed_step}, 1.0);
}

void read_cutting_speed_law(LawReader& reader) {
  read_linear_law(reader);
  read_speed(reader, {cutting_first, cutting_last, cutting_step},
             reader.around().cutting_speed_unit);
}

}  // namespace stanok::lang
