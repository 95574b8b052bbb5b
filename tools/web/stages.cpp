#include "web/stages.hpp"

#include <jauscat/bridge/sae_delivery.hpp>
#include <jauscat/ethercat/master/master.hpp>
#include <jauscat/ethercat/slave/loopback_link.hpp>
#include <jauscat/schema/ethercat/datagram.hpp>
#include <jauscat/schema/ethercat/frame.hpp>
#include <jauscat/schema/translation/sae_table.hpp>
#include <jauscat/schema/translation/self_contained_table.hpp>
#include <jauscat/translate/diagnose.hpp>

#include <optional>

namespace page {

namespace {

namespace bridging = jauscat::bridging;
namespace ethercat = jauscat::ethercat;
namespace jaus = jauscat::jaus;
namespace sae = jauscat::sae;
namespace text = jauscat::text;
namespace translate = jauscat::translate;
namespace translation = jauscat::translation;
namespace wire = jauscat::wire;
using bytes = std::vector<std::byte>;
using packet_type = jauscat::hilscher::sdo_download_request;

constexpr std::uint32_t seed_base = translation::seed_index_base,
                        manufacturer_base = translation::manufacturer_index_base,
                        profile_base = translation::profile_index_base;

/// Calls `use.template operator()<Table>()` with the table of the name and the index base; false where there is none.
bool with_table(const std::string& name, std::uint32_t base, auto&& use) {
    const auto pick = [&]<std::uint32_t... Bases>(auto made_for) {
        return (... || (base == Bases && (made_for.template operator()<Bases>(), true)));
    };
    if (name == "seed")
        return pick.template operator()<seed_base, manufacturer_base, profile_base>(
            [&]<std::uint32_t Base>() { use.template operator()<typename translation::seed_table_of<Base>::type>(); });
    if (name == "self-contained")
        return pick.template operator()<seed_base, manufacturer_base, profile_base>([&]<std::uint32_t Base>() {
            use.template operator()<typename translation::self_contained_table_of<Base>::type>();
        });
    if (name == "sae")
        return pick.template operator()<manufacturer_base, profile_base>(
            [&]<std::uint32_t Base>() { use.template operator()<typename translation::sae_table_of<Base>::type>(); });
    return false;
}

template <class Table> constexpr bool is_sae = std::is_same_v<typename Table::header_type, sae::message_head>;

/// The place among `parts` of the one with a field; null where none has it.
json part_with(const json& parts, std::string_view path) {
    for (std::size_t i = 0; i != parts.size(); ++i)
        for (const auto& field : parts[i].at("fields"))
            if (field.at("path").get_ref<const std::string&>() == path) return i;
    return nullptr;
}
void mark(json& parts, std::string_view path, const json& from) {
    const json at = part_with(parts, path);
    if (!at.is_null() && !from.is_null()) parts[at.get<std::size_t>()]["from"] = from;
}

/// The path of a field as annotations have it: that of an SAE header is inside `message_head`, which messages are not.
template <class Path> std::string path_of() {
    const std::string parent{Path::parent()}, field{Path::field()};
    return parent.empty() || parent == "transport" ? field : parent + "." + field;
}
template <auto A, auto B, auto C> std::string path_of_three() {
    return std::string{wire::name_of<B>()} + "." + std::string{wire::name_of<C>()};
}
template <class Path> struct path_name {
    static std::string text() { return path_of<Path>(); }
};
template <auto A, auto B, auto C> struct path_name<translate::at<A, B, C>> {
    static std::string text() { return path_of_three<A, B, C>(); }
};

/// Marks packet fields with the message field that a row of the table makes them of.
template <class Row> void mark_row(json& packet, const json& message) {
    const auto mark_pair = [&]<class Use, class... Uses, class Write, class... Writes>(
                               translate::path_list<Use, Uses...>, translate::path_list<Write, Writes...>) {
        mark(packet, path_name<Write>::text(), part_with(message, path_name<Use>::text()));
    };
    if constexpr (Row::uses::size != 0 && Row::writes::size != 0)
        mark_pair(typename Row::uses{}, typename Row::writes{});
}
template <class Table> void mark_rows(json& packet, const json& message) {
    [&]<class... Rows>(translate::row_list<Rows...>) {
        (mark_row<Rows>(packet, message), ...);
    }(typename Table::rows{});
    mark(packet, path_name<typename Table::data_count_row::counts_data>::text(),
         part_with(message, path_name<typename Table::body_size_row::states_body_size>::text()));
}

/// Adds the parts of the message that are in the data, which begin at `offset`.
template <class Table> void append_data(json& to, const json& message, std::size_t offset, std::size_t message_size) {
    const auto append = [&](std::size_t begin, std::size_t size) {
        const std::size_t end = begin + size;
        for (std::size_t i = 0; i != message.size(); ++i) {
            const auto at = message[i].at("offset").get<std::size_t>(),
                       bytes = message[i].at("size").get<std::size_t>();
            if (at < begin || at + bytes > end) continue;
            if (at != begin) // bytes that belong to no part
                to.push_back({{"offset", offset}, {"size", at - begin}, {"place", "data"}, {"fields", json::array()}});
            offset += at - begin;
            to.push_back(
                {{"offset", offset}, {"size", bytes}, {"place", "data"}, {"fields", json::array()}, {"from", i}});
            offset += bytes;
            begin = at + bytes;
        }
        if (begin < end)
            to.push_back({{"offset", offset}, {"size", end - begin}, {"place", "data"}, {"fields", json::array()}});
        offset += end - begin;
    };
    for (std::size_t i = 0; i != Table::rest.count; ++i) append(Table::rest.range[i].offset, Table::rest.range[i].size);
    constexpr std::size_t header = translate::translator<Table>::header_size;
    append(header, message_size - header);
}

struct any_object {
    ethercat::object_read read(std::uint16_t, std::uint8_t, std::span<std::byte>) noexcept { return {}; }
    ethercat::abort_code write(std::uint16_t, std::uint8_t, std::span<const std::byte>) noexcept {
        return ethercat::abort_code::none;
    }
};

/// A master and a slave in memory, and the frames between them, as they come back.
class bus {
  public:
    explicit bus(std::uint16_t station) : station_{station} { run(ethercat::bring_up{0, station}); }

