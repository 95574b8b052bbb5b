#include "diagram.hpp"

#include "svg.hpp"
#include "words.hpp"

#include <algorithm>
#include <map>

namespace jauscat::reference {

namespace {

// Pixels. Text is set in a monospaced font, whose characters are 0.6 of its size wide.
constexpr int picture_width = 880, margin = 12;
constexpr int gap = 6;           // between boxes
constexpr int label_height = 14; // above a box: its place and what announces it
constexpr int box_height = 44;   // of a leaf
constexpr int strip_height = 7;  // of its bytes
constexpr int frame_padding = 8;
constexpr int cell_width = 22;         // of a bit in a presence vector
constexpr std::size_t most_cells = 16; // of a leaf
constexpr int text_width(std::size_t characters, int size) { return static_cast<int>(characters) * size * 6 / 10 + 1; }

std::string rectangle(const std::string& style, int x, int y, int width, int height) {
    return "<rect class=\"" + style + "\"" + attribute("x", x) + attribute("y", y) + attribute("width", width) +
           attribute("height", height) + "/>\n";
}
std::string words(const char* style, int x, int y, std::string_view text) {
    return text_element(style, x, y, escaped(text));
}

/// A box of the picture; boxes flow like words of a text, and may have boxes in them.
struct box {
    enum class look : std::uint8_t { leaf, frame, choice };
    look how{};
    bool structural{};       // says how what follows is laid out
    bool maybe{};            // may be absent
    std::string left{};      // label above: its place
    std::string right{};     // and what announces it
    std::string title{};     // name of the field
    std::string subtitle{};  // of a leaf
    std::size_t bytes{};     // drawn as cells on top of a leaf; 0 where their number varies
    unsigned bits{}, used{}; // cells in a presence vector
    std::vector<box> inside{};
    int x{}, y{}, width{}, height{}; // without the label; from the corner of the box around it

    [[nodiscard]] std::string style_of() const {
        return how == look::frame ? "frame" : how == look::choice ? "choice" : structural ? "structural" : "leaf";
    }
    void arrange(int available);
    void draw(std::string& svg, int left_edge, int top_edge) const;
};

/// Places boxes in lines of the given width from a corner on; returns the size they take.
std::pair<int, int> flow(std::vector<box>& boxes, int available, int left_edge, int top_edge) {
    const bool labelled = std::ranges::any_of(boxes, [](const box& one) { return !(one.left + one.right).empty(); });
    const int label = labelled ? label_height : gap;
    int x = 0, y = 0, line = 0, widest = 0;
    for (box& one : boxes) {
        one.arrange(available);
        if (x != 0 && x + one.width > available) {
            x = 0;
            y += line + gap;
            line = 0;
        }
        one.x = left_edge + x;
        one.y = top_edge + y + label;
        x += one.width + gap;
        line = std::max(line, label + one.height);
        widest = std::max(widest, x - gap);
    }
    return {widest, y + line};
}

void box::arrange(int available) {
    const int label = text_width(characters_of(left) + characters_of(right) + 3, 10);
    const int titled = text_width(characters_of(title), 12) + 14;
    width = std::max(label, titled);
    if (how == look::leaf) {
        width = std::max({width, text_width(characters_of(subtitle), 11) + 14,
                          static_cast<int>(std::min<std::size_t>(bytes, 8)) * 18,
                          static_cast<int>(bits) * cell_width + 14});
        height = box_height + (bits != 0 ? 20 : 0);
        return;
    }
    const auto [inner_width, inner_height] = flow(inside, available - 2 * frame_padding, frame_padding, 18);
    width = std::max(width, inner_width + 2 * frame_padding);
    height = 18 + inner_height + frame_padding;
}

void box::draw(std::string& svg, int left_edge, int top_edge) const {
    const int from_left = left_edge + x, from_top = top_edge + y;
    const std::string dash = maybe ? " dashed" : "";
    if (!left.empty()) svg += words("place", from_left + 1, from_top - 4, left);
    if (!right.empty()) svg += words("place maybe", from_left + width - 1, from_top - 4, right);
    svg += rectangle(style_of() + dash, from_left, from_top, width, height);
    if (how != look::leaf) {
        svg += words("title", from_left + 7, from_top + 15, title);
        for (const box& one : inside) one.draw(svg, from_left, from_top);
        return;
    }
    // The bytes, where their number is fixed and not too large to see.
    const int cells = bytes == 0 || bytes > most_cells ? 1 : static_cast<int>(bytes);
    for (int i = 0; i != cells; ++i)
        svg += rectangle(bytes == 0   ? "open"
                         : structural ? "byte strong"
                                      : "byte",
                         from_left + i * width / cells, from_top, (i + 1) * width / cells - i * width / cells,
                         strip_height);
    svg += words("title", from_left + 7, from_top + 23, title);
    svg += words("type", from_left + 7, from_top + 37, subtitle);
    for (unsigned i = 0; i != bits; ++i) {
        const int at = from_left + 7 + static_cast<int>(i) * cell_width;
        svg += rectangle(i < used ? "used" : "unused", at, from_top + 43, cell_width, 16);
        svg += words("bit", at + cell_width / 2, from_top + 55, std::to_string(i));
    }
}

/// Draws a message's parts from its first byte on.
class drawing {
  public:
    /// `at` is where the first of them lies, as long as that is the same in every message.
    std::vector<box> boxes(const std::vector<part>& parts, std::string_view prefix, std::optional<std::size_t> at) {
        std::vector<box> made;
        for (const part& one : parts) {
            if (one.what == part::kind::flag) continue; // seen in the presence vector alone
            made.push_back(box_of(one, prefix, at));
            made.back().structural |= std::ranges::any_of(parts, [&](const part& other) { return steers(one, other); });
            advance(at, one);
        }
        return made;
    }

