// SPDX-License-Identifier: BSD-3-Clause
#include "plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace cellsearch::bench {
namespace {

constexpr double width = 1120.0;
constexpr double height = 520.0;

std::string number(double value, const char* pattern = "%.1f") {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), pattern, value);
  return text.data();
}

std::string text_at(double x, double y, const std::string& more, const std::string& text) {
  return "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" " + more + ">" + text + "</text>\n";
}

std::string line(double x1, double y1, double x2, double y2, const std::string& style) {
  return "<line x1=\"" + number(x1) + "\" y1=\"" + number(y1) + "\" x2=\"" + number(x2) + "\" y2=\"" +
         number(y2) + "\" " + style + "/>\n";
}

/// A logarithmic axis from `from` to `to` in the picture.
struct Axis {
  double lo = 1.0;
  double hi = 10.0;
  double from = 0.0;
  double to = 1.0;

  double operator()(double value) const {
    return from + (to - from) * std::log(value / lo) / std::log(hi / lo);
  }

  /// Where lines are drawn: powers of ten, and within them 2 and 5 if there are few.
  std::vector<double> ticks() const {
    const bool few = hi / lo < 2e3;
    std::vector<double> result;
    for (double power = 1e-6; power < 1e13; power *= 10.0) {
      for (const double step : {1.0, 2.0, 5.0}) {
        const double value = step * power;
        if ((few || step == 1.0) && value >= lo * 0.9999 && value <= hi * 1.0001) result.push_back(value);
      }
    }
    return result;
  }
};

/// From the smallest to the largest value, with some room.
Axis axis_over(const std::vector<double>& values, double room, double from, double to) {
  if (values.empty()) return {1.0, 10.0, from, to};
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return {*least / room, *most * room, from, to};
}

/// 1000000 as 10 with a raised 6.
std::string as_power(double value) {
  const int power = static_cast<int>(std::lround(std::log10(value)));
  return "10<tspan dy=\"-6\" font-size=\"10\">" + std::to_string(power) + "</tspan>";
}

std::string plain(double value) {
  return value < 1.0 ? number(value, "%.2g") : number(value, "%.0f");
}

struct Style {
  std::string colour;
  std::string dashes;
  double thickness = 1.6;
  int marker = 0;  ///< 0 circle, 1 square, 2 triangle, 3 diamond
};

Style style_of(std::size_t place, const std::string& method, bool peer, std::size_t peers_before) {
  // Eight colours that most colour-blind people can tell apart (Okabe & Ito 2008), black for ours.
  static constexpr std::array own{"#0072b2", "#009e73", "#56b4e9", "#8c6bb1", "#7f7f7f"};
  static constexpr std::array others{"#d55e00", "#cc79a7", "#e69f00", "#8c510a", "#b2182b"};
  if (method.rfind("production", 0) == 0) {
    return {"#000000", method == "production" ? "" : "2 3", method == "production" ? 3.2 : 2.0, 0};
  }
  if (peer) {
    return {others[peers_before % others.size()], "7 4", 1.6, static_cast<int>(peers_before % 4)};
  }
  return {own[place % own.size()], "", 1.6, static_cast<int>(place % 4)};
}

std::string marker(double x, double y, const Style& style) {
  const std::string look = "fill=\"white\" stroke=\"" + style.colour + "\" stroke-width=\"1.6\"/>\n";
  const auto polygon = [&](std::initializer_list<std::array<double, 2>> corners) {
    std::string points;
    for (const auto& [dx, dy] : corners) points += number(x + dx) + "," + number(y + dy) + " ";
    return "<polygon points=\"" + points + "\" " + look;
  };
  switch (style.marker) {
    case 0:
      return "<circle cx=\"" + number(x) + "\" cy=\"" + number(y) + "\" r=\"3.6\" " + look;
    case 1:
      return polygon({{-3.3, -3.3}, {3.3, -3.3}, {3.3, 3.3}, {-3.3, 3.3}});
    case 2:
      return polygon({{0.0, -4.4}, {4.0, 3.2}, {-4.0, 3.2}});
    default:
      return polygon({{0.0, -4.6}, {4.6, 0.0}, {0.0, 4.6}, {-4.6, 0.0}});
  }
}

/// The rectangle of a chart.
struct Place {
  double left;
  double top;
  double right;
  double bottom;
};

std::string frame(const Place& place, const Axis& x, const Axis& y, const std::string& title,
                  const std::string& label) {
  std::string svg;
  for (const double tick : x.ticks()) {
    const double mantissa = tick / std::pow(10.0, std::floor(std::log10(tick) + 1e-9));
    const bool main = std::fabs(mantissa - 1.0) < 0.01;
    svg += line(x(tick), place.top, x(tick), place.bottom, main ? "class=\"main\"" : "class=\"minor\"");
    if (main) svg += text_at(x(tick), place.bottom + 20.0, "text-anchor=\"middle\"", as_power(tick));
  }
  for (const double tick : y.ticks()) {
    svg += line(place.left, y(tick), place.right, y(tick), "class=\"main\"");
    svg += text_at(place.left - 8.0, y(tick) + 4.0, "text-anchor=\"end\"", plain(tick));
  }
  svg += "<rect x=\"" + number(place.left) + "\" y=\"" + number(place.top) + "\" width=\"" +
         number(place.right - place.left) + "\" height=\"" + number(place.bottom - place.top) +
         "\" fill=\"none\" stroke=\"#444\"/>\n";
  svg += text_at(place.left, place.top - 12.0, "font-weight=\"bold\"", title);
  svg += text_at(0.5 * (place.left + place.right), place.bottom + 44.0, "text-anchor=\"middle\"",
                 "number of nodes N");
  const double x_label = place.left - 46.0;
  const double y_label = 0.5 * (place.top + place.bottom);
  svg += text_at(
      x_label, y_label,
      "text-anchor=\"middle\" transform=\"rotate(-90 " + number(x_label) + " " + number(y_label) + ")\"",
      label);
  return svg;
}

