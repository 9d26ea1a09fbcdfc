#include "channels/preparation/preparation_parts.h"

#include <stdexcept>
#include <string>
#include <utility>

#include "channels/contract/channel_description.h"
#include "channels/contract/motion_config.h"

namespace stanok::channels {

SchemeSet make_schemes(const ChannelConfig& channel) {
  SchemeSet schemes;
  for (const kinematics::SchemeConfig& config : channel.schemes) {
    auto scheme = kinematics::make_scheme(config);
    if (scheme == nullptr) throw std::invalid_argument("unknown scheme type " + config.type);
    schemes.emplace(config.id, std::move(scheme));
  }
  return schemes;
}

PreparationParts::PreparationParts(const MachineConfig& machine, const ChannelConfig& channel,
                                   const SchemeSet& scheme_set, const lang::Files& files,
                                   const PreparationBooks& books)
    : config(channel),
      schemes(scheme_set),
      reports(books.reports),
      motion(motion_config(machine, channel)),
      description(channel_description(machine, channel)),
      tables(books.tables, machine, channel, &books.link.lengths),
      interpreter(description, tables, files),
      queue(motion, books.link, books.shared, books.situations),
      feed(machine, channel, motion, queue, &tables) {}

void PreparationParts::restart(const Stand& stand) {
  scheme = schemes.contains(stand.scheme) ? schemes.at(stand.scheme).get() : nullptr;
  feed.blocks().restart(scheme, stand.axes_M);
  if (scheme != nullptr) tables.set_scheme(*scheme);
  interpreter.take_tool({stand.tool.number, stand.tool.edge});
}

void PreparationParts::stand(const Stand& stand) {
  scheme = schemes.contains(stand.scheme) ? schemes.at(stand.scheme).get() : nullptr;
  feed.blocks().change_scheme(scheme, stand.axes_M);
  if (scheme != nullptr) tables.set_scheme(*scheme);
  interpreter.take_tool({stand.tool.number, stand.tool.edge});
}

void PreparationParts::set_program(std::shared_ptr<const lang::Program> next) {
  program = std::move(next);
  feed.set_program(program);
}

}  // namespace stanok::channels
