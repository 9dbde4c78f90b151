// SPDX-License-Identifier: MIT
// Documents as JSON: read, checked, as links, and made from the options of `gaitsmith synthesize`.
#include <pybind11/stl.h>

#include "core/document/json.h"
#include "core/document/link.h"
#include "shell/catalogue/catalogue.h"
#include "shell/command_line/files.h"
#include "shell/command_line/synthesize_request.h"
#include "shell/python/bindings.h"
#include "shell/python/fault.h"

namespace gaitsmith::python {

namespace py = pybind11;

namespace {

/// The options of `gaitsmith synthesize` that describe a document.
constexpr std::string_view kOptions[] = {"figure",     "problem", "from",          "repair",      "clip",
                                         "task",       "sense",   "weight",        "way",         "pose",
                                         "controller", "rules",   "duration",      "joints",      "ground",
                                         "handover",   "search",  "search-option", "evaluations", "seed"};

std::string DocumentFor(const std::vector<std::string>& words) {
  const std::vector<std::string_view> views(words.begin(), words.end());
  const auto arguments = Take(shell::Arguments::ParseOptions(views, kOptions));
  return EncodeJson(Take(shell::ReadRequest(arguments)).document);
}

}  // namespace

Document DocumentOf(const std::string& json) { return Take(DecodeJson(json)); }

void AddDocumentFunctions(py::module_& core) {
  core.def("read", [](const std::string& name) { return EncodeJson(Take(shell::ReadDocument(name))); });
  core.def("complete", [](const std::string& json) { return EncodeJson(DocumentOf(json)); });
  core.def("encode_link", [](const std::string& json) { return EncodeLink(DocumentOf(json)); });
  core.def("decode_link", [](const std::string& link) { return EncodeJson(Take(DecodeLink(link))); });
  core.def("document", &DocumentFor);
  core.def("catalogue", &shell::CatalogueJson);
}

}  // namespace gaitsmith::python
