#include "client/offline/workpiece/workpiece_follow_command.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <functional>
#include <lcm/lcm-cpp.hpp>
#include <memory>
#include <stdexcept>

#include "client/offline/workpiece/streamed_workpieces.h"
#include "client/terminal/exit_codes.h"
#include "client/terminal/interrupts.h"
#include "client/terminal/noun_command.h"
#include "client/terminal/output.h"
#include "config/files/machine_file.h"
#include "recording/log/log_reader.h"
#include "runtime/recorded_run.h"

namespace stanok::client {
namespace {

using runtime::WorkpieceStream;

constexpr int wait_ms = 100;

struct FollowOptions {
  std::string source;
  std::string machine_file;
  std::string folder = ".";
  double every_s = 10.0;
  double until_s = -1.0;
  std::uint64_t memory_mib = simulation::memory_default >> 20U;
  bool json = false;
};

// Writes the pictures of all workpieces when another interval of machine time is over, and at the
// end their surfaces and reports as well.
class Album {
 public:
  explicit Album(const FollowOptions& options)
      : folder_(options.folder), every_s_(options.every_s), next_s_(options.every_s) {
    std::filesystem::create_directories(folder_);
  }

  void look(WorkpieceStream& stream) {
    if (next_s_ < 0.0 || stream.time_s() < next_s_) return;
    while (every_s_ > 0.0 && next_s_ <= stream.time_s()) next_s_ += every_s_;
    char name[32];
    std::snprintf(name, sizeof name, "part-%04d.png", ++pictures_);
    write(stream, {.stl = "", .picture = folder_ / name, .report = ""});
  }

  // False when a file could not be written.
  [[nodiscard]] bool finish(WorkpieceStream& stream) {
    write(stream, {.stl = folder_ / "part.stl",
                   .picture = folder_ / "part.png",
                   .report = folder_ / "part.json"});
    return !has_failed_;
  }

 private:
  void write(WorkpieceStream& stream, const WorkpieceFiles& files) {
    const auto workpieces = streamed_workpieces(stream);
    if (workpieces.empty()) return;
    for (const std::string& failure : write_files(workpieces, files, file_names_of(stream))) {
      complain(0, "E9204", failure);
      has_failed_ = true;
    }
    if (!files.picture.empty()) {
      write_message(fmt::format("{:10.3f} s  {}\n", stream.time_s(), files.picture));
    }
  }

  std::filesystem::path folder_;
  double every_s_;
  double next_s_;
  int pictures_ = 0;
  bool has_failed_ = false;
};

bool is_over(const FollowOptions& options, const WorkpieceStream& stream) {
  return is_interrupted() || (options.until_s >= 0.0 && stream.time_s() >= options.until_s);
}

int end(const FollowOptions& options, WorkpieceStream& stream, Album& album) {
  const bool is_written = album.finish(stream);
  if (const auto& missing = stream.missing(); missing.count > 0) {
    complain(0, "W720",
             fmt::format("{} setpoints are missing, the first at {:.3f} s: the tool goes straight "
                         "over each gap, and what it cut beside that is not shown",
                         missing.count, missing.first_s));
  }
  const auto workpieces = streamed_workpieces(stream);
  if (workpieces.empty()) {
    complain(0, "E9201",
             "no workpiece was announced; on a machine, `stanok workpiece allow` lets the daemon "
             "tell of them");
    return is_interrupted() ? exit_interrupted : exit_failed;
  }
  if (options.json) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const NamedWorkpiece& named : workpieces) {
      json.push_back(to_json(named, file_names_of(stream)));
      json.back()["program"] = named.title;
    }
    write_json(json);
  } else {
    print(workpieces, file_names_of(stream));
  }
  return is_written ? 0 : exit_failed;
}

int follow_log(const FollowOptions& options) {
  const auto run = runtime::read_run(options.source);
  auto reader = recording::LogReader::open(options.source);
  if (!reader) throw std::runtime_error(reader.error().text);
  WorkpieceStream stream(run->beginning.machine.machine, options.memory_mib << 20U, complain,
                         run->files.get());
  Album album(options);
  while (const auto event = reader->next()) {
    stream.take(event->channel, event->bytes);
    album.look(stream);
    if (is_over(options, stream)) break;
  }
  return end(options, stream, album);
}

struct BusHandler {
  WorkpieceStream& stream;

  void handle(const lcm::ReceiveBuffer* buffer, const std::string& channel) {
    stream.take(channel, {static_cast<const std::uint8_t*>(buffer->data), buffer->data_size});
  }
};

int follow_bus(const FollowOptions& options) {
  if (options.machine_file.empty())
    throw CLI::RequiredError("--machine: the bus does not tell the geometry of the machine");
  const config::MachineFile file = config::read_machine_file(options.machine_file);
  lcm::LCM bus(options.source);
  if (!bus.good()) throw std::runtime_error("LCM " + options.source + " cannot be opened");
  WorkpieceStream stream(file.machine, options.memory_mib << 20U, complain);
  Album album(options);
  BusHandler handler{stream};
  lcm::Subscription* subscription = bus.subscribe("STANOK_.*", &BusHandler::handle, &handler);
  subscription->setQueueCapacity(0);  // without a bound: a picture takes a while
  while (!is_over(options, stream)) {
    if (bus.handleTimeout(wait_ms) < 0) break;
    album.look(stream);
  }
  return end(options, stream, album);
}

int follow(const FollowOptions& options) {
  catch_interrupts();
  const bool is_url = options.source.find("://") != std::string::npos;
  return is_url ? follow_bus(options) : follow_log(options);
}

}  // namespace

void add_workpiece_follow_command(CLI::App& app, int& exit_code) {
  const auto options = std::make_shared<FollowOptions>();
  CLI::App& noun = noun_command(app, "workpiece", "virtual workpiece");
  CLI::App* command = noun.add_subcommand(
      "follow",
      "cut a virtual workpiece along with a machine: pictures during the run, STL at the end");
  command->add_option("SOURCE", options->source, "log file, or URL of the LCM bus")
      ->type_name("FILE|URL")
      ->required();
  command
      ->add_option("--machine", options->machine_file,
                   "machine file; required for the bus only: a log contains its own")
      ->type_name("FILE");
  command
      ->add_option("--out", options->folder,
                   "folder for part-0001.png ..., part.png, part.stl, part.json")
      ->type_name("FOLDER")
      ->capture_default_str();
  command->add_option("--every", options->every_s, "machine time between pictures, s")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  command->add_option("--until", options->until_s, "stop at this machine time, s");
  command
      ->add_option("--workpiece-memory", options->memory_mib, "maximum memory of a workpiece, MiB")
      ->capture_default_str()
      ->check(CLI::Range(1, 1 << 20));
  command->add_flag("--json", options->json, "print JSON");
  command->callback([options, &exit_code] { exit_code = follow(*options); });
}

}  // namespace stanok::client
