// What the preparation of a channel works with, on the machine of MachineBench, and its rings,
// which no cycle empties.
#pragma once

#include <string>
#include <vector>

#include "channels/preparation/preparation_parts.h"
#include "channels/preparation/program_shelf.h"
#include "lang/contract/active_codes.h"
#include "tests/support/machine/machine_bench.h"

namespace stanok::channels {

struct PreparationBench {
  // All items that are in the ring, taken out of it.
  std::vector<Item> items() {
    std::vector<Item> found;
    Item item;
    while (link.items.pop(item)) found.push_back(item);
    return found;
  }
  static ProgramLoad load_of(const std::string& program) {
    return {.number = 1, .load_in_use = 0, .program = ShortText(program)};
  }
  static RunStart start() { return {.run = 7, .load = 1, .stand = {.scheme = 1}}; }

  MachineConfig machine = stanok::testing::two_channel_machine();
  const ChannelConfig& channel = machine.channels[0];
  SchemeSet schemes = make_schemes(channel);
  stanok::testing::MemoryFiles files;
  LiveTables tables{machine};
  SharedVariables shared;
  ChannelLink link;
  ReportBook reports;
  SituationBook blocks;
  PreparationBooks books{tables, shared, link, reports, blocks};
};

}  // namespace stanok::channels
