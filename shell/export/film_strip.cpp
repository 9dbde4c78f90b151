// SPDX-License-Identifier: MIT
// A film strip as SVG. Numbers have fixed decimals, so the same motion yields the same bytes everywhere.
#include "shell/export/film_strip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <set>
#include <string_view>

#include "core/world/ground_view.h"
#include "shell/body/body_parts.h"
#include "shell/body/figure_pose.h"
#include "shell/export/film_strip_layout.h"
#include "shell/export/number_text.h"
#include "shell/export/picture_colours.h"
#include "shell/export/xml_text.h"

namespace gaitsmith::shell {

namespace {

constexpr double kLegendRow = 24.0;  // [px]
constexpr double kLetterWidth =
    6.8;  // approximate width of a letter in the legend, since text cannot be measured here [px]
constexpr double kTickInset = 4.0;  // distance of marks and labels from the edge of the ground [px]
constexpr double kTickRow = 19.0, kLetterRow = 45.0, kTimeRow = 67.0;  // baselines below the ground [px]

/// A coordinate.
std::string Px(double value) { return Decimal(value, 1); }

/// Fills in {1} to {9}.
std::string Filled(std::string_view pattern, std::initializer_list<std::string> inserts) {
  std::string out;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    const bool place = pattern[i] == '{' && i + 2 < pattern.size() && pattern[i + 2] == '}';
    const auto which = static_cast<std::size_t>(place ? pattern[i + 1] - '1' : 9);
    if (which < inserts.size()) {
      out += inserts.begin()[which];
      i += 2;
    } else {
      out += pattern[i];
    }
  }
  return out;
}

class StripDrawing {
 public:
  StripDrawing(const Document& document, const Motion& motion, const FilmStripOptions& options)
      : document_(document),
        motion_(motion),
        bars_(BarsOf(document.figure)),
        look_(LookOf(document.figure)),
        words_(options.words),
        ground_(document.environment.ground),
        layout_(LayOutStrip(motion, ground_, options)) {
    std::set<int> used;
    for (int frame = layout_.frames.front(); frame <= layout_.frames.back(); ++frame) {
      if (ControllerAt(frame) >= 0) used.insert(ControllerAt(frame));
    }
    if (used.size() > 1) controllers_.assign(used.begin(), used.end());
  }

