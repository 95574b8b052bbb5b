#include "data_path.hpp"

#include "sdo_frame.hpp"
#include "svg.hpp"
#include <jauscat/jaus/message/message.hpp>
#include <jauscat/schema/ethercat/datagram.hpp>
#include <jauscat/schema/jaus/platform.hpp>
#include <jauscat/schema/translation/seed_table.hpp>
#include <jauscat/text/hex.hpp>

#include <sstream>
#include <string>

namespace {

namespace bridging = jauscat::bridging;
namespace ethercat = jauscat::ethercat;
namespace jaus = jauscat::jaus;
namespace wire = jauscat::wire;
using jauscat::reference::attribute;
using jauscat::reference::bytes;
using jauscat::reference::text_element;
using delivery = bridging::delivery<jauscat::translation::seed_table>;

constexpr bridging::slave_identity arm{.subsystem = 2, .station = 2};
constexpr double effort = 50;

// Pixels.
constexpr int picture_width = 890, margin = 20, byte_width = 26, box_height = 28, row_height = 128, first_box = 76;

/// A place in the picture: some bytes, or a field with its value. Places of one kind hold the same thing in other rows.
struct cell {
    std::string kind{};  ///< empty: nothing that came with the message
    std::string label{}; ///< above the box
    std::vector<std::string> boxes{};
    int box_width{byte_width};
    int x{};

    [[nodiscard]] int width() const { return static_cast<int>(boxes.size()) * box_width; }
};

struct row {
    std::string who{}, what{};
    std::vector<cell> cells{};
    int y{};
};

/// The next bytes of a message.
class reader {
  public:
    explicit reader(std::span<const std::byte> all) : all_{all} {}
    cell next(const char* kind, const char* label, std::size_t size) {
        cell result{.kind = kind, .label = label};
        for (const std::byte byte : all_.subspan(at_, size)) result.boxes.push_back(jauscat::text::hex({&byte, 1}));
        at_ += size;
        return result;
    }
    /// Bytes that are not shown.
    cell skip(const char* label, std::size_t size) {
        at_ += size;
        return field("", label, std::to_string(size) + " bytes");
    }
    static cell field(const char* kind, const char* label, const std::string& value) {
        return {.kind = kind, .label = label, .boxes = {value}, .box_width = 76};
    }
    cell rest(const char* label) { return skip(label, all_.size() - at_); }

