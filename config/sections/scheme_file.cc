// Checks of a scheme; names of axes become indices in the channel.
#include "config/sections/scheme_file.h"

#include <algorithm>

#include "base/overloaded.h"
#include "base/place.h"
#include "channels/contract/motion_config.h"
#include "config/sections/scheme_keys.h"

namespace stanok::config {
namespace {

using kinematics::Parking;
using kinematics::SchemeConfig;
using kinematics::SchemeKey;

std::string axis_text(std::string_view name) {
  return "axis '" + std::string(name) + "'";
}

// One scheme being resolved: its table, the axes of its channel, the faults.
class SchemeReader {
 public:
  // Reads the keys; `file` comes with the id.
  SchemeReader(const toml::table& table, const Keys<SchemeFile>& keys, SchemeFile file,
               const ChannelAxes& axes, Scope scope)
      : table_(table),
        file_(std::move(file)),
        axes_(axes),
        scope_(std::move(scope)),
        faults_before_(scope_.faults.size()) {
    read_keys(table_, keys, file_, scope_);
    scheme().id = file_.id;
    if (const auto* type = kinematics::find_scheme_type(scheme().type)) {
      scheme().geometry = type->geometry;
      geometry_keys_ = kinematics::keys_of(scheme().geometry);
    }
    refuse_keys_without_owner(keys);
  }

  SchemeConfig resolve() {
    read_geometry();
    resolve_axes();
    resolve_parking();
    if (is_right()) check_every_axis_has_a_place();
    resolve_retract();
    resolve_roles();
    resolve_zero();
    if (is_right()) {
      const std::string defect = kinematics::scheme_defect(scheme());
      if (!defect.empty()) scope_.fault(place_of(table_, "axes"), scheme().type + ": " + defect);
    }
    return scheme();
  }

  SchemeReader(const SchemeReader&) = delete;  // geometry_keys_ refers to file_
  SchemeReader& operator=(const SchemeReader&) = delete;

 private:
  struct NamedAxis {
    std::string_view key;
    std::string name;
    std::reference_wrapper<int> axis;
  };

  SchemeConfig& scheme() { return file_.scheme; }
  // Further checks would only repeat the faults found so far.
  [[nodiscard]] bool is_right() const { return scope_.faults.size() == faults_before_; }

  // Index of an axis of the channel; -1, and a fault, when there is none.
  int find_axis(std::string_view name, const toml::source_region& place) {
    const int axis = axes_.find(name);
    if (axis < 0) {
      scope_.fault(place, "'" + std::string(name) +
                              "' is not an axis of the channel; its axes are " + axes_.list());
    }
    return axis;
  }

  void check_travel(int axis, double position, const toml::source_region& place) {
    const auto& limits = axes_.axes[axis]->limits;
    if (position >= limits.position_min && position <= limits.position_max) return;
    scope_.fault(place, axis_text(axes_.words[checked_size(axis)]) + " cannot reach " +
                            number_text(position) + "; its travel is " +
                            number_text(limits.position_min) + " to " +
                            number_text(limits.position_max));
  }

  // Keys that no type has, and keys that this type has not.
  void refuse_keys_without_owner(const Keys<SchemeFile>& common) {
    std::vector<std::string_view> known;
    for (const auto& key : common) known.push_back(key.name);
    for (const SchemeKey& key : geometry_keys_) known.push_back(key.name);
    for (const auto& [key, node] : table_) {
      const std::string owners = owners_of(key.str());
      if (owners.empty() || std::ranges::find(known, key.str()) != known.end()) continue;
      known.push_back(key.str());
      if (!is_type_known()) continue;
      scope_.fault(node.source(), std::string(key.str()) + " belongs to a scheme of type " +
                                      owners + "; remove it");
    }
    refuse_unknown_keys(table_, known, scope_);
  }

  [[nodiscard]] bool is_type_known() {
    return kinematics::find_scheme_type(scheme().type) != nullptr;
  }

  // The types that have a geometry key; empty for keys that are no geometry.
  static std::string owners_of(std::string_view key) {
    std::string owners;
    for (const kinematics::TypeOfScheme& type : kinematics::scheme_types()) {
      kinematics::SchemeGeometry geometry = type.geometry;
      const std::vector<SchemeKey> keys = kinematics::keys_of(geometry);
      if (std::ranges::find(keys, key, &SchemeKey::name) == keys.end()) continue;
      owners += (owners.empty() ? "" : " or ") + std::string(type.name);
    }
    return owners;
  }

