// SPDX-License-Identifier: MIT
// Arrays that come from Python: their type, shape and order, checked with sentences that say what is wrong.
#pragma once

#include <pybind11/numpy.h>

#include <span>
#include <string>
#include <vector>

#include "core/control/gene_groups.h"

namespace gaitsmith::python {

/// Views of the rows of an array of genomes, which is not copied.
/// @param genomes must be a C-contiguous array of uint16 with shape (n, genes) @throws Fault
std::vector<std::span<const Gene>> RowsOf(const pybind11::object& genomes, std::size_t genes);

/// Numbers as single precision: an array of this shape, or anything that NumPy makes one of.
/// @param shape with -1 where any length is right @throws Fault
pybind11::array_t<float> Floats(const char* name, const pybind11::object& numbers,
                                const std::vector<pybind11::ssize_t>& shape);

/// Genomes as a new array of uint16 with shape (n, genes).
pybind11::array_t<Gene> ArrayOf(std::span<const Genome> genomes, std::size_t genes);

}  // namespace gaitsmith::python
