// The keys of [[contact]] and their checks.
#include "config/sections/contact_section.h"

#include <algorithm>

namespace stanok::config {
namespace {

struct ContactFile {
  SimulatedContact contact;
  std::string axis;
};

const Keys<ContactFile>& contact_keys() {
  static const Keys<ContactFile> keys = {
      {"input", at<&ContactFile::contact, &SimulatedContact::input>, required, "",
       "digital input that it switches on", from(0, 63)},
      {"axis", at<&ContactFile::axis>, required, "", "axis whose position switches it"},
      {"from", at<&ContactFile::contact, &SimulatedContact::from>, optional, "mm or deg",
       "smallest position at which it is on", any, "the end of travel"},
      {"to", at<&ContactFile::contact, &SimulatedContact::to>, optional, "mm or deg",
       "largest position at which it is on", any, "the end of travel"},
  };
  return keys;
}

SimulatedContact read_contact(const toml::table& table,
                              const std::vector<channels::AxisConfig>& axes, const Scope& scope) {
  ContactFile file;
  read_table(table, contact_keys(), file, scope);
  const auto axis = std::ranges::find(axes, file.axis, &channels::AxisConfig::name);
  if (axis == axes.end() && !file.axis.empty()) {
    scope.fault(place_of(table, "axis"),
                "'" + file.axis + "' is not an axis of the machine; write the name of an [[axis]]");
  }
  file.contact.axis = static_cast<int>(axis - axes.begin());
  if (!table.contains("from") && !table.contains("to")) {
    scope.fault(table.source(), "neither from nor to is given; the input would always be on");
  }
  if (file.contact.from > file.contact.to) {
    scope.fault(place_of(table, "to"), "to is below from, " + number_text(file.contact.from) +
                                           "; the input would never be on");
  }
  return file.contact;
}

}  // namespace

std::vector<SimulatedContact> read_contacts(Subtables contacts,
                                            const std::vector<channels::AxisConfig>& axes,
                                            const Scope& scope) {
  std::vector<SimulatedContact> configs;
  if (contacts == nullptr) return configs;
  for (const toml::node& node : *contacts) {
    const Scope inner{scope.faults, "contact " + std::to_string(configs.size() + 1)};
    configs.push_back(read_contact(*node.as_table(), axes, inner));
  }
  return configs;
}

std::vector<KeyRow> contact_key_rows() {
  return describe(contact_keys());
}

}  // namespace stanok::config
