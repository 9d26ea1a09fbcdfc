#include "tests/support/chain/operator_session.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "config/files/machine_file.h"
#include "lang/contract/active_codes.h"
#include "tests/support/project_folders.h"
#include "tests/support/sanitized.h"

namespace stanok::testing {
namespace {

constexpr int cycles_max = 400000;
constexpr double same = 1e-9;

void compare(std::string& found, const std::string& what, double a, double b) {
  if (std::abs(a - b) <= same) return;
  if (!found.empty()) found += "; ";
  found += what + " " + std::to_string(a) + " and " + std::to_string(b);
}

using Row = std::map<std::string, double>;

Row values_of(const channels::TablesConfig& tables) {
  Row values;
  for (const auto& [name, row] : tables.offsets) {
    for (const auto& [axis, value] : row) values[name + " " + axis] = value;
  }
  for (const auto& [channel, points] : tables.reference_points) {
    for (const auto& [name, row] : points) {
      for (const auto& [axis, value] : row)
        values[name + " of channel " + std::to_string(channel) + " " + axis] = value;
    }
  }
  for (const channels::ToolEdge& tool : tables.tools) {
    const std::string name =
        "tool " + std::to_string(tool.number) + " edge " + std::to_string(tool.edge);
    values[name + " length"] = tool.length;
    values[name + " length_x"] = tool.length_x;
    values[name + " length_y"] = tool.length_y;
    values[name + " wear"] = tool.wear_length;
    values[name + " radius"] = tool.radius;
  }
  return values;
}

}  // namespace

std::vector<std::string> machines_with_tools() {
  std::vector<std::string> names;
  const std::filesystem::path folder = source_folder() + "/config/machines";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".toml") continue;
    const std::string name = entry.path().stem();
    if (!shipped_machine(name).tables.tools.empty()) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

channels::MachineConfig shipped_machine(const std::string& name) {
  return config::read_machine_file(source_folder() + "/config/machines/" + name + ".toml").machine;
}

std::string difference(const ChannelLeft& a, const ChannelLeft& b) {
  std::string found;
  for (std::size_t k = 0; k < a.axes_M.size(); ++k)
    compare(found, "axis " + std::to_string(k), a.axes_M[k], b.axes_M[k]);
  Row values = values_of(a.tables);
  const Row others = values_of(b.tables);
  for (const auto& [name, value] : others) values.try_emplace(name, 0.0);
  for (const auto& [name, value] : values) {
    const auto other = others.find(name);
    compare(found, name, value, other == others.end() ? 0.0 : other->second);
  }
  for (std::size_t k = 0; k < a.frame.offset.size(); ++k)
    compare(found, "zero of axis " + std::to_string(k), a.frame.offset[k], b.frame.offset[k]);
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      compare(found, "rotation", a.frame.rotation.rows()[row][column],
              b.frame.rotation.rows()[row][column]);
    }
  }
  for (std::size_t k = 0; k < a.words.size(); ++k)
    compare(found, "word of axis " + std::to_string(k), a.words[k], b.words[k]);
  if (a.length.tool != b.length.tool || a.length.edge != b.length.edge ||
      a.length.row != b.length.row || a.length.mode != b.length.mode)
    found += "; origin of the length";
  for (std::size_t k = 0; k < 3; ++k) {
    compare(found, "length", a.length.offset_mm[k], b.length.offset_mm[k]);
    compare(found, "base of the length", a.length.base_mm[k], b.length.base_mm[k]);
  }
  if (a.mode != b.mode) found += "; mode of the point";
  compare(found, "tool", a.tool, b.tool);
  compare(found, "spindle", a.spindle_rev_per_min, b.spindle_rev_per_min);
  std::vector<std::string> codes;
  std::set_symmetric_difference(a.codes.begin(), a.codes.end(), b.codes.begin(), b.codes.end(),
                                std::back_inserter(codes));
  for (const std::string& code : codes) found += "; " + code + " in one alone";
  return found;
}

channels::MachineConfig HandPlace::config() const {
  channels::MachineConfig config = shipped_machine(machine);
  config.entry_limits = random_entries;
  for (channels::ChannelConfig& one : config.channels) {
    one.rules.dialect = dialect;
    if (one.id == channel) one.scheme = scheme;
  }
  return config;
}

