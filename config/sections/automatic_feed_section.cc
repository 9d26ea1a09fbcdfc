// Keys and checks of [[channel.automatic_feed]].
#include "config/sections/automatic_feed_section.h"

#include <algorithm>

namespace stanok::config {
namespace {

using motion::AutomaticFeedConfig;

struct AutomaticFeedFile {
  AutomaticFeedConfig law;
  std::string kind;
};

constexpr double release_usual = 0.8;  // of the level

const Keys<AutomaticFeedFile>& automatic_feed_keys() {
  static const Keys<AutomaticFeedFile> keys = {
      {"law", at<&AutomaticFeedFile::kind>, required, "",
       "modulated: acts on the vibration of the master spindle in um; linear: on its power in W",
       one_of({"modulated", "linear"})},
      {"level", at<&AutomaticFeedFile::law, &AutomaticFeedConfig::level>, required, "um or W",
       "signal above which the law acts", positive},
      {"release", at<&AutomaticFeedFile::law, &AutomaticFeedConfig::release>, optional, "um or W",
       "signal below which it releases the feed", positive, "0.8 level"},
      {"feed_min", at<&AutomaticFeedFile::law, &AutomaticFeedConfig::part_min>, required, "",
       "smallest feed, as a fraction of the programmed feed", from(0.01, 0.99)},
      {"feed_step", at<&AutomaticFeedFile::law, &AutomaticFeedConfig::part_step>, optional, "",
       "one increment of the feed, as a fraction of the programmed feed", from(0.001, 1.0)},
      {"path_step", at<&AutomaticFeedFile::law, &AutomaticFeedConfig::path_step_mm>, optional, "mm",
       "path at feed between two increments", positive},
      {"active", at<&AutomaticFeedFile::law, &AutomaticFeedConfig::on_at_start>, optional, "",
       "on at power-on; operators switch it with process automatic"},
  };
  return keys;
}

AutomaticFeedConfig read_law(const toml::table& table, const Scope& scope) {
  AutomaticFeedFile file;
  read_table(table, automatic_feed_keys(), file, scope);
  AutomaticFeedConfig& law = file.law;
  law.law = file.kind == "linear" ? motion::LawKind::linear : motion::LawKind::modulated;
  if (!table.contains("release")) law.release = release_usual * law.level;
  if (law.release > law.level) {
    scope.fault(place_of(table, "release"), "release exceeds level, " + number_text(law.level) +
                                                "; the law would never release the feed");
  }
  if (law.part_min < 1.0 && law.part_step > 1.0 - law.part_min) {
    scope.fault(place_of(table, "feed_step"), "one increment leads below feed_min, " +
                                                  number_text(law.part_min) + "; use at most " +
                                                  number_text(1.0 - law.part_min));
  }
  return law;
}

}  // namespace

std::vector<AutomaticFeedConfig> read_automatic_feeds(Subtables laws,
                                                      const channels::ChannelConfig& channel,
                                                      const Scope& scope) {
  std::vector<AutomaticFeedConfig> configs;
  if (laws == nullptr) return configs;
  const Scope inner = scope.inner("automatic_feed");
  for (const toml::node& node : *laws) {
    const toml::table& table = *node.as_table();
    const AutomaticFeedConfig law = read_law(table, inner);
    if (channel.spindles.empty()) {
      inner.fault(node.source(),
                  "the channel has no spindle with a sensor that could control the feed");
    }
    if (std::ranges::find(configs, law.law, &AutomaticFeedConfig::law) != configs.end()) {
      inner.fault(place_of(table, "law"),
                  "the law appears twice; a channel has at most one of each");
      continue;
    }
    configs.push_back(law);
  }
  return configs;
}

std::vector<KeyRow> automatic_feed_key_rows() {
  return describe(automatic_feed_keys());
}

}  // namespace stanok::config
