#include "jobs/interpret/axis_fields.h"

namespace stanok::jobs {

Fields axis_fields(const Words& words, const lang::AxisValues& point) {
  Fields fields;
  fields.reserve(words.size());
  for (std::size_t k = 0; k < words.size(); ++k) fields.push_back({words[k], point[k]});
  return fields;
}

}  // namespace stanok::jobs