std::string HandPlace::name() const {
  std::string text = machine + "_" + std::to_string(channel);
  if (scheme != 1) text += "_scheme" + std::to_string(scheme);
  for (const auto& [of, called] :
       {std::pair{lang::Dialect::fanuc, "_fanuc"}, std::pair{lang::Dialect::haas, "_haas"},
        std::pair{lang::Dialect::linuxcnc, "_linuxcnc"}}) {
    if (dialect == of) text += called;
  }
  return text;
}

std::vector<HandPlace> hand_places() {
  std::vector<HandPlace> places;
  for (const std::string& name : machines_with_tools()) {
    for (const channels::ChannelConfig& channel : shipped_machine(name).channels) {
      if (channel.kind == lang::ChannelKind::master) continue;
      for (const auto& scheme : channel.schemes) places.push_back({name, channel.id, scheme.id});
      if (channel.id != 1) continue;
      for (const lang::Dialect dialect :
           {lang::Dialect::fanuc, lang::Dialect::haas, lang::Dialect::linuxcnc})
        places.push_back({name, channel.id, channel.schemes[0].id, dialect});
    }
  }
  if (!is_sanitized) return places;
  std::vector<HandPlace> fewer;
  std::size_t others = 0;
  for (const HandPlace& place : places) {
    const bool is_first = fewer.empty() || fewer.back().machine != place.machine;
    if (is_first || others++ % 4 == 0) fewer.push_back(place);
  }
  return fewer;
}

HandBench::HandBench(channels::MachineConfig machine, int channel)
    : machine_(std::move(machine)),
      channel_(channel),
      bench_(machine_, {.on_at_start = true, .stops_go_on = false}) {
  settle();
}

const channels::ChannelConfig& HandBench::channel() const {
  return *std::find_if(machine_.channels.begin(), machine_.channels.end(),
                       [this](const auto& one) { return one.id == channel_; });
}

void HandBench::settle() {
  for (int n = 0; n < cycles_max; ++n) {
    bench_.cycle();
    if (bench_.machine().is_idle() || bench_.machine().waits_for_operator()) return;
  }
  ADD_FAILURE() << "the machine does not come to rest";
}

std::string HandBench::wait(const std::function<bool()>& is_over) {
  const std::size_t alarms = bench_.machine().alarms().size();
  const std::size_t replies = bench_.replies().size();
  for (int n = 0; n < cycles_max && !is_over(); ++n) {
    bench_.cycle();
    for (std::size_t k = replies; k < bench_.replies().size(); ++k) {
      const channels::OperatorReply& reply = bench_.replies()[k];
      if (!reply.ok) return reply.code.view().empty() ? "E7005" : std::string(reply.code.view());
    }
    const auto all = bench_.machine().alarms();
    if (all.size() > alarms && bench_.machine().is_idle()) return all.back().diagnostic.code;
  }
  return is_over() ? "" : "no end";
}

std::string HandBench::type(const std::string& line) {
  bench_.ask(channels::OperatorAction::mdi, channel_, line);
  bench_.cycle();
  const std::uint32_t run = now().run;
  return wait([&] { return now().run != run && bench_.machine().is_idle(); });
}

std::string HandBench::run_to_stop(const std::string& text, const std::string& subprograms) {
  bench_.program("lines.nc", text + "\nM0\nM2\n" + subprograms);
  bench_.run(channel_, "lines.nc");
  return wait([&] {
    return now().hold_cause == channels::HoldCause::program_stop &&
           bench_.machine().waits_for_operator();
  });
}

std::string HandBench::ask(const channels::CommandFields& command) {
  const std::size_t replies = bench_.replies().size();
  channels::OperatorEvent event;
  event.channel = channel_;
  event.command = channels::command_of(command).value();
  bench_.ask(event);
  settle();
  for (std::size_t k = replies; k < bench_.replies().size(); ++k) {
    const channels::OperatorReply& reply = bench_.replies()[k];
    if (!reply.ok) return std::string(reply.code.view());
  }
  return "";
}

void HandBench::begin(const std::string& text, std::size_t cycles) {
  bench_.program("lines.nc", text);
  bench_.run(channel_, "lines.nc");
  pass(cycles);
}

void HandBench::pass(std::size_t cycles) {
  for (std::size_t n = 0; n < cycles; ++n) bench_.cycle();
}

