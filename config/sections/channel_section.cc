// Keys and checks of [[channel]]; names of axes become indices in the machine.
#include "config/sections/channel_section.h"

#include <algorithm>
#include <numeric>
#include <set>

#include "channels/contract/channel_description.h"
#include "channels/contract/motion_config.h"
#include "channels/contract/output.h"
#include "config/sections/automatic_feed_section.h"
#include "config/sections/axis_section.h"
#include "config/sections/scheme_file.h"
#include "lang/text/dialect_line.h"
#include "lang/text/source.h"

namespace stanok::config {
namespace {

using channels::ChannelConfig;
using channels::MachineConfig;

struct ChannelFile {
  ChannelConfig channel;
  std::string kind = "mill";
  Texts axes;
  int active = 0;
  Subtables schemes = nullptr;
  Subtables automatic_feeds = nullptr;
  std::string on_owner_failure = "hold";
  std::string dialect = "stanok";
  std::string code_system;
};

const Keys<ChannelFile>& channel_keys() {
  static const Keys<ChannelFile> keys = {
      {"id", at<&ChannelFile::channel, &ChannelConfig::id>, required, "",
       "number by which programs and operators call the channel", from(1, 99)},
      {"name", at<&ChannelFile::channel, &ChannelConfig::name>, required, "", "name to display"},
      {"kind", at<&ChannelFile::kind>, optional, "",
       "set of codes of its programs; a master has no axes and no spindles",
       one_of({"mill", "lathe", "grind", "master"})},
      {"axes", at<&ChannelFile::axes>, optional, "",
       "names of its [[axis]], at most 8, in the order of displays and messages"},
      {"words", at<&ChannelFile::channel, &ChannelConfig::words>, optional, "",
       "names of the axes in its programs, in the same order", any, "their names"},
      {"spindles", at<&ChannelFile::channel, &ChannelConfig::spindles>, optional, "",
       "ids of its [[spindle]]; the first is the master spindle"},
      {"active", at<&ChannelFile::active>, optional, "",
       "scheme at power-on; may also be written as scheme = N", from(1), "the first"},
      {"scheme", at<&ChannelFile::schemes>, optional, "", "kinematic schemes", any,
       "scheme 1: cartesian, all axes, zero at 0"},
      {"automatic_feed", at<&ChannelFile::automatic_feeds>, optional, "",
       "feed laws that the cycle computes from a sensor of the master spindle", any, "none"},
      {"path_tolerance", at<&ChannelFile::channel, &ChannelConfig::path_tolerance_mm>, optional,
       "mm", "how far the path may deviate from a corner under G64 without P", not_negative},
      {"orientation_tolerance",
       at<&ChannelFile::channel, &ChannelConfig::orientation_tolerance_deg>, optional, "deg",
       "the same for rotary axes", not_negative},
      {"arc_radius_tolerance", at<&ChannelFile::channel, &ChannelConfig::arc_radius_tolerance_mm>,
       optional, "mm", "how far the start and end radius of an arc may differ", not_negative},
      {"on_owner_failure", at<&ChannelFile::on_owner_failure>, optional, "",
       "what a channel does when the channel that started it fails",
       one_of({"hold", "continue", "reset"})},
      {"probe_input", at<&ChannelFile::channel, &ChannelConfig::probe_input>, optional, "",
       "digital input that is on while the probe of G38.2 to G38.5 touches", from(0, 63), "none"},
      {"skip_inputs", at<&ChannelFile::channel, &ChannelConfig::skip_inputs>, optional, "",
       "digital inputs of G31 P2, P3 and P4"},
      {"measuring_feed",
       at<&ChannelFile::channel, &ChannelConfig::tool_measuring,
          &lang::ToolMeasuring::feed_mm_per_min>,
       optional, "mm/min", "feed of `G37` on the last part of the path to the tool setter",
       positive},
      {"measuring_before",
       at<&ChannelFile::channel, &ChannelConfig::tool_measuring, &lang::ToolMeasuring::before_mm>,
       optional, "mm", "where that part begins: distance before the position of `G37`", positive},
      {"measuring_within",
       at<&ChannelFile::channel, &ChannelConfig::tool_measuring, &lang::ToolMeasuring::within_mm>,
       optional, "mm",
       "how far from the position of `G37` a tool may touch; not more than measuring_before",
       positive},
      {"dialect", at<&ChannelFile::dialect>, optional, "",
       "control whose meaning applies where controls contradict each other",
       one_of({"stanok", "linuxcnc", "fanuc", "haas"})},
      {"code_system", at<&ChannelFile::code_system>, optional, "",
       "G codes of a lathe in the dialects fanuc and haas, by the Fanuc name",
       one_of({"A", "B", "C"}), "B"},
      {"plain_corners", at<&ChannelFile::channel, &ChannelConfig::plain_corners>, optional, "",
       "on lathes in the dialects fanuc and haas: A, C and R of `G1`, if they are not axes, are "
       "angle, chamfer and rounding without a comma"},
      {"tool_change", at<&ChannelFile::channel, &ChannelConfig::tool_change>, optional, "",
       "which word changes the tool", one_of({"m6", "t_word"})},
      {"t_format", at<&ChannelFile::channel, &ChannelConfig::t_format>, optional, "",
       "what T selects: the tool, tool and edge (T0102: edge 2 of tool 1), or tool and offset "
       "(T0102: tool 1 with the values of tool 2)",
       one_of({"plain", "tool_edge", "tool_offset"})},
      {"address_alias", at<&ChannelFile::channel, &ChannelConfig::address_alias>, optional, "",
       "free letters that stand for named addresses (E = \"dS\"): A, B, C, E and, except on a "
       "lathe, V and W, if they are not axes"},
      {"codes", at<&ChannelFile::channel, &ChannelConfig::codes>, optional, "",
       "G and M codes of the user: the program they call (G200 = \"cycles/groove.nc\", G201 = "
       "\"lib.nc:slot\" for a function of it), or M100 to M899 as output before, after or "
       "with_motion (M120 = \"before wait\"), or a digital output and its feedback (M11 = \"output "
       "4 on, input 7 within 2 s\"); outputs may also be M50 to M53, M61 to M68, M70 to M72 and "
       "free codes below M100"},
  };
  return keys;
}

lang::ChannelKind channel_kind(std::string_view name) {
  if (name == "lathe") return lang::ChannelKind::lathe;
  if (name == "grind") return lang::ChannelKind::grind;
  if (name == "master") return lang::ChannelKind::master;
  return lang::ChannelKind::mill;
}

// A code system is one of Fanuc lathes.
lang::TextRules text_rules(const toml::table& table, const ChannelFile& file,
                           lang::ChannelKind kind, const Scope& scope) {
  lang::TextRules rules;
  rules.dialect = lang::dialect_called(file.dialect).value_or(lang::Dialect::stanok);
  if (file.code_system.empty()) return rules;
  rules.code_system =
      lang::code_system_called(lang::folded(file.code_system)).value_or(lang::CodeSystem::b);
  if (rules.is_fanuc() && kind == lang::ChannelKind::lathe) return rules;
  scope.fault(place_of(table, "code_system"),
              "a code system is only for lathes in the dialects fanuc and haas; remove it, or give "
              "the channel kind = \"lathe\" and dialect = \"fanuc\"");
  return rules;
}

channels::OwnerFailure owner_failure(std::string_view name) {
  if (name == "continue") return channels::OwnerFailure::continue_run;
  if (name == "reset") return channels::OwnerFailure::reset;
  return channels::OwnerFailure::hold;
}

void resolve_axes(const toml::table& table, const ChannelFile& file, const MachineConfig& machine,
                  ChannelConfig& channel, const Scope& scope) {
  for (std::size_t i = 0; i < file.axes.size(); ++i) {
    const std::string& name = file.axes[i];
    const auto axis = std::ranges::find(machine.axes, name, &channels::AxisConfig::name);
    const auto& place = place_of(table, "axes", i);
    const int index = static_cast<int>(axis - machine.axes.begin());
    if (axis == machine.axes.end()) {
      scope.fault(place,
                  "'" + name + "' is not an axis of the machine; add an [[axis]] with that name");
    } else if (std::ranges::find(channel.axes, index) != channel.axes.end()) {
      scope.fault(place, "axis '" + name + "' appears twice in axes; remove one");
    } else {
      channel.axes.push_back(index);
    }
  }
  if (file.axes.size() > motion::axes_max) {
    scope.fault(place_of(table, "axes", motion::axes_max),
                "more than 8 axes; a channel has at most 8: divide them between two channels");
  }
}

void check_words(const toml::table& table, const ChannelConfig& channel, const Scope& scope) {
  if (channel.words.size() != channel.axes.size()) {
    scope.fault(place_of(table, "words"), "words and axes differ in number (" +
                                              std::to_string(channel.words.size()) + " and " +
                                              std::to_string(channel.axes.size()) +
                                              "); give one word for each axis");
  }
  for (std::size_t i = 0; i < channel.words.size(); ++i) {
    const std::string& word = channel.words[i];
    const auto& place = place_of(table, "words", i);
    if (!is_axis_name(word)) {
      scope.fault(
          place,
          "'" + word +
              "' is not an axis word; use A, B, C, U, V, W, X, Y or Z, then digits, as in X2");
    }
    const auto before = channel.words.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::find(channel.words.begin(), before, word) != before) {
      scope.fault(place, "word '" + word + "' appears twice; each axis needs its own");
    }
  }
}

void check_spindles(const toml::table& table, const ChannelConfig& channel,
                    const MachineConfig& machine, const Scope& scope) {
  for (std::size_t i = 0; i < channel.spindles.size(); ++i) {
    const auto known =
        std::ranges::find(machine.spindles, channel.spindles[i], &channels::SpindleConfig::id);
    if (known != machine.spindles.end()) continue;
    scope.fault(place_of(table, "spindles", i), "there is no spindle " +
                                                    std::to_string(channel.spindles[i]) +
                                                    "; add a [[spindle]] with that id");
  }
}

void check_skip_inputs(const toml::table& table, const ChannelConfig& channel, const Scope& scope) {
  constexpr std::size_t most = 3;
  constexpr int last_input = 63;
  if (channel.skip_inputs.size() > most)
    scope.fault(place_of(table, "skip_inputs"), "G31 has P2, P3 and P4: three inputs at most");
  for (std::size_t i = 0; i < channel.skip_inputs.size(); ++i) {
    if (channel.skip_inputs[i] >= 0 && channel.skip_inputs[i] <= last_input) continue;
    scope.fault(place_of(table, "skip_inputs", i), "there is no digital input " +
                                                       std::to_string(channel.skip_inputs[i]) +
                                                       "; they are 0 to 63");
  }
}

void check_names(const toml::table& table, const ChannelConfig& channel, const Scope& scope) {
  if (const toml::table* codes = table["codes"].as_table()) {
    for (const auto& [key, node] : *codes) {
      const auto fault =
          channels::fault_of_code(key.str(), node.value<std::string>().value_or("before"));
      if (fault) scope.fault(key.source(), *fault);
    }
  }
  if (const toml::table* aliases = table["address_alias"].as_table()) {
    for (const auto& [key, node] : *aliases) {
      const auto address = node.value<std::string>();
      if (!address) continue;
      const auto fault = channels::fault_of_alias(key.str(), *address, channel);
      if (fault) scope.fault(key.source(), *fault);
    }
  }
}

// Words of lathes without a comma, and how far G37 may go: what would mean nothing is refused.
void check_dialect_keys(const toml::table& table, const ChannelConfig& channel,
                        const Scope& scope) {
  if (channel.plain_corners && channel.kind != lang::ChannelKind::lathe) {
    scope.fault(place_of(table, "plain_corners"),
                "plain_corners has a meaning only on lathes; remove it, or give the channel kind = "
                "\"lathe\"");
  }
  const lang::ToolMeasuring& measuring = channel.tool_measuring;
  if (measuring.within_mm > measuring.before_mm) {
    const char* const key =
        table.contains("measuring_within") ? "measuring_within" : "measuring_before";
    scope.fault(place_of(table, key),
                "measuring_within is larger than measuring_before: the tool would touch in rapid; "
                "make measuring_before the larger one");
  }
}

void check_master(const toml::table& table, const ChannelConfig& channel, const Scope& scope) {
  if (channel.kind == lang::ChannelKind::master) {
    for (const char* key : {"axes", "words", "spindles", "scheme", "active"}) {
      if (!table.contains(key)) continue;
      scope.fault(
          place_of(table, key),
          std::string(key) + " has no meaning in a master channel, which has no axes; remove it");
    }
  } else if (channel.axes.empty()) {
    scope.fault(place_of(table, "axes"),
                "the channel has no axes; name some, or make it kind = \"master\"");
  }
}

// Names of the axes that several channels have.
using SharedAxes = std::set<std::string, std::less<>>;

SharedAxes shared_axes(const toml::array& channels) {
  SharedAxes seen;
  SharedAxes shared;
  for (const toml::node& node : channels) {
    const toml::table* const table = node.as_table();
    const toml::array* const axes = table == nullptr ? nullptr : (*table)["axes"].as_array();
    if (axes == nullptr) continue;
    for (const toml::node& axis : *axes) {
      const std::string name = axis.value_or(std::string());
      if (!seen.insert(name).second) shared.insert(name);
    }
  }
  return shared;
}

kinematics::SchemeConfig default_scheme(const ChannelConfig& channel) {
  kinematics::SchemeConfig scheme;
  scheme.id = 1;
  scheme.type = kinematics::Cartesian::type_name;
  scheme.axes.resize(channel.axes.size());
  std::iota(scheme.axes.begin(), scheme.axes.end(), 0);
  scheme.linear = channels::geometry_axes(channel);
  return scheme;
}

void resolve_schemes(const toml::table& table, const ChannelFile& file,
                     const MachineConfig& machine, const std::filesystem::path& folder,
                     const SharedAxes& shared, ChannelConfig& channel, const Scope& scope) {
  ChannelAxes axes{.words = channel.words, .axes = {}, .is_shared = {}};
  for (const int axis : channel.axes) {
    const channels::AxisConfig& config = machine.axes[axis];
    axes.axes.push_back(&config);
    axes.is_shared.push_back(shared.contains(config.name));
  }
  channel.schemes = read_schemes(file.schemes, axes, folder, scope);
  if (channel.schemes.empty()) channel.schemes = {default_scheme(channel)};
  channel.scheme = file.active == 0 ? channel.schemes.front().id : file.active;
  const auto active =
      std::ranges::find(channel.schemes, channel.scheme, &kinematics::SchemeConfig::id);
  if (active == channel.schemes.end()) {
    scope.fault(place_of(table, "active"), "there is no scheme " + std::to_string(file.active) +
                                               "; name one of [[channel.scheme]]");
  }
}

// The axis of a spindle is part of every scheme: parked, it could not turn.
void check_spindle_axes(const toml::table& table, const ChannelConfig& channel,
                        const MachineConfig& machine, const SharedAxes& shared,
                        const Scope& scope) {
  for (const channels::SpindleConfig& spindle : machine.spindles) {
    if (std::ranges::find(channel.spindles, spindle.id) == channel.spindles.end()) continue;
    const auto axis = std::ranges::find_if(
        channel.axes, [&](int index) { return machine.axes[index].name == spindle.axis; });
    if (axis == channel.axes.end()) continue;
    if (shared.contains(spindle.axis)) {
      scope.fault(place_of(table, "axes"), "axis '" + spindle.axis + "' is spindle " +
                                               std::to_string(spindle.id) +
                                               "; only one channel can have it");
    }
    const int index = static_cast<int>(axis - channel.axes.begin());
    for (const kinematics::SchemeConfig& scheme : channel.schemes) {
      if (std::ranges::find(scheme.axes, index) != scheme.axes.end()) continue;
      scope.fault(place_of(table, "spindles"),
                  "scheme " + std::to_string(scheme.id) + " leaves out axis '" + spindle.axis +
                      "', which is spindle " + std::to_string(spindle.id) +
                      "; name it in the axes of the scheme");
    }
  }
}

ChannelConfig read_channel(const toml::table& table, const MachineConfig& machine,
                           const SharedAxes& shared, const std::filesystem::path& folder,
                           const Scope& scope) {
  const std::size_t faults_before = scope.faults.size();
  ChannelFile file;
  read_table(table, channel_keys(), file, scope);
  ChannelConfig channel = std::move(file.channel);
  channel.kind = channel_kind(file.kind);
  channel.on_owner_failure = owner_failure(file.on_owner_failure);
  channel.rules = text_rules(table, file, channel.kind, scope);
  resolve_axes(table, file, machine, channel, scope);
  if (!table.contains("words")) channel.words = file.axes;
  check_skip_inputs(table, channel, scope);
  check_spindles(table, channel, machine, scope);
  check_names(table, channel, scope);
  check_dialect_keys(table, channel, scope);
  channel.automatic_feeds = read_automatic_feeds(file.automatic_feeds, channel, scope);
  // A wrong axis is one fault, not one more for every word and scheme that counts on it.
  const bool axes_are_right = channel.axes.size() == file.axes.size();
  if (axes_are_right) check_words(table, channel, scope);
  if (scope.faults.size() == faults_before) check_master(table, channel, scope);
  const bool words_are_right = channel.words.size() == channel.axes.size();
  if (axes_are_right && words_are_right && !channel.axes.empty()) {
    resolve_schemes(table, file, machine, folder, shared, channel, scope);
    check_spindle_axes(table, channel, machine, shared, scope);
  }
  return channel;
}

// " = 1", what follows a key.
bool is_integer_assignment(std::string_view text) {
  constexpr std::string_view blanks = " \t";
  const std::size_t sign = text.find_first_not_of(blanks);
  if (sign == std::string_view::npos || text[sign] != '=') return false;
  const std::size_t value = text.find_first_not_of(blanks, sign + 1);
  return value != std::string_view::npos && text[value] >= '0' && text[value] <= '9';
}

bool takes_part_at_start(const ChannelConfig& channel, int machine_axis) {
  const auto scheme =
      std::ranges::find(channel.schemes, channel.scheme, &kinematics::SchemeConfig::id);
  const auto axis = std::ranges::find(channel.axes, machine_axis);
  if (scheme == channel.schemes.end() || axis == channel.axes.end()) return false;
  const int index = static_cast<int>(axis - channel.axes.begin());
  return std::ranges::find(scheme->axes, index) != scheme->axes.end();
}

// An axis listens to one channel: at power-on to the one whose scheme it is part of.
void check_claims_at_start(const std::vector<ChannelConfig>& earlier, const ChannelConfig& channel,
                           const MachineConfig& machine, const toml::table& table,
                           const Scope& scope) {
  for (const int axis : channel.axes) {
    if (!takes_part_at_start(channel, axis)) continue;
    const auto owner = std::ranges::find_if(
        earlier, [&](const ChannelConfig& other) { return takes_part_at_start(other, axis); });
    if (owner == earlier.end()) continue;
    scope.fault(place_of(table, "axes"), "axis '" + machine.axes[axis].name +
                                             "' takes part in the power-on scheme of channel " +
                                             std::to_string(owner->id) +
                                             ", too; begin with a scheme that leaves it out");
  }
}

}  // namespace