    std::vector<bytes> frames_of(const bridging::object_access& object) {
        frames_.clear();
        run(ethercat::download{station_, object.index, object.subindex, object.data});
        return frames_;
    }

  private:
    void run(const auto& job) {
        static_cast<void>(master_.start(job));
        std::array<std::byte, ethercat::max_frame_size> frame{};
        while (!master_.idle()) {
            master_.on_time(now_);
            if (const auto size = master_.next_frame(frame, now_);
                size != 0 && link_.send(std::span{frame}.first(size))) {
                const auto back = link_.receive(frame, {});
                frames_.emplace_back(frame.begin(), frame.begin() + static_cast<std::ptrdiff_t>(back));
                master_.on_frame(std::span{frame}.first(back), now_);
            }
            const auto wake = master_.next_event();
            if (wake) now_ = std::max(*wake, now_ + std::chrono::microseconds{1});
        }
    }

    std::uint16_t station_;
    any_object objects_{};
    std::array<ethercat::slave, 1> slaves_{ethercat::slave{{.vendor = 1, .product = 2}, objects_}};
    ethercat::loopback_link link_{slaves_};
    ethercat::master_for<16> master_{};
    jauscat::time_point now_{};
    std::vector<bytes> frames_{};
};

/// Takes a frame apart as far as it has the headers of an SDO download; null where it has other content.
class frame_reader {
  public:
    frame_reader(std::span<const std::byte> frame, const json& packet) : frame_{frame}, packet_{packet} {}