  private:
    /// Whether `one` says how many elements or which form another part, or one in it, has.
    static bool steers(const part& one, const part& other) {
        return other.times.substr(0, other.times.find(' ')) == one.name || other.selector == one.name ||
               std::ranges::any_of(other.parts, [&](const part& inner) { return steers(one, inner); });
    }

    /// Where the same form was drawn before: there it can be looked up. Else it is remembered.
    std::string drawn_before(const std::string& form, const std::string& name) {
        const auto [place, is_new] = drawn_.emplace(form, name);
        return is_new ? "" : "as " + (place->second == name ? "above" : place->second);
    }

    void fill_record(box& made, const part& one, std::string_view prefix, std::optional<std::size_t> at) {
        if (const std::string before = drawn_before(one.type, one.name); !before.empty()) {
            made.subtitle = one.type + ", " + before;
        } else {
            made.how = box::look::frame;
            made.inside = boxes(one.parts, prefix, made.maybe ? std::nullopt : at);
        }
    }

    void fill_choice(box& made, const part& one) {
        std::string form = one.selector;
        for (const part& each : one.parts) form += " " + each.type;
        if (const std::string before = drawn_before(form, one.name); !before.empty()) {
            made.subtitle = "by " + one.selector + ", " + before;
            return;
        }
        made.how = box::look::choice;
        made.title += ": one of these, by " + one.selector;
        for (const part& each : one.parts) {
            box alternative{.right = "= " + numbers_of(each.tags),
                            .title = each.type.empty() ? "nothing" : each.type,
                            .subtitle = counted(each.least, "byte"),
                            .bytes = each.least == each.most ? each.least : 0};
            if (each.what == part::kind::record) {
                alternative.how = box::look::frame;
                alternative.inside = boxes(each.parts, "+", 0);
            }
            made.inside.push_back(std::move(alternative));
        }
    }