NumberedList<ChannelConfig> read_channels(Subtables channels, const MachineConfig& machine,
                                          const std::filesystem::path& folder, const Scope& scope) {
  NumberedList<ChannelConfig> configs;
  if (channels == nullptr) return configs;
  const SharedAxes shared = shared_axes(*channels);
  for (const toml::node& node : *channels) {
    const toml::table& table = *node.as_table();
    const Scope inner{scope.faults, "channel " + std::to_string(table["id"].value_or(0))};
    ChannelConfig channel = read_channel(table, machine, shared, folder, inner);
    if (std::ranges::find(configs, channel.id, &ChannelConfig::id) != configs.end()) {
      inner.fault(place_of(table, "id"), "the id is taken; every channel needs its own");
    }
    check_claims_at_start(configs, channel, machine, table, inner);
    configs.push_back(std::move(channel));
  }
  if (configs.size() > channels::channels_max) {
    scope.fault(channels->get(channels::channels_max)->source(),
                "more than 16 channels; a machine has at most 16");
  }
  std::ranges::sort(configs, {}, &ChannelConfig::id);
  return configs;
}

std::string with_active_scheme_key(std::string text) {
  constexpr std::string_view blanks = " \t";
  constexpr std::string_view written = "scheme";
  constexpr std::string_view spelt = "active";
  static_assert(written.size() == spelt.size());
  bool in_channel = false;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line(text.data() + begin, end - begin);
    const std::size_t indent = std::min(line.find_first_not_of(blanks), line.size());
    const std::string_view content = line.substr(indent);
    if (content.starts_with('[')) in_channel = content.starts_with("[[channel]]");
    if (in_channel && content.starts_with(written) &&
        is_integer_assignment(content.substr(written.size()))) {
      text.replace(begin + indent, written.size(), spelt);
    }
    begin = end + 1;
  }
  return text;
}

std::vector<KeyRow> channel_key_rows() {
  return describe(channel_keys());
}

}  // namespace stanok::config
