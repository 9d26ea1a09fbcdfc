// Feeds in the text of a part program: a block becomes several, each with its own F.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace stanok::jobs {

// Points of a block in the words of the program, and the feed up to each; the last one is its end.
struct FedPoint {
  std::string words;  // "X60 Z-20"; empty: the end of the block as it is programmed
  std::string feed;   // "F0.157"
};

// The program with these lines (from 1) in place of those: the points before the end as blocks of
// their own, then the line with its F replaced or added. #adaptive lines become comments: the feeds
// are made.
[[nodiscard]] std::string with_feeds(const std::string& text,
                                     const std::map<std::uint32_t, std::vector<FedPoint>>& lines);

}  // namespace stanok::jobs
