// RecordedWork: what is known of the preparation of a channel in a run that is repeated.
//
// A preparation runs ahead of the cycle, and what it read of the tables depended on how far. It is
// repeated with the takings of the recorded run, and goes no farther than these are known: a taking
// is in the recording before the first thing that was made behind it.
#pragma once

#include <cstdint>
#include <deque>

#include "channels/contract/input_record.h"
#include "channels/contract/output.h"

namespace stanok::channels {

struct RecordedWork {
  Arrivals known;                   // the newest that has been read
  std::deque<TableTaking> takings;  // in their order, those that were not repeated yet

  // The one at this command of a run, if there is one; those before it were never reached.
  [[nodiscard]] const TableTaking* at(std::uint32_t run, std::uint64_t command) {
    while (!takings.empty() && is_before(takings.front(), run, command)) takings.pop_front();
    const bool is_here =
        !takings.empty() && takings.front().run == run && takings.front().command == command;
    return is_here ? &takings.front() : nullptr;
  }

 private:
  static bool is_before(const TableTaking& taking, std::uint32_t run, std::uint64_t command) {
    return taking.run < run || (taking.run == run && taking.command < command);
  }
};

}  // namespace stanok::channels