  private:
    std::span<const std::byte> all_;
    std::size_t at_{};
};

std::vector<cell> cells_of_message(std::span<const std::byte> message) {
    reader in{message};
    return {in.next("properties", "prop", 2), in.next("code", "command", 2), in.next("instance", "inst", 1),
            in.next("component", "comp", 1),  in.next("node", "node", 1),    in.next("subsystem", "subs", 1),
            in.next("source", "source", 4),   in.next("size", "size", 2),    in.next("sequence", "sequence", 2),
            in.next("body", "body", 4)};
}

void append_data(std::vector<cell>& to, reader in) {
    to.push_back(in.next("properties", "", 2));
    to.push_back(in.next("source", "data", 4));
    to.push_back(in.next("sequence", "", 2));
    to.push_back(in.next("body", "", 4));
}

std::string number(double value) { return (std::ostringstream{} << value).str(); }

std::vector<row> rows() {
    bytes message(64), packet(delivery::translator::max_packet_size), again(64);
    const jaus::header head{.destination = {.instance = 1, .component = 33, .node = 2, .subsystem = 2},
                            .source = {.instance = 1, .component = 32, .node = 1, .subsystem = 1},
                            .sequence_number = 7};
    message.resize(
        jaus::make_message(head, jaus::set_wrench_effort{.propulsive_linear_effort_x = effort}, message)->size());
    packet.resize(delivery::translator::to_packet(message, packet)->size());
    const auto object = delivery::object_of(packet);
    const auto frame = jauscat::reference::frame_with(object);
    again.resize(delivery::message_of(object, arm, again)->size());
    const auto received = jaus::split(again);
    jaus::set_wrench_effort obeyed{};
    if (message.empty() || again != message || !wire::decode(obeyed, received.body))
        throw std::logic_error{"the message does not arrive"};

    std::vector<row> result;
    result.push_back({"Operator",
                      "JAUS message over UDP, " + std::to_string(message.size()) + " bytes: Set Wrench Effort, " +
                          number(effort) + " % forward",
                      cells_of_message(message)});

    jauscat::hilscher::sdo_download_request fields{};
    if (!wire::decode_prefix(fields, packet)) throw std::logic_error{"no packet"};
    const auto shown = [](std::uint32_t value) { return std::to_string(value); };
    row controller{"Robot controller", "the table makes it an SDO download packet, and back", {}};
    controller.cells = {reader::field("subsystem", "ulDest", shown(fields.head.ul_dest)),
                        reader::field("instance", "ulDestId", shown(fields.head.ul_dest_id)),
                        reader::field("code", "ulSubIndex", shown(fields.ul_sub_index)),
                        reader::field("component", "ulIndex", shown(fields.ul_index)),
                        reader::field("node", "ulNodeId", shown(fields.ul_node_id)),
                        reader::field("size", "ulDataCnt", shown(fields.ul_data_cnt))};
    append_data(controller.cells, reader{object.data});
    result.push_back(controller);

    reader in{frame};
    row ethernet{"EtherCAT",
                 "frame, " + std::to_string(frame.size()) + " bytes: the master writes object " + shown(object.index) +
                     ":" + shown(object.subindex) + " of the slave",
                 {}};
    constexpr std::size_t before_mailbox = 6; // of a datagram's header, behind the station
    ethernet.cells = {
        in.skip("Ethernet", wire::max_size<ethercat::ethernet_header> + wire::max_size<ethercat::frame_header>),
        in.next("", "FPWR, tag", 2),
        in.next("node", "station", 2),
        in.skip("mailbox, CoE",
                before_mailbox + wire::max_size<ethercat::mailbox_header> + wire::max_size<ethercat::coe_header>),
        in.next("", "SDO", 1),
        in.next("component", "index", 2),
        in.next("code", "sub.", 1),
        in.next("size", "complete size", 4)};
    const std::size_t data_at = wire::max_size<ethercat::ethernet_header> + wire::max_size<ethercat::frame_header> +
                                wire::max_size<ethercat::datagram_header> + wire::max_size<ethercat::mailbox_header> +
                                wire::max_size<ethercat::coe_header> + wire::max_size<ethercat::sdo_normal>;
    reader data{std::span{frame}.subspan(data_at)};
    append_data(ethernet.cells, data);
    static_cast<void>(in.skip("", object.data.size()));
    ethernet.cells.push_back(in.rest("zeros, WKC"));
    result.push_back(ethernet);

    result.push_back({"Robot arm",
                      "the object is the JAUS message again, to this arm of this robot: forward " +
                          number(obeyed.propulsive_linear_effort_x.value_or(0)) + " %",
                      cells_of_message(again)});
    return result;
}

constexpr const char* style = R"(<style>
text { font-family: "DejaVu Sans", Arial, sans-serif; fill: #1f2933 }
.who { font-size: 15px; font-weight: bold }
.what { font-size: 13px; stroke: #ffffff; stroke-width: 4px; stroke-linejoin: round; paint-order: stroke }
.label { font-size: 9px; text-anchor: middle; fill: #52606d }
.byte { font-family: "DejaVu Sans Mono", monospace; font-size: 13px; text-anchor: middle }
.box { stroke: #ffffff; stroke-width: 2; fill: #e4e7eb }
.band { opacity: 0.3 }
.code { fill: #7cb7f0 } .component { fill: #7ed09a } .node { fill: #ffb46b } .subsystem { fill: #f2a0c4 }
.instance { fill: #c3a6f0 } .size { fill: #f5d547 } .properties, .source, .sequence { fill: #b5c0cc } .body { fill: #f58f7f }
</style>
)";

std::string drawn(const row& one) {
    std::string out = text_element("what", margin, one.y - 34,
                                   "<tspan class=\"who\">" + one.who + "</tspan>&#160;&#160; " + one.what);
    for (const cell& place : one.cells) {
        if (!place.label.empty()) out += text_element("label", place.x + place.width() / 2, one.y - 6, place.label);
        int x = place.x;
        for (const auto& box : place.boxes) {
            out += "<rect class=\"box " + place.kind + "\"" + attribute("x", x) + attribute("y", one.y) +
                   attribute("width", place.box_width) + attribute("height", box_height) + " rx=\"4\"/>\n" +
                   text_element("byte", x + place.box_width / 2, one.y + 19, box);
            x += place.box_width;
        }
    }
    return out;
}

/// From the places of a row to those of the next that hold the same.
std::string bands(const row& from, const row& to) {
    std::string out;
    for (const cell& a : from.cells)
        for (const cell& b : to.cells) {
            if (a.kind.empty() || a.kind != b.kind) continue;
            const int top = from.y + box_height, bottom = to.y, half = (top + bottom) / 2;
            const auto point = [](int x, int y) { return std::to_string(x) + " " + std::to_string(y) + " "; };
            out += "<path class=\"band " + a.kind + "\" d=\"M" + point(a.x, top) + "C" + point(a.x, half) +
                   point(b.x, half) + point(b.x, bottom) + "H" + std::to_string(b.x + b.width()) + " C" +
                   point(b.x + b.width(), half) + point(a.x + a.width(), half) + point(a.x + a.width(), top) +
                   "Z\"/>\n";
        }
    return out;
}

} // namespace

std::string jauscat::reference::data_path_picture() {
    auto all = rows();
    int y = first_box;
    for (row& one : all) {
        int width = 0;
        for (const cell& place : one.cells) width += place.width();
        int x = (picture_width - width) / 2;
        for (cell& place : one.cells) {
            place.x = x;
            x += place.width();
        }
        one.y = y;
        y += row_height;
    }
    const int height = y - row_height + box_height + margin;
    std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + std::to_string(picture_width) + " " +
                      std::to_string(height) + "\"" + attribute("width", picture_width) + attribute("height", height) +
                      ">\n<title>One command from an operator to an arm, byte by byte</title>\n" + style +
                      "<rect width=\"100%\" height=\"100%\" rx=\"10\" fill=\"#ffffff\"/>\n";
    for (std::size_t i = 0; i + 1 < all.size(); ++i) out += bands(all[i], all[i + 1]);
    for (const row& one : all) out += drawn(one);
    return out + "</svg>\n";
}