  // All keys of the type but those that name axes: their values are kept in axis_names_.
  void read_geometry() {
    for (const SchemeKey& key : geometry_keys_) {
      GeometryKey row = geometry_key(key);
      const toml::node* const node = table_.get(key.name);
      if (node == nullptr && row.text.presence == required) {
        scope_.fault(table_.source(), "key '" + std::string(key.name) + "' is missing; a " +
                                          scheme().type + " scheme needs it");
      }
      if (node != nullptr) {
        std::visit([&](auto& value) { detail::read_value(*node, row.text, scope_, value); },
                   row.value);
      }
      std::visit(Overloaded{[&](const kinematics::AxisName& name) {
                              axis_names_.push_back(
                                  {key.name, std::get<std::string>(row.value), name.axis});
                            },
                            [&](const auto& place) { place_value(place, row.value); }},
                 key.value);
    }
  }

  static void place_value(const kinematics::Direction& direction, const SchemeValue& value) {
    direction.vector.get() = vector3(std::get<Numbers3>(value));
  }
  static void place_value(const kinematics::Place& place, const SchemeValue& value) {
    place.vector.get() = vector3(std::get<Numbers3>(value));
  }
  static void place_value(const kinematics::Number& number, const SchemeValue& value) {
    number.value.get() = std::get<double>(value);
  }
  static void place_value(const kinematics::Choice& choice, const SchemeValue& value) {
    const auto name = std::ranges::find(choice.names, std::get<std::string>(value));
    choice.choose(checked_size(name - choice.names.begin()));
  }

  void resolve_axes() {
    for (std::size_t i = 0; i < file_.axes.size(); ++i) {
      const auto& place = place_of(table_, "axes", i);
      const int axis = find_axis(file_.axes[i], place);
      if (axis < 0) continue;
      if (takes_part(scheme(), axis)) {
        scope_.fault(place, axis_text(file_.axes[i]) + " appears twice in axes; remove one");
      } else {
        scheme().axes.push_back(axis);
      }
    }
  }

  void resolve_parking() {
    if (file_.parked == nullptr) return;
    for (const toml::node& node : *file_.parked) {
      const toml::table& table = *node.as_table();
      ParkedFile parked;
      read_table(table, parked_keys(), parked, scope_.inner("parked"));
      if (parked.axis.empty()) continue;
      const auto& place = place_of(table, "axis");
      const int axis = find_axis(parked.axis, place);
      if (axis < 0) continue;
      if (takes_part(scheme(), axis)) {
        scope_.fault(
            place, axis_text(parked.axis) +
                       " takes part and is parked as well; remove it from axes or from [[parked]]");
      } else if (is_parked(axis)) {
        scope_.fault(place, axis_text(parked.axis) + " is parked twice; remove one");
      }
      check_travel(axis, parked.parking.position, place_of(table, "position"));
      check_velocity(axis, parked.parking.velocity, place_of(table, "velocity"));
      parked.parking.axis = axis;
      parked.parking.drive_off = parked.drive == "off";
      scheme().parking.push_back(parked.parking);
    }
  }

  void check_velocity(int axis, double velocity, const toml::source_region& place) {
    const double most = axes_.axes[axis]->limits.velocity_max;
    if (velocity > most) {
      scope_.fault(place, "velocity is " + number_text(velocity) + "; the axis reaches at most " +
                              number_text(most));
    }
  }

  bool is_parked(int axis) {
    return std::ranges::any_of(scheme().parking,
                               [&](const Parking& parking) { return parking.axis == axis; });
  }

  void check_every_axis_has_a_place() {
    for (std::size_t axis = 0; axis < axes_.words.size(); ++axis) {
      const int index = static_cast<int>(axis);
      if (takes_part(scheme(), index) || is_parked(index) || axes_.is_shared[axis]) continue;
      scope_.fault(place_of(table_, "axes"),
                   axis_text(axes_.words[axis]) +
                       " neither takes part nor is parked; name it in axes or add [[parked]] "
                       "axis = \"" +
                       axes_.words[axis] + "\"");
    }
  }

  // Number of `node` in a table of axis positions; nothing, and a fault, for another kind.
  std::optional<double> position(std::string_view name, const toml::node& node,
                                 std::string_view table_name) {
    double value = 0.0;
    const std::size_t faults_before = scope_.faults.size();
    detail::read_value(node, {.name = name, .unit = "mm, deg", .meaning = table_name}, scope_,
                       value);
    if (scope_.faults.size() != faults_before) return std::nullopt;
    return value;
  }

