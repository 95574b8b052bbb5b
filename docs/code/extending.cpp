// The extension points of extending.md, each with the smallest type that models its concept.
//     docs_extending
// [includes]
#include <jauscat/jauscat.hpp>
#include <jauscat/net/node/node_component.hpp>
#include <jauscat/schema/jaus/platform.hpp>
#include <jauscat/text/hex.hpp>

#include <array>
#include <iostream>

namespace bridging = jauscat::bridging;
namespace ethercat = jauscat::ethercat;
namespace jaus = jauscat::jaus;
namespace net = jauscat::net;
namespace wire = jauscat::wire;
using namespace std::chrono_literals;
using jauscat::time_point;
using std::chrono::nanoseconds;

// [includes end]

// [codec]
/// A number from 0 to 99 as two decimal digits in one byte.
struct two_digits {
    using value_type = std::uint8_t;
    static constexpr std::size_t size = 1;
    static constexpr wire::errc store(std::byte* out, std::uint8_t value) noexcept {
        if (value > 99) return wire::errc::out_of_range;
        *out = static_cast<std::byte>(value / 10 * 16 + value % 10);
        return wire::errc::ok;
    }
    static constexpr wire::errc load(const std::byte* in, std::uint8_t& value) noexcept {
        const auto byte = std::to_integer<unsigned>(*in);
        if (byte / 16 > 9 || byte % 16 > 9) return wire::errc::out_of_range;
        value = static_cast<std::uint8_t>(byte / 16 * 10 + byte % 16);
        return wire::errc::ok;
    }
};
// [codec end]

// [item]
/// One byte that is always `Value`, such as a start mark.
template <std::uint8_t Value> struct mark {
    using keys = wire::key_list<>;
    static constexpr bool optional = false;
    static constexpr std::size_t min_size = 1, max_size = 1;
    static constexpr wire::errc put(const auto&, std::byte* out) noexcept {
        *out = std::byte{Value};
        return wire::errc::ok;
    }
    static constexpr wire::errc get(auto&, const std::byte* in) noexcept {
        return *in == std::byte{Value} ? wire::errc::ok : wire::errc::out_of_range;
    }
    static constexpr void visit(auto&, auto&&) noexcept {}
};
// [item end]

// [layout]
struct time_of_day {
    std::uint8_t hour{}, minute{};

    struct schema : jauscat::wire::items {
        using T = time_of_day;
        using type = layout<mark<0x7E>, field<&T::hour, two_digits>, field<&T::minute, two_digits>>;
    };
};
// [layout end]

// [part]
/// A lamp that is switched on for some seconds, and off when the component that has done so is lost.
class lamp {
  public:
    static constexpr std::uint16_t switch_on = 0xD102; ///< private message; one byte: seconds

    jaus::message_outcome on_message(const jaus::header& head, std::span<const std::byte> body, time_point now,
                                     jaus::message_sink) {
        if (head.command_code != switch_on) return jaus::message_outcome::unhandled;
        if (body.size() != 1) return jaus::message_outcome::malformed;
        user_ = head.source;
        off_at_ = now + std::to_integer<int>(body[0]) * 1s;
        return jaus::message_outcome::handled;
    }
    void on_time(time_point now, jaus::message_sink) {
        if (off_at_ && now >= *off_at_) off_at_.reset();
    }
    [[nodiscard]] std::optional<time_point> next_event() const { return off_at_; }
    void on_lost(const jaus::address& who) {
        if (jaus::stands_for(who, user_)) off_at_.reset();
    }

    [[nodiscard]] bool is_on() const { return off_at_.has_value(); }

  private:
    jaus::address user_{};
    std::optional<time_point> off_at_{};
};
// [part end]

// [component]
/// A component as before, with the number of its messages.
template <net::node_component Component> struct counted_component {
    Component& it;
    unsigned messages{};

    [[nodiscard]] const jaus::address& self() const { return it.self(); }
    jaus::component_outcome on_message(const jaus::header& head, std::span<const std::byte> body, time_point now,
                                       jaus::message_sink out, auto&& application) {
        ++messages;
        return it.on_message(head, body, now, out, application);
    }
    void on_time(time_point now, jaus::message_sink out) { it.on_time(now, out); }
    [[nodiscard]] std::optional<time_point> next_event() const { return it.next_event(); }
    void on_lost(const jaus::address& who) { it.on_lost(who); }
};
// [component end]