    /// `data` bytes of the object have been in frames before; it returns how many are in this one.
    std::optional<std::size_t> read(const bridging::object_access& object, std::size_t sent, const json& data) {
        if (!header<ethercat::ethernet_header>("ethernet") || !header<ethercat::frame_header>("frame")) return {};
        ethercat::datagram_header datagram{};
        if (!header(datagram, "datagram") || datagram.cmd != ethercat::command::fpwr) return {};
        mark(parts_, "adp", from("ul_node_id"));
        const std::size_t end = at_ + datagram.length;
        ethercat::mailbox_header mailbox{};
        if (!header(mailbox, "mailbox") || mailbox.type != ethercat::mailbox_type::coe) return {};
        const std::size_t mail_end = at_ + mailbox.length;
        if (!header<ethercat::coe_header>("CoE")) return {};
        if (sent == 0) {
            if (!header<ethercat::sdo_normal>("SDO")) return {};
            mark(parts_, "header.index", from("ul_index"));
            mark(parts_, "header.subindex", from("ul_sub_index"));
            mark(parts_, "size", from("ul_data_cnt"));
        } else if (!header<ethercat::sdo_segment_header>("SDO segment")) {
            return {};
        }
        if (mail_end > frame_.size()) return {};
        const std::size_t size = std::min(mail_end - at_, object.data.size() - sent);
        if (!std::ranges::equal(frame_.subspan(at_, size), object.data.subspan(sent, size))) return {};
        append(data, sent, size);
        if (at_ < end) rest(end - at_, "mailbox");
        header<ethercat::datagram_trailer>("datagram");
        if (at_ < frame_.size()) rest(frame_.size() - at_, "padding");
        return size;
    }
    json parts() && { return std::move(parts_); }

  private:
    json from(std::string_view path) const {
        const json at = part_with(packet_, path);
        return at.is_null() ? at : packet_[at.get<std::size_t>()].value("from", json(nullptr));
    }
    template <class Header> bool header(Header& head, const char* place) {
        if (!wire::decode_prefix(head, frame_.subspan(at_))) return false;
        append_parts(parts_, parts_of<Header>(frame_.subspan(at_)), at_, place);
        at_ += wire::max_size<Header>;
        return true;
    }
    template <class Header> bool header(const char* place) {
        Header head{};
        return header(head, place);
    }
    void rest(std::size_t size, const char* place) {
        parts_.push_back({{"offset", at_}, {"size", size}, {"place", place}, {"fields", json::array()}});
        at_ += size;
    }
    /// The parts of `data` from `sent` on.
    void append(const json& data, std::size_t sent, std::size_t size) {
        for (const json& part : data) {
            const auto begin = std::max(part.at("offset").get<std::size_t>(), sent);
            const auto end =
                std::min(part.at("offset").get<std::size_t>() + part.at("size").get<std::size_t>(), sent + size);
            if (begin >= end) continue;
            json cut = part;
            cut["offset"] = at_ + begin - sent;
            cut["size"] = end - begin;
            parts_.push_back(std::move(cut));
        }
        at_ += size;
    }