  void resolve_retract() {
    if (file_.retract == nullptr) return;
    struct Move {
      toml::source_position place;
      int axis;
      double position;
    };
    std::vector<Move> moves;  // a TOML table does not keep its order: the places do
    for (const auto& [key, node] : *file_.retract) {
      const int axis = find_axis(key.str(), key.source());
      const auto value = position(key.str(), node, "retract position");
      if (axis < 0 || !value) continue;
      check_travel(axis, *value, node.source());
      moves.push_back({key.source().begin, axis, *value});
    }
    std::ranges::sort(moves, {},
                      [](const Move& m) { return std::pair(m.place.line, m.place.column); });
    for (const Move& move : moves) scheme().retract.emplace_back(move.axis, move.position);
  }

  void resolve_roles() {
    channels::ChannelConfig channel;
    channel.words.assign(axes_.words.begin(), axes_.words.end());
    scheme().linear = channels::geometry_axes(channel);
    for (const NamedAxis& named : axis_names_) {
      if (!named.name.empty()) named.axis.get() = rotary_axis(named.key, named.name);
    }
  }

  int rotary_axis(std::string_view key, const std::string& name) {
    const int axis = find_axis(name, place_of(table_, key));
    if (axis >= 0 && !axes_.axes[axis]->rotary) {
      scope_.fault(place_of(table_, key),
                   axis_text(name) + " is linear; " + std::string(key) + " must be a rotary axis");
    }
    return axis;
  }

  void resolve_zero() {
    scheme().zero = kinematics::zero_default(scheme());
    if (file_.zero == nullptr) return;
    for (const auto& [key, node] : *file_.zero) {
      const int axis = find_axis(key.str(), key.source());
      const auto value = position(key.str(), node, "position of the base");
      if (axis < 0 || !value) continue;
      if (!takes_part(scheme(), axis)) {
        scope_.fault(key.source(), axis_text(key.str()) +
                                       " does not take part; a parked axis has no zero: remove it");
      }
      scheme().zero[axis] = *value;
    }
  }

  const toml::table& table_;
  SchemeFile file_;
  const ChannelAxes& axes_;
  Scope scope_;
  std::size_t faults_before_;
  std::vector<SchemeKey> geometry_keys_;  // of the type, when the file names one
  std::vector<NamedAxis> axis_names_;
};

SchemeConfig read_scheme(const toml::table& entry, const ChannelAxes& axes,
                         const std::filesystem::path& folder, const Scope& scope) {
  if (!entry.contains("file")) return SchemeReader(entry, inline_keys(), {}, axes, scope).resolve();
  const std::size_t faults_before = scope.faults.size();
  SchemeFile file;
  read_table(entry, reference_keys(), file, scope);
  file.scheme.id = file.id;
  if (scope.faults.size() != faults_before) return file.scheme;
  const std::filesystem::path path = (folder / file.file).lexically_normal();
  file.scheme.file = path.string();
  if (!scope.faults.is_file(path)) {
    scope.fault(place_of(entry, "file"), "scheme file '" + path.string() +
                                             "' does not exist; its path is relative to the "
                                             "machine file");
    return file.scheme;
  }
  const auto table = parse_file(path, scope.faults);
  if (!table) return file.scheme;
  return SchemeReader(*table, scheme_keys(), std::move(file), axes, scope).resolve();
}

}  // namespace

int ChannelAxes::find(std::string_view name) const {
  const auto word = std::ranges::find(words, name);
  if (word != words.end()) return static_cast<int>(word - words.begin());
  const auto axis = std::ranges::find(axes, name, &channels::AxisConfig::name);
  return axis == axes.end() ? -1 : static_cast<int>(axis - axes.begin());
}

std::string ChannelAxes::list() const {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text.empty() ? "none" : text;
}

std::vector<SchemeConfig> read_schemes(Subtables schemes, const ChannelAxes& axes,
                                       const std::filesystem::path& folder, const Scope& scope) {
  std::vector<SchemeConfig> configs;
  if (schemes == nullptr) return configs;
  for (const toml::node& node : *schemes) {
    const toml::table& table = *node.as_table();
    const Scope inner = scope.inner("scheme " + std::to_string(table["id"].value_or(0)));
    SchemeConfig scheme = read_scheme(table, axes, folder, inner);
    const bool is_known = std::ranges::any_of(
        configs, [&](const SchemeConfig& other) { return other.id == scheme.id; });
    if (is_known) {
      inner.fault(place_of(table, "id"),
                  "the id is taken; every scheme of a channel needs its own");
    }
    configs.push_back(std::move(scheme));
  }
  return configs;
}

}  // namespace stanok::config
