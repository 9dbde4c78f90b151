// SPDX-License-Identifier: MIT
#include "shell/command_line/study/rank_diagram.h"

#include <algorithm>
#include <cstdio>

#include "shell/export/xml_text.h"

namespace gaitsmith::shell {

namespace {

constexpr double kPageWidth = 760.0, kScaleLeft = 210.0,
                 kScaleRight = 550.0;  // of the picture, and the ends of its scale
constexpr double kScaleY = 46.0, kNameHeight = 20.0, kBarHeight = 8.0;

std::string Pixels(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", value);
  return text;
}

std::string LineTo(double x1, double y1, double x2, double y2, const char* width) {
  return "<line x1=\"" + Pixels(x1) + "\" y1=\"" + Pixels(y1) + "\" x2=\"" + Pixels(x2) + "\" y2=\"" +
         Pixels(y2) + "\" stroke-width=\"" + width + "\"/>\n";
}

std::string TextAt(double x, double y, const char* anchor, const std::string& text) {
  return "<text x=\"" + Pixels(x) + "\" y=\"" + Pixels(y) + "\" text-anchor=\"" + anchor + "\">" +
         EscapedXml(text) + "</text>\n";
}

}  // namespace

std::string RankDiagramSvg(const RankOrder& order, std::span<const std::string> names, std::size_t blocks) {
  const std::size_t count = order.places.size(), half = (count + 1) / 2;
  const auto at = [&](double rank) {
    return kScaleLeft + (kScaleRight - kScaleLeft) * (rank - 1.0) / static_cast<double>(count - 1);
  };
  const double bars = kScaleY + 10.0;
  const double first = bars + kBarHeight * static_cast<double>(order.groups.size()) + 14.0;
  const double height = first + kNameHeight * static_cast<double>(half) + 30.0;
  std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + Pixels(kPageWidth) + " " +
                    Pixels(height) + "\" font-family=\"sans-serif\" font-size=\"13\" role=\"img\">\n<title>" +
                    EscapedXml("Mean ranks of " + std::to_string(count) + " searches over " +
                               std::to_string(blocks) + " blocks, 1 is best") +
                    "</title>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n<g stroke=\"#222\">\n";
  svg += LineTo(kScaleLeft, kScaleY, kScaleRight, kScaleY, "1.2");
  for (std::size_t rank = 1; rank <= count; ++rank)
    svg +=
        LineTo(at(static_cast<double>(rank)), kScaleY - 6.0, at(static_cast<double>(rank)), kScaleY, "1.2");
  for (std::size_t group = 0; group < order.groups.size(); ++group) {
    const double y = bars + kBarHeight * static_cast<double>(group);
    svg += LineTo(at(order.places[order.groups[group].first].rank) - 3.0, y,
                  at(order.places[order.groups[group].last].rank) + 3.0, y, "4");
  }
  std::string words;
  for (std::size_t place = 0; place < count; ++place) {
    const auto& [search, rank] = order.places[place];
    // The better half to the left, best on top; the worse half to the right, worst on top.
    const bool left = place < half;
    const double y = first + kNameHeight * static_cast<double>(left ? place : count - 1 - place);
    const double end = left ? kScaleLeft - 14.0 : kScaleRight + 14.0;
    svg += LineTo(at(rank), kScaleY, at(rank), y, "1") + LineTo(at(rank), y, end, y, "1");
    words += TextAt(left ? end - 5.0 : end + 5.0, y + 4.5, left ? "end" : "start",
                    left ? names[search] + "  " + Pixels(rank) : Pixels(rank) + "  " + names[search]);
  }
  svg += "</g>\n<g fill=\"#222\">\n" + words;
  for (std::size_t rank = 1; rank <= count; ++rank)
    svg += TextAt(at(static_cast<double>(rank)), kScaleY - 11.0, "middle", std::to_string(rank));
  svg +=
      TextAt(kScaleLeft, height - 9.0, "start", "Mean rank, 1 is best. A bar: not told apart at 5 % (Holm).");
  return svg + "</g>\n</svg>\n";
}

}  // namespace gaitsmith::shell