    std::span<const std::byte> frame_;
    const json& packet_;
    json parts_ = json::array();
    std::size_t at_{};
};

json frames_of(const bridging::object_access& object, const json& packet, const json& data) {
    json told = json::array();
    std::size_t sent = 0;
    for (const bytes& frame : bus{object.station}.frames_of(object)) {
        if (sent == object.data.size()) break;
        frame_reader reader{frame, packet};
        const auto size = reader.read(object, sent, data);
        if (!size) continue;
        sent += *size;
        told.push_back({{"hex", text::detail::plain_hex(frame)}, {"parts", std::move(reader).parts()}});
    }
    return told;
}

template <class Table> translate::errc deliverable(std::span<const std::byte> message) {
    if constexpr (is_sae<Table>) {
        sae::message_head head{};
        static_cast<void>(wire::decode_prefix(head, message));
        return bridging::sae_delivery<Table>::deliverable(head.transport);
    } else {
        jaus::header head{};
        static_cast<void>(wire::decode_prefix(head, message));
        return bridging::delivery<Table>::deliverable(head);
    }
}
template <class Table>
auto message_of(const bridging::object_access& object, std::span<const std::byte> sent, std::span<std::byte> out) {
    if constexpr (is_sae<Table>) {
        return bridging::sae_delivery<Table>::message_of(object, out);
    } else {
        jaus::header head{}; // the slave knows its own subsystem and instance
        static_cast<void>(wire::decode_prefix(head, sent));
        return bridging::delivery<Table>::message_of(object,
                                                     {.subsystem = head.destination.subsystem,
                                                      .station = head.destination.node,
                                                      .instance = head.destination.instance},
                                                     out);
    }
}

json error_of(const translate::diagnosis& why) {
    std::string told{describe(why.error)};
    const std::string field =
        why.parent.empty() ? std::string{why.field} : std::string{why.parent} + "." + std::string{why.field};
    if (why.row != translate::diagnosis::no_row && !field.empty())
        told += ": " + field + " is " + std::to_string(why.value);
    return {{"error", std::string{text::enumerator_name(why.error)}}, {"field", field}, {"text", told}};
}

template <class Table> json stages_by(std::span<const std::byte> message, const json& parts) {
    using translator = translate::translator<Table>;
    std::array<std::byte, translator::max_packet_size> room{};
    const auto packet = translator::to_packet(message, room);
    if (!packet) return {{"error", error_of(translate::diagnose_to_packet<Table>(packet.error(), message))}};

    json told, packet_parts = json::array(), data = json::array();
    append_parts(packet_parts, parts_of<packet_type>(*packet), 0, "packet");
    mark_rows<Table>(packet_parts, parts);
    append_data<Table>(data, parts, 0, message.size());
    const json fields = packet_parts;
    for (json part : data) {
        part["offset"] = part["offset"].template get<std::size_t>() + translator::packet_size;
        packet_parts.push_back(std::move(part));
    }
    told["packet"] = {{"hex", text::detail::plain_hex(*packet)}, {"parts", packet_parts}};

    if (const auto error = deliverable<Table>(message); error != translate::errc::ok) {
        told["object"] = {{"error", error_of({.error = error})}};
        return told;
    }
    const auto object = bridging::detail::object_of(*packet);
    told["object"] = {{"station", object.station},
                      {"index", object.index},
                      {"subindex", object.subindex},
                      {"hex", text::detail::plain_hex(object.data)},
                      {"parts", data}};
    told["frames"] = frames_of(object, fields, data);
    bytes again(message.size());
    const auto restored = message_of<Table>(object, message, again);
    if (restored)
        told["message"] = {{"hex", text::detail::plain_hex(*restored)}};
    else
        told["message"] = {{"error", error_of({.error = restored.error()})}};
    return told;
}

} // namespace

void append_parts(json& to, const std::vector<text::annotated_part>& parts, std::size_t first_offset,
                  const std::string& place) {
    for (const auto& part : parts) {
        if (part.size == 0 && part.fields.empty()) continue;
        json fields = json::array();
        for (const auto& field : part.fields) fields.push_back({{"path", field.path}, {"value", field.value}});
        to.push_back({{"offset", first_offset + part.offset},
                      {"size", part.size},
                      {"place", place},
                      {"fields", std::move(fields)}});
    }
}

json tables() {
    json all = json::array();
    for (const auto* name : {"seed", "self-contained", "sae"})
        for (const auto base : {seed_base, manufacturer_base, profile_base})
            if (with_table(name, base, []<class Table>() {})) all.push_back({{"table", name}, {"base", base}});
    return all;
}

json stages(std::span<const std::byte> message, const json& parts, const std::string& table, std::uint32_t base) {
    json told;
    if (!with_table(table, base, [&]<class Table>() { told = stages_by<Table>(message, parts); }))
        return {{"error", {{"text", "there is no such table"}}}};
    return told;
}

json message_of_packet(std::span<const std::byte> packet, const std::string& table, std::uint32_t base) {
    json told;
    with_table(table, base, [&]<class Table>() {
        using translator = translate::translator<Table>;
        bytes room(translator::max_message_size);
        const auto message = translator::from_packet(packet, room);
        if (message)
            told = {{"hex", text::detail::plain_hex(*message)}, {"generation", is_sae<Table> ? "sae" : "ra"}};
        else
            told = {{"error", error_of(translate::diagnose_from_packet<Table>(message.error(), packet))}};
    });
    return told;
}

} // namespace page
