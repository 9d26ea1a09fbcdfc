#include "gateway/start/gateway.h"

#include <mosquitto.h>
#include <spdlog/spdlog.h>

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/signal_set.hpp>
#include <csignal>
#include <deque>
#include <exception>
#include <thread>

#include "gateway/broker/broker_publisher.h"
#include "gateway/cell/machine_reader.h"
#include "gateway/cell/state_board.h"
#include "gateway/history/history_writer.h"
#include "gateway/sparkplug/sparkplug_publisher.h"

namespace stanok::gateway {
namespace {

namespace asio = boost::asio;

std::vector<std::string> consumers_of(const GatewayOptions& options) {
  std::vector<std::string> consumers;
  if (options.has_broker) consumers.emplace_back(BrokerPublisher::consumer);
  if (!options.history.empty()) consumers.emplace_back(HistoryWriter::consumer);
  return consumers;
}

void rethrow(const std::exception_ptr& fault) {
  if (fault) std::rethrow_exception(fault);
}

}  // namespace

void run_gateway(const GatewayOptions& options) {
  check(options);
  std::filesystem::create_directories(options.state_folder);
  Outbox outbox(options.outbox(), options.events_max);
  outbox.set_consumers(consumers_of(options));
  StateBoard board(outbox.source());
  mosquitto_lib_init();

  asio::io_context io(1);
  asio::signal_set signals(io, SIGINT, SIGTERM);
  signals.async_wait([&io](const auto& /*error*/, int /*signal*/) { io.stop(); });

  // Addresses of readers must not change: their coroutines run on.
  std::deque<MachineReader> readers;
  for (const MachineAddress& machine : options.machines) {
    MachineReader& reader = readers.emplace_back(io.get_executor(), machine, options.prefix,
                                                 options.rate_hz, outbox, board);
    asio::co_spawn(io, reader.run(), rethrow);
  }
  std::jthread publisher;
  if (options.has_broker) {
    publisher = std::jthread([&](const std::stop_token& stop) {
      BrokerPublisher(options.broker, options.prefix, options.outbox(), board).run(stop);
    });
  }
  std::jthread sparkplug;
  if (!options.sparkplug_group.empty()) {
    sparkplug = std::jthread([&](const std::stop_token& stop) {
      SparkplugPublisher(options.broker, options.prefix, options.sparkplug_group, options.outbox(),
                         board)
          .run(stop);
    });
  }
  std::jthread history;
  if (!options.history.empty()) {
    history = std::jthread([&](const std::stop_token& stop) {
      HistoryWriter(options.history, options.outbox(), options.keep_days).run(stop);
    });
  }
  spdlog::info("{} machines, outbox {}", options.machines.size(), options.outbox().string());
  io.run();
}

}  // namespace stanok::gateway