    box box_of(const part& one, std::string_view prefix, std::optional<std::size_t> at) {
        box made{.left = span_of(prefix, at, one),
                 .right = condition_of(one),
                 .title = one.name,
                 .bytes = one.least == one.most ? one.least : 0};
        made.maybe = !made.right.empty();
        switch (one.what) {
        case part::kind::presence_vector:
            made.structural = true;
            made.bits = static_cast<unsigned>(one.least) * 8;
            made.used = one.width;
            made.subtitle = one.type;
            break;
        case part::kind::packed:
            made.how = box::look::frame;
            made.title = one.type + ", bit by bit";
            for (const part& field : one.parts)
                made.inside.push_back({.left = bits_of(field),
                                       .title = field.name.empty() ? "reserved" : field.name,
                                       .subtitle = counted(field.width, "bit"),
                                       .bytes = field.width});
            break;
        case part::kind::record: fill_record(made, one, prefix, at); break;
        case part::kind::choice: fill_choice(made, one); break;
        case part::kind::list:
            made.how = box::look::frame;
            made.title += one.times.empty() ? ": nodes of a tree, depth first" : " × " + one.times;
            made.inside = boxes(one.parts, "+", 0);
            break;
        case part::kind::octets:
            made.subtitle = (one.least == one.most ? std::to_string(one.least) + " "
                             : one.times.empty()   ? ""
                                                   : one.times + " ") +
                            one.type;
            break;
        default:
            made.structural = one.what == part::kind::count;
            made.subtitle = one.type + (one.unit.empty() ? "" : ", " + one.unit);
        }
        return made;
    }

    std::map<std::string, std::string> drawn_{}; // forms, and the part that shows them
};

// A page may be light or dark whatever the reader's system prefers, so pictures bring their own ground.
constexpr std::string_view style = R"(<style>
text { font-family: ui-monospace, SFMono-Regular, Menlo, Consolas, "DejaVu Sans Mono", monospace; fill: #1f2328; }
.title { font-size: 12px; } .type { font-size: 11px; fill: #59636e; } .place { font-size: 10px; fill: #818b98; }
.maybe { fill: #0969da; text-anchor: end; } .bit { font-size: 10px; text-anchor: middle; fill: #59636e; }
rect { stroke: #c4ccd5; fill: none; } .ground { fill: #ffffff; stroke: #d8dee4; } .leaf { fill: #f6f8fa; }
.structural { fill: #eaf4ff; stroke: #a8cdf0; } .byte { fill: #e3e8ee; } .open { fill: #eff2f5; stroke-dasharray: 2 2; }
.used, .strong { fill: #cfe4fa; stroke: #a8cdf0; } .unused { fill: #ffffff; stroke: #dce6f0; }
.frame { stroke: #afb8c1; } .choice { stroke: #d4a72c; } .dashed { stroke-dasharray: 4 3; }
@media (prefers-color-scheme: dark) {
text { fill: #e6edf3; } .type, .bit { fill: #9198a1; } .place { fill: #7d8590; } .maybe { fill: #4493f8; }
rect { stroke: #444c56; } .ground { fill: #0d1117; stroke: #3d444d; } .leaf { fill: #161b22; }
.structural { fill: #121d2f; stroke: #2c5282; } .byte { fill: #2b3138; } .open { fill: #21262d; }
.used, .strong { fill: #1f3a5f; stroke: #2c5282; } .unused { fill: #0d1117; stroke: #2d333b; }
.frame { stroke: #57606a; } .choice { stroke: #9e6a03; }
}
</style>
)";

} // namespace

std::string diagram(const std::vector<part>& parts, std::string_view title) {
    std::vector<box> boxes = drawing{}.boxes(parts, "", 0);
    const auto [inner_width, inner_height] = flow(boxes, picture_width - 2 * margin, margin, margin - 4);
    const int width = inner_width + 2 * margin, height = inner_height + 2 * margin - 4;
    std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\"" + attribute("width", width) +
                      attribute("height", height) + " viewBox=\"0 0 " + std::to_string(width) + " " +
                      std::to_string(height) + "\" role=\"img\">\n<title>" + escaped(title) + "</title>\n" +
                      std::string{style} + "<rect class=\"ground\" x=\"0.5\" y=\"0.5\" width=\"" +
                      std::to_string(width - 1) + "\" height=\"" + std::to_string(height - 1) + "\" rx=\"6\"/>\n";
    for (const box& one : boxes) one.draw(svg, 0, 0);
    return svg + "</svg>\n";
}

} // namespace jauscat::reference
