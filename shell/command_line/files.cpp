// SPDX-License-Identifier: MIT
#include "shell/command_line/files.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

#include "core/document/json.h"
#include "core/document/link.h"
#include "shell/embedded/embedded.h"

namespace gaitsmith::shell {

namespace {
constexpr ErrorCode kFileFault = ErrorCode::kMissing;
}

Result<std::string> ReadText(const std::string& path) {
  if (path == "-") return std::string(std::istreambuf_iterator<char>(std::cin), {});
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) return Fail(kFileFault, path, "is a folder");
  std::ifstream file(path, std::ios::binary);
  if (!file) return Fail(kFileFault, path, std::string("cannot be read: ") + std::strerror(errno));
  std::string text(std::istreambuf_iterator<char>(file), {});
  if (file.bad()) return Fail(kFileFault, path, "cannot be read to its end");
  return text;
}

Result<void> WriteText(const std::string& path, const std::string& text) {
  if (path == "-") {
    std::cout << text << std::flush;
    if (!std::cout) return Fail(kFileFault, "standard output", "cannot be written");
    return {};
  }
  const bool special = std::filesystem::exists(path) && !std::filesystem::is_regular_file(path);
  const std::string target = special ? path : path + ".part";
  {
    std::ofstream file(target, std::ios::binary);
    file << text << std::flush;
    if (!file) return Fail(kFileFault, path, std::string("cannot be written: ") + std::strerror(errno));
  }
  if (special) return {};
  std::error_code fault;
  std::filesystem::rename(target, path, fault);
  if (fault) return Fail(kFileFault, path, "cannot be written: " + fault.message());
  return {};
}

Result<Document> ReadDocument(const std::string& path) {
  for (const auto shipped : {ExampleDocuments(), ExampleProblems(), ExampleGallery()}) {
    for (const Example& example : shipped) {
      if (example.name == path && !std::filesystem::exists(path)) return DecodeJson(example.json);
    }
  }
  const auto text = ReadText(path);
  if (!text) return std::unexpected(text.error());
  const auto first = text->find_first_not_of(" \t\r\n");
  auto document = first != std::string::npos && (*text)[first] == '{' ? DecodeJson(*text) : DecodeLink(*text);
  if (!document) {
    const std::string& where = document.error().where;
    return Fail(document.error().code, path + (where.empty() ? "" : ": " + where), document.error().what);
  }
  return document;
}

Result<Document> TheDocument(const Arguments& arguments) {
  if (arguments.Positional().size() != 1)
    return Fail(ErrorCode::kMissing, "DOC", "give exactly one document");
  return ReadDocument(arguments.Positional()[0]);
}

const Controller& FirstControllerOf(const Document& document) {
  const int first = document.timeline.empty() ? 0 : document.timeline.front().controller;
  return document.controllers[static_cast<std::size_t>(first)];
}

Result<Figure> ReadFigure(const std::string& name_or_path) {
  for (const Example& example : ExampleFigures()) {
    if (example.name == name_or_path) return DecodeFigureJson(example.json);
  }
  if (name_or_path.find_first_of("./\\") == std::string::npos && name_or_path != "-") {
    std::string known;
    for (const Example& example : ExampleFigures())
      known += (known.empty() ? "" : ", ") + std::string(example.name);
    return Fail(
        ErrorCode::kUnknownName, "--figure",
        "there is no figure \"" + name_or_path + "\"; choose from " + known + ", or give the path of a file");
  }
  const auto text = ReadText(name_or_path);
  if (!text) return std::unexpected(text.error());
  auto figure = DecodeFigureJson(*text);
  if (!figure) {
    const std::string& where = figure.error().where;
    return Fail(figure.error().code, name_or_path + (where.empty() ? "" : ": " + where), figure.error().what);
  }
  return figure;
}

}  // namespace gaitsmith::shell
