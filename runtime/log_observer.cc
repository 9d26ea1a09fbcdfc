#include "runtime/log_observer.h"

#include <stdexcept>

namespace stanok::runtime {

LogObserver::LogObserver(const config::MachineFile& file, const RunSetup& setup,
                         const std::string& path, std::string version) {
  auto writer = recording::LogWriter::open(path);
  if (!writer) throw std::runtime_error(writer.error().text);
  writer_ = std::move(*writer);
  stream_ = std::make_unique<recording::MessageStream>(
      description_of(file, std::move(version), this_build()),
      std::vector<recording::MessageSink*>{writer_.get()});
  record_setup(setup, file, *stream_);
}

std::string LogObserver::close() {
  static_cast<void>(writer_->finish());
  const auto& error = writer_->status().error;
  if (error) return error->text;
  if (lost_cycle_ == 0) return {};
  return "W720 inputs from cycle " + std::to_string(lost_cycle_) +
         " on are missing from the log: too many arrived in one cycle; it can be replayed only up "
         "to this cycle";
}

}  // namespace stanok::runtime
