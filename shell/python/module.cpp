// SPDX-License-Identifier: MIT
#include "shell/python/bindings.h"
#include "shell/python/fault.h"

// NOLINTNEXTLINE: names and globals of the macro
PYBIND11_MODULE(_core, core) {
  using namespace gaitsmith::python;
  core.doc() =
      "The compiled part of gaitsmith. Use the module gaitsmith, whose functions document themselves.";
  core.attr("version") = GAITSMITH_VERSION;
  pybind11::register_exception<Fault>(core, "Error", PyExc_ValueError);
  AddDocumentFunctions(core);
  AddMotionFunctions(core);
  AddProblemClass(core);
  AddSearchClass(core);
  AddStudyFunctions(core);
  AddWorldsClass(core);
}