channels::MachineConfig HandBench::kept() const {
  channels::MachineConfig config = machine_;
  config.tables = bench_.machine().tables();
  for (const channels::ChannelConfig& channel : machine_.channels) {
    const channels::ChannelOutput& output = bench_.channel(channel.id);
    for (std::size_t k = 0; k < channel.axes.size(); ++k)
      config.axes[channel.axes[k]].start = output.axes[k].position;
  }
  return config;
}

lang::AxisValues HandBench::shown() {
  lang::AxisValues point{};
  for (std::size_t k = 0; k < point.size(); ++k) point[k] = now().point_W[k].value;
  return lang::words_at(bench_.machine().situation(now()).meaning, point);
}

std::string HandBench::typed_back() {
  constexpr double inch = 25.4;
  const lang::Meaning meaning = bench_.machine().situation(now()).meaning;
  const channels::ChannelConfig& channel = this->channel();
  const auto scheme = std::find_if(channel.schemes.begin(), channel.schemes.end(),
                                   [&](const auto& one) { return one.id == now().scheme; });
  const lang::AxisValues words = shown();
  std::string line = "G90 G40 G80 G0";
  for (std::size_t k = 0; k < channel.words.size(); ++k) {
    const auto& axes = scheme->axes;
    if (std::find(axes.begin(), axes.end(), static_cast<int>(k)) == axes.end()) continue;
    if (now().drives[k].follows_velocity) continue;
    const bool is_rotary = machine_.axes[channel.axes[k]].rotary;
    std::array<char, 40> value{};
    std::snprintf(value.data(), value.size(), "%.13f",
                  words[k] / (meaning.inches() && !is_rotary ? inch : 1.0));
    const std::string& word = channel.words[k];
    line += " " + word + (word.size() > 1 ? "=" : "") + value.data();
  }
  return line;
}

ChannelLeft HandBench::left() {
  const channels::SituationReport situation = bench_.machine().situation(now());
  ChannelLeft left;
  const lang::AxisValues words = shown();
  for (std::size_t k = 0; k < channel().axes.size(); ++k) {
    const bool turns =
        now().drives[k].follows_velocity;  // a spindle: how long it does is no matter
    left.axes_M.push_back(turns ? 0.0 : now().axes[k].position);
    if (turns) continue;
    left.words.push_back(words[k]);
  }
  left.tables = bench_.machine().tables();
  left.frame = now().work_frame;
  left.mode = now().point_mode;
  lang::ActiveCodes codes = situation.meaning.codes;
  for (const lang::Group passing :
       {lang::Group::stop, lang::Group::state, lang::Group::input_output, lang::Group::subprogram})
    codes[passing] = 0;
  for (const char letter : {'G', 'M'}) {
    for (const std::string& code : lang::names_of(codes, letter)) left.codes.push_back(code);
  }
  std::sort(left.codes.begin(), left.codes.end());
  left.length = situation.meaning.terms->length;
  left.tool = now().tool.number;
  left.spindle_rev_per_min = now().process.spindles[0].rev_per_min;
  return left;
}

OperatorSession::OperatorSession(const channels::MachineConfig& machine, int channel,
                                 Choices& choices, WordCounts counts)
    : machine_(machine),
      channel_(channel),
      source_(machine, choices, channel, std::move(counts)),
      lines_({source_.first()}) {
  set_up_anew();
}

void OperatorSession::set_up_anew() {
  bench_ = std::make_unique<HandBench>(machine_, channel_);
  for (const std::string& line : lines_)
    EXPECT_EQ(bench_->type(line), "") << line << "\n" << text();
}

void OperatorSession::type(int count) {
  constexpr int tries = 8;
  for (int n = 0, refused = 0; (n < count || source_.goes_on()) && refused < tries;) {
    const std::string line = source_.next(bench_->shown());
    if (bench_->type(line).empty()) {
      lines_.push_back(line);
      source_.taken();
      ++n;
      continue;
    }
    ++refused;
    if (bench_->has_alarm()) set_up_anew();
  }
}

void OperatorSession::forget() {
  bench_ = std::make_unique<HandBench>(machine_, channel_);
}

void OperatorSession::restart() {
  bench_ = std::make_unique<HandBench>(bench_->kept(), channel_);
}

std::string OperatorSession::text() const {
  std::string text;
  for (const std::string& line : lines_) text += line + "\n";
  return text;
}

}  // namespace stanok::testing
