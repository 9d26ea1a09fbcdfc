#include "client/offline/workpiece/streamed_workpieces.h"

namespace stanok::client {

FileNames file_names_of(const runtime::WorkpieceStream& stream) {
  return [files = stream.files()](const simulation::Origin& origin) {
    const auto found = files.find({origin.channel, origin.run});
    if (found == files.end()) return std::string();
    const std::vector<std::string>& names = found->second;
    if (origin.file < names.size()) return names[origin.file];
    return names.front() + " (file " + std::to_string(origin.file) + " of it)";
  };
}

std::vector<NamedWorkpiece> streamed_workpieces(runtime::WorkpieceStream& stream) {
  const FileNames name_of = file_names_of(stream);
  std::vector<NamedWorkpiece> named;
  for (runtime::ChannelFeed* const feed : stream.feeds()) {
    feed->follower().flush();
    for (const auto& workpiece : feed->follower().workpieces()) {
      named.push_back({workpiece.get(), title_of(*workpiece, name_of, feed->channel()),
                       removal_of(*workpiece)});
    }
  }
  return named;
}

}  // namespace stanok::client
