// A feed law as a JSON object: what `stanok interpret` prints of it.
#pragma once

#include <string>

#include "lang/contract/command.h"

namespace stanok::client {

// Appends the object to `text`: "law" and what this law has of feeds, lengths (mm) and speeds.
void append_feed_law(std::string& text, const lang::FeedLaw& law);

}  // namespace stanok::client
