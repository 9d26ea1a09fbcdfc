#include "runtime/log_observer.h"

#include <stdexcept>

namespace stanok::runtime {

LogObserver::LogObserver(const channels::MachineConfig& machine, const std::string& path,
                         std::string version) {
  auto writer = recording::LogWriter::open(path);
  if (!writer) throw std::runtime_error(writer.error().text);
  writer_ = std::move(*writer);
  stream_ = std::make_unique<recording::MessageStream>(
      recording::describe(machine, std::move(version), this_build()),
      std::vector<recording::MessageSink*>{writer_.get()});
}

std::string LogObserver::close() {
  static_cast<void>(writer_->flush());
  const auto& error = writer_->status().error;
  return error ? error->text : std::string();
}

std::string this_build() {
#if defined(__clang__)
  return "clang " __clang_version__;
#else
  return "g++ " __VERSION__;
#endif
}

}  // namespace stanok::runtime
