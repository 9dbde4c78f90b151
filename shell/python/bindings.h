// SPDX-License-Identifier: MIT
// The parts of the compiled module gaitsmith._core. The pure Python part in gaitsmith/ documents what users
// call.
#pragma once

#include <pybind11/pybind11.h>

#include <string>

#include "core/document/document.h"

namespace gaitsmith::python {

void AddDocumentFunctions(pybind11::module_&);
void AddMotionFunctions(pybind11::module_&);
void AddProblemClass(pybind11::module_&);
void AddSearchClass(pybind11::module_&);
void AddStudyFunctions(pybind11::module_&);
void AddWorldsClass(pybind11::module_&);

/// A document as it crosses the border: its JSON. @throws Fault if it is not valid
Document DocumentOf(const std::string& json);

}  // namespace gaitsmith::python
