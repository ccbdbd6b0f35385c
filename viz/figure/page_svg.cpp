// SPDX-License-Identifier: GPL-3.0-or-later
// SVG with real text: Cairo's own SVG would turn it into outlines.
#include <cmath>
#include <cstdio>

#include "figure/page.h"
#include "figure/plot.h"
#include "figure/png.h"

namespace psm {
namespace {

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", value);
  std::string short_text = text;
  while (short_text.back() == '0') short_text.pop_back();
  if (short_text.back() == '.') short_text.pop_back();
  return short_text == "-0" ? "0" : short_text;
}

std::string attribute(const char* name, double value) { return std::string(" ") + name + "=\"" + number(value) + "\""; }
std::string attribute(const char* name, const std::string& value) { return std::string(" ") + name + "=\"" + value + "\""; }

std::string color_text(const glm::vec3& color) {
  const glm::ivec3 c(glm::round(glm::clamp(color, 0.0f, 1.0f) * 255.0f));
  char text[8];
  std::snprintf(text, sizeof text, "#%02X%02X%02X", unsigned(c.r & 255), unsigned(c.g & 255), unsigned(c.b & 255));
  return text;
}

/// A paint's colour, and its opacity where it is not opaque.
std::string paint(const char* what, const glm::vec4& color) {
  if (color.a <= 0.0f) return attribute(what, "none");
  const std::string opacity = color.a < 1.0f ? attribute((std::string(what) + "-opacity").c_str(), color.a) : "";
  return attribute(what, color_text(glm::vec3(color))) + opacity;
}

std::string base64(const std::string& bytes) {
  static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) out += i + k > bytes.size() ? '=' : digits[group >> (18 - 6 * k) & 63];
  }
  return out;
}

class SvgWriter {
 public:
  std::string body, definitions;

  void operator()(const PageLine& line) {
    const std::string ends =
        attribute("x1", line.a.x) + attribute("y1", line.a.y) + attribute("x2", line.b.x) + attribute("y2", line.b.y);
    const bool fades = std::abs(line.opacity_a - line.opacity_b) > 0.004;
    const std::string stroke = fades ? attribute("stroke", "url(#" + gradient(line, ends) + ")")
                                     : paint("stroke", glm::vec4(line.color, float(line.opacity_a)));
    body += "<line" + ends + stroke + attribute("stroke-width", line.width);
    if (line.dash_on > 0.0) body += attribute("stroke-dasharray", number(line.dash_on) + " " + number(line.dash_off));
    body += "/>\n";
  }

  void operator()(const PagePolygon& polygon) {
    std::string points;
    for (const glm::dvec2& p : polygon.corners) points += (points.empty() ? "" : " ") + number(p.x) + "," + number(p.y);
    // Feathered edges of translucent neighbours would show as seams.
    const std::string edges = polygon.fill.a < 1.0f ? attribute("shape-rendering", "crispEdges") : "";
    body += "<polygon" + attribute("points", points) + paint("fill", polygon.fill) + edges + "/>\n";
  }

  void operator()(const PageBox& box) {
    body += "<rect" + place(box.top_left, box.size) + attribute("rx", box.radius) + paint("fill", box.fill);
    if (box.rim_width > 0.0) body += paint("stroke", box.rim) + attribute("stroke-width", box.rim_width);
    body += "/>\n";
  }

  void operator()(const PageText& text) {
    body += "<text" + attribute("x", text.top_left.x + 0.5 * text.size.x) +
            attribute("y", text.top_left.y + kAscentPerHeight * text.size.y) +
            attribute("font-size", kEmPerHeight * text.size.y) + paint("fill", glm::vec4(text.color, 1.0f)) +
            " xml:space=\"preserve\">" + xml_text(text.text) + "</text>\n";
  }

  void operator()(const PageImage& image) {
    const auto png = png_bytes(image.image);
    body += "<image" + place(image.top_left, image.size) + attribute("preserveAspectRatio", "none") +
            attribute("href", "data:image/png;base64," + base64(png)) + "/>\n";
  }

  /// Opens a group that is cut off at this rectangle.
  void open_panel(const PagePanel& panel) {
    const std::string id = "panel" + std::to_string(++names_);
    definitions += "<clipPath" + attribute("id", id) + "><rect" + place(panel.top_left, panel.size) + "/></clipPath>\n";
    body += "<g" + attribute("clip-path", "url(#" + id + ")") + ">\n";
  }

 private:
  static std::string place(const glm::dvec2& top_left, const glm::dvec2& size) {
    return attribute("x", top_left.x) + attribute("y", top_left.y) + attribute("width", size.x) + attribute("height", size.y);
  }

  std::string gradient(const PageLine& line, const std::string& ends) {
    const std::string id = "fade" + std::to_string(++names_);
    const auto stop = [&](double offset, double opacity) {
      return "<stop" + attribute("offset", offset) + attribute("stop-color", color_text(line.color)) +
             attribute("stop-opacity", opacity) + "/>";
    };
    definitions += "<linearGradient" + attribute("id", id) + attribute("gradientUnits", "userSpaceOnUse") + ends + ">" +
                   stop(0.0, line.opacity_a) + stop(1.0, line.opacity_b) + "</linearGradient>\n";
    return id;
  }

  int names_ = 0;
};

}  // namespace

std::string page_svg(const Page& page) {
  SvgWriter writer;
  for (const PagePanel& panel : page.panels) {
    writer.open_panel(panel);
    for (const PageItem& item : panel.items) std::visit(writer, item);
    writer.body += "</g>\n";
  }
  const std::string width = number(page.size.x), height = number(page.size.y);
  std::string svg = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width +
                    "\" height=\"" + height + "\" viewBox=\"0 0 " + width + " " + height +
                    "\" font-family=\"DejaVu Sans, Verdana, Arial, sans-serif\" text-anchor=\"middle\">\n";
  svg += "<title>" + xml_text(page.title) + "</title>\n<metadata>" + xml_text(page.parameters) + "</metadata>\n";
  svg += "<defs>\n" + writer.definitions + "</defs>\n";
  if (page.background) svg += "<rect width=\"100%\" height=\"100%\"" + paint("fill", glm::vec4(*page.background, 1.0f)) + "/>\n";
  return svg + writer.body + "</svg>\n";
}

}  // namespace psm