  std::string Whole() {
    const double height = layout_.height + LegendHeight();
    const std::string size = Px(layout_.width) + " " + Px(height);
    out_ =
        R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 )" + size + R"(" width=")" +
        Px(layout_.width) + R"(" height=")" + Px(height) +
        R"(" role="img" aria-labelledby="strip-title strip-desc" )"
        R"(font-family="Inter, 'Helvetica Neue', Helvetica, Arial, sans-serif" font-size="12" fill="#1d2733">)"
        "\n";
    Header();
    for (const StripCell& cell : layout_.cells) Ground(cell);
    for (std::size_t pose = 1; pose < layout_.frames.size(); ++pose) Trail(pose);  // behind all poses
    for (std::size_t pose = 0; pose < layout_.frames.size(); ++pose) {
      Pose(pose);
      Caption(pose);
    }
    Legend();
    return std::move(out_) + "</svg>\n";
  }

 private:
  [[nodiscard]] int ControllerAt(int frame) const {
    const int clip = motion_.At(frame).clip;
    return clip < 0 ? -1 : document_.timeline[static_cast<std::size_t>(clip)].controller;
  }
  [[nodiscard]] double Seconds(std::size_t pose) const {
    return layout_.frames[pose] * 0.01;  // the decimal value of StepS, which a float only approximates
  }
  /// A number in the reader's language.
  [[nodiscard]] std::string Number(double value, int decimals) const {
    std::string text = Decimal(value, decimals);
    if (text[0] == '-') text.replace(0, 1, "−");
    const std::size_t mark = text.find('.');
    if (mark != std::string::npos) text.replace(mark, 1, EscapedXml(words_.decimal_mark));
    return text;
  }
  static std::string Letter(std::size_t pose) { return std::string(1, static_cast<char>('A' + pose)); }
  [[nodiscard]] double X(const StripCell& cell, double x_m) const {
    return cell.x + (x_m - cell.left_m) * layout_.scale;
  }
  [[nodiscard]] double GroundY(const StripCell& cell, double y_m) const {
    return cell.ground_y - (y_m - cell.level_m) * layout_.scale;
  }
  /// The lower edge of rods touches the ground.
  [[nodiscard]] double Y(const StripCell& cell, double y_m) const {
    return GroundY(cell, y_m) - 0.5 * layout_.rod_px;
  }
  [[nodiscard]] double CentreX(const StripCell& cell, int frame) const {
    return X(cell, motion_.At(frame).x_m);
  }
  void Text(double x, double y, const char* style, const std::string& text) {
    out_ += "<text x=\"" + Px(x) + "\" y=\"" + Px(y) + "\" " + style + ">" + text + "</text>\n";
  }
  void Line(double x1, double y1, double x2, double y2, const char* style) {
    out_ += "<path d=\"M" + Px(x1) + " " + Px(y1) + "L" + Px(x2) + " " + Px(y2) + "\" " + style + "/>\n";
  }

  void Header() {
    const std::size_t last = layout_.frames.size() - 1;
    const std::string from = Number(Seconds(0), 2), to = Number(Seconds(last), 2);
    const std::string figure = EscapedXml(document_.figure.name);
    const std::string title = EscapedXml(document_.title.empty() ? document_.figure.name : document_.title);
    out_ += "<title id=\"strip-title\">" + title + "</title>\n<desc id=\"strip-desc\">" +
            Filled(EscapedXml(words_.description),
                   {std::to_string(layout_.frames.size()), figure, from, to, Letter(0), Letter(last)}) +
            "</desc>\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
    Text(kStripMargin, 42.0, R"(font-size="21" font-weight="600")", title);
    std::string subtitle = from + "–" + to + " s";
    if (!figure.empty() && figure != title) subtitle = figure + " · " + subtitle;
    if (document_.environment.slope_rad != 0.0f) {
      const double degrees = static_cast<double>(document_.environment.slope_rad) * 180.0 / kPi;
      subtitle += " · " + Filled(EscapedXml(words_.slope), {Number(degrees, 1)});
    }
    Text(kStripMargin, 64.0, R"(font-size="13" fill="#5b6672")", subtitle);
    // The scale.
    const double bar_m = RoundLength(layout_.scale, 48.0);
    const double right = layout_.width - kStripMargin, left = right - bar_m * layout_.scale;
    Text(0.5 * (left + right), 50.0, R"(text-anchor="middle" fill="#5b6672")", Metres(bar_m, bar_m));
    out_ += "<path d=\"M" + Px(left) + " 57.0v8.0M" + Px(right) + " 57.0v8.0M" + Px(left) + " 61.0H" +
            Px(right) + "\" stroke=\"#5b6672\" stroke-width=\"1.5\" fill=\"none\"/>\n";
  }

  /// @param spacing between marks; decides the number of decimals
  [[nodiscard]] std::string Metres(double value, double spacing) const {
    return Number(value, spacing < 0.095 ? 2 : spacing < 0.95 ? 1 : 0) + " m";
  }

  /// The ground's line in a cell. Ground that is lower than what poses stand on is cut off: captions are
  /// there.
  [[nodiscard]] std::string Surface(const StripCell& cell) const {
    const std::string end = Px(cell.x + cell.width);
    if (ground_.Level()) return "M" + Px(cell.x) + " " + Px(cell.ground_y) + "H" + end;
    const double right_m = cell.left_m + cell.width / layout_.scale;
    const auto y = [&](double y_m) { return Px(std::min(GroundY(cell, y_m), cell.ground_y)); };
    std::string line = "M" + Px(cell.x) + " " + y(HeightBelow(ground_, cell.left_m));
    for (const Terrain::Face& face : ground_.FacesBetween(cell.left_m, right_m)) {
      if (face.x > cell.left_m) line += "L" + Px(X(cell, face.x)) + " " + y(face.y);
    }
    return line + "L" + end + " " + y(HeightBelow(ground_, right_m));
  }

  void Ground(const StripCell& cell) {
    const double below = cell.y + cell.height - cell.ground_y;
    if (layout_.own_ground) {
      out_ += "<rect x=\"" + Px(cell.x) + "\" y=\"" + Px(cell.y) + "\" width=\"" + Px(cell.width) +
              "\" height=\"" + Px(cell.height) + "\" rx=\"7\" fill=\"#fbfaf6\" stroke=\"#e3dfd6\"/>\n";
    }
    const double band = layout_.own_ground ? kTickRow + 7.0 : std::min(below, kTickRow + 9.0);
    const std::string surface = Surface(cell);
    if (ground_.Level()) {
      out_ += "<rect x=\"" + Px(cell.x) + "\" y=\"" + Px(cell.ground_y) + "\" width=\"" + Px(cell.width) +
              "\" height=\"" + Px(band) + "\" fill=\"#efebe3\"/>\n";
    } else {
      const std::string bottom = Px(cell.ground_y + band);
      out_ += "<path d=\"" + surface + "V" + bottom + "H" + Px(cell.x) + "Z\" fill=\"#efebe3\"/>\n";
    }
    const double first = std::ceil(cell.left_m / layout_.tick_m);
    for (double mark = first; X(cell, mark * layout_.tick_m) <= cell.x + cell.width; mark += 1.0) {
      const double x = X(cell, mark * layout_.tick_m);
      if (x < cell.x + kTickInset || x > cell.x + cell.width - kTickInset) continue;
      const double y = std::min(GroundY(cell, HeightBelow(ground_, mark * layout_.tick_m)), cell.ground_y);
      Line(x, y, x, y + 6.0, R"(stroke="#8a929b")");
      const std::string label = Metres(mark * layout_.tick_m, layout_.tick_m);
      const double half = kTickInset + 3.2 * static_cast<double>(label.size());
      if (x - half < cell.x || x + half > cell.x + cell.width)
        continue;  // a label that is cut off could be misread
      Text(x, cell.ground_y + kTickRow, R"(text-anchor="middle" font-size="11" fill="#5b6672")", label);
    }
    out_ += "<path d=\"" + surface + (ground_.Level() ? "\"" : "\" fill=\"none\"") +
            " stroke=\"#5b6672\" stroke-width=\"1.5\"/>\n";
  }

  /// The path of the centre of mass since the previous pose.
  void Trail(std::size_t pose) {
    const StripCell& cell = layout_.CellOf(pose);
    std::string path;
    for (int frame = layout_.frames[pose - 1]; frame <= layout_.frames[pose]; ++frame) {
      const double x = CentreX(cell, frame);
      const double y = Y(cell, static_cast<double>(motion_.At(frame).y_m));
      if (x < cell.x + 4.0 || x > cell.x + cell.width - 4.0 || y < cell.y + 4.0) {
        path.clear();  // the path enters from the side
        continue;
      }
      path += (path.empty() ? "M" : "L") + Px(x) + " " + Px(y);
    }
    if (path.find('L') == std::string::npos) return;
    out_ +=
        "<path class=\"trail\" d=\"" + path +
        R"(" fill="none" stroke="#2f5fd0" stroke-opacity="0.45" stroke-width="1.5" stroke-linejoin="round"/>)"
        "\n";
  }

  void Pose(std::size_t pose) {
    const StripCell& cell = layout_.CellOf(pose);
    const int frame = layout_.frames[pose];
    const auto place = [&](int endpoint) {
      const Motion::Point point = motion_.Endpoint(frame, endpoint);
      const Motion::Frame& at = motion_.At(frame);
      return std::array{X(cell, at.x_m + static_cast<double>(point.x)),
                        Y(cell, static_cast<double>(at.y_m) + static_cast<double>(point.y))};
    };
    out_ += "<g class=\"pose\" id=\"pose-" + Letter(pose) + "\">\n";
    if (document_.figure.HasSprings()) {
      Springs(place);
    } else {
      Rods(place);
    }
    out_ += "</g>\n";
  }

  void Disc(const std::array<double, 2>& at, double radius, const char* colour) {
    out_ += "<circle cx=\"" + Px(at[0]) + "\" cy=\"" + Px(at[1]) + "\" r=\"" + Px(radius) + "\" fill=\"" +
            colour + "\"/>\n";
  }

  /// @param place of an endpoint [px]
  void Rods(const auto& place) {
    std::array<int, kMaxContacts> rods_at{};
    std::string rods;
    for (const Bar& bar : bars_) {
      const auto from = place(bar.from), to = place(bar.to);
      rods += "M" + Px(from[0]) + " " + Px(from[1]) + "L" + Px(to[0]) + " " + Px(to[1]);
      ++rods_at[static_cast<std::size_t>(bar.from)];
      ++rods_at[static_cast<std::size_t>(bar.to)];
    }
    const double width = layout_.rod_px;
    out_ += "<path d=\"" + rods + "\" fill=\"none\" stroke=\"#1d2733\" stroke-width=\"" + Px(width) +
            "\" stroke-linecap=\"round\"/>\n";
    for (int k = 0; k < motion_.Connections().contacts; ++k) {
      const int meeting = rods_at[static_cast<std::size_t>(k)];
      if (meeting < 2) continue;
      if (meeting >= 3) Disc(place(k), 0.76 * width, "#1d2733");  // a hub: a disc in the rods
      Disc(place(k), (meeting >= 3 ? 0.46 : 0.3) * width, "#ffffff");
    }
  }

  /// The body, because a muscle that swells shows what it does. @param place of a node [px]
  void Springs(const auto& place) {
    std::vector<BodyPoint> nodes;
    nodes.reserve(static_cast<std::size_t>(motion_.Connections().contacts));
    for (int k = 0; k < motion_.Connections().contacts; ++k) {
      const auto at = place(k);
      nodes.push_back({static_cast<float>(at[0] / layout_.scale), static_cast<float>(at[1] / layout_.scale)});
    }
    out_ += "<g stroke-linecap=\"round\" stroke-linejoin=\"round\">\n";
    for (const BodyPart& part : BodyPartsOf(look_, nodes)) Spring(part);
    out_ += "</g>\n";
  }

  /// A spring, a muscle or a node. @param part with lengths [m] from the corner of the picture
  void Spring(const BodyPart& part) {
    const auto px = [&](float value_m) { return static_cast<double>(value_m) * layout_.scale; };
    const std::array from = {px(part.from.x), px(part.from.y)}, to = {px(part.to.x), px(part.to.y)};
    if (from == to) return Disc(from, px(part.from_m), "#1d2733");
    const double dx = to[0] - from[0], dy = to[1] - from[1];
    const double belly = 2.0 * px(part.belly_m) / std::sqrt(dx * dx + dy * dy);  // of the curve's handle
    const auto side = [&](double way) {
      return "Q" + Px(from[0] + 0.5 * dx - way * belly * dy) + " " +
             Px(from[1] + 0.5 * dy + way * belly * dx) + " ";
    };
    const std::string start = Px(from[0]) + " " + Px(from[1]), end = Px(to[0]) + " " + Px(to[1]);
    const char* colour = part.far ? "#8a929b" : "#1d2733";
    out_ += "<path d=\"M" + start + (part.far ? "L" + end : side(1.0) + end + side(-1.0) + start + "Z") +
            "\" fill=\"" + (part.far ? "none" : colour) + "\" stroke=\"" + colour + "\" stroke-width=\"" +
            Px(2.0 * px(part.from_m)) + "\"/>\n";
  }

  void Caption(std::size_t pose) {
    const StripCell& cell = layout_.CellOf(pose);
    const int frame = layout_.frames[pose];
    double x = cell.x + 0.5 * cell.width;
    if (!layout_.own_ground) x = std::clamp(CentreX(cell, frame), cell.x + 24.0, cell.x + cell.width - 24.0);
    Text(x, cell.ground_y + kLetterRow, R"(text-anchor="middle" font-size="16" font-weight="600")",
         Letter(pose));
    Text(x, cell.ground_y + kTimeRow, R"(text-anchor="middle" fill="#5b6672")",
         Number(Seconds(pose), 2) + " s");
    if (controllers_.empty()) return;
    const int controller = ControllerAt(frame);
    out_ += "<rect x=\"" + Px(x - 13.0) + "\" y=\"" + Px(cell.ground_y + kLetterRow + 3.5) +
            R"(" width="26" height="3.5" rx="1.7" fill=")" +
            HexColour(controller < 0 ? kInkColour.light : RuleColourHex(controller)) + "\"/>\n";
  }

  [[nodiscard]] std::string NameOf(int controller) const {
    return document_.controllers[static_cast<std::size_t>(controller)].name;
  }
  /// Places the controllers' names, wrapping to the next row where needed.
  template <class Use>
  double EachName(Use use) const {
    double x = kStripMargin, row = 0.0;
    for (const int controller : controllers_) {
      const double width = 40.0 + kLetterWidth * static_cast<double>(NameOf(controller).size());
      if (x > kStripMargin && x + width > layout_.width - kStripMargin) {
        x = kStripMargin;
        row += 1.0;
      }
      use(controller, x, row);
      x += width;
    }
    return row + 1.0;
  }
  [[nodiscard]] double LegendHeight() const {
    return controllers_.empty() ? 0.0 : kLegendRow * EachName([](int, double, double) {});
  }
  void Legend() {
    EachName([&](int controller, double x, double row) {
      const double y = layout_.height - 10.0 + row * kLegendRow;
      out_ += "<rect x=\"" + Px(x) + "\" y=\"" + Px(y - 6.0) + R"(" width="18" height="4" rx="2" fill=")" +
              HexColour(RuleColourHex(controller)) + "\"/>\n";
      Text(x + 25.0, y, R"(fill="#5b6672")", EscapedXml(NameOf(controller)));
    });
  }

  const Document& document_;
  const Motion& motion_;
  std::vector<Bar> bars_;
  FigureLook look_;
  const FilmStripWords& words_;
  const Terrain ground_;
  const StripLayout layout_;
  std::vector<int> controllers_;  // the active controllers, if there are several
  std::string out_;
};

}  // namespace

std::string FilmStripSvg(const Document& document, const Motion& motion, const FilmStripOptions& options) {
  return StripDrawing(document, motion, options).Whole();
}

}  // namespace gaitsmith::shell
