#include "web/server/web_log.h"

#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <cstdlib>

namespace stanok::web {

void log_to_standard_error() {
  auto logger = spdlog::stderr_logger_st("stanok-web");
  // Set by systemd; read before any thread exists.
  const bool has_journal =
      std::getenv("JOURNAL_STREAM") != nullptr;  // NOLINT(concurrency-mt-unsafe)
  logger->set_pattern(has_journal ? "%l: %v" : "%Y-%m-%d %H:%M:%S.%e %l: %v");
  spdlog::set_default_logger(std::move(logger));
}

}  // namespace stanok::web
