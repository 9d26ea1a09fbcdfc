#include "channels/cycle/arrival_window.h"

namespace stanok::channels {

bool ArrivalWindow::has_prepared(const Arrivals& recorded) const {
  if (recorded.resets > arrivals_.resets) return true;  // what it saw is counted from there on
  return link_.path.chunks.pushed() - forgotten_.chunks >= recorded.chunks &&
         link_.items.pushed() - forgotten_.items >= recorded.items &&
         link_.riders.pushed() - forgotten_.riders >= recorded.riders &&
         link_.remarks.pushed() - forgotten_.remarks >= recorded.remarks;
}

void ArrivalWindow::open(const Arrivals& recorded) RT_SAFE {
  const bool resets = recorded.resets > arrivals_.resets;
  const Arrivals& seen = resets ? all : recorded;
  link_.show({.resets = 0,
              .chunks = forgotten_.chunks + seen.chunks,
              .items = forgotten_.items + seen.items,
              .riders = forgotten_.riders + seen.riders,
              .remarks = forgotten_.remarks + seen.remarks});
  const Arrivals shown = link_.shown();
  arrivals_.chunks = shown.chunks - forgotten_.chunks;
  arrivals_.items = shown.items - forgotten_.items;
  arrivals_.riders = shown.riders - forgotten_.riders;
  arrivals_.remarks = shown.remarks - forgotten_.remarks;
}

void ArrivalWindow::show_rest() RT_SAFE {
  Arrivals rest = all;
  rest.items = link_.items.shown();
  link_.show(rest);
}

void ArrivalWindow::begin_anew(std::uint64_t items) RT_SAFE {
  forgotten_ = link_.shown();
  forgotten_.items = items;
  arrivals_ = {.resets = arrivals_.resets + 1, .chunks = 0, .items = link_.items.size()};
}

}  // namespace stanok::channels
