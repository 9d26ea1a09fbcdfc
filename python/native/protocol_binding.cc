// The table of operator methods, for who generates python/stanok/methods.py and tests it.
#include <nlohmann/json.hpp>

#include "protocol/contract/discovery.h"
#include "protocol/contract/json_text.h"
#include "protocol/contract/version.h"
#include "python/native/bindings.h"

namespace stanok::python {

void bind_protocol(pybind11::module_& module) {
  module.def("discovery",
             [] { return protocol::json_text(protocol::discovery_document(protocol::version)); });
}

}  // namespace stanok::python