// [link]
/// A link as before, with the number of its frames.
template <ethercat::link Link> struct counted_link {
    Link& medium;
    unsigned frames{};

    bool send(std::span<const std::byte> frame) {
        ++frames;
        return medium.send(frame);
    }
    std::size_t receive(std::span<std::byte> buffer, nanoseconds timeout) { return medium.receive(buffer, timeout); }
};
// [link end]

// [objects]
/// A slave's application with one object: 2000h:0, 16 bits.
struct thermometer {
    std::uint16_t kelvin{293};

    ethercat::object_read read(std::uint16_t index, std::uint8_t subindex, std::span<std::byte> out) noexcept {
        if (index != 0x2000 || subindex != 0) return {.error = ethercat::abort_code::no_object};
        if (out.size() < 2) return {.error = ethercat::abort_code::exceeds_mailbox};
        static_cast<void>(wire::u16le::store(out.data(), kelvin));
        return {.size = 2};
    }
    ethercat::abort_code write(std::uint16_t index, std::uint8_t, std::span<const std::byte>) noexcept {
        return index == 0x2000 ? ethercat::abort_code::read_only : ethercat::abort_code::no_object;
    }
};
// [objects end]

int main() {
    // [codec_use]
    std::array<std::byte, wire::max_size<time_of_day>> bytes{};
    const auto size = wire::encode(time_of_day{.hour = 23, .minute = 59}, bytes);
    if (!size) return std::cerr << describe(size.error()) << '\n', 1;
    std::cout << "23:59 is " << jauscat::text::hex(bytes) << '\n';
    // [codec_use end]

    // [part_use]
    constexpr jaus::address self{.instance = 1, .component = 60, .node = 2, .subsystem = 2};
    constexpr jaus::address visitor{.instance = 1, .component = 32, .node = 1, .subsystem = 1};
    const auto on_state = [](jaus::primary_status_code, jaus::primary_status_code) {}; // bring actuators to rest
    const auto send = [](std::span<const std::byte>) {};                               // to the network
    const auto unhandled = [](const jaus::header&, std::span<const std::byte>) {
        return jaus::message_outcome::unhandled;
    };

    jaus::component_memory<> memory{};
    lamp light{};
    jaus::component unit{self, memory, {.on_state = on_state}, {}, light};
    unit.change(jaus::state_event::initialized);
    // [part_use end]

    counted_component<decltype(unit)> counted{unit};
    static_assert(net::node_component<decltype(counted)>);
    counted.on_message({.command_code = lamp::switch_on, .destination = self, .source = visitor},
                       std::array{std::byte{30}}, time_point{}, send, unhandled);
    std::cout << "the lamp is " << (light.is_on() ? "on" : "off");
    counted.on_lost(visitor);
    std::cout << ", and " << (light.is_on() ? "on" : "off") << " when the visitor is lost; " << counted.messages
              << " message\n";

    // [filler]
    const auto fill = [](std::uint16_t, std::uint32_t fields, std::span<std::byte> body) -> std::optional<std::size_t> {
        jaus::report_wrench_effort report{.propulsive_linear_effort_x = 50};
        jaus::keep_requested(report, fields);
        const auto written = wire::encode(report, body);
        if (!written) return std::nullopt;
        return written->size();
    };
    constexpr std::array reports{jaus::connectable_report{jaus::command_code_of<jaus::report_wrench_effort>}};
    std::array<std::byte, 64> room{};
    jaus::service_connections<4> connections{self, reports, fill, room};
    // [filler end]
    std::cout << connections.connections().size() << " places for connections\n";

    ethercat::loopback_link wire_end{{}};
    counted_link<ethercat::loopback_link> medium{wire_end};
    std::array<std::byte, 60> frame{};
    const bool sent = medium.send(frame) && medium.receive(frame, 0s) == frame.size();
    std::cout << medium.frames << " frame " << (sent ? "returned" : "lost") << '\n';

    // [objects_use]
    thermometer sensor{};
    ethercat::object_dictionary objects{sensor}; // what a slave is constructed with
    std::array<std::byte, 2> kelvin{};
    if (objects.read(0x2000, 0, kelvin).size != 2) return 1;
    std::cout << "2000h:0 is " << jauscat::text::hex(kelvin) << '\n';
    // [objects_use end]

    // [observer]
    const auto lost = [](const bridging::slave_front& slave, bridging::loss, const ethercat::master_error&) {
        std::cout << "slave " << slave.station() << " is lost\n";
    };
    const bridging::observer watcher{.slave_lost = lost}; // for each slave_front
    // [observer end]
    return watcher.slave_lost ? 0 : 1;
}