std::string path(const Axis& x, const Axis& y, const std::vector<double>& xs, const std::vector<double>& ys,
                 const Style& style) {
  std::string points;
  std::string markers;
  for (std::size_t k = 0; k < xs.size(); ++k) {
    if (!(ys[k] > 0.0)) continue;
    points += number(x(xs[k])) + "," + number(y(ys[k])) + " ";
    markers += marker(x(xs[k]), y(ys[k]), style);
  }
  return "<polyline points=\"" + points + "\" fill=\"none\" stroke=\"" + style.colour + "\" stroke-width=\"" +
         number(style.thickness) + "\" stroke-dasharray=\"" + style.dashes + "\"/>\n" + markers;
}

using Values = std::vector<double> Curve::*;

std::vector<double> all_of(const std::vector<Curve>& curves, Values values) {
  std::vector<double> result;
  for (const Curve& curve : curves) {
    for (const double value : curve.*values) {
      if (value > 0.0) result.push_back(value);
    }
  }
  return result;
}

std::string chart(const Place& place, const std::vector<Curve>& curves, const std::vector<Style>& styles,
                  Values values, const std::array<std::string, 2>& labels) {
  const Axis x = axis_over(all_of(curves, &Curve::nodes), 1.35, place.left, place.right);
  const Axis y = axis_over(all_of(curves, values), 1.4, place.bottom, place.top);
  std::string svg = frame(place, x, y, labels[0], labels[1]);
  // Later ones lie on top: the first methods are the ones to see.
  for (std::size_t k = curves.size(); k-- > 0;) {
    svg += path(x, y, curves[k].nodes, curves[k].*values, styles[k]);
  }
  return svg;
}

std::string legend(double left, double top, const std::vector<Curve>& curves,
                   const std::vector<Style>& styles) {
  std::string svg = text_at(left, top, "font-weight=\"bold\"", "method");
  svg += text_at(left + 204.0, top, "text-anchor=\"end\" font-weight=\"bold\"", "total time");
  for (std::size_t k = 0; k < curves.size(); ++k) {
    const double y = top + 24.0 + 24.0 * static_cast<double>(k);
    svg += line(left, y - 4.0, left + 32.0, y - 4.0,
                "stroke=\"" + styles[k].colour + "\" stroke-width=\"" + number(styles[k].thickness) +
                    "\" stroke-dasharray=\"" + styles[k].dashes + "\"");
    svg += marker(left + 16.0, y - 4.0, styles[k]);
    svg += text_at(left + 42.0, y, "", curves[k].method);
    if (curves[k].nodes.size() >= 2) {
      svg +=
          text_at(left + 204.0, y, "text-anchor=\"end\"",
                  "N<tspan dy=\"-6\" font-size=\"10\">" + number(curves[k].exponent(), "%.2f") + "</tspan>");
    }
  }
  return svg;
}

}  // namespace

std::string plot(const std::string& title, const std::vector<Curve>& curves,
                 const std::vector<std::string>& peers) {
  std::vector<Style> styles;
  std::size_t peers_before = 0;
  for (std::size_t k = 0; k < curves.size(); ++k) {
    const bool peer = std::find(peers.begin(), peers.end(), curves[k].method) != peers.end();
    styles.push_back(style_of(k, curves[k].method, peer, peers_before));
    if (peer) ++peers_before;
  }
  const std::string size =
      "width=\"" + number(width, "%.0f") + "\" height=\"" + number(height, "%.0f") + "\"";
  std::string svg =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" " + size + " viewBox=\"0 0 " + number(width, "%.0f") + " " +
      number(height, "%.0f") +
      "\" font-family=\"Helvetica, Arial, sans-serif\" font-size=\"13\" fill=\"#222\">\n"
      "<style>.main { stroke: #ccc; stroke-width: 1; } .minor { stroke: #eee; stroke-width: 1; }"
      "</style>\n<rect " +
      size + " fill=\"white\"/>\n";
  svg += text_at(24.0, 30.0, "font-size=\"17\" font-weight=\"bold\"", title);
  svg += chart({72.0, 78.0, 432.0, 450.0}, curves, styles, &Curve::ns_per_segment,
               {"Time: build and query", "ns per segment"});
  svg += chart({512.0, 78.0, 872.0, 450.0}, curves, styles, &Curve::bytes_per_node,
               {"Memory, without the answer", "bytes per node"});
  svg += legend(896.0, 90.0, curves, styles);
  return svg + "</svg>\n";
}

void write_plot(const std::string& file, const std::string& title, const std::vector<Curve>& curves,
                const std::vector<std::string>& peers) {
  std::ofstream stream(file);
  stream << plot(title, curves, peers) << std::flush;
  if (!stream) throw std::runtime_error("The file " + file + " cannot be written.");
}

}  // namespace cellsearch::bench
