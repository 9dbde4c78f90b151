// SPDX-License-Identifier: MIT
#include "shell/python/array_check.h"

#include <algorithm>
#include <array>

#include "shell/python/fault.h"

namespace gaitsmith::python {

namespace py = pybind11;

namespace {

using Shape = std::span<const py::ssize_t>;

std::string ShapeText(Shape shape) {
  std::string text = "(";
  for (std::size_t i = 0; i < shape.size(); ++i)
    text.append(i == 0 ? "" : ", ").append(shape[i] < 0 ? "n" : std::to_string(shape[i]));
  return text + (shape.size() == 1 ? ",)" : ")");
}

Shape ShapeOf(const py::array& array) { return {array.shape(), static_cast<std::size_t>(array.ndim())}; }

bool Fits(Shape shape, Shape wanted) {
  return std::ranges::equal(shape, wanted,
                            [](py::ssize_t is, py::ssize_t must) { return must < 0 || is == must; });
}

}  // namespace

std::vector<std::span<const Gene>> RowsOf(const py::object& genomes, std::size_t genes) {
  const std::string must =
      "genomes: must be a C-contiguous array of uint16 with shape (n, " + std::to_string(genes) + "), is ";
  if (!py::isinstance<py::array>(genomes))
    throw Fault(must + "a " + std::string(py::str(py::type::of(genomes).attr("__name__"))));
  const auto array = py::reinterpret_borrow<py::array>(genomes);
  const std::string type = py::str(array.dtype());
  if (!py::isinstance<py::array_t<Gene>>(array) ||
      !Fits(ShapeOf(array), std::array{py::ssize_t{-1}, static_cast<py::ssize_t>(genes)}))
    throw Fault(must + type + " with shape " + ShapeText(ShapeOf(array)));
  if ((array.flags() & py::array::c_style) == 0)
    throw Fault(must + "in another order; numpy.ascontiguousarray copies it");
  const auto* first = static_cast<const Gene*>(array.data());
  std::vector<std::span<const Gene>> rows;
  rows.reserve(static_cast<std::size_t>(array.shape(0)));
  for (py::ssize_t i = 0; i < array.shape(0); ++i)
    rows.emplace_back(first + static_cast<std::size_t>(i) * genes, genes);
  return rows;
}

py::array_t<float> Floats(const char* name, const py::object& numbers,
                          const std::vector<py::ssize_t>& shape) {
  const std::string must = std::string(name) + ": must be numbers with shape " + ShapeText(shape) + ", ";
  py::array any = py::array::ensure(numbers);
  if (!any) throw Fault(must + "is a " + std::string(py::str(py::type::of(numbers).attr("__name__"))));
  if (std::string("biuf").find(any.dtype().kind()) == std::string::npos)
    throw Fault(must + "is of type " + std::string(py::str(any.dtype())));
  if (!Fits(ShapeOf(any), shape)) throw Fault(must + "has shape " + ShapeText(ShapeOf(any)));
  auto floats = py::array_t < float, py::array::c_style | py::array::forcecast > ::ensure(any);
  if (!floats) throw Fault(must + "cannot be converted to float32");
  return floats;
}

py::array_t<Gene> ArrayOf(std::span<const Genome> genomes, std::size_t genes) {
  py::array_t<Gene> array({static_cast<py::ssize_t>(genomes.size()), static_cast<py::ssize_t>(genes)});
  Gene* row = array.mutable_data();
  for (const Genome& genome : genomes) row = std::ranges::copy(genome, row).out;
  return array;
}

}  // namespace gaitsmith::python
