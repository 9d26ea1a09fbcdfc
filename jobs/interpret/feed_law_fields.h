// A feed law by its names: what `stanok interpret` and Python give of it.
#pragma once

#include "base/fields.h"
#include "lang/contract/command.h"

namespace stanok::jobs {

// "law", and what this law has of feeds, lengths (mm) and speeds.
[[nodiscard]] Fields feed_law_fields(const lang::FeedLaw& law);

}  // namespace stanok::jobs
