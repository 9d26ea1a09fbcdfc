#include "protocol/contract/plane_json.h"

namespace stanok::protocol {
namespace {

using nlohmann::ordered_json;

ordered_json angles(const std::vector<RotaryAngle>& axes) {
  ordered_json json = ordered_json::object();
  for (const RotaryAngle& axis : axes) json[axis.word] = axis.deg;
  return json;
}

ordered_json fields(const PlanePosition& plane) {
  ordered_json json = {{"file", plane.place.file},
                       {"line", plane.place.line},
                       {"tool", plane.tool},
                       {"axes", angles(plane.axes)}};
  if (!plane.other) return json;
  ordered_json other = {{"word", plane.other->word}, {"axes", angles(plane.other->axes)}};
  if (plane.other->limit_deg) other["limit"] = *plane.other->limit_deg;
  json["other"] = std::move(other);
  return json;
}

}  // namespace

ordered_json plane_json(const PlanePositions& planes) {
  ordered_json json = ordered_json::array();
  for (const PlanePosition& plane : planes) json.push_back(fields(plane));
  return json;
}

}  // namespace stanok::protocol
