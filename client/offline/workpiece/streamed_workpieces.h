// The workpieces of a stream of messages, with the names that people call them by.
#pragma once

#include <vector>

#include "client/offline/workpiece/workpiece_output.h"
#include "runtime/workpiece/workpiece_stream.h"

namespace stanok::client {

[[nodiscard]] FileNames file_names_of(const runtime::WorkpieceStream& stream);
// All of them, cut as far as the messages go.
[[nodiscard]] std::vector<NamedWorkpiece> streamed_workpieces(runtime::WorkpieceStream& stream);

}  // namespace stanok::client
